#!/usr/bin/python3
"""Which bases a filter holds: whole bases packed on it, and single grains among its own, over D15/d, with friction and
without; compared with published boundaries. validation/filters.toml has the samples. --only NAME runs one of its studies."""

import statistics
import sys

import common

WHOLE = ("whole-3", "whole-5", "whole-7", "whole-9", "whole-12")
SINGLE = ("3", "4-2", "5", "5-6", "6-2", "9")
FRICTION = ("37 deg", "0 deg")
MOST_LOST = 0.05  # of the base: as the report has it
# Boundaries of D15/d that could be read: the base is held below the first number, lost above the second.
PUBLISHED = (
    ("Terzaghi: D15/d85", 4, 5),
    ("no-erosion boundary of sands, criterion 7 (Foster and Fell)", 6.8, 10),
    ("retained size 0.11 D15 (Sherard et al. 1984)", 1 / 0.11, 1 / 0.11),
    ("outflow (Tham, UBC)", 7, 8),
    ("interlayer coefficient (10.1016/j.compgeo.2025.107448)", 4, 6),
)


def changes_of(study, quick):
    if not quick:
        return {}
    fewer = {f"study.{study}.replicates": 1, f"study.{study}.stage.flow.hold_at_most": "100 ms"}
    if study == "single":
        fewer["study.single.sweep"] = {"soil": [f"single-{ratio}" for ratio in ("3", "5", "6-2", "9")], "stage.flow.friction": list(FRICTION)}
    return fewer


def ratio_of(name):
    """9 of "whole-9/..." and 4.2 of "single/soil=single-4-2/..."."""
    words = name.split("/")
    last = words[0] if words[0].startswith("whole") else next(word for word in words if word.startswith("soil="))
    return float(last.split("-", 1)[1].replace("-", "."))


def has_friction(name):
    return "friction=37" in name.replace(" ", "")


def rows_of(run):
    """A row for each sample whose flow is done."""
    rows = []
    for name in run.stages:
        if not name.endswith("/flow"):
            continue
        stage = run[name]
        held = 0 if "stack" in stage.numbers else stage["fixed_mass_share"]  # shares of a stack leave its screen out
        rows.append({
            "kind": name.split("/")[0].split("-")[0], "ratio": ratio_of(name), "friction": int(has_friction(name)), "sample": name,
            "passed": stage["eroded_mass_share"] / max(1 - held, 1e-9), "moving": stage["moving_mass_share"],
            "ended": int(all(hold["ended"] for hold in stage["holds"])), "seconds_held": stage["seconds"],
            "depth": stage["holds"][-1]["depth"], "entered": stage["holds"][-1]["entered_mass_share"],
            "overlap": stage["largest_overlap"], "seconds": stage["wall_seconds"],
        })
    return rows


def print_table(rows, kind):
    print(f"\n{kind}: D15/d{'85' if kind == 'whole' else ''}, friction; passed of what is free, still moving, ended of samples, depth, overlap")
    for friction in (1, 0):
        for ratio in sorted({row["ratio"] for row in rows if row["kind"] == kind}):
            some = [row for row in rows if row["kind"] == kind and row["ratio"] == ratio and row["friction"] == friction]
            if some:
                print(
                    f"{ratio:5g}  {'37 deg' if friction else 'none  '}  {100 * common.mean(some, 'passed'):6.2f} ± {100 * common.deviation(some, 'passed'):.2f} %"
                    f"  {100 * common.mean(some, 'moving'):5.1f} %  {sum(row['ended'] for row in some)} of {len(some)}"
                    f"  {1e3 * common.mean(some, 'depth'):.2f} mm  {max(row['overlap'] for row in some):.3f}"
                )


def boundary(rows, kind, friction, share):
    """The largest ratio of which at most `share` passes, and the smallest of which more does; means over the seeds."""
    passed = {}
    for row in rows:
        if row["kind"] == kind and row["friction"] == friction:
            passed.setdefault(row["ratio"], []).append(row["passed"])
    held = [ratio for ratio, values in passed.items() if statistics.fmean(values) <= share]
    lost = [ratio for ratio, values in passed.items() if statistics.fmean(values) > share]
    return max(held, default=float("nan")), min(lost, default=float("nan"))


def main():
    only = sys.argv.pop(sys.argv.index("--only") + 1) if "--only" in sys.argv else None
    if only:
        sys.argv.remove("--only")
    given = common.options(__doc__)
    studies = [only] if only else ["single", *(WHOLE[:3] if given.quick else WHOLE)]
    rows = []
    for study in studies:
        rows += rows_of(common.conduct(given, "filters", [study], changes_of(study, given.quick), folder=f"filters/{study}"))
    common.keep(given, "filters", rows)
    verdict = common.Verdict()
    for kind, share in (("single", 0.5), ("whole", MOST_LOST)):
        print_table(rows, kind)
        for friction in (1, 0):
            held, lost = boundary(rows, kind, friction, share)
            print(f"{kind}, {'with' if friction else 'without'} friction: at most {100 * share:g} % pass up to {held:g}, more from {lost:g}")
    print("\npublished: held up to, lost from")
    for words, held, lost in PUBLISHED:
        print(f"{held:5.1f} {lost:5.1f}  {words}")
    for friction in (1, 0):
        finest = [row for row in rows if row["kind"] == "single" and row["ratio"] == 3 and row["friction"] == friction]
        if finest:
            verdict.at_most(f"single grains of D15/d = 3, {'with' if friction else 'without'} friction: passed", common.mean(finest, "passed"), 0.2)
    whole = [row for row in rows if row["kind"] == "whole" and row["ratio"] == 3 and row["friction"] == 1]
    if whole:
        verdict.at_most("whole bases of D15/d85 = 3, with friction: passed", max(row["passed"] for row in whole), MOST_LOST)
    verdict.end()


main()
