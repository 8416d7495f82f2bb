#!/usr/bin/python3
"""Gradients that move the fines of gap-graded soils, compared with Skempton and Brogan's line: the rows of the atlas under upward
flow (atlas.py). Also single samples of critical_gradient.toml: five seeds, a tenth of K, and a uniform sand."""

import math
import statistics

import common
import suffuse

STEP = 0.075  # of the ramps in critical_gradient.toml, which the program refines
SOFTER = 1e-4  # a tenth of the K that scales forces: curves may not depend on it
SOFTENED = {"ratio-6-5": 5, "ratio-3-5": 20}  # dense soils and their fines contents [%] for which K is varied
SEEDS = 5  # of the soil of ratio 6.5 with 10 % of fines


def upward_rows():
    """Of the atlas: samples under upward flow."""
    rows = [row for row in suffuse.atlas() if row["flow"] == "up"]
    return sorted(rows, key=lambda row: (row["ratio"], row["fines"], row["density"], row["seed"]))


def share_of_heave(row):
    """i1/i_c; endless where 1 % do not move below heave."""
    return row["i1"] / row["i_c"] if math.isfinite(row["i1"]) else math.inf


def of_case(gradients):
    """Indices of the gradients that the case gives, known by their step, without those that refine the ramp."""
    steps = {k: gradient / STEP for k, gradient in enumerate(gradients)}
    return {round(step): k for k, step in steps.items() if abs(step - round(step)) < 1e-6}


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


def dense_gaps(given, soil, contents, seeds=1):
    """The run of dense samples of one soil, to the end of their ramps."""
    changes = {"study.gaps.soil": soil, "study.gaps.sweep": {"fines_content": [f"{k} %" for k in contents]}, "study.gaps.replicates": seeds}
    return common.conduct(given, "critical_gradient", ["gaps"], changes, folder=f"critical_gradient/{soil}-{contents[0]}")


def ramps_of(run):
    return sorted(name for name in run.stages if name.endswith("-upward"))


def print_rows(rows):
    print("ratio fines density grains  e      i_c   alpha  a i_c  FC i_c/s  i1    i10   i50   i1/i_c")
    for row in rows:
        void_ratio, by_fines = row["porosity"] / (1 - row["porosity"]), row["fines"] * row["i_c"] / row["drag_share"]
        print(
            f"{row['ratio']:5g} {100 * row['fines']:3.0f} %  {row['density']:6} {row['grains']:7.0f}  {void_ratio:.3f}  {row['i_c']:.2f}  {row['alpha']:.3f}"
            f"  {row['alpha'] * row['i_c']:.2f}   {by_fines:.2f}      {row['i1']:.2f}  {row['i10']:.2f}  {row['i50']:.2f}  {row['i1'] / row['i_c']:.2f}"
        )


def check_order(rows, verdict):
    """More fines need a higher gradient, and so does a denser packing."""
    shares = {(row["density"], row["ratio"], round(100 * row["fines"])): share_of_heave(row) for row in rows if row["seed"] == 1}
    verdict.at_least("ratio 6.5, 30 % fines, dense: i1/i_c", shares["dense", 6.5, 30], 0.6)
    falls = [1 - shares.get((way, ratio, content + 5), math.inf) / share for (way, ratio, content), share in shares.items()]
    verdict.at_most("largest relative fall of i1/i_c by 5 % more fines", max(falls), 0.1)
    denser = [share / shares["loose", ratio, content] for (way, ratio, content), share in shares.items() if way == "dense"]
    verdict.at_least("least i1/i_c of a dense sample over that of the loose one", min(denser), 1)


def check_softer(given, soil, content, verdict):
    run = dense_gaps(given, soil, [content])
    (name,) = ramps_of(run)
    found = differences_of_softer(run, name)
    print(f"{soil}, {content} %: difference of K and K/10", *(f"{i:.3f} {share:.4f}{'' if ended else ' moving'}" for i, share, ended in found))
    ended = [share for _, share, ended in found if ended]
    # Few: where more than a tenth of the fines moves, the ramp has one rate, and motion does not end.
    verdict.at_least(f"{soil}, {content} %: gradients whose motion ended by K and K/10", len(ended), 2)
    verdict.at_most(f"{soil}, {content} %: their curves of K and K/10 differ by", max(ended), 0.05)


def check_seeds(given, verdict):
    run = dense_gaps(given, "ratio-6-5", [10], SEEDS)
    stages = [run[name] for name in ramps_of(run)]
    shares = [stage["critical_gradient"]["1 %"] / stage["heave_gradient"] for stage in stages]
    print(f"ratio 6.5, 10 % fines, dense: i1/i_c of {SEEDS} seeds", *(f"{value:.3f}" for value in shares))
    mean, error = statistics.fmean(shares), statistics.stdev(shares) / math.sqrt(len(shares))
    verdict.at_most(f"ratio 6.5, 10 % fines: i1/i_c, mean of {len(shares)} seeds ± {error:.3f}", mean, 0.2)


def show_sand(given):
    run = common.conduct(given, "critical_gradient", ["sand"], folder="critical_gradient/sand")
    for name in ramps_of(run):
        sand = run[name]
        below = [level["mobile_mass_share"] for level in sand["mobility"] if level["gradient"] < sand["heave_gradient"]]
        print(
            f"{name}: e {sand['void_ratio']:.3f}, i_c {sand['heave_gradient']:.2f}, alpha {sand['alpha_fines']:.2f}: {100 * below[-1]:.2g} % mobile"
            f" below heave; {100 * sand['load_bearing_mass_share']:.0f} % are held, for they carry"
        )


def chart(rows):
    points = [
        {"alpha": row["alpha"], "share": row["i1"] / row["i_c"], "soil": f"ratio {row['ratio']:g}, {row['density']}", "content": f"{100 * row['fines']:.0f} %"}
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
                                    "sort": [f"{content} %" for content in range(5, 40, 5)]}}},
        ],
    }


def main():
    given = common.options(__doc__)
    rows, verdict = upward_rows(), common.Verdict()
    print_rows(rows)
    check_order(rows, verdict)
    check_softer(given, "ratio-6-5", SOFTENED["ratio-6-5"], verdict)
    if not given.quick:
        check_softer(given, "ratio-3-5", SOFTENED["ratio-3-5"], verdict)
        check_seeds(given, verdict)
        show_sand(given)
        common.draw(given, "critical_gradient", chart(rows))
    verdict.end()


main()
