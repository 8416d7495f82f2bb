#!/usr/bin/python3
"""Gradients that move the fines of gap-graded soils and of a uniform sand: critical_gradient.toml, with Skempton and Brogan's line."""

import math
import re
import statistics

import common

QUICK = {"study.gaps.sweep": {"soil": ["ratio-6-5"], "fines_content": ["5 %"]}}
SEEDS = {"study.gaps.sweep": {"soil": ["ratio-6-5"], "fines_content": ["10 %"]}, "study.gaps.replicates": 5}
STEP = 0.075  # of the ramps in critical_gradient.toml, which the program refines
SOFTER = 1e-4  # a tenth of the K that scales forces: curves may not depend on it
COLUMNS = {
    "grains": "grains", "e": "void_ratio", "alpha": "alpha_fines", "i_c": "heave_gradient",
    "alpha_i_c": "skempton_brogan_gradient", "fines_i_c": "fines_heave_gradient",
    "load_bearing": "load_bearing_mass_share", "sifting": "sifting_mass_share",
}
NAN = math.nan


def row_of(run, name):
    """What a ramp of gradients found, by its stage gaps/soil=ratio-6-5/fc=10/loose-upward, wide/fc=5/... or sand/..."""
    stage = run[name]
    ratio = re.search(r"ratio-([0-9-]+)", name)
    content = re.search(r"fc=(\d+)", name)
    row = {
        "ratio": float(ratio[1].replace("-", ".")) if ratio else 10.0 if name.startswith("wide") else NAN,
        "fines": int(content[1]) / 100 if content else round(stage["fines_content"], 2),
        "way": name.split("/")[-1].removesuffix("-upward"),
    }
    row |= {column: stage[key] for column, key in COLUMNS.items()}
    gradients = stage["critical_gradient"]
    row |= {f"i{share.split()[0]}": NAN if value is None else value for share, value in gradients.items()}
    row["still_moving"] = max(level["still_moving"] for level in stage["mobility"])
    return row | {f"at_{gradient:.3f}": share for gradient, share in given_levels(stage).items()}


def of_case(gradients):
    """Indices of the gradients that the case gives, known by their step, without those that refine the ramp."""
    steps = {k: gradient / STEP for k, gradient in enumerate(gradients)}
    return {round(step): k for k, step in steps.items() if abs(step - round(step)) < 1e-6}


def given_levels(stage):
    ramp = stage["mobility"]
    found = of_case([level["gradient"] for level in ramp])
    return {STEP * step: ramp[k]["mobile_mass_share"] for step, k in found.items()}


def differences_of_softer(run, name):
    """Differences of the mobile share by K and by a tenth of it: (gradient, difference, whether the motion ended by both)
    for each gradient of the case that both reached. A share whose motion had not ended is a lower bound, of no curve."""
    ramp = run[name]["mobility"]
    found = of_case([level["gradient"] for level in ramp])
    softer = run[name.removesuffix("-upward")].world.mobility(
        [STEP * step for step in found], direction="z", down="-z", softness=SOFTER
    )
    softly = of_case(softer["gradient"])
    return [
        (
            STEP * step,
            abs(ramp[found[step]]["mobile_mass_share"] - softer["mobile_mass_share"][softly[step]]),
            not (ramp[found[step]]["still_growing"] or softer["still_growing"][softly[step]]),
        )
        for step in sorted(found.keys() & softly.keys())
    ]


def name_of(row):
    return f"ratio {row['ratio']:g}, {row['way']}" if math.isfinite(row["ratio"]) else f"uniform sand, {row['way']}"


def chart(rows):
    points = [
        {"alpha": row["alpha"], "share": row["i1"] / row["i_c"], "soil": name_of(row), "content": f"{100 * row['fines']:.0f} %"}
        for row in rows if math.isfinite(row["i1"])
    ]
    x = {"field": "alpha", "type": "quantitative", "title": "α, stress of the fines over that of the soil [-]"}
    y = {"field": "share", "type": "quantitative", "title": "gradient that moves 1 % of the fines / i_c [-]"}
    return {
        "description": "Gradient that moves 1 % of the fines over Terzaghi's, against α; the line is Skempton and Brogan's.",
        "width": 420, "height": 320,
        "layer": [
            {"data": {"values": [{"alpha": 0, "share": 0}, {"alpha": 1, "share": 1}]},
             "mark": {"type": "line", "strokeDash": [5, 4], "color": "#666666"}, "encoding": {"x": x, "y": y}},
            {"data": {"values": points}, "mark": {"type": "point", "filled": True, "size": 55, "opacity": 0.85},
             "encoding": {"x": x, "y": y, "color": {"field": "soil", "type": "nominal", "title": None, "legend": {"orient": "right"}},
                          "shape": {"field": "content", "type": "nominal", "title": "fines", "legend": {"orient": "right"},
                                    "sort": ["5 %", "10 %", "20 %", "30 %", "35 %"]}}},
        ],
    }


def main():
    given = common.options(__doc__)
    if given.quick:
        run = common.conduct(given, "critical_gradient", ["gaps"], QUICK, until="dense-upward")
    else:
        run = common.conduct(given, "critical_gradient")
    ramps = sorted(name for name in run.stages if name.endswith("-upward"))
    rows = sorted((row_of(run, name) for name in ramps), key=lambda row: (str(row["ratio"]).zfill(5), row["fines"], row["way"]))
    common.keep(given, "critical_gradient", rows)
    print("soil                 fines grains  e      i_c   alpha  a i_c  FC i_c/s  i1    i10   i50   i1/i_c")
    for row in rows:
        print(
            f"{name_of(row):20} {100 * row['fines']:3.0f} % {row['grains']:6}  {row['e']:.3f}  {row['i_c']:.2f}  {row['alpha']:.3f}  {row['alpha_i_c']:.2f}"
            f"   {row['fines_i_c']:.2f}      {row['i1']:.2f}  {row['i10']:.2f}  {row['i50']:.2f}  {row['i1'] / row['i_c']:.2f}"
        )

    verdict = common.Verdict()
    softer = ["gaps/soil=ratio-6-5/fc=5/dense-upward"] + ([] if given.quick else ["gaps/soil=ratio-3-5/fc=20/dense-upward"])
    for name in softer:
        found = differences_of_softer(run, name)
        print(f"{name}: difference of K and K/10", *(f"{i:.3f} {share:.4f}{'' if ended else ' moving'}" for i, share, ended in found))
        ended = [share for _, share, ended in found if ended]
        verdict.at_least(f"{name}: gradients whose motion ended by K and K/10", len(ended), 3)
        verdict.at_most(f"{name}: their curves of K and K/10 differ by", max(ended), 0.05)
    if given.quick:
        verdict.at_most("ratio 6.5, 5 % fines: i1/i_c", rows[0]["i1"] / rows[0]["i_c"], 0.3)
    else:
        share = lambda stage: (stage["critical_gradient"]["1 %"] or math.inf) / stage["heave_gradient"]
        seeds = common.conduct(given, "critical_gradient", ["gaps"], SEEDS, "dense-upward", "critical_gradient_seeds")
        shares = [share(seeds[name]) for name in sorted(seeds.stages) if name.endswith("-upward")]
        print("ratio 6.5, 10 % fines, dense: i1/i_c of five seeds", *(f"{value:.3f}" for value in shares))
        mean, error = statistics.fmean(shares), statistics.stdev(shares) / math.sqrt(len(shares))
        verdict.at_most(f"ratio 6.5, 10 % fines: i1/i_c, mean of {len(shares)} seeds ± {error:.3f}", mean, 0.2)
        verdict.at_least("ratio 6.5, 30 % fines: i1/i_c", share(run["gaps/soil=ratio-6-5/fc=30/dense-upward"]), 0.6)
        for name in (name for name in ramps if name.startswith("sand")):
            sand = run[name]
            below = [level["mobile_mass_share"] for level in sand["mobility"] if level["gradient"] < sand["heave_gradient"]]
            print(f"{name}: {100 * below[-1]:.2g} % mobile below heave; {100 * sand['load_bearing_mass_share']:.0f} % are held, for they carry")
        common.draw(given, "critical_gradient", chart(rows))
    verdict.end()


main()
