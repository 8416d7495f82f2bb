#!/usr/bin/python3
"""Stress that the fines of gap-graded mixtures carry, over fines content, size ratio and density: stress_share.toml."""

import re

import common

QUICK = {"study.shares.sweep": {"soil": ["ratio-4"], "fines_content": ["20 %", "35 %"]}}
WAYS = ("loose", "dense")


def row_of(run, name):
    """Of a stage shares/soil=ratio-6-5/fc=20/loose."""
    stage = run[name]
    return {
        "ratio": float(re.search(r"ratio-([0-9-]+)", name)[1].replace("-", ".")),
        "fines": int(re.search(r"fc=(\d+)", name)[1]) / 100,
        "way": name.split("/")[-1],
        "grains": stage["grains"],
        "e": stage["void_ratio"],
        "e_g": stage["intergranular_void_ratio"],
        "alpha": stage["alpha_fines"],
        "active": stage["active_fines_fraction"],
        "deviator_stress": stage["deviator_stress"] / stage["mean_stress"],
    }


def chart(rows):
    points = [row | {"soil": f"{row['ratio']:g}", "percent": 100 * row["fines"]} for row in rows]
    return {
        "description": "α over the fines content; solid: dense, dashed: loose; colors: size ratios.",
        "width": 420, "height": 300,
        "data": {"values": points},
        "mark": {"type": "line", "point": True},
        "encoding": {
            "x": {"field": "percent", "type": "quantitative", "title": "fines content [%]", "scale": {"zero": False}},
            "y": {"field": "alpha", "type": "quantitative", "title": "α, stress of the fines over that of the soil [-]"},
            "color": {"field": "soil", "type": "nominal", "title": "size ratio", "sort": ["4", "6.5", "10"]},
            "strokeDash": {"field": "way", "type": "nominal", "sort": ["dense", "loose"], "legend": None},
        },
    }


def main():
    given = common.options(__doc__)
    run = common.conduct(given, "stress_share", changes=QUICK if given.quick else None)
    rows = [row_of(run, name) for name in run.stages if name.split("/")[-1] in WAYS]
    rows.sort(key=lambda row: (row["ratio"], row["way"], row["fines"]))
    common.keep(given, "stress_share", rows)
    print("ratio fines way   grains  e      e_g    alpha  active q/p")
    for row in rows:
        print(
            f"{row['ratio']:5g} {100 * row['fines']:3.0f} %  {row['way']:5} {row['grains']:6}  {row['e']:.3f}  {row['e_g']:.3f}  {row['alpha']:.3f}"
            f"  {row['active']:.2f}   {row['deviator_stress']:.2f}"
        )
    verdict = common.Verdict()
    of = lambda ratio, way, content: next(r["alpha"] for r in rows if (r["ratio"], r["way"], r["fines"]) == (ratio, way, content))
    ratios = sorted({row["ratio"] for row in rows})
    for ratio in ratios:  # what the sources say in words, and what stress equilibrium bounds
        for way in WAYS:
            verdict.at_least(f"ratio {ratio:g}, {way}: alpha at 35 % over that at 20 %", of(ratio, way, 0.35) - of(ratio, way, 0.2), 0)
        verdict.at_least(f"ratio {ratio:g}, 35 %: dense over loose", of(ratio, "dense", 0.35) - of(ratio, "loose", 0.35), 0)
    if not given.quick:
        common.draw(given, "stress_share", chart(rows))
    verdict.end()


main()
