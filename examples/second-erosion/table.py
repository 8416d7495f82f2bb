#!/usr/bin/env python3
"""Prints the passes of a run as a Markdown table: table.py RUN_FOLDER. Needs nothing but Python's own library."""

import json
import pathlib
import sys


def trace(stress):
    return sum(stress[a][a] for a in range(3))


def row(name, stage_pass):
    probe = stage_pass["probe"]
    contacts = {int(k): n for k, n in stage_pass["coordination_histogram"].items()}
    active = sum(n for k, n in contacts.items() if k >= 2)
    before, still = trace(stage_pass["stress_before"]), trace(stage_pass["stress_constant_volume"])
    cells = [
        name,
        stage_pass["pass"],
        f"{probe['unbalanced_force']:.0e}",
        probe["detachable_by_velocity"],
        probe["detachable_by_displacement"],
        stage_pass["held_back"],
        stage_pass["removed"],
        active,
        f"{stage_pass['eroded_mass_percent_of_initial']:.2f}",
        f"{100 * (1 - still / before):.2g}",
        f"{100 * stage_pass['volumetric_strain']:.2g}",
        f"{stage_pass['porosity_after_removal']:.4f}",
        f"{stage_pass['porosity_after']:.4f}",
    ]
    return "| " + " | ".join(str(c) for c in cells) + " |"


def main():
    stages = json.loads((pathlib.Path(sys.argv[1]) / "summary.json").read_text())["stages"]
    print("| case | pass | unbalance | by velocity | by displacement | held back | removed | of these active | mass [%] | "
          "stress lost [%] | contraction [%] | porosity, removal | porosity, settled |")
    print("|---|---|---|---|---|---|---|---|---|---|---|---|---|")
    for name, numbers in stages.items():
        for stage_pass in numbers.get("passes", []):
            print(row(name.split("/", 1)[1], stage_pass))


if __name__ == "__main__":
    main()
