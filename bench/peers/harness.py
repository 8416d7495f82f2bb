"""What every comparison with a peer shares: the case, our side, windows in turn, the processor time each side got, and
ratios with quartiles."""
import argparse
import csv
import gzip
import json
import math
import os
import pathlib
import resource
import statistics
import subprocess
import sys
import time

# A window in which a code got less than this of its processors was disturbed by something else on the machine.
CLEAN = 0.9


def arguments(description):
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("--peer", required=True, choices=["yade", "lammps"])
    parser.add_argument("--program", required=True, help="suffuse, or what answers as it does")
    parser.add_argument("--packing", required=True, help="x,y,z,r table, .csv.gz, with the parameters in the .json next to it")
    parser.add_argument("--output", required=True, type=pathlib.Path, help="CSV to write, a row a window")
    parser.add_argument("--pairs", type=int, default=7)
    parser.add_argument("--threads", type=int, default=2, help="of either code; MPI ranks where the peer has no threads")
    parser.add_argument("--at-least", type=float, default=0, help="exit code 1 where the median ratio is below this")
    return parser


def read_case(packing):
    """The packing and the example's law; the parameters are those that the packing was made with."""
    with gzip.open(packing, "rt") as file:
        grains = [[float(row[c]) for c in "xyzr"] for row in csv.DictReader(file)]
    about = json.loads(pathlib.Path(str(packing).replace(".csv.gz", ".json")).read_text())
    made_with = about["params"]
    material = {k: made_with[k] for k in ("young", "poisson", "density", "alphaKr", "alphaKtw", "etaRoll", "etaTwist")}
    material["frictionAngle"] = math.radians(made_with["phiDeg"])
    return {
        "cell": about["cell"],
        "grains": grains,
        "law": {"material": material, "damping": made_with["damping"]},
        "pressure": 100e3,  # [Pa]
        "time_step": 4.1e-8,  # [s]
        "strain_rate": 10,  # [1/s]
        "settle_steps_at_most": 20000,
        "stress_tolerance": 5e-3,
        "unbalanced_force": 1e-3,
    }


def run_alone(command, **more):
    """A program from its start to its end: its standard output, wall seconds, and seconds of processor time."""
    before, begin = resource.getrusage(resource.RUSAGE_CHILDREN), time.perf_counter()
    done = subprocess.run([str(word) for word in command], stdout=subprocess.PIPE, text=True, **more)
    wall, after = time.perf_counter() - begin, resource.getrusage(resource.RUSAGE_CHILDREN)
    if done.returncode != 0:
        sys.exit(f"{' '.join(str(word) for word in command)}: exit code {done.returncode}; it said:\n{done.stdout[-2000:]}")
    return done.stdout, wall, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def in_turn(pairs, measures):
    """Windows of both codes (A B, B A, A B, ...), so that a slow minute of the machine meets both."""
    windows = []
    for pair in range(pairs):
        for measure in measures[:: 1 if pair % 2 == 0 else -1]:
            time.sleep(0.5)  # the other's threads go to sleep
            window = {"pair": pair, "load_before": os.getloadavg()[0], **measure()}
            window["load_after"] = os.getloadavg()[0]
            windows.append(window)
            say(f"pair {pair + 1}: {window['code']:8} {window['steps_per_second']:.1f} steps/s, processors {window['processors']:.0%}")
    return windows


def of(windows, code):
    return [w for w in windows if w["code"] == code]


def quartiles(values):
    low, middle, high = statistics.quantiles(values, n=4, method="inclusive") if len(values) > 1 else values * 3
    return f"{middle:.4g} ({low:.4g} to {high:.4g})"


def row(title, *cells):
    print(f"{title:30}" + "".join(f"{cell:>36}" for cell in cells))


def print_machine(ours, theirs):
    """Processor time and load; distinguishes the pairs in which both codes had their processors."""
    row("processor time / threads", quartiles([w["processors"] for w in ours]), quartiles([w["processors"] for w in theirs]))
    loads = [w[when] for w in ours + theirs for when in ("load_before", "load_after")]
    clean = [k for k, (s, p) in enumerate(zip(ours, theirs)) if min(s["processors"], p["processors"]) >= CLEAN]
    print(f"\nload average {min(loads):.1f} to {max(loads):.1f}; in {len(clean)} of {len(ours)} pairs both had at least {CLEAN:.0%}")
    return clean


def write_rows(output, columns, windows):
    with open(output, "w", newline="") as file:
        writer = csv.DictWriter(file, columns, extrasaction="ignore")
        writer.writeheader()
        writer.writerows(windows)


def say(text):
    print(text, file=sys.stderr, flush=True)
