#!/usr/bin/python3
"""Permeability of random packings of equal spheres: Kozeny and Carman, and van der Hoef et al. 2005."""

import math

import numpy
import suffuse

import common

# What makes a packing dense or loose: friction angle [degrees], and whether rolling is resisted.
WAYS = {
    "frictionless": (0, False),
    "3 deg": (3, False),
    "10 deg": (10, False),
    "10 deg, rolling resisted": (10, True),
    "40 deg, rolling resisted": (40, True),
}
STIFFNESS = 10_000  # to pressure: overlaps of 1e-4 of the diameter
WITHIN = 0.15


def kozeny_carman(solid_fraction):
    """Permeability over the squared diameter, with the constant 180."""
    return (1 - solid_fraction) ** 3 / (180 * solid_fraction**2)


def van_der_hoef(solid_fraction):
    """Permeability over the squared diameter from their drag at low Reynolds number."""
    porosity = 1 - solid_fraction
    drag = 10 * solid_fraction / porosity**2 + porosity**2 * (1 + 1.5 * math.sqrt(solid_fraction))
    return porosity / (18 * solid_fraction * drag)


def packed(way, grains, seed):
    """A sample of equal spheres."""
    angle, resisted = WAYS[way]
    rolling = {} if resisted else {"rolling_stiffness": 0, "rolling_friction": 0}
    material = suffuse.Material(
        density=common.DENSITY, modulus=2 * STIFFNESS * common.PRESSURE, friction=math.radians(angle), **rolling
    )
    world = suffuse.make_cloud(numpy.full(int(grains), common.DIAMETER / 2), porosity=0.5, material=material, seed=int(seed))
    common.compact(world)
    return world


def measure(way, grains, seed):
    world = packed(way, grains, seed)
    state = common.state_of(world)
    tensor = numpy.asarray(suffuse.seep(world, tensor=True).tensor)
    permeability = numpy.trace(tensor) / 3 / common.DIAMETER**2
    return {
        "solid_fraction": state["solid_fraction"],
        "permeability": permeability,  # over the squared diameter
        "to_kozeny_carman": permeability / kozeny_carman(state["solid_fraction"]),
        "to_van_der_hoef": permeability / van_der_hoef(state["solid_fraction"]),
        "yade_to_bounded": numpy.trace(numpy.asarray(suffuse.seep(world, tensor=True, conductance="yade").tensor))
        / numpy.trace(tensor),
        "anisotropy": abs(tensor - numpy.trace(tensor) / 3 * numpy.eye(3)).max() / (numpy.trace(tensor) / 3),
        "unbalanced": state["unbalanced"],
    }


def chart(samples):
    x = {"field": "solid_fraction", "type": "quantitative", "title": "solid fraction",
         "scale": {"zero": False, "domain": [0.51, 0.65]}}
    y = {"type": "quantitative", "title": "permeability over the correlation's", "scale": {"domain": [0.8, 1.6], "zero": False}}
    points = [
        {"solid_fraction": row["solid_fraction"], "ratio": row[name], "to": to}
        for row in samples
        for name, to in (("to_kozeny_carman", "Kozeny and Carman, 180"), ("to_van_der_hoef", "van der Hoef et al."))
    ]
    return {
        "description": "Permeability of random packings of equal spheres over that of two correlations.",
        "width": 420, "height": 280,
        "layer": [
            {"data": {"values": [{"low": 1 - WITHIN, "high": 1 + WITHIN}]},
             "mark": {"type": "rect", "color": "#e6efe6"},
             "encoding": {"y": {"field": "low", **y}, "y2": {"field": "high"}}},
            {"data": {"values": [{"y": 1}]}, "mark": {"type": "rule", "strokeDash": [5, 4], "color": "#666666"},
             "encoding": {"y": {"field": "y", **y}}},
            {"data": {"values": points}, "mark": {"type": "point", "filled": True, "size": 50, "opacity": 0.85},
             "encoding": {"x": x, "y": {"field": "ratio", **y},
                          "color": {"field": "to", "type": "nominal", "title": None},
                          "shape": {"field": "to", "type": "nominal", "title": None}}},
        ],
    }


def main():
    given = common.options(__doc__)
    samples = common.Samples(given, "permeability")
    ways = ["frictionless", "40 deg, rolling resisted"] if given.quick else list(WAYS)
    grains, seeds = 900, 1 if given.quick else 5
    for way in ways:
        for seed in range(1, seeds + 1):
            samples.measure(measure, way=way, grains=grains, seed=seed)
    m, s = common.mean, common.deviation
    print("way                       solid fraction    1000 k/d2   to Kozeny-Carman  to van der Hoef  Yade/bounded  anisotropy %")
    for way in ways:
        rows = samples.of(way=way)
        print(
            f"{way:24}  {m(rows, 'solid_fraction'):.4f} ± {s(rows, 'solid_fraction'):.4f}   "
            f"{1000 * m(rows, 'permeability'):.4f}      {m(rows, 'to_kozeny_carman'):.3f} ± {s(rows, 'to_kozeny_carman'):.3f}"
            f"     {m(rows, 'to_van_der_hoef'):.3f} ± {s(rows, 'to_van_der_hoef'):.3f}    {m(rows, 'yade_to_bounded'):.3f}    {100 * m(rows, 'anisotropy'):.1f}"
        )
    verdict = common.Verdict()
    for way in ways:
        rows = samples.of(way=way)
        solid = f"solid fraction {m(rows, 'solid_fraction'):.3f}, over"
        verdict.near(f"{solid} Kozeny and Carman's", m(rows, "to_kozeny_carman"), 1, WITHIN)
        verdict.near(f"{solid} van der Hoef's", m(rows, "to_van_der_hoef"), 1, WITHIN)
    if not given.quick:
        print(f"{samples.seconds / 60:.1f} min of one core")
        common.draw(given, "permeability", chart(samples.rows))
    verdict.end()


if __name__ == "__main__":
    main()
