"""Adds what the program's speed is to bench/history.csv; bench/record.sh calls it."""
import argparse
import csv
import datetime
import json
import os
import pathlib
import re
import resource
import statistics
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[1]
HISTORY = ROOT / "bench/history.csv"
PACKING = ROOT / "tests/reference/packing10k.csv.gz"
ROUNDS = 5
OTHERS = 0.05  # of the processors' time that other programs may take meanwhile
TICK = os.sysconf("SC_CLK_TCK")


def machine():
    """A virtual machine may tell no more of a processor's name than its make: family and model tell which it is."""
    cpuinfo = dict(re.findall(r"^([\w ]+?)\s*: (.*)$", pathlib.Path("/proc/cpuinfo").read_text(), re.M))
    name, family, model = (cpuinfo.get(key, "unknown") for key in ("model name", "cpu family", "model"))
    return f"{name}, family {family} model {model}; {os.cpu_count()} cores"


def commit():
    command = ["git", "-C", ROOT, "describe", "--always", "--dirty", "--abbrev=10", "--exclude=*"]
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout.strip()


def busy():
    """Seconds that all processors have worked, also for other guests of their host."""
    user, nice, system, _, _, irq, softirq, steal = map(int, pathlib.Path("/proc/stat").read_text().split()[1:9])
    return (user + nice + system + irq + softirq + steal) / TICK


def own():
    spent = [resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
    return sum(one.ru_utime + one.ru_stime for one in spent)


def figures(program):
    """Name, unit, and what measures it once."""
    cell = ",".join(map(str, json.loads(PACKING.with_name("packing10k.json").read_text())["cell"]))
    scene = ["--packing", PACKING, "--cell", cell, "--json"]

    def once(kind, *words):
        done = subprocess.run([program, "bench", kind, *scene, *words], capture_output=True, text=True, check=True)
        return json.loads(done.stdout)

    for mode in ("reference", "fast"):
        for threads in (1, 2):
            words = ("--mode", mode, "--threads", str(threads))
            on = "1 thread" if threads == 1 else f"{threads} threads"
            yield f"step, {mode}, {on}", "ns/contact", lambda words=words: once("step", *words)["ns_per_contact"]
    yield "flow, 2 threads", "s", lambda: once("flow", "--threads", "2")["seconds"]["total"]


def main():
    parser = argparse.ArgumentParser(prog="bench/record.sh")
    parser.add_argument("program")
    parser.add_argument("--build", type=float, metavar="SECONDS", help="what a build from nothing took")
    options = parser.parse_args()
    begin, busy_before, own_before = time.monotonic(), busy(), own()
    found = [(name, unit, statistics.median(measure() for _ in range(ROUNDS))) for name, unit, measure in figures(options.program)]
    wall = time.monotonic() - begin
    others = (busy() - busy_before - own() + own_before) / (wall * os.cpu_count())
    if options.build:
        found.append(("build from nothing", "s", options.build))
    rows = [(datetime.date.today().isoformat(), commit(), machine(), name, f"{value:.4g}", unit) for name, unit, value in found]
    csv.writer(sys.stdout, lineterminator="\n").writerows(rows)
    if others > OTHERS:
        sys.exit(f"bench/record.sh: other programs took {others:.0%} of the processors: nothing is added to {HISTORY.name}")
    with open(HISTORY, "a", newline="", encoding="utf-8") as file:
        csv.writer(file, lineterminator="\n").writerows(rows)
    return 0


if __name__ == "__main__":
    sys.exit(main())
