"""Flips a bit in the middle of each file: damage.py FILE..."""

import pathlib
import sys

for name in sys.argv[1:]:
    data = bytearray(pathlib.Path(name).read_bytes())
    data[len(data) // 2] ^= 1
    pathlib.Path(name).write_bytes(data)
