#!/usr/bin/python3
"""A wheel made of a build that is there, in an environment of its own: wheel.py BUILD. What the compiler would do is not
tried again. Exit code 77 where this Python cannot make environments."""

import importlib.util
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.dont_write_bytecode = True
sys.path.insert(0, str(ROOT / "packaging"))
import suffuse_wheel

if importlib.util.find_spec("ensurepip") is None:
    print("no ensurepip (Debian: python3-venv)")
    sys.exit(77)


def install_build(_, stage):
    """In place of build_tree(): what `cmake --install` takes from the build."""
    for component in ("program", "python"):
        subprocess.run(
            ["cmake", "--install", sys.argv[1], "--prefix", stage, "--component", component], check=True, stdout=subprocess.DEVNULL
        )
    (stage / "lib/python3/dist-packages").rename(stage / "package")


suffuse_wheel.build_tree = install_build
with tempfile.TemporaryDirectory() as name:
    folder = pathlib.Path(name)
    wheel = folder / suffuse_wheel.build_wheel(folder)
    subprocess.run([sys.executable, "-m", "venv", "--system-site-packages", folder / "env"], check=True)
    subprocess.run(
        [folder / "env/bin/pip", "install", "-q", "--no-index", "--disable-pip-version-check", wheel], check=True
    )
    version = suffuse_wheel.read_project()["version"]
    script = "import suffuse; from suffuse.run import page_folder; print(suffuse.__version__, suffuse.__file__, page_folder())"
    output = subprocess.run([folder / "env/bin/python", "-c", script], check=True, capture_output=True, text=True, cwd=folder).stdout
    found, module, page = output.split(maxsplit=2)
    assert found == version, f"the module is of version {found}"
    assert module.startswith(f"{folder}/env/"), f"another module was imported: {module}"
    if (pathlib.Path(sys.argv[1]).parent / "report-page").is_dir():
        assert page.strip() == f"{folder}/env/share/suffuse/report-page", f"the page is sought at {page}"
    output = subprocess.run([folder / "env/bin/suffuse", "--version"], check=True, capture_output=True, text=True).stdout
    assert version in output, output
