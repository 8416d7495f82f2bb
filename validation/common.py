"""What the validation scripts share: their options, samples that survive a stop, statistics, figures, the verdict.

Each script is one comparison with others' numbers: ./run validation/NAME.py measures, prints the table that
validation/NAME.md shows, and writes NAME.csv and NAME.svg to build/validation. Samples that are in NAME.csv there
already are not measured again, so that a script that was stopped goes on; delete the file to begin anew.
"""

import argparse
import csv
import json
import math
import pathlib
import shutil
import statistics
import subprocess
import sys
import time

import suffuse

ROOT = pathlib.Path(__file__).resolve().parents[1]
PRESSURE, DENSITY, DIAMETER = 100e3, 2600.0, 0.2e-3  # only their ratios to stiffness and rate matter


def options(description, portions=None, seeds=0):
    """The command line. portions: values by name, of which a table can be made in part, with the first of so many seeds."""
    parser = argparse.ArgumentParser(description=description)
    portions = portions or {}
    for name, values in portions.items():
        parser.add_argument(f"--{name}", type=type(values[0]), choices=values, action="append", help="this alone; may be repeated")
    if portions:
        parser.add_argument("--seeds", type=int, default=seeds, help="the first so many")
        parser.add_argument("--draw", action="store_true", help="show what is there, alone")
    parser.add_argument("--quick", action="store_true", help="fewer and smaller samples: what ./test --long checks")
    parser.add_argument("-o", "--output", type=pathlib.Path, help="folder of results [build/validation]")
    parser.add_argument("-j", "--threads", type=int, default=1, help="threads; they change no bit")
    given = parser.parse_args()
    for name, values in portions.items():
        setattr(given, name, getattr(given, name) or values)
    given.output = given.output or ROOT / "build" / ("validation-quick" if given.quick else "validation")
    given.output.mkdir(parents=True, exist_ok=True)
    suffuse.set_threads(given.threads)
    return given


class Samples:
    """A table NAME.csv of measured samples, a row each, known by the columns of its key. home: another file, unless --quick."""

    def __init__(self, given, name, home=None):
        self.path = home if home and not given.quick else given.output / f"{name}.csv"
        self.rows = []
        if given.quick:
            self.path.unlink(missing_ok=True)  # a test measures
        if self.path.exists():
            with open(self.path, newline="", encoding="utf-8") as file:
                self.rows = [{name: _number(cell) for name, cell in row.items()} for row in csv.DictReader(file)]

    def measure(self, work, **key):
        """The row of `key`, by work(**key), a dictionary of numbers, where it is not there yet."""
        for row in self.rows:
            if all(row[name] == value for name, value in key.items()):
                return row
        begin = time.process_time()
        row = {**key, **work(**key), "seconds": round(time.process_time() - begin, 1)}
        self.add(**row)
        print("  ".join(f"{name} {_text(value)}" for name, value in row.items()), file=sys.stderr, flush=True)
        return self.rows[-1]

    def add(self, **row):
        with open(self.path, "a", newline="", encoding="utf-8") as file:
            writer = csv.DictWriter(file, list(row), lineterminator="\n")
            if not self.rows:
                writer.writeheader()
            writer.writerow({name: _text(value) for name, value in row.items()})
        self.rows.append({name: _number(_text(value)) for name, value in row.items()})  # as it is read back

    def of(self, **key):
        return [row for row in self.rows if all(row[name] == value for name, value in key.items())]

    @property
    def seconds(self):
        return sum(row["seconds"] for row in self.rows)


def conduct(given, name, studies=(), changes=None, until="", folder=""):
    """The run of the case validation/NAME.toml, gone on with where it was stopped. folder: unless it is NAME."""
    case = suffuse.Case(ROOT / "validation" / f"{name}.toml", changes=changes, studies=list(studies))
    return case.run(given.output / (folder or name), until=until, threads=given.threads)


def keep(given, name, rows):
    """Writes the table NAME.csv of rows, dictionaries of the same keys."""
    with open(given.output / f"{name}.csv", "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, list(rows[0]), lineterminator="\n")
        writer.writeheader()
        writer.writerows({key: _text(value) for key, value in row.items()} for row in rows)


def _text(value):
    return f"{value:.6g}" if isinstance(value, float) else str(value)


def _number(cell):
    try:
        return float(cell)
    except ValueError:
        return cell


def mean(rows, name):
    return statistics.fmean(row[name] for row in rows)


def deviation(rows, name):
    """Standard deviation of single samples; 0 for one."""
    return statistics.stdev(row[name] for row in rows) if len(rows) > 1 else 0.0


def stiff(stiffness, **fields):
    """A material without rolling resistance whose stiffness to pressure E/(2 p) is `stiffness` at PRESSURE."""
    return suffuse.Material(
        density=DENSITY, modulus=2 * stiffness * PRESSURE, rolling_stiffness=0, rolling_friction=0, **fields
    )


def rate_of(inertial_number, diameter=DIAMETER):
    """Strain rate of an inertial number I = rate d sqrt(density/pressure) [1/s]."""
    return inertial_number * math.sqrt(PRESSURE / DENSITY) / diameter


def settle(world, pressure, unbalanced):
    """With a drag, for local damping alone would leave slow modes ringing."""
    balance = suffuse.Balance(unbalanced_force=unbalanced, stress_error=1e-3, patience=100)
    world.settle(suffuse.Loading(stress=pressure), balance=balance)


def compact(world, unbalanced=1e-3, **preparation):
    """Compacts by `faithful` to PRESSURE, then settles, with the drag only when grains have come to rest: it would hold
    them in looser packings. The largest inertial number is 6.4e-4 at DIAMETER once the sample carries half of the
    pressure, unless `max_rate` is given."""
    nearly = suffuse.Balance(unbalanced_force=2e-3, stress_error=0.01, patience=200)
    world.compact(PRESSURE, balance=nearly, **preparation)
    settle(world, PRESSURE, unbalanced)


SOFT = 1000.0  # stiffness to pressure at which `densest` compacts


def densest(world, stiffness, unbalanced=1e-3, **preparation):
    """Compacts frictionless grains of stiffness SOFT, then lowers the pressure until the stiffness to pressure is
    `stiffness`: a tenth of the steps of compaction at the lower pressure."""
    compact(world, **preparation)
    factor = 1.0
    while SOFT * factor < stiffness:
        factor = min(3 * factor, stiffness / SOFT)
        settle(world, PRESSURE / factor, unbalanced if SOFT * factor >= stiffness else 1e-3)


def state_of(world):
    """What the tables say of a packing."""
    numbers = world.measure()
    return {
        "solid_fraction": 1 - numbers["porosity"],
        "z_star": numbers["backbone_coordination"],
        "rattlers": numbers["backbone_rattlers"] / numbers["grains"],
        "stiffness_to_pressure": numbers["stiffness_to_pressure"],
        "overlap": numbers["max_overlap_ratio"],
        "unbalanced": numbers["unbalanced_force"],
    }


# ---- figures

LOOK = {
    "font": "Helvetica, Arial, 'DejaVu Sans', sans-serif",
    "background": "white",
    "view": {"stroke": None},
    "axis": {
        "labelFontSize": 11, "titleFontSize": 12, "titleFontWeight": "normal", "titlePadding": 8,
        "labelColor": "#333333", "titleColor": "#111111", "domainColor": "#666666", "tickColor": "#666666",
        "gridColor": "#e4e4e4",
    },
    "legend": {
        "orient": "top", "labelFontSize": 11, "titleFontSize": 11, "titleFontWeight": "normal", "labelLimit": 480,
    },
    "header": {"labelFontSize": 12, "titleFontSize": 12},
    "range": {"category": ["#3b82b8", "#d55e00", "#2a9d74", "#b5669a", "#b5852f", "#7a6fd0"]},
}


def draw(given, name, chart):
    """NAME.vl.json, and NAME.svg from it where ./run has built the report's page."""
    specification = given.output / f"{name}.vl.json"
    chart = {"$schema": "https://vega.github.io/schema/vega-lite/v6.json", "config": LOOK, **chart}
    specification.write_text(json.dumps(chart, indent=1) + "\n", encoding="utf-8")
    tool = ROOT / "build" / "report-page" / "figures.mjs"
    node = shutil.which("node")
    if not tool.exists() or not node:
        print(f"no picture: {tool} or node is missing; any Vega-Lite editor draws {specification}", file=sys.stderr)
        return
    subprocess.run([node, tool, given.output, specification], check=True)
    print(f"{given.output / name}.svg", file=sys.stderr)


# ---- verdict


class Verdict:
    """Acceptance numbers, each met or not; `end` prints them and ends the script with 1 where one is not met."""

    def __init__(self):
        self.lines, self.met = [], True

    def near(self, what, ours, expected, within):
        self._add(f"{what}: {ours:.4g}, expected {expected:.4g} within {within:g}", abs(ours - expected) <= within)

    def between(self, what, ours, low, high):
        self._add(f"{what}: {ours:.4g}, expected {low:g} to {high:g}", low <= ours <= high)

    def at_least(self, what, ours, low):
        self._add(f"{what}: {ours:.4g}, expected {low:g} at least", ours >= low)

    def at_most(self, what, ours, high):
        self._add(f"{what}: {ours:.4g}, expected {high:g} at most", ours <= high)

    def _add(self, line, met):
        self.lines.append(f"{'met    ' if met else 'NOT MET'}  {line}")
        self.met = self.met and met

    def end(self):
        print("\n".join(["", *self.lines]))
        sys.exit(0 if self.met else 1)
