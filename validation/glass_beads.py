#!/usr/bin/python3
"""Equal spheres with friction 0.3 compressed from a gas: state D of Agnolin and Roux 2007."""

import math

import numpy
import suffuse

import common

# Theirs, five samples of 4,000 beads: mean, standard deviation.
THEIRS = {"solid_fraction": (0.5923, 0.0006), "z_star": (4.546, 0.009), "rattlers": (0.111, 0.004)}
STIFFNESS = 39_000  # their (E/((1 - nu^2) p))^(2/3): E = 70 GPa, nu = 0.3, 10 kPa
SHEAR_RATIO = 2 * (1 - 0.3) / (2 - 0.3)  # of Mindlin's springs, before slip
# Largest strain rate [1/s], local damping, and speed of the grains at the start over sqrt(pressure/density): as
# `faithful` has them, and what could make the difference to theirs.
WAYS = {
    "as usual": (250, 0.2, 0),
    "slower": (80, 0.2, 0),
    "more damping": (250, 0.7, 0),
    "agitated": (250, 0.2, 0.3),
    "agitated, less damping": (250, 0.05, 0.3),
    "hot, less damping": (250, 0.05, 3.0),
}


def measure(way, grains, seed):
    material = common.stiff(STIFFNESS, friction=math.atan(0.3), shear_ratio=SHEAR_RATIO)
    radius = numpy.full(int(grains), common.DIAMETER / 2)
    world = suffuse.make_cloud(radius, porosity=0.5, material=material, seed=int(seed))
    rate, damping, agitation = WAYS[way]
    random = numpy.random.default_rng(int(seed))
    speed = agitation * math.sqrt(common.PRESSURE / common.DENSITY)
    world.grains.velocity = random.normal(0, speed / math.sqrt(3), (len(world.grains), 3))
    common.compact(world, unbalanced=1e-4, damping=damping, max_rate=rate)
    return common.state_of(world)


def chart(samples):
    x = {"type": "quantitative", "title": "solid fraction", "scale": {"zero": False}}
    color = {"field": "way", "type": "nominal", "title": None, "sort": list(WAYS), "legend": {"columns": 3, "orient": "bottom"}}

    def panel(name, title):
        y = {"type": "quantitative", "title": title, "scale": {"zero": False}}
        theirs = [{"x": THEIRS["solid_fraction"][0], "y": THEIRS[name][0]}]
        points = {"type": "point", "filled": True, "size": 55, "opacity": 0.85}
        diamond = {"type": "point", "shape": "diamond", "size": 130, "color": "#111111"}
        return {"width": 290, "height": 250, "layer": [
            {"data": {"values": samples}, "mark": points,
             "encoding": {"x": {"field": "solid_fraction", **x}, "y": {"field": name, **y}, "color": color}},
            {"data": {"values": theirs}, "mark": diamond,
             "encoding": {"x": {"field": "x", **x}, "y": {"field": "y", **y}}},
        ]}

    return {
        "description": "Solid fraction, backbone coordination and rattlers of packings compressed with friction.",
        "hconcat": [panel("z_star", "contacts per grain of the backbone, z*"), panel("rattlers", "share of rattlers")],
    }


def main():
    given = common.options(__doc__)
    samples = common.Samples(given, "glass_beads")
    grains, seeds = (1000, 2 if given.quick else 8)
    ways = ["as usual", "agitated, less damping"] if given.quick else list(WAYS)
    for seed in range(1, seeds + 1):
        for way in ways:
            samples.measure(measure, way=way, grains=grains, seed=seed)
    m, s = common.mean, common.deviation
    print("way                     solid fraction    z*               rattlers %")
    for way in ways:
        rows = samples.of(way=way)
        print(
            f"{way:22}  {m(rows, 'solid_fraction'):.4f} ± {s(rows, 'solid_fraction'):.4f}   "
            f"{m(rows, 'z_star'):.3f} ± {s(rows, 'z_star'):.3f}   "
            f"{100 * m(rows, 'rattlers'):.1f} ± {100 * s(rows, 'rattlers'):.1f}"
        )
    print(f"{samples.seconds / 60:.1f} min of one core")
    verdict = common.Verdict()
    for way in ways[-1:] if given.quick else ("as usual", "agitated, less damping"):
        rows = samples.of(way=way)
        verdict.near(f"{way}: solid fraction", m(rows, "solid_fraction"), THEIRS["solid_fraction"][0], 0.005)
        verdict.near(f"{way}: z*", m(rows, "z_star"), THEIRS["z_star"][0], 0.1)
        verdict.near(f"{way}: share of rattlers", m(rows, "rattlers"), THEIRS["rattlers"][0], 0.02)
    if not given.quick:
        common.draw(given, "glass_beads", chart(samples.rows))
    verdict.end()


main()
