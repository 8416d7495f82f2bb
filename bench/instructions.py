#!/usr/bin/python3
"""The guard against work that creeps in: instructions of a contact step, a grain step and an iteration of the flow solver.

Counts with callgrind on fixed scenes (bench/count.cpp), as the difference of two runs of different length over the work
between them, and compares with bench/instructions.json: 1 % more or less fails. Valgrind hides AVX-512, so the AVX2 clones
are counted. Counts of another compiler or on a processor without AVX2 say nothing: then it skips, and says why.

    bench/instructions.py build/benchmarks            compare
    bench/instructions.py build/benchmarks --write    make the baseline, after a change that is meant to change it
"""
import json
import pathlib
import re
import signal
import subprocess
import sys
import tempfile

BASELINE = pathlib.Path(__file__).resolve().parent / "instructions.json"
TOLERANCE = 0.01
SKIPPED = 77
# Scene, short run, long run, and what its work is counted by.
SCENES = {"step": (20, 120, ["contact", "grain"]), "flow": (1, 3, ["iteration"])}


def output_of(command):
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}: exit code {done.returncode}\n{done.stderr[-2000:]}")
    return done.stdout, done.stderr


def count(program, scene, n):
    """Instructions of the whole run, and what one time of the work consists of."""
    with tempfile.TemporaryDirectory() as folder:
        command = ["valgrind", "--vgdb=no", "--tool=callgrind", f"--callgrind-out-file={folder}/out", program, scene, str(n)]
        out, err = output_of(command)
    return int(re.search(r"Collected : (\d+)", err).group(1)), json.loads(out)


def measure(program):
    found = {}
    for scene, (short, long, items) in SCENES.items():
        (few, _), (many, parts) = count(program, scene, short), count(program, scene, long)
        once = (many - few) / (long - short)
        found.update({f"{scene}: instructions per {item}": round(once / parts[item], 1) for item in items})
    return found


def compiler(build):
    cache = (build / "CMakeCache.txt").read_text()
    program = re.search(r"^CMAKE_CXX_COMPILER:\w+=(.*)$", cache, re.MULTILINE).group(1)
    return output_of([program, "--version"])[0].splitlines()[0]


def main():
    signal.signal(signal.SIGTERM, lambda number, frame: sys.exit(128 + number))  # the folder of a count goes
    build = pathlib.Path(sys.argv[1])
    program = build / "bench" / "suffuse_count"
    tools = {"compiler": compiler(build), "valgrind": output_of(["valgrind", "--version"])[0].strip()}
    if " avx2 " not in pathlib.Path("/proc/cpuinfo").read_text():
        print("skipped: this processor has no AVX2, so another clone would be counted")
        return SKIPPED
    if "--write" in sys.argv:
        BASELINE.write_text(json.dumps({**tools, "counts": measure(program)}, indent=4) + "\n")
        print(BASELINE.read_text(), end="")
        return 0
    baseline = json.loads(BASELINE.read_text())
    for tool, version in tools.items():
        if version != baseline[tool]:
            print(f"skipped: the baseline is of {baseline[tool]}, this is {version}")
            return SKIPPED
    worst = 0
    for title, found in measure(program).items():
        change = found / baseline["counts"][title] - 1
        worst = max(worst, abs(change))
        print(f"{title:32}{baseline['counts'][title]:>12} before {found:>12} now {change:>+8.2%}")
    if worst > TOLERANCE:
        print(f"more than {TOLERANCE:.0%} off. Meant? Then: bench/instructions.sh --write, and say why in the commit")
    return 1 if worst > TOLERANCE else 0


if __name__ == "__main__":
    sys.exit(main())
