"""Tables of numbers: structured NumPy arrays that know their units, and how other libraries want them."""

import csv
import importlib

import numpy

# Of the names that files of a run give to numbers that have a unit; the others are shares, ratios and counts.
_UNITS = {
    "Pa": "stress mean_stress deviator_stress stress_1 stress_2 stress_3 pressure axial_stress peak_deviator final_deviator "
    "stiffness excess_pore_pressure q p preparation_adhesion",
    "m": "x y z r d diameter radius overlap hydraulic_radius inscribed_radius length constriction constriction_mean "
    "constriction_median constriction_d35 travel progress path distance kenney_lau_split spacing constrictions_by_merge.none "
    "constrictions_by_merge.center constrictions_by_merge.overlap constrictions.mean constrictions.median constrictions.d35 grading.d10 grading.d30 grading.d50 "
    "grading.d60 grading.smallest grading.largest",
    "m2": "area permeability permeability_along permeability_before permeability_after network_permeability "
    "finer_permeability",
    "m3": "volume void_volume",
    "m3/s": "flux",
    "m/s": "vx vy vz mean_velocity",
    "m/s2": "gravity",
    "rad/s": "wx wy wz",
    "rad": "friction_angle preparation_friction angle",
    "N": "fx fy fz fnx fny fnz fsx fsy fsz force_sum force_distribution.mean_normal_force force_distribution.mean_force",
    "N m": "tx ty tz mx my mz",
    "kg": "mass",
    "J": "kinetic_energy",
    "J/m3": "second_order_work energy",
    "s": "time time_step wall_seconds seconds viscous_time",
    "1/s": "strain_rate particle_steps_per_second",
    "1/m": "filter_coefficient",
    "Pa/m": "pressure_gradient",
    "%": "eroded_mass_percent eroded_mass_percent_of_initial fc",
    "-": "count",  # within constrictions_by_merge
}
_UNIT_OF = {name: unit for unit, names in _UNITS.items() for name in names.split()}


def unit_of(name):
    """Of a number of stage.json or of a table: its own, else that of the object that it is in, as of "wall_seconds.flow";
    "-" of shares, ratios and counts. A name may carry its unit itself, as "d [mm]" does."""
    if name.endswith("]") and "[" in name:
        return name[name.rindex("[") + 1 : -1]
    words = name.rpartition("/")[2].split(".")  # "STAGE/void_ratio"
    if "known_error" in words:  # relative, of whatever
        return "-"
    for end in range(len(words), 0, -1):
        for known in (".".join(words[max(end - 2, 0) : end]), words[end - 1]):
            if known in _UNIT_OF:
                return _UNIT_OF[known]
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


def read_records(path):
    """A CSV of numbers, and perhaps words; lines that begin with # are remarks."""
    with open(path, newline="", encoding="utf-8") as file:
        rows = list(csv.reader(line for line in file if not line.startswith("#")))
    names, rows = rows[0], rows[1:]
    columns = zip(*rows) if rows else [()] * len(names)
    return records_of({name: _column(column) for name, column in zip(names, columns)})


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
