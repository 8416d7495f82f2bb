#!/usr/bin/env python3
"""Rows of tests/reference/planned_runs.csv from run folders: what each stage took, and how fast the machine was.

tools/record_plans.py RUN... >> tests/reference/planned_runs.csv
tools/record_plans.py --preparation RUN...

The second writes the table of suffuse/plan/preparation_price.hpp anew: what preparing samples took in these runs, over
what the plan had expected, for each kind of preparation that they hold; other rows stay.

The speed is that which the run measured when it began, or --speed: of a run on a machine that others use too, take the
best of several `suffuse plan CASE`, and processor time (--cpu FILE: JSON, "STUDY/STAGE" -> seconds).
"""

import argparse
import json
import math
import pathlib
import re
import statistics

TABLE = pathlib.Path(__file__).parent.parent / "suffuse/plan/preparation_price.hpp"
COVERED = 5 / 6  # of the samples seen lie in a row's range, around their median


def case_of(request):
    """The example that the run is of, wherever it was copied to."""
    parts = pathlib.Path(request["case"]).parts
    return "/".join(parts[parts.index("examples"):])


def record_preparation(runs):
    """Fits each row to what the runs took: the planned steps are the row's range times those of the strain."""
    text = TABLE.read_text()
    seen = {}
    for run in runs:
        for stage in json.loads((run / "plan.json").read_text())["stages"]:
            kind = stage["basis"].split(":")[0]
            if "steps_taken" in stage and stage["steps"][1] > 0 and f'{{"{kind}",' in text:
                numbers = json.loads((run / "studies" / stage["study"] / stage["stage"] / "stage.json").read_text())
                if "preparation_trials" not in numbers:
                    tables = stage.get("by_tables", {}).get("steps") or math.sqrt(math.prod(stage["steps"]))
                    seen.setdefault(kind, []).append(stage["steps_taken"] / tables)
    for kind, ratios in seen.items():
        row = re.search(rf'\{{"{kind}", \{{([\d.]+), ([\d.]+)\}}\}}', text)
        middle = statistics.median(ratios)
        off = sorted(max(ratio / middle, middle / ratio) for ratio in ratios)
        factor = off[min(len(off) - 1, math.floor(COVERED * len(off)))]
        planned = math.sqrt(float(row[1]) * float(row[2]))
        least, most = planned * middle / factor, planned * middle * factor
        text = text.replace(row[0], f'{{"{kind}", {{{least:.2g}, {most:.2g}}}}}')
        print(f"{kind}: {least:.2g} to {most:.2g} from {len(ratios)} samples")
    TABLE.write_text(text)


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("runs", nargs="+", type=pathlib.Path, metavar="RUN")
    options.add_argument("--speed", type=float)
    options.add_argument("--use", choices=["fitted", "held", "lent"], default="held")
    options.add_argument("--cpu", type=pathlib.Path)
    options.add_argument("--preparation", action="store_true")
    given = options.parse_args()
    if given.preparation:
        return record_preparation(given.runs)
    cpu = json.loads(given.cpu.read_text()) if given.cpu else {}
    for run in given.runs:
        plan = json.loads((run / "plan.json").read_text())
        request = json.loads((run / "run_options.json").read_text())
        head = [given.use, case_of(request), request["preset"], ";".join(request["overrides"]).replace(",", "|")]
        head += [str(plan["threads"]), str(plan["samples_at_once"])]
        head.append(f"{given.speed or plan['particle_steps_per_second']:.4g}")
        head.append(f"{plan.get('reference_steps_per_second', 0):.4g}")
        for stage in plan["stages"]:
            if "steps_taken" in stage:
                seconds = cpu.get(f"{stage['study']}/{stage['stage']}", stage["seconds_taken"])
                print(",".join(head + [f"{stage['study']}/{stage['stage']}", str(stage["steps_taken"]), f"{seconds:.3g}"]))


if __name__ == "__main__":
    main()
