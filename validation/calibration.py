#!/usr/bin/env python3
"""Calibrations of curves that the program made itself: are the parameters found, and are their intervals honest?

Truths are drawn by a fixed seed before anything is fitted, from the inner 70 % of the ranges; none that fails is
dropped. Each is tested at 100 and 400 kPa, with grains and seeds of its own, as a laboratory has a specimen for each
test. It is then calibrated from the two curves with its void ratio unknown. The first round of samples is the same for
all truths and computed once. The first truths are also calibrated from the deviator stress at 100 kPa alone.

Prints truth, mean and interval of each parameter, how many intervals cover their truth, and the errors. Ends with 1 where
intervals cover too few, or stresses at one pressure seem to identify rolling resistance.
"""

import argparse
import csv
import json
import math
import pathlib
import random
import subprocess
import sys
import tempfile

RANGES = {  # key: least, most, whether logarithmic, unit in SI
    "contact.modulus": (50e6, 2e9, True),
    "contact.friction": (math.radians(18), math.radians(45), False),
    "contact.rolling_friction": (0.02, 0.6, False),
    "void_ratio": (0.58, 0.80, False),
}
PROTOTYPE = {  # root mean square errors of the table in LABORATORY.md, void ratio unknown; of a modulus: of its logarithm
    "contact.modulus": math.log(1.03),
    "contact.friction": math.radians(2.4),
    "contact.rolling_friction": 0.029,
    "void_ratio": 0.021,
}
HEAD = """schema = 1
seed = {seed}
mode = "fast"
[grain]
density = "2650 kg/m^3"
[contact]
shear_ratio = 0.42
rolling_stiffness = 7.5
{contact}
[soil.sand]
psd = {{ d = ["0.1 mm", "0.14 mm", "0.2 mm"], passing = ["0 %", "50 %", "100 %"] }}
"""
TRUTH = """[study.{name}]
soil = "sand"
particles = {particles}
sweep = {{ seed = [{seed}] }}
[[study.{name}.stage]]
name = "cloud"
do = "pack"
[[study.{name}.stage]]
name = "sample"
do = "compact"
pressure = "{pressure} kPa"
protocol = "swift"
void_ratio = {void_ratio!r}
void_ratio_tolerance = 0.005
[[study.{name}.stage]]
name = "test"
do = "triaxial"
strain = 0.11
inertial_number = 2e-3
rows = 200
"""
UNKNOWNS = ('"contact.modulus" = ["50 MPa", "2 GPa", "log"], "contact.friction" = ["18 deg", "45 deg"], '
            '"contact.rolling_friction" = [0.02, 0.6], void_ratio = [0.58, 0.8]')
PRESSURES = {"low": 100, "high": 400}  # kPa
SCATTER = 0.01  # of measurements: simulated ones have no errors, and the program takes no smaller ones for stresses


def draw_truth(stream):
    truth = {}
    for key, (least, most, is_log) in RANGES.items():
        share = 0.15 + 0.7 * stream.random()
        truth[key] = least * (most / least) ** share if is_log else least + share * (most - least)
    return truth


def make_tests(program, folder, truth, particles, seed):
    """Runs the tests of a truth; their record, with strains over the length of the start."""
    contact = (f'modulus = "{truth["contact.modulus"]!r} Pa"\nfriction = "{truth["contact.friction"]!r} rad"\n'
               f'rolling_friction = {truth["contact.rolling_friction"]!r}')
    case = HEAD.format(seed=seed, contact=contact) + '[output]\nformats = ["csv"]\nsnapshots = "none"\n'
    for k, (name, pressure) in enumerate(PRESSURES.items()):
        case += TRUTH.format(name=name, particles=particles, seed=seed + k, pressure=pressure,
                             void_ratio=truth["void_ratio"])
    (folder / "truth.toml").write_text(case)
    run(program, folder, ["run", "truth.toml", "-o", "truth", "--no-cache", "-q"])
    lines = ["test,axial strain [%],q [kPa],volumetric strain [%]"]
    for name in PRESSURES:
        with open(next(folder.glob(f"truth/studies/{name}/**/test/history.csv"))) as table:
            for row in csv.DictReader(table):
                strain = [float(row[f"strain_{k}"]) for k in (1, 2, 3)]
                stress = [float(row[f"stress_{k}"]) for k in (1, 2, 3)]
                q = stress[2] - (stress[0] + stress[1]) / 2
                lines.append(f"{name},{-100 * math.expm1(-strain[2])!r},{q / 1e3!r},{-100 * math.expm1(-sum(strain))!r}")
    (folder / "tests.csv").write_text("\n".join(lines) + "\n")
    stresses = [",".join(line.split(",")[:3]) for line in lines]
    (folder / "stresses.csv").write_text("\n".join(stresses) + "\n")


def calibrate(program, folder, name, given, targets):
    table = (f'[calibrate]\nsoil = "sand"\nparticles = {given.particles}\nsamples = {given.samples}\n'
             f"targets = [{targets}]\nunknowns = {{ {UNKNOWNS} }}\n")
    (folder / f"{name}.toml").write_text(HEAD.format(seed=given.seed, contact="") + table)
    run(program, folder, ["calibrate", f"{name}.toml", "-o", name, "-q", "--cache", "../cache"])
    return json.loads((folder / name / "calibration.json").read_text())


def run(program, folder, words):
    done = subprocess.run([program, *words], cwd=folder, capture_output=True, text=True, stdin=subprocess.DEVNULL)
    if done.returncode not in (0, 1, 4):
        sys.exit(f"{' '.join(words)}: exit code {done.returncode}\n{done.stderr}")


def target(name, file, more=""):
    return (f'{{ name = "{name}", file = "{file}", sample = "{name}", pressure = "{PRESSURES[name]} kPa", '
            f'contraction = "positive", scatter = {SCATTER}{more} }}')


def on_scale(key, value):
    return math.log(value) if RANGES[key][2] else value


def compare(truth, found):
    """Prints the parameters. @return for each: whether its interval covers the truth, error of the mean, half-width"""
    rows = {}
    for key, true in truth.items():
        p = found["parameters"][key]
        is_in = p["low"] <= true <= p["high"]
        rows[key] = (is_in, on_scale(key, p["mean"]) - on_scale(key, true),
                     (on_scale(key, p["high"]) - on_scale(key, p["low"])) / 2)
        print(f"{key:26s} {true:10.4g} {p['mean']:10.4g}  {p['low']:10.4g} {p['high']:10.4g}  {p['information']:4.1f} bit  "
              f"{'covered' if is_in else 'MISSED'}{'' if p['identified'] else ', not identified'}", flush=True)
    return rows


def judge(rows):
    """Prints what all truths say. @return whether coverage, widths and errors are as they should be"""
    covered = sum(row[key][0] for row in rows for key in row)
    intervals = len(rows) * len(RANGES)
    least = math.ceil(intervals * 39 / 48)  # of twelve truths; 43 are expected
    print(f"{covered} of {intervals} intervals cover their truth; at least {least} should")
    print(f"{'parameter':26s}  covered  rms error  / prototype's  half-width / rms error")
    passed = {"coverage": covered >= least, "half-widths": True, "errors": True}
    for key in RANGES:
        rms = math.sqrt(sum(row[key][1] ** 2 for row in rows) / len(rows))
        half = sum(row[key][2] for row in rows) / len(rows)
        print(f"{key:26s}  {sum(row[key][0] for row in rows):7d} {rms:10.4g} {rms / PROTOTYPE[key]:14.2f} {half / rms:23.2f}")
        passed["half-widths"] &= half <= 3 * rms
        passed["errors"] &= rms <= 1.5 * PROTOTYPE[key]
    print(", ".join(f"{name}: {'passed' if is_good else 'FAILED'}" for name, is_good in passed.items()))
    return passed["coverage"]


def compare_sizes(truth, program, top, given, targets):
    """The same truth from samples of several sizes. @return whether each mean lies in all of the intervals"""
    found = []
    for particles in given.sizes:
        print(f"samples of {particles} grains:")
        own = argparse.Namespace(**(vars(given) | {"particles": particles}))
        found.append(calibrate(program, top / "truth-1", f"both-{particles}", own, targets))
        compare(truth, found[-1])
    is_same = True
    for key in truth:
        parameters = [one["parameters"][key] for one in found]
        apart = max(p["mean"] for p in parameters) - min(p["mean"] for p in parameters)
        width = min(p["high"] - p["low"] for p in parameters)
        is_in = all(p["low"] <= other["mean"] <= p["high"] for p in parameters for other in parameters)
        print(f"{key:26s} means differ by {apart / width:.2f} of the narrower interval: {'within' if is_in else 'BEYOND'}")
        is_same &= is_in
    return is_same


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--program", default="suffuse")
    parser.add_argument("--draw", type=int, default=5701, help="seed of the truths")
    parser.add_argument("--seed", type=int, default=1, help="of the samples")
    parser.add_argument("--truths", type=int, default=12)
    parser.add_argument("--grains", type=int, default=4000, help="of a truth")
    parser.add_argument("--particles", type=int, default=1000, help="of a sample")
    parser.add_argument("--samples", type=int, default=64, help="of each target")
    parser.add_argument("--stress-alone", type=int, default=4, help="truths that are also fitted by stresses at 100 kPa")
    parser.add_argument("--sizes", type=int, nargs="+", metavar="GRAINS",
                        help="of samples: the first truth alone, calibrated with each of them")
    parser.add_argument("--folder", help="keeps all runs; truths that are there are not computed again")
    given = parser.parse_args()
    program = str(pathlib.Path(given.program).resolve()) if "/" in given.program else given.program
    stream = random.Random(given.draw)
    truths = [draw_truth(stream) for _ in range(given.truths)]
    with tempfile.TemporaryDirectory() as name:
        top = pathlib.Path(given.folder or name)
        for k, truth in enumerate(truths[:1] if given.sizes else truths):
            folder = top / f"truth-{k + 1}"
            folder.mkdir(parents=True, exist_ok=True)
            if not (folder / "tests.csv").exists():
                make_tests(program, folder, truth, given.grains, given.draw * 100 + 2 * k)
        print(f"{'parameter':26s} {'truth':>10s} {'mean':>10s}  {'5 %':>10s} {'95 %':>10s}", flush=True)
        both = target("low", "tests.csv") + ", " + target("high", "tests.csv", ', void_ratio_of = "low"')
        if given.sizes:
            sys.exit(not compare_sizes(truths[0], program, top, given, both))
        rows = [compare(truth, calibrate(program, top / f"truth-{k + 1}", "both", given, both))
                for k, truth in enumerate(truths)]
        is_good = judge(rows)
        for k in range(min(given.stress_alone, given.truths)):
            alone = calibrate(program, top / f"truth-{k + 1}", "alone", given, target("low", "stresses.csv"))
            print(f"stresses at 100 kPa alone, truth {k + 1}:")
            compare(truths[k], alone)
            is_good &= not alone["parameters"]["contact.rolling_friction"]["identified"]
    sys.exit(not is_good)


if __name__ == "__main__":
    main()
