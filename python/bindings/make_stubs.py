"""Writes the types of suffuse._core for editors and type checkers, from the docstrings that pybind11 makes: what a
compiled module does not tell them itself.

    PYTHONPATH=<build>/python make_stubs.py <build>/python/suffuse/_core.pyi
"""

import inspect
import pathlib
import re
import sys

import suffuse
from suffuse import _core

HEAD = '''# Made by python/bindings/make_stubs.py.
import os
from collections.abc import Callable, Sequence
from typing import Any, List, Optional, Tuple

import numpy
from numpy.typing import ArrayLike

from suffuse.run import Stage

'''


def split(arguments):
    """At the commas that separate arguments, not those within brackets or texts."""
    parts, depth, quoted = [""], 0, False
    for letter in arguments:
        quoted ^= letter == "'"
        depth += (letter in "([{<") - (letter in ")]}>") if not quoted else 0
        if letter == "," and depth == 0 and not quoted:
            parts.append("")
        else:
            parts[-1] += letter
    return [part.strip() for part in parts if part.strip()]


def type_of(text):
    text = re.sub(r"numpy\.ndarray\[[^\]]*\]", "numpy.ndarray", text.strip())
    text = text.replace("os.PathLike", "str | os.PathLike[str]")
    return re.sub(r"\bsuffuse\.(?:_core\.)?", "", text)


def argument(part):
    """`name: type = default`, whose default is left out: it may not be Python."""
    declared, given, _ = part.partition(" = ")
    name, colon, kind = declared.partition(": ")
    return name + (f": {type_of(kind)}" if colon and name != "self" else "") + (" = ..." if given else "")


def signature(doc):
    """Of the first line of a docstring: name(arguments) -> type."""
    found = re.match(r"\w*\((.*)\) -> (.*)", doc.splitlines()[0])
    arguments = [argument(part) for part in split(found[1])]
    return ["self" if part.startswith("arg0") else part for part in arguments], type_of(found[2])


def quoted(doc, indent):
    lines = (doc or "").strip().splitlines()
    text = f"\n{indent}".join([lines[0], *(line.strip() for line in lines[1:])]) if lines else ""
    return f'{indent}"""{text}"""\n' if text else ""


def function(name, one, indent, decorator=""):
    if inspect.isfunction(one):  # of Python's own, besides those of C++
        return f"{indent}def {name}{inspect.signature(one)}:\n{quoted(one.__doc__, indent + '    ')}{indent}    ...\n"
    arguments, result = signature(one.__doc__)
    signature_text = one.__doc__.partition("\n")[2]
    return (
        f"{decorator}{indent}def {name}({', '.join(arguments)}) -> {result}:\n"
        f"{quoted(signature_text, indent + '    ')}{indent}    ...\n"
    )


def value(name, one):
    made = "" if inspect.isfunction(one.fget) else signature(one.fget.__doc__)[1]
    text = f"    @property\n    def {name}(self) -> {made or 'Any'}:\n{quoted(one.__doc__, ' ' * 8)}        ...\n"
    if one.fset:
        taken = signature(one.fset.__doc__)[0][1].partition(": ")[2]
        kind = {"object": "ArrayLike"}.get(taken, taken)
        text += f"    @{name}.setter\n    def {name}(self, value: {kind}) -> None: ...\n"
    return text


def class_of(name, one):
    bases = [base.__name__ for base in one.__bases__ if base is not object and not base.__name__.startswith("pybind11")]
    text = f"class {name}({', '.join(bases)}):\n" if bases else f"class {name}:\n"
    text += quoted(one.__doc__, "    ")
    for member, what in vars(one).items():
        if isinstance(what, property):
            text += value(member, what)
        elif isinstance(what, staticmethod):
            text += function(member, what.__func__, "    ", "    @staticmethod\n")
        elif member == "__init__" and what.__doc__.startswith("Initialize self"):
            continue  # made by functions, not by users
        elif callable(what) and (not member.startswith("_") or member in ("__init__", "__len__", "__getitem__")):
            text += function(member, what, "    ")
    return text + "    ...\n"


def stubs():
    text = HEAD
    for name, one in sorted(vars(_core).items()):
        if inspect.isclass(one):
            text += class_of(name, one) + "\n"
        elif callable(one):
            text += function(name, one, "") + "\n"
    return text + "__version__: str\n"


if __name__ == "__main__":
    pathlib.Path(sys.argv[1]).write_text(stubs(), encoding="utf-8")
