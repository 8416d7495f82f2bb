#!/usr/bin/python3
"""Gradients that move the fines of gap-graded and continuous soils, beside Skempton and Brogan's line."""

import math
import sys

import numpy
import suffuse

import common

RATIO_SOILS = [  # size ratio, fines content, way
    (3.5, 0.05, "dense"), (3.5, 0.2, "dense"), (3.5, 0.2, "loose"), (3.5, 0.3, "dense"),
    (6.5, 0.05, "dense"), (6.5, 0.1, "dense"), (6.5, 0.1, "loose"), (6.5, 0.2, "dense"), (6.5, 0.3, "dense"),
    (10, 0.05, "dense"),
]
FRICTION = {"dense": "10 deg", "loose": "37 deg"}
COARSE = 60
GRADIENTS = [round(0.05 * k, 2) for k in range(1, 9)] + [round(0.1 * k, 1) for k in range(5, 13)]
MOST_GRAINS = 6000
SAND = ([0.1, 0.16, 0.2, 0.26, 0.35, 0.4], [0, 0.1, 0.35, 0.75, 0.95, 1])  # [mm], passing: a uniform sand's


def gap_graded(ratio, content, seed):
    coarse, rng = 0.5e-3, numpy.random.default_rng(seed)
    count = COARSE
    while count > 30 and count * content / (1 - content) * ratio**3 > MOST_GRAINS:
        count -= 1
    fines = max(20, round(count * content / (1 - content) * ratio**3))
    radius = numpy.concatenate([coarse * rng.uniform(0.9, 1.1, count), coarse / ratio * rng.uniform(0.9, 1.1, fines)])
    return radius, numpy.arange(len(radius)) >= count


def continuous(seed):
    """A uniform sand whose fines, below 0.26 mm, are three quarters of it and carry: it is stable."""
    rng, grains = numpy.random.default_rng(seed), 2500
    share = (numpy.arange(grains * 40) + rng.uniform(size=grains * 40)) / (grains * 40)
    size = 1e-3 * numpy.interp(share, SAND[1], SAND[0])
    chosen = rng.choice(size, grains, p=size**-3.0 / (size**-3.0).sum(), replace=False)
    return chosen / 2, chosen < 0.26e-3


def packed(radius, fine, way, seed):
    world = suffuse.make_cloud(radius, fine=fine, material=suffuse.Material(density=2650), seed=seed)
    world.compact("100 kPa", friction=FRICTION[way], protocol="swift")
    return world


def told(found):
    """What a row holds of a mobility: None is not a number there."""
    number = lambda value: math.nan if value is None else float(value)
    row = {f"i{name.split()[0]}": number(value) for name, value in found["critical_gradient"].items()}
    row |= {f"at_{i:.2f}": float(share) for i, share in zip(found["gradient"], found["mobile_mass_share"])}
    for name in ("heave_gradient", "alpha_fines", "skempton_brogan_gradient", "fines_heave_gradient",
                 "load_bearing_mass_share", "sifting_mass_share", "fines_drag_share"):
        row[name] = number(found[name])
    return row


def gap_row(ratio, content, way, softness, seed):
    radius, fine = gap_graded(ratio, content, int(seed))
    world = packed(radius, fine, way, int(seed))
    found = world.mobility(GRADIENTS, softness=softness)
    return {"grains": len(radius), "void_ratio": float(1 / (1 - world.porosity) - 1), **told(found)}


def sand_row(way, softness, seed):
    radius, fine = continuous(int(seed))
    world = packed(radius, fine, way, int(seed))
    return {"grains": len(radius), "void_ratio": float(1 / (1 - world.porosity) - 1), **told(world.mobility(GRADIENTS, softness=softness))}


def curve_difference(one, other):
    """Largest difference of the mobile shares of two rows at one gradient."""
    return max(abs(one[name] - other[name]) for name in one if name.startswith("at_"))


def chart(rows):
    points = [
        {"alpha": row["alpha_fines"], "share": row["i1"] / row["heave_gradient"],
         "soil": f"ratio {row['ratio']:g}, {row['way']}", "content": f"{100 * row['content']:.0f} %"}
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
             "encoding": {"x": x, "y": y, "color": {"field": "soil", "type": "nominal", "title": None},
                          "shape": {"field": "content", "type": "nominal", "title": "fines"}}},
        ],
    }


def main():
    given = common.options(__doc__)
    gaps, sands = common.Samples(given, "critical_gradient"), common.Samples(given, "critical_gradient_sand")
    usual, softer = 1e-3, 1e-4
    soils = [(6.5, 0.05, "dense")] if given.quick else RATIO_SOILS
    for ratio, content, way in soils:
        gaps.measure(gap_row, ratio=ratio, content=content, way=way, softness=usual, seed=1)
    for ratio, content, way in [(6.5, 0.05, "dense")] if given.quick else [(6.5, 0.05, "dense"), (3.5, 0.2, "dense")]:
        gaps.measure(gap_row, ratio=ratio, content=content, way=way, softness=softer, seed=1)
    if not given.quick:
        sands.measure(sand_row, way="dense", softness=usual, seed=1)

    verdict = common.Verdict()
    print("ratio fines way    e     alpha  i_c   alpha i_c  FC i_c/s  i1    i10   i50   i1/i_c")
    rows = [row for soil in soils for row in gaps.of(ratio=soil[0], content=soil[1], way=soil[2], softness=usual)]
    for row in rows + sands.rows:
        name = f"{row['ratio']:5} {100 * row['content']:3.0f} %" if "ratio" in row else "sand       "
        print(
            f"{name} {row['way']:6} {row['void_ratio']:.3f} {row['alpha_fines']:.3f} {row['heave_gradient']:.3f} {row['skempton_brogan_gradient']:.3f}"
            f"      {row['fines_heave_gradient']:.3f}     {row['i1']:.2f}  {row['i10']:.2f}  {row['i50']:.2f}  {row['i1'] / row['heave_gradient']:.2f}"
        )
    for ratio, content, way in [(6.5, 0.05, "dense"), (3.5, 0.2, "dense")]:
        both = [gaps.of(ratio=ratio, content=content, way=way, softness=k) for k in (usual, softer)]
        if all(both):
            verdict.near(f"ratio {ratio}, {100 * content:.0f} %: curves of K and K/10", curve_difference(both[0][0], both[1][0]), 0, 0.05)
    if not given.quick:
        one = lambda ratio, content, way: gaps.of(ratio=ratio, content=content, way=way, softness=usual)[0]
        free, held = one(6.5, 0.1, "dense"), one(6.5, 0.3, "dense")
        verdict.at_most("ratio 6.5, 10 % fines: i1/i_c", free["i1"] / free["heave_gradient"], 0.2)
        share = held["i1"] / held["heave_gradient"] if math.isfinite(held["i1"]) else math.inf
        verdict.at_least("ratio 6.5, 30 % fines: i1/i_c", share, 0.6)
        sand = sands.rows[0]
        below = max(i for i in GRADIENTS if i < sand["heave_gradient"])
        verdict.at_most("uniform sand: mobile share at the last gradient below heave", sand[f"at_{below:.2f}"], 0.01)
        common.draw(given, "critical_gradient", chart(rows))
    print(f"{gaps.seconds + sands.seconds:.0f} s of one core", file=sys.stderr)
    verdict.end()


main()
