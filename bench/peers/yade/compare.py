#!/usr/bin/python3
"""One time step against Yade's, on one packing, with one law, on the same threads, measured in turn in one run.

Yade settles the packing once and stays alive; each of our windows is one call of `suffuse bench step`, which settles
the same packing itself. Windows alternate (Y S, S Y, Y S, ...), so that a slow minute of the machine meets both.
Called by step_vs_yade.sh; writes a row a window to --output, and prints ratios with quartiles beside the physics of both.
"""
import argparse
import csv
import gzip
import json
import math
import os
import pathlib
import statistics
import subprocess
import sys
import time

HERE = pathlib.Path(__file__).resolve().parent
PHYSICS = ["grains", "contacts", "void_ratio", "coordination", "stress_1", "stress_2", "stress_3", "unbalanced_force_yade"]


def read_arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", required=True, help="suffuse, or what answers as it does")
    parser.add_argument("--packing", required=True, help="x,y,z,r table, .csv.gz, with the parameters in the .json beside it")
    parser.add_argument("--output", required=True, help="CSV to write, a row a window")
    parser.add_argument("--pairs", type=int, default=7)
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--yade-steps", type=int, default=500, help="steps of one of Yade's windows")
    parser.add_argument("--steps", type=int, default=5000, help="steps of one of our windows")
    parser.add_argument("--at-least", type=float, default=0, help="exit code 1 where the median ratio is below this")
    return parser.parse_args()


def read_case(packing):
    """The packing and the example's law, as step.py wants them; the parameters are those the packing was made with."""
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


class Yade:
    def __init__(self, case_file, threads):
        command = ["yade", "-n", "-x", f"-j{threads}", str(HERE / "step.py"), str(case_file)]
        environment = {**os.environ, "OMP_PROC_BIND": "true"}
        self.process = subprocess.Popen(
            command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, env=environment
        )
        self.said = []

    def ask(self, command):
        self.process.stdin.write(command + "\n")
        self.process.stdin.flush()
        for line in self.process.stdout:
            if line.startswith("@"):
                return json.loads(line[1:])
            self.said.append(line)
        sys.exit("Yade ended early; it said:\n" + "".join(self.said[-20:]))

    def measure(self, steps):
        found = self.ask(f"window {steps}")
        found.update({f"stress_{a + 1}": found["stress"][a] for a in range(3)})
        return {"code": "yade", "steps_per_second": steps / found["seconds"], **found}


def measure_ours(options, case, packing_csv):
    cell = ",".join(repr(edge) for edge in case["cell"])
    command = [options.program, "bench", "step", "--packing", str(packing_csv), "--cell", cell]
    command += ["--steps", str(options.steps), "--threads", str(options.threads), "--json"]
    done = subprocess.run(command, stdout=subprocess.PIPE, text=True)
    if done.returncode != 0:
        sys.exit(f"{' '.join(command)}: exit code {done.returncode}")
    found = json.loads(done.stdout)
    stress = found.get("stress", [])
    found.update({f"stress_{a + 1}": row[a] if isinstance(row, list) else row for a, row in enumerate(stress)})
    return {"code": "suffuse", **found}


def quartiles(values):
    low, middle, high = statistics.quantiles(values, n=4, method="inclusive") if len(values) > 1 else values * 3
    return f"{middle:.4g} ({low:.4g} to {high:.4g})"


def shown(value):
    return f"{value:.5g}" if isinstance(value, (int, float)) else "-"


def print_result(options, windows):
    yade, ours = ([w for w in windows if w["code"] == code] for code in ("yade", "suffuse"))
    print(f"{'median (quartiles)':28}{'suffuse':>34}{'Yade':>34}{'ratio, pair by pair':>34}")
    ratios = {}
    for title, rate in {
        "steps/s": lambda w: w["steps_per_second"],
        "contacts x steps/s": lambda w: w["steps_per_second"] * w["contacts"],
    }.items():
        ratios[title] = [rate(s) / rate(y) for s, y in zip(ours, yade)]
        cells = (quartiles([rate(w) for w in ours]), quartiles([rate(w) for w in yade]), quartiles(ratios[title]))
        print(f"{title:28}" + "".join(f"{cell:>34}" for cell in cells))
    print(f"\n{'state after the last window':28}{'suffuse':>34}{'Yade':>34}{'relative difference':>34}")
    for name in PHYSICS:
        s, y = ours[-1].get(name), yade[-1].get(name)
        difference = f"{s / y - 1:+.2%}" if isinstance(s, (int, float)) and y else "-"
        print(f"{name:28}{shown(s):>34}{shown(y):>34}{difference:>34}")
    print(f"\n{options.threads} threads; windows of {options.steps} (ours) and {options.yade_steps} (Yade) steps, in turn")
    return statistics.median(ratios["steps/s"])


def main():
    options = read_arguments()
    case = read_case(options.packing)
    output = pathlib.Path(options.output)
    output.parent.mkdir(parents=True, exist_ok=True)
    case_file, packing_csv = output.with_suffix(".case.json"), output.with_suffix(".packing.csv")
    case_file.write_text(json.dumps(case))
    packing_csv.write_bytes(gzip.open(options.packing).read())

    yade = Yade(case_file, options.threads)
    print(f"Yade settles {len(case['grains'])} grains ...", file=sys.stderr, flush=True)
    settled = yade.ask("settle")
    print(f"... {settled['steps']} steps, {settled['seconds']:.0f} s, quiet: {settled['quiet']}", file=sys.stderr)
    measure_both = [lambda: yade.measure(options.yade_steps), lambda: measure_ours(options, case, packing_csv)]
    windows = []
    for pair in range(options.pairs):
        for measure in measure_both[:: 1 if pair % 2 == 0 else -1]:
            time.sleep(0.5)  # the other's threads go to sleep
            windows.append({"pair": pair, **measure()})
            print(f"pair {pair + 1}: {windows[-1]['code']} {windows[-1]['steps_per_second']:.1f} steps/s", file=sys.stderr)
    yade.process.stdin.close()

    columns = ["pair", "code", "steps_per_second", *PHYSICS]
    with open(output, "w", newline="") as file:
        writer = csv.DictWriter(file, columns, extrasaction="ignore")
        writer.writeheader()
        writer.writerows(windows)
    sys.exit(1 if print_result(options, windows) < options.at_least else 0)


if __name__ == "__main__":
    main()
