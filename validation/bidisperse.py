#!/usr/bin/python3
"""Densest packings of spheres of two sizes, frictionless, against the rods of Farr and Groot 2009."""

import math

import numpy
import suffuse

import common
import rods

STIFFNESS = 1e4  # to pressure: an overlap of 1e-4 diameters adds 2e-4 to the solid fraction
WITHIN = 0.01
MAX_RATE = 60  # largest strain rate [1/s]
COARSE = 2 * common.DIAMETER
LEAST_COARSE = 150
# How the cloud is compacted: grains at rest, as a stage does, or agitated by random speeds, a gas that cools by its
# collisions; a local damping of 0.005 takes 1 % of the energy of a collision, the usual 0.2 a third.
WAYS = {"at rest": None, "agitated": 0.005}
GRAINS = {"at rest": (2000, 5000), "agitated": (6000, 6000)}  # at least, at most
SEEDS = {"at rest": (1,), "agitated": (1, 2, 3)}
AGITATION, COLD = 0.25, 0.03  # speed along an axis of a grain of mean mass, over sqrt(pressure/density): first, last
MIXTURES = [(1, 0.0)] + [(ratio, fines) for ratio in (2, 3, 4, 5, 6) for fines in (0.2, 0.3)]
LOOSE = [(1, 0.0), (2, 0.2), (3, 0.2), (4, 0.2)]  # too loose at rest; equal spheres show whether grains order
STEPS_OF_A_COLLISION = 6  # of two fine grains; with 2, as dense packings allow, it gains energy


def numbers_of(way, ratio, fines):
    """Coarse and fine grains of a sample, and the share of the volume that the fines really have."""
    fine_per_coarse = fines / (1 - fines) * ratio**3
    least, most = (grains / (1 + fine_per_coarse) for grains in GRAINS[way])
    coarse = round(min(max(LEAST_COARSE, least), most))
    fine = round(coarse * fine_per_coarse)
    return coarse, fine, fine / (fine + coarse * ratio**3)


def speed_of(world):
    mass, velocity = numpy.asarray(world.grains.mass), numpy.asarray(world.grains.velocity)
    energy = (mass * (velocity**2).sum(axis=1)).mean() / 3
    return math.sqrt(energy / mass.mean() / (common.PRESSURE / common.DENSITY))


def agitate(world, seed):
    """Random velocities, of the same energy for coarse and fine grains, without momentum."""
    mass = numpy.asarray(world.grains.mass)
    speed = AGITATION * numpy.sqrt(common.PRESSURE / common.DENSITY * mass.mean() / mass)
    velocity = numpy.random.default_rng(seed).normal(size=(len(mass), 3)) * speed[:, None]
    world.grains.velocity = velocity - mass @ velocity / mass.sum()


def cool(world, damping):
    """Steps under the pressure until the gas has cooled by its collisions."""
    radius = float(numpy.min(world.grains.radius))
    mass = 4 / 3 * math.pi * radius**3 * common.DENSITY
    collision = math.pi / math.sqrt(2 * world.material.modulus * radius / mass)
    loading = suffuse.Loading(stress=common.PRESSURE, max_rate=MAX_RATE)
    for _ in range(1000):
        world.step(1000, loading, damping=damping, time_step=collision / STEPS_OF_A_COLLISION)
        if speed_of(world) < COLD:
            return
    raise RuntimeError(f"the gas does not cool: its speed is {speed_of(world):.3f} after a million steps")


def measure(way, ratio, fines, seed):
    coarse, fine, share = numbers_of(way, ratio, fines)
    radius = numpy.repeat([COARSE / 2, COARSE / 2 / ratio], [coarse, fine])
    material = common.stiff(common.SOFT, friction=0, shear_ratio=1e-3)
    world = suffuse.make_cloud(radius, porosity=0.5, fine=radius < radius[0], material=material, seed=int(seed))
    if WAYS[way]:
        agitate(world, int(seed))
        cool(world, WAYS[way])
    common.densest(world, STIFFNESS, max_rate=MAX_RATE)
    rod = rods.solid_fraction([1, 1 / ratio], [1 - share, share])
    return {"coarse": coarse, "grains": coarse + fine, "share": share, **common.state_of(world), "rods": rod}


def chart(samples):
    ratios = sorted({row["ratio"] for row in samples if row["ratio"] > 1})
    curves = []
    for ratio in ratios:
        for share in numpy.linspace(0, 1, 41):
            curves.append({"ratio": ratio, "share": 100 * share,
                           "y": rods.solid_fraction([1, 1 / ratio], [1 - share, share], count=4000)})
    points = [{**row, "share": 100 * row["share"]} for row in samples if row["ratio"] > 1]
    x = {"field": "share", "type": "quantitative", "title": "fines [% of the solid volume]"}
    y = {"type": "quantitative", "title": "solid fraction", "scale": {"domain": [0.62, 0.82], "zero": False}}
    color = {"field": "ratio", "type": "nominal", "title": "size ratio"}
    return {
        "description": "Solid fraction of frictionless bidisperse packings (points) against Farr and Groot 2009 (lines).",
        "width": 520, "height": 320,
        "layer": [
            {"data": {"values": curves}, "mark": {"type": "line", "strokeWidth": 1.3},
             "encoding": {"x": x, "y": {"field": "y", **y}, "color": color}},
            {"data": {"values": points}, "mark": {"type": "point", "filled": True, "size": 55, "opacity": 0.85},
             "encoding": {"x": x, "y": {"field": "solid_fraction", **y}, "color": color,
                          "shape": {"field": "way", "type": "nominal", "title": "cloud",
                                    "scale": {"domain": list(WAYS), "range": ["cross", "circle"]}}}},
        ],
    }


def main():
    given = common.options(__doc__)
    samples = common.Samples(given, "bidisperse")
    plan = {"at rest": [(2, 0.3), (4, 0.3)]} if given.quick else {"at rest": MIXTURES, "agitated": LOOSE}
    for way, mixtures in plan.items():
        for ratio, fines in mixtures:
            for seed in SEEDS[way]:
                samples.measure(measure, way=way, ratio=ratio, fines=fines, seed=seed)
    verdict = common.Verdict()
    print("ratio  fines %  cloud     grains  solid fraction  rods    ours - rods  rattlers %")
    for ratio, fines in sorted({(row["ratio"], row["fines"]) for row in samples.rows}):
        rows = samples.of(ratio=ratio, fines=fines)
        for row in rows:
            ours, theirs = row["solid_fraction"], row["rods"]
            print(
                f"{ratio:5.0f}  {100 * fines:7.0f}  {row['way']:8}  {row['grains']:6.0f}  {ours:14.4f}  {theirs:.4f}  "
                f"{ours - theirs:+.4f}      {100 * row['rattlers']:.0f}"
            )
        within = WITHIN + (0.003 if given.quick else 0)  # single samples scatter by that
        if ratio > 1:
            ways = [[row for row in rows if row["way"] == way] for way in {row["way"] for row in rows}]
            densest = max(ways, key=lambda of: common.mean(of, "solid_fraction"))
            verdict.near(
                f"densest at ratio {ratio:.0f}, {100 * fines:.0f} % fines", common.mean(densest, "solid_fraction"),
                common.mean(densest, "rods"), within,
            )
    print(f"{samples.seconds / 60:.1f} min of one core")
    if not given.quick:
        common.draw(given, "bidisperse", chart(samples.rows))
    verdict.end()


main()
