#!/usr/bin/python3
"""What scripts may rely on of the Python module: its public names with their signatures, compared with a kept list.

    PYTHONPATH=build/release/python tools/python_interface.py            what has changed; exit code 1 where something has
    PYTHONPATH=build/release/python tools/python_interface.py --write    keeps it, after a change that is meant
"""

import difflib
import functools
import inspect
import pathlib
import re
import sys

import suffuse

KEPT = pathlib.Path(__file__).resolve().parents[1] / "python/tests/interface.txt"
ADVICE = """the Python interface has changed. If that is meant: tools/python_interface.py --write (with PYTHONPATH, as its
help says), and tell users in CHANGELOG.md what has changed"""
SPECIAL = ("__init__", "__call__", "__getitem__", "__iter__", "__len__")


def signature(name, one):
    """Of Python's own functions as they are written; of C++ ones what the first line of the docstring says."""
    if inspect.isfunction(one):
        return f"{name}{inspect.signature(one)}"
    first = (one.__doc__ or "").splitlines()[:1]
    return re.sub(r"\bsuffuse\._core\.", "suffuse.", first[0]) if first and "(" in first[0] else name


def member(name, one):
    """A line, or None of what is nobody's business."""
    if name.startswith("_") and name not in SPECIAL:
        return None
    if isinstance(one, functools.cached_property):
        return f"{name}: computed once"
    if isinstance(one, property):
        reported = signature(name, one.fget).partition(" -> ")[2] if not inspect.isfunction(one.fget) else ""
        return f"{name}: {reported or 'a property'}{', may be set' if one.fset else ''}"
    if isinstance(one, (staticmethod, classmethod)):
        return f"{type(one).__name__} {signature(name, one.__func__)}"
    if not callable(one):
        return f"{name} = {one!r}"
    if name == "__init__" and not inspect.isfunction(one) and one.__doc__.startswith("Initialize self"):
        return None  # made by functions, not by users
    return signature(name, one)


def is_inner(base):
    """Whether a base class is no public name: what it has belongs to the classes that inherit it."""
    return base.__module__.startswith("suffuse.") and base.__module__ != "suffuse._core" and base.__name__ not in suffuse.__all__


def members_of(one):
    found = {}
    for base in reversed([base for base in one.__bases__ if is_inner(base)]):
        found.update(members_of(base))
    found.update(vars(one))
    return found


def lines_of(name, one):
    if inspect.isclass(one):
        bases = [
            base.__name__
            for base in one.__bases__
            if base is not object and "pybind11" not in base.__name__ and not is_inner(base)
        ]
        lines = [f"class {name}({', '.join(bases)})"]
        found = (member(part, what) for part, what in sorted(members_of(one).items()))
        return lines + [f"    {line}" for line in found if line]
    if callable(one):
        return [signature(name, one)]
    return [f"{name}: {type(one).__name__}"]


def interface():
    lines = []
    for name in sorted(suffuse.__all__):
        lines += lines_of(name, getattr(suffuse, name))
    return "".join(f"{line}\n" for line in lines)


def changes():
    """Lines of a comparison with what is kept; none where nothing has changed."""
    kept = KEPT.read_text(encoding="utf-8") if KEPT.exists() else ""
    found = difflib.unified_diff(kept.splitlines(), interface().splitlines(), "kept", "now", lineterm="", n=0)
    return list(found)


def main():
    if sys.argv[1:] == ["--write"]:
        KEPT.write_text(interface(), encoding="utf-8")
        return 0
    if sys.argv[1:]:
        print(__doc__, file=sys.stderr)
        return 2
    found = changes()
    if found:
        print("\n".join([*found, ADVICE]))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
