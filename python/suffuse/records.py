"""Tables of numbers: structured NumPy arrays that know their units, and how other libraries want them."""

import csv
import functools
import importlib
import pathlib

import numpy

from suffuse import _core


@functools.cache
def _units():
    return _core.units()


def unit_of(name):
    """Of a number of stage.json or of a table: its own, else that of the object that it is in, as of "wall_seconds.flow";
    "-" of shares, ratios and counts. A name may carry its unit itself, as "d [mm]" does."""
    if name.endswith("]") and "[" in name:
        return name[name.rindex("[") + 1 : -1]
    units = _units()
    words = name.rpartition("/")[2].split(".")  # "STAGE/void_ratio"
    if "known_error" in words:  # relative, of whatever
        return "-"
    for end in range(len(words), 0, -1):
        for known in (".".join(words[max(end - 2, 0) : end]), words[end - 1]):
            if known in units:
                return units[known]
    return "-"


def library(name, purpose):
    """A library that suffuse does not need itself. @raises ImportError that says what to install."""
    try:
        return importlib.import_module(name)
    except ImportError as error:
        raise ImportError(
            f"{purpose} needs {name}, which this Python has not: install it (Debian: python3-{name}; else pip install {name})"
        ) from error


class Records(numpy.ndarray):
    """A structured array: rows["name"] is a column, rows[0] a row. Numbers are in SI unless `units` says otherwise."""

    def __array_finalize__(self, other):
        self._known_units = getattr(other, "_known_units", {})

    @property
    def units(self):
        """The unit of each column of numbers, "-" of shares, ratios and counts."""
        return {
            name: self._known_units.get(name) or unit_of(name)
            for name in self.dtype.names or ()
            if self.dtype[name].kind != "U"
        }

    def to_pandas(self):
        """A pandas.DataFrame of the same columns; its attrs["units"] has the units."""
        frame = library("pandas", "to_pandas()").DataFrame({name: numpy.asarray(self[name]) for name in self.dtype.names})
        frame.attrs["units"] = self.units
        return frame

    def to_xarray(self):
        """An xarray.Dataset of the same columns along `row`; each has its unit in attrs["units"]."""
        xarray = library("xarray", "to_xarray()")
        units = self.units
        return xarray.Dataset(
            {
                name: ("row", numpy.asarray(self[name]), {"units": units[name]} if name in units else {})
                for name in self.dtype.names
            }
        )


def records_of(columns, units=None):
    """Of columns by name, all of one length. `units` are of columns whose names do not say it."""
    columns = {name: numpy.asarray(column) for name, column in columns.items()}
    rows = max((len(column) for column in columns.values()), default=0)
    table = numpy.empty(rows, [(name, column.dtype) for name, column in columns.items()])
    for name, column in columns.items():
        table[name] = column
    records = table.view(Records)
    records._known_units = units or {}
    return records


def _column(cells):
    """Numbers where all are or lack one, else texts."""
    try:
        return numpy.array([numpy.nan if cell in ("", None) else float(cell) for cell in cells], dtype=float)
    except ValueError:
        return numpy.array(["" if cell is None else cell for cell in cells], dtype=str)


# Columns whose names mean something else, or nothing, in other tables.
_units_of_table = {
    "migration.csv": {"energy": "J", "eroded_mass": "kg", "fed_mass": "kg"},
    "ledger.csv": {
        **dict.fromkeys(("x0", "y0", "z0", "narrowest"), "m"),
        **dict.fromkeys(("entered", "departed", "left"), "s"),
    },
    "profile.csv": {"from": "m", "to": "m"},
    "throats.csv": {"conductance": "m3/(Pa s)"},
}


def read_records(path):
    """A CSV of numbers, and perhaps words; lines that begin with # are remarks."""
    with open(path, newline="", encoding="utf-8") as file:
        rows = list(csv.reader(line for line in file if not line.startswith("#")))
    names, rows = rows[0], rows[1:]
    columns = zip(*rows) if rows else [()] * len(names)
    known = _units_of_table.get(pathlib.Path(path).name)
    return records_of({name: _column(column) for name, column in zip(names, columns)}, known)


def gather(rows, units=None):
    """Of dictionaries: a column for each key of any of them, in the order in which they come; not a number, or an empty
    text, where a row has none."""
    names = list(dict.fromkeys(name for row in rows for name in row))
    return records_of({name: _column([row.get(name) for row in rows]) for name in names}, units)


def numbers_in(values, within=""):
    """The numbers of stage.json by name, those within objects as "response.peak_ratio"."""
    found = {}
    for name, value in values.items():
        if isinstance(value, dict):
            found.update(numbers_in(value, f"{within}{name}."))
        elif isinstance(value, (bool, int, float)):
            found[within + name] = value
    return found
