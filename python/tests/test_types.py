"""What editors and type checkers read of the compiled half is Python, and lists all that there is."""

import ast
import inspect
import pathlib

import suffuse
from suffuse import _core

FOLDER = pathlib.Path(suffuse.__file__).parent


def test_the_types_of_the_compiled_half_are_documented():
    stubs = ast.parse((FOLDER / "_core.pyi").read_text())
    names = {one.name: one for one in stubs.body if isinstance(one, (ast.ClassDef, ast.FunctionDef))}
    for name, one in vars(_core).items():
        if not name.startswith("__"):
            assert name in names, name
        if inspect.isclass(one):
            members = {part.name for part in names[name].body if isinstance(part, ast.FunctionDef)}
            assert {member for member in vars(one) if not member.startswith("_")} <= members, name
    assert (FOLDER / "py.typed").exists()


def test_types_are_those_of_soil_mechanics_not_of_the_compiler():
    text = (FOLDER / "_core.pyi").read_text()
    compact = next(line for line in text.splitlines() if "def compact(" in line)
    assert "pressure: float | str" in compact and "friction: float | str | None" in compact and "-> dict" in compact
    assert "suffuse::" not in text and "_core." not in text and "<" not in "".join(
        line for line in text.splitlines() if line.strip().startswith("def ")
    )


def test_names_are_where_users_find_them():
    for name in suffuse.__all__:
        one = getattr(suffuse, name)
        if getattr(one, "__module__", None) is not None and inspect.isclass(one):
            assert one.__module__.startswith("suffuse") and "_core" not in one.__module__
            assert one.__doc__, name
    assert list(inspect.signature(suffuse.seep).parameters)[3:7] == ["gradient", "direction", "fluid", "tensor"]


def test_what_is_printed_names_what_it_is(settled):
    water = suffuse.seep(settled, gradient=0.05)
    for one in (settled, settled.grains, settled.contacts, water, water.network, suffuse.constrictions(settled)):
        assert " object at 0x" not in repr(one)
    assert "500, of " in repr(settled.grains) and "Reynolds number" in repr(water)


def test_progress_is_printed_of_steps_too(settled, capsys):
    suffuse.print_progress("shear", 12345)
    assert "shear: 12,345 steps" in capsys.readouterr().err
