"""CBOR (RFC 8949) as the program writes it: whole numbers, floats, texts, truth values, null, arrays and maps."""

import struct

from trees import Literal

FLOATS = {25: ">e", 26: ">f", 27: ">d"}
SIMPLE = {20: False, 21: True, 22: None}


class Reader:
    def __init__(self, data):
        self.data, self.at = data, 0

    def take(self, size):
        if self.at + size > len(self.data):
            raise ValueError(f"CBOR ends within a value at byte {self.at}")
        self.at += size
        return self.data[self.at - size:self.at]

    def number(self, low):
        """What the low five bits of the first byte say: a number, or how many bytes of one follow."""
        if low < 24:
            return low
        if low > 27:
            raise ValueError(f"CBOR of unknown length at byte {self.at}")
        return int.from_bytes(self.take(1 << (low - 24)), "big")

    def value(self):
        first = self.take(1)[0]
        kind, low = first >> 5, first & 31
        if kind == 7:
            if low in FLOATS:
                (found,) = struct.unpack(FLOATS[low], self.take(1 << (low - 24)))
                return Literal(repr(found))
            if low in SIMPLE:
                return SIMPLE[low]
            raise ValueError(f"CBOR value {first} at byte {self.at}")
        number = self.number(low)
        if kind in (0, 1):
            return Literal(number if kind == 0 else -1 - number)
        if kind == 2:
            return self.take(number).hex()
        if kind == 3:
            return self.take(number).decode()
        if kind == 4:
            return [self.value() for _ in range(number)]
        if kind == 5:
            return {self.value(): self.value() for _ in range(number)}
        raise ValueError(f"CBOR tag at byte {self.at}")


def decoded(data):
    reader = Reader(data)
    tree = reader.value()
    if reader.at != len(data):
        raise ValueError(f"{len(data) - reader.at} bytes after the CBOR value")
    return tree
