"""CBOR (RFC 8949) as the program writes it: whole numbers, floats, texts, truth values, null, arrays and maps.

A float stays the bytes that stand there, which compare to the bit and cost nothing.
"""

from trees import Literal

FLOATS = {0xF9: 3, 0xFA: 5, 0xFB: 9}  # their first byte, and how many there are
SIMPLE = {0xF4: False, 0xF5: True, 0xF6: None}


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

    def values(self, count):
        """Most arrays are of floats, by the hundred thousand."""
        found, data = [], self.data
        for _ in range(count):
            width = FLOATS.get(data[self.at]) if self.at < len(data) else None
            if width:
                found.append(data[self.at:self.at + width])
                self.at += width
            else:
                found.append(self.value())
        return found

    def value(self):
        first = self.take(1)[0]
        if first in SIMPLE:
            return SIMPLE[first]
        if first in FLOATS:
            return bytes([first]) + self.take(FLOATS[first] - 1)
        kind, number = first >> 5, self.number(first & 31)
        if kind in (0, 1):
            return Literal(number if kind == 0 else -1 - number)
        if kind == 2:
            return self.take(number).hex()
        if kind == 3:
            return self.take(number).decode()
        if kind == 4:
            return self.values(number)
        if kind == 5:
            return {self.value(): self.value() for _ in range(number)}
        raise ValueError(f"CBOR value {first} at byte {self.at}")


def decoded(data):
    reader = Reader(data)
    tree = reader.value()
    if reader.at != len(data):
        raise ValueError(f"CBOR of {len(data)} bytes whose value has {reader.at}")
    return tree
