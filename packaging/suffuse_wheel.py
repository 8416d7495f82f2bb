"""Wheels of suffuse [PEP 517, PEP 427]: CMake builds and installs the Python module and the program, this packs them.

The wheel holds the package, the program, its manual page and completions, and the report's page. Our libraries are linked in; what
is left to the system stands in the wheel's METADATA (Requires-External) and printed.

    pip wheel . --no-build-isolation --config-settings build-dir=DIR     # elsewhere than in build/wheel, which is kept
"""

import base64
import hashlib
import io
import pathlib
import re
import subprocess
import sys
import sysconfig
import tarfile
import tempfile
import tomllib
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[1]


def read_project():
    """The table [project] of pyproject.toml, with the version of CMakeLists.txt."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    project["version"] = re.search(r"project\(suffuse VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text())[1]
    return project


def stem(project):
    return f"{project['name']}-{project['version']}"


def metadata(project, external=()):
    fields = [("Metadata-Version", "2.1"), ("Name", project["name"]), ("Version", project["version"])]
    fields += [("Summary", project["description"]), ("License", project["license"]["text"])]
    fields += [("Keywords", ",".join(project["keywords"])), ("Requires-Python", project["requires-python"])]
    fields += [("Classifier", name) for name in project["classifiers"]]
    fields += [("Requires-Dist", name) for name in project["dependencies"]]
    fields += [("Requires-External", name) for name in external]
    fields += [("Description-Content-Type", "text/markdown")]
    return "".join(f"{name}: {value}\n" for name, value in fields) + "\n" + (ROOT / project["readme"]).read_text()


def build_tree(build, stage):
    """Builds, and installs below `stage` what belongs to the program and to the module."""
    options = ["-G", "Ninja", "-D", "CMAKE_BUILD_TYPE=Release", "-D", "SUFFUSE_TESTS=OFF", "-D", "SUFFUSE_QUICK_BUILD=ON"]
    options += ["-D", f"SUFFUSE_PYTHON_PROGRAM={sys.executable}", "-D", "SUFFUSE_PYTHON_DIR=package"]
    subprocess.run(["cmake", "-S", ROOT, "-B", build, *options], check=True)
    subprocess.run(["cmake", "--build", build, "--target", "suffuse", "suffuse_python_package"], check=True)
    for component in ("program", "python"):
        subprocess.run(["cmake", "--install", build, "--prefix", stage, "--component", component, "--strip"], check=True)


def place_in_wheel(path, data):
    """Where a wheel holds a file that was installed at `path`, or None: documents stay in the checkout."""
    if path.parts[0] == "package":
        return pathlib.PurePosixPath(*path.parts[1:])
    if path.parts[0] == "bin":
        return data / "scripts" / path.name
    return None if path.parts[:2] == ("share", "doc") else data / "data" / path


def needed_libraries(files):
    """Names of the shared libraries that the dynamic linker will look for, without those of the compiler and the C library."""
    names = set()
    for file in files:
        output = subprocess.run(["readelf", "-d", file], check=True, capture_output=True, text=True, env={"LC_ALL": "C"})
        names.update(re.findall(r"\(NEEDED\).*\[(.+)\]", output.stdout))
    return sorted(name for name in names if not re.match(r"(libc|libm|libgcc_s|libstdc\+\+|ld-linux.*)\.so", name))


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    project = read_project()
    build = (ROOT / (config_settings or {}).get("build-dir", "build/wheel")).resolve()
    data, info = (pathlib.PurePosixPath(f"{stem(project)}.{end}") for end in ("data", "dist-info"))
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    tag = f"{python}-{python}-{re.sub('[-.]', '_', sysconfig.get_platform())}"
    name = f"{stem(project)}-{tag}.whl"
    record = []
    with tempfile.TemporaryDirectory() as folder, zipfile.ZipFile(
        pathlib.Path(wheel_directory) / name, "w", zipfile.ZIP_DEFLATED
    ) as wheel:
        stage = pathlib.Path(folder)
        build_tree(build, stage)

        def add(place, content, mode=0o644):
            entry = zipfile.ZipInfo(str(place))
            entry.external_attr = (0o100000 | mode) << 16
            entry.compress_type = zipfile.ZIP_DEFLATED
            wheel.writestr(entry, content)
            digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
            record.append(f"{place},sha256={digest},{len(content)}\n")

        for file in sorted(path for path in stage.rglob("*") if path.is_file()):
            place = place_in_wheel(file.relative_to(stage), data)
            if place:
                add(place, file.read_bytes(), file.stat().st_mode & 0o777)
        external = needed_libraries([*stage.glob("package/suffuse/_core*.so"), stage / "bin" / "suffuse"])
        add(info / "METADATA", metadata(project, external).encode())
        add(info / "WHEEL", f"Wheel-Version: 1.0\nGenerator: suffuse_wheel\nRoot-Is-Purelib: false\nTag: {tag}\n".encode())
        add(info / "licenses" / "LICENSE", (ROOT / "LICENSE").read_bytes())
        wheel.writestr(f"{info}/RECORD", "".join(record) + f"{info}/RECORD,,\n")
    print(f"{name} needs of the system: {', '.join(external)}")
    return name


def build_sdist(sdist_directory, config_settings=None):
    """What is committed, with its metadata."""
    project = read_project()
    files = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, check=True, capture_output=True, text=True).stdout
    name = f"{stem(project)}.tar.gz"
    with tarfile.open(pathlib.Path(sdist_directory) / name, "w:gz") as archive:
        for file in files.rstrip("\0").split("\0"):
            archive.add(ROOT / file, f"{stem(project)}/{file}", recursive=False)
        text = metadata(project).encode()
        entry = tarfile.TarInfo(f"{stem(project)}/PKG-INFO")
        entry.size = len(text)
        archive.addfile(entry, io.BytesIO(text))
    return name
