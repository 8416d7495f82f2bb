"""Trees of what files hold, and the places where two of them differ.

A tree is made of dictionaries, lists, texts, truth values, None, floats as CBOR has them (bytes), and the two kinds of
leaves below.
"""

import dataclasses
import struct


class Literal(str):
    """A number as it is written: 1.0 is not 1, and neither is the text "1"."""

    def __eq__(self, other):
        return isinstance(other, Literal) and str.__eq__(self, other)

    def __ne__(self, other):
        return not self == other

    __hash__ = str.__hash__


@dataclasses.dataclass(frozen=True)
class Array:
    """Values of one type, compared to the bit; `kind` is a letter of the module `struct`."""

    kind: str
    shape: tuple
    data: bytes

    def values(self):
        return memoryview(self.data).cast(self.kind)

    def place_of(self, index):
        """Row, column and so on of a value, counted from 0."""
        place = []
        for size in reversed(self.shape):
            index, at = divmod(index, size)
            place.insert(0, at)
        return place


class Absent:
    """Stands where one of two trees has nothing."""

    def __repr__(self):
        return "nothing"


ABSENT = Absent()


@dataclasses.dataclass(frozen=True)
class Difference:
    path: tuple
    before: object
    after: object

    def __str__(self):
        return f"{'/'.join(map(str, self.path)) or 'the whole'}: {shown(self.before)} | {shown(self.after)}"


def shown(value):
    if isinstance(value, dict):
        return f"a table of {len(value)}"
    if isinstance(value, list):
        return f"a list of {len(value)}"
    if isinstance(value, Array):
        return f"an array {value.kind} {' x '.join(map(str, value.shape))}"
    if isinstance(value, bytes):
        (value,) = struct.unpack({3: ">xe", 5: ">xf", 9: ">xd"}[len(value)], value)
    text = str.__str__(value) if isinstance(value, Literal) else repr(value)
    return text if len(text) <= 80 else f"{text[:40]} ... {text[-30:]}"


def differences_of_arrays(before, after, path):
    if (before.kind, before.shape) != (after.kind, after.shape):
        return [Difference(path, before, after)]
    width = before.values().itemsize
    found = []
    for index, (one, other) in enumerate(zip(before.values(), after.values())):
        at = slice(index * width, (index + 1) * width)
        if before.data[at] != after.data[at]:
            found.append(Difference((*path, *before.place_of(index)), one, other))
    return found


def blanked(tree):
    """The same form, without what stands in it."""
    if isinstance(tree, dict):
        return {key: blanked(value) for key, value in tree.items()}
    if isinstance(tree, list):
        return [blanked(value) for value in tree]
    return tree if tree is None or tree is ABSENT else "masked"


def differences(before, after, masks, path=()):
    """All places where the trees differ, in their order. `masks` says whether a place is "gone", which is not
    looked at, or "blank", of which the form alone is compared."""
    if type(before) is type(after) and before == after:
        return []
    mask = masks(path)
    if mask == "gone":
        return []
    if mask == "blank":
        return differences(blanked(before), blanked(after), lambda path: None, path)
    if type(before) is not type(after):
        return [Difference(path, before, after)]
    if isinstance(before, dict):
        found = []
        for key in [*before, *(key for key in after if key not in before)]:
            found += differences(before.get(key, ABSENT), after.get(key, ABSENT), masks, (*path, key))
        return found
    if isinstance(before, list):
        found = [Difference((*path, "length"), len(before), len(after))] if len(before) != len(after) else []
        for index, (one, other) in enumerate(zip(before, after)):
            found += differences(one, other, masks, (*path, index))
        return found
    if isinstance(before, Array):
        return differences_of_arrays(before, after, path)
    return [Difference(path, before, after)]
