#!/usr/bin/env python3
"""Rows of tests/reference/planned_runs.csv from run folders: what each stage took, and how fast the machine was.

tools/record_plans.py RUN... >> tests/reference/planned_runs.csv

The speed is that which the run measured when it began, or --speed: of a run on a machine that others use too, take the
best of several `suffuse plan CASE`, and processor time (--cpu FILE: JSON, "STUDY/STAGE" -> seconds).
"""

import argparse
import json
import pathlib


def case_of(asked):
    """The example that the run is of, wherever it was copied to."""
    parts = pathlib.Path(asked["case"]).parts
    return "/".join(parts[parts.index("examples"):])


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("runs", nargs="+", type=pathlib.Path, metavar="RUN")
    options.add_argument("--speed", type=float)
    options.add_argument("--cpu", type=pathlib.Path)
    given = options.parse_args()
    cpu = json.loads(given.cpu.read_text()) if given.cpu else {}
    for run in given.runs:
        plan = json.loads((run / "plan.json").read_text())
        asked = json.loads((run / "run_options.json").read_text())
        head = [case_of(asked), asked["preset"], ";".join(asked["overrides"]), str(plan["threads"])]
        head.append(f"{given.speed or plan['particle_steps_per_second']:.4g}")
        for stage in plan["stages"]:
            if "steps_taken" in stage:
                seconds = cpu.get(f"{stage['study']}/{stage['stage']}", stage["seconds_taken"])
                print(",".join(head + [stage["stage"], str(stage["steps_taken"]), f"{seconds:.3g}"]))


if __name__ == "__main__":
    main()
