# A recipe for Spack. Checked for its syntax only: no Spack was at hand, and nobody has built it yet. It has no address of a
# release: `spack dev-build suffuse@main` builds the checkout that it is called in. The report's page, which npm makes, is taken
# from build/report-page where page/build.sh left it; else reports are plain.
from spack.package import *


class Suffuse(CMakePackage):
    """Internal erosion of soils, grain by grain: discrete elements, pore-scale flow, and an erosion loop."""

    license("GPL-3.0-or-later")

    version("main")

    variant("python", default=True, description="Build the Python module")

    depends_on("c", type="build")
    depends_on("cxx", type="build")
    depends_on("cmake@3.25:", type="build")
    depends_on("ninja", type="build")
    depends_on("boost@1.66:", type="build")
    depends_on("cgal@5.5:+header_only", type="build")
    depends_on("cli11@2.1:", type="build")
    depends_on("cpp-httplib@0.11:")
    depends_on("eigen@3.4:", type="build")
    depends_on("tomlplusplus@3.3:")
    depends_on("nlohmann-json@3.11:")
    depends_on("fmt@9:")
    depends_on("fftw@3.3: precision=float,double")
    depends_on("gmp")
    depends_on("mpfr")
    depends_on("hdf5@1.10:~mpi")
    depends_on("openssl@3:")
    depends_on("zlib-api")
    extends("python", when="+python")
    depends_on("py-pybind11@2.10:", type="build", when="+python")
    depends_on("py-numpy", type=("build", "run"), when="+python")

    generator("ninja")

    def cmake_args(self):
        args = [
            self.define("SUFFUSE_TESTS", False),
            self.define("SUFFUSE_WERROR", False),
            self.define("SUFFUSE_QUICK_BUILD", True),
            self.define_from_variant("SUFFUSE_PYTHON", "python"),
        ]
        if self.spec.satisfies("+python"):
            args.append(self.define("SUFFUSE_PYTHON_PROGRAM", self.spec["python"].command.path))
            python = f"python{self.spec['python'].version.up_to(2)}"
            args.append(self.define("SUFFUSE_PYTHON_DIR", join_path("lib", python, "site-packages")))
        return args
