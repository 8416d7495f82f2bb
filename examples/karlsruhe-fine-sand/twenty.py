#!/usr/bin/env python3
"""Twenty sets of parameters from a calibration, as rows of case.toml, and what came out of them.

    python3 twenty.py rows runs/sand          # writes critical-state.csv and gradient.csv
    python3 twenty.py answer runs/questions   # prints mean and range of each result over the rows
"""

import csv
import json
import math
import pathlib
import sys

FINES = 0.1  # of the mass
DENSITY = "medium"  # whose void ratio the sand has
TOP = 0.8  # of the ramp
LAST = 0.05  # strain over which the critical state is averaged


def written(path, rows):
    with open(path, "w", newline="", encoding="utf-8") as file:
        table = csv.DictWriter(file, rows[0], lineterminator="\n")
        table.writeheader()
        table.writerows(rows)


def make_rows(folder):
    import suffuse

    here = pathlib.Path(__file__).resolve().parent
    critical, gradient = [], []
    for sample in suffuse.Calibration(folder).samples(20):
        contact = {key: value for key, value in sample.items() if key.startswith("contact.")}
        skeleton = sample.get("void_ratio", sample.get(f"void_ratio.{DENSITY}"))
        # Fines lie in the pores: of a unit of solids, the sand's share has its pores, less the fines in them.
        filled = (1 - FINES) * skeleton - FINES
        critical.append(contact | {"stage.sample.void_ratio": round(skeleton, 4)})
        gradient.append(contact | {"stage.mixture.void_ratio": round(filled, 4)})
    written(here / "critical-state.csv", critical)
    written(here / "gradient.csv", gradient)


def critical_state(folder):
    """Friction angle [deg] and void ratio, averaged over the last of the strain."""
    with open(folder / "shear/history.csv", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    end = float(rows[-1]["strain_3"])
    angles, ratios = [], []
    for row in rows:
        if float(row["strain_3"]) >= end - LAST:
            sigma = [float(row[f"stress_{k}"]) for k in (1, 2, 3)]
            radial = (sigma[0] + sigma[1]) / 2
            angles.append(math.degrees(math.asin((sigma[2] - radial) / (sigma[2] + radial))))
            ratios.append(float(row["void_ratio"]))
    return sum(angles) / len(angles), sum(ratios) / len(ratios)


def shown(name, values, digits):
    values = sorted(values)
    at = [values[max(0, round(share * (len(values) - 1)))] for share in (0.05, 0.95)]
    mean = sum(values) / len(values)
    print(f"{name:62s} {mean:8.{digits}f}   {at[0]:.{digits}f} to {at[1]:.{digits}f}   of {len(values)} samples")


def answer(run):
    studies = pathlib.Path(run) / "studies"
    states = [critical_state(path.parent.parent) for path in sorted(studies.glob("critical-state/*/shear/stage.json"))]
    shown("critical friction angle [deg]", [state[0] for state in states], 1)
    shown("critical void ratio at 100 kPa", [state[1] for state in states], 3)
    for where, what in (("gradient", ""), ("seeds", ", one set, other grains")):
        found = [json.loads(path.read_text(encoding="utf-8"))["critical_gradient"]
                 for path in sorted(studies.glob(f"{where}/**/upward/stage.json"))]
        for share in ("1 %", "10 %"):
            reached = [one[share] for one in found if one[share] is not None]
            if reached:
                shown(f"gradient that moves {share} of the fines{what}", reached, 2)
            if len(reached) < len(found):
                print(f"  {len(found) - len(reached)} samples do not reach it before {TOP}")


if __name__ == "__main__":
    if len(sys.argv) != 3 or sys.argv[1] not in ("rows", "answer"):
        sys.exit(__doc__)
    make_rows(sys.argv[2]) if sys.argv[1] == "rows" else answer(sys.argv[2])
