#!/usr/bin/python3
"""Does a suspension clog one throat? Fines enter a simple cubic lattice of held grains with the water, a throat wide. How many
pass before nothing does, over the throat's width in grains, the solid fraction of the suspension and friction."""

import math
import statistics
import sys
import warnings

import common
import numpy
import suffuse

COARSE = 1e-3  # diameter of the lattice's grains [m]
THROAT = math.sqrt(2) - 1  # of it: the widest sphere between four of them
LAYERS = 2  # throats in a row
RATIOS = [1.5, 2, 2.5, 3, 3.5, 4, 5, 6]  # throat over grain
FRACTIONS = [0.02, 0.1, 0.2]  # solid volume over that of the suspension
SEEDS = range(1, 9)
ARRIVALS = 150  # grains that reach the throat
# "low": smooth spheres; "sand": 37 degrees and rolling resistance. Nearly without weight: the water carries all.
FRICTION = {
    "low": {"friction": 0.1, "rolling_stiffness": 0, "rolling_friction": 0},
    "sand": {"friction": math.tan(math.radians(37)), "rolling_stiffness": 7.5, "rolling_friction": 0.22},
}
ACCELERATION, GRADIENT = 9.81e-3, 100.0  # the pull of the water is 100 times the weight
PULL = 1000 * ACCELERATION * GRADIENT  # [Pa/m]


def lattice(ratio, friction, seed):
    """Grains that just do not touch, and one fine grain between them, whose size those that enter have."""
    side, d = 1.0005 * COARSE, THROAT * COARSE / ratio
    position = [[side / 2, side / 2, (k + 0.5) * side] for k in range(LAYERS)] + [[0.01 * side, 0.02 * side, side]]
    return suffuse.World(
        [side, side, LAYERS * side], position, [COARSE / 2] * LAYERS + [d / 2], fine=[0] * LAYERS + [1],
        material=suffuse.Material(density=2650, modulus=1e9, **FRICTION[friction]), seed=seed,
    )


def arrivals_a_second(world, fraction, permeability):
    """Of grains, and how long one needs to the end of the lattice [s]."""
    darcy = permeability * PULL / 1e-3
    area = (1.0005 * COARSE) ** 2
    grain = math.pi / 6 * (2 * world.grains.radius[-1]) ** 3
    porosity = 1 - math.pi / 6 * COARSE**3 / (area * 1.0005 * COARSE)
    return fraction / (1 - fraction) * darcy * area / grain, LAYERS * 1.0005 * COARSE * porosity / darcy


def run(friction, ratio, fraction, seed):
    """How many grains have left, the longest time between two of them, and what is left of the permeability."""
    world = lattice(ratio, friction, int(seed))
    cell, position, radius = world.cell, world.grains.position[:LAYERS], world.grains.radius[:LAYERS]
    alone = suffuse.seep(cell, position, radius, direction="z").permeability
    rate, transit = arrivals_a_second(world, fraction, alone)
    time = 2 * transit + ARRIVALS / rate
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # motion does not end while grains enter
        found = world.migrate(
            [GRADIENT], direction="z", down="z", acceleration=ACCELERATION, feed=2650 * fraction / (1 - fraction),
            hold_at_most=time, still=1e-9, still_for=time, softness=2e-4,
        )
    left = numpy.sort(found["grains"]["left"])
    left = left[numpy.isfinite(left)]
    pauses = numpy.diff(left)
    k_end = float(found["rows"]["permeability"][-1] / alone)
    return {
        "passed": int(left.size), "fed": int(numpy.isfinite(found["grains"]["entered"]).sum()),
        "clogged": int(k_end < 0.5), "longest_pause": float(pauses.max() * rate) if pauses.size else 0.0,
        "k_end": k_end, "overlap": found["largest_overlap"],
    }


def wanted(quick):
    if quick:
        return [(friction, ratio, 0.1, seed) for friction in FRICTION for ratio in (2, 4) for seed in (1, 2)]
    at_one = [(friction, ratio, 0.1, seed) for friction in FRICTION for ratio in RATIOS for seed in SEEDS]
    others = [(friction, ratio, fraction, seed) for friction in FRICTION for ratio in (2, 3) for fraction in FRACTIONS for seed in SEEDS]
    return at_one + [key for key in others if key[2] != 0.1]


def print_table(samples):
    print("| friction | throat/grain | solid fraction | clogged | passed before | their deviation | longest pause | k at the end |")
    print("|---|---|---|---|---|---|---|---|")
    for friction in FRICTION:
        for fraction, ratio in sorted({(row["fraction"], row["ratio"]) for row in samples.of(friction=friction)}):
            rows = samples.of(friction=friction, fraction=fraction, ratio=ratio)
            clogged = [row["passed"] for row in rows if row["clogged"]]
            print(
                f"| {friction} | {ratio:g} | {fraction:g} | {len(clogged)} of {len(rows)} "
                f"| {statistics.fmean(clogged):.0f} | {statistics.stdev(clogged) if len(clogged) > 1 else 0:.0f} " if clogged else
                f"| {friction} | {ratio:g} | {fraction:g} | 0 of {len(rows)} | – | – ", end="",
            )
            print(f"| {max(row['longest_pause'] for row in rows):.0f} | {common.mean(rows, 'k_end'):.2f} |")


def draw(given, samples):
    nodes = []
    for friction in FRICTION:
        for ratio in RATIOS:
            rows = samples.of(friction=friction, ratio=float(ratio), fraction=0.1)
            if rows:
                nodes.append({"throat/grain": ratio, "clogged": 100 * common.mean(rows, "clogged"), "friction": friction})
    common.draw(given, "arching", {
        "data": {"values": nodes}, "width": 360, "height": 220, "mark": {"type": "line", "point": True},
        "encoding": {
            "x": {"field": "throat/grain", "type": "quantitative", "title": "throat over grain [-]"},
            "y": {"field": "clogged", "type": "quantitative", "title": "samples that clog [%]", "scale": {"domain": [0, 100]}},
            "color": {"field": "friction", "type": "nominal", "title": "friction"},
        },
    })


def main():
    given = common.options(__doc__)
    samples = common.Samples(given, "arching")
    for friction, ratio, fraction, seed in wanted(given.quick):
        samples.measure(run, friction=friction, ratio=float(ratio), fraction=float(fraction), seed=float(seed))
    print_table(samples)
    draw(given, samples)
    verdict = common.Verdict()
    wide = [row for row in samples.of(friction="low", fraction=0.1) if row["ratio"] > 3]
    verdict.at_most("low friction, throats wider than three grains: share of samples that clog", common.mean(wide, "clogged"), 0.0)
    narrow = [row for row in samples.of(friction="sand", fraction=0.1) if row["ratio"] <= 2]
    verdict.at_least("sand, throats of two grains at most: share of samples that clog", common.mean(narrow, "clogged"), 0.9)
    verdict.end()


if __name__ == "__main__":
    sys.exit(main())
