#!/usr/bin/python3
"""Do the settings of a migration change what erodes, does a short probe find what migrates, and do few fines without
friction leave as if each were routed alone? The tables of docs/theory/migration.md. Takes an hour."""

import csv
import math
import statistics

import common


def by_stage(run, study):
    """Finished stages of the study by the name of their stage, in the order of samples."""
    found = {}
    for name in sorted(run.stages):
        if name.startswith(study + "/"):
            found.setdefault(name.rsplit("/", 1)[1], []).append(run[name])
    return found


def show_settings(stages):
    """Mass that eroded with each setting halved and doubled, and the change of it in the same sample [% of the fines]."""
    found = {name: [100 * stage["eroded_mass_share"] for stage in rows] for name, rows in stages.items() if "holds" in rows[0]}
    print("| setting | eroded [%] | change [%] | still moving [%] | holds that ended |\n|---|---|---|---|---|")
    for name, eroded in found.items():
        change = [after - before for after, before in zip(eroded, found["as-is"])]
        moving = statistics.fmean(100 * stage["moving_mass_share"] for stage in stages[name])
        ended = sum(stage["holds"][-1]["ended"] for stage in stages[name])
        print(f"| {name} | {statistics.fmean(eroded):.1f} ± {statistics.stdev(eroded):.1f} | {statistics.fmean(change):+.1f} ± "
              f"{statistics.stdev(change) / math.sqrt(len(change)):.1f} | {moving:.1f} | {ended} of {len(eroded)} |")


def departed_by_gradient(stage):
    """Share of the fines' mass that was half a diameter away by the end of each gradient."""
    with open(stage.folder / "ledger.csv", newline="", encoding="utf-8") as file:
        grains = list(csv.DictReader(line for line in file if not line.startswith("#")))
    mass = sum(float(grain["mass"]) for grain in grains)
    return [sum(float(grain["mass"]) for grain in grains if grain["departed"] and float(grain["gradient"]) <= hold["gradient"] + 1e-9) / mass
            for hold in stage["holds"]]


def show_probe(stages):
    """Share that the probe calls mobile at each gradient, and the share that migrates by it, each a mean over samples [%]."""
    gradients = [hold["gradient"] for hold in stages["migrate"][0]["holds"]]
    print("| i | mobile by the probe [%] | departed [%] | eroded [%] | difference of the first two [%] |\n|---|---|---|---|---|")
    for k, gradient in enumerate(gradients):
        mobile = [100 * next(level["mobile_mass_share"] for level in stage["mobility"] if abs(level["gradient"] - gradient) < 1e-9)
                  for stage in stages["ramp"]]
        departed = [100 * departed_by_gradient(stage)[k] for stage in stages["migrate"]]
        eroded = [100 * stage["holds"][k]["eroded_mass_share"] for stage in stages["migrate"]]
        difference = [after - before for after, before in zip(departed, mobile)]
        cells = " | ".join(f"{statistics.fmean(values):.1f} ± {statistics.stdev(values):.1f}" for values in (mobile, departed, eroded, difference))
        print(f"| {gradient:g} | {cells} |")


def show_routing(run):
    """Share of the fines that leaves by single grains that travel, and by migration without friction, a row a soil."""
    print("| size ratio | by the flow's way [%] | migrates [%] | by the widest way [%] | still moving [%] |\n|---|---|---|---|---|")
    for soil in ("ratio-5", "ratio-7"):
        stages = by_stage(run, f"routing/soil={soil}")
        columns = [[100 * stage["eroded_share_of_fines"] for stage in stages["routed"]],
                   [100 * stage["eroded_mass_share"] for stage in stages["migrate"]],
                   [100 * stage["eroded_share_of_fines"] for stage in stages["widest"]],
                   [100 * stage["moving_mass_share"] for stage in stages["migrate"]]]
        print(f"| {soil.removeprefix('ratio-')} | " + " | ".join(", ".join(f"{value:.1f}" for value in values) for values in columns) + " |")


def main():
    given = common.options(__doc__)
    few = {f"study.{study}.replicates": 2 for study in ("settings", "probe")} if given.quick else None
    show_routing(common.conduct(given, "migration_routing", changes={"study.routing.replicates": 1} if given.quick else None))
    run = common.conduct(given, "migration", changes=few)
    show_settings(by_stage(run, "settings"))
    show_probe(by_stage(run, "probe"))


main()
