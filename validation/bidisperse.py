#!/usr/bin/python3
"""Densest packings of spheres of two sizes, frictionless, against the rods of Farr and Groot 2009."""

import numpy
import suffuse

import common
import rods

STIFFNESS = 1e4  # to pressure: an overlap of 1e-4 diameters adds 2e-4 to the solid fraction
WITHIN = 0.01
COARSE = 2 * common.DIAMETER
LEAST_COARSE, LEAST_GRAINS, MOST_GRAINS = 150, 2000, 5000


def numbers_of(ratio, fines):
    """Coarse and fine grains of a sample, and the share of the volume that the fines really have."""
    fine_per_coarse = fines / (1 - fines) * ratio**3
    most_coarse = MOST_GRAINS / (1 + fine_per_coarse)
    coarse = round(min(max(LEAST_COARSE, LEAST_GRAINS / (1 + fine_per_coarse)), most_coarse))
    fine = round(coarse * fine_per_coarse)
    return coarse, fine, fine / (fine + coarse * ratio**3)


def measure(ratio, fines, seed):
    coarse, fine, share = numbers_of(ratio, fines)
    radius = numpy.repeat([COARSE / 2, COARSE / 2 / ratio], [coarse, fine])
    material = common.stiff(common.SOFT, friction=0, shear_ratio=1e-3)
    world = suffuse.make_cloud(radius, porosity=0.5, fine=radius < radius[0], material=material, seed=int(seed))
    common.densest(world, STIFFNESS, max_rate="60 1/s")
    rod = rods.solid_fraction([1, 1 / ratio], [1 - share, share])
    return {"coarse": coarse, "grains": coarse + fine, "share": share, **common.state_of(world), "rods": rod}


def chart(samples, ratios):
    curves = []
    for ratio in ratios:
        for share in numpy.linspace(0, 1, 41):
            curves.append({"ratio": ratio, "share": 100 * share,
                           "y": rods.solid_fraction([1, 1 / ratio], [1 - share, share], count=4000)})
    points = [{**row, "share": 100 * row["share"]} for row in samples]
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
             "encoding": {"x": x, "y": {"field": "solid_fraction", **y}, "color": color}},
        ],
    }


def main():
    given = common.options(__doc__)
    samples = common.Samples(given, "bidisperse")
    ratios = (2, 4) if given.quick else (2, 3, 4, 5, 6)
    contents = (0.3,) if given.quick else (0.2, 0.3)
    for ratio in ratios:
        for fines in contents:
            samples.measure(measure, ratio=ratio, fines=fines, seed=1)
    verdict = common.Verdict()
    print("ratio  fines %  grains  solid fraction  rods    ours - rods")
    for ratio in ratios:
        for fines in contents:
            [row] = samples.of(ratio=ratio, fines=fines)
            ours, theirs = row["solid_fraction"], row["rods"]
            print(f"{ratio:5}  {100 * fines:7.0f}  {row['grains']:6.0f}  {ours:14.4f}  {theirs:.4f}  {ours - theirs:+.4f}")
            within = WITHIN + (0.003 if given.quick else 0)  # single samples scatter by that
            verdict.near(f"solid fraction at ratio {ratio}, {100 * fines:.0f} % fines", ours, theirs, within)
    print(f"{samples.seconds / 60:.1f} min of one core")
    if not given.quick:
        common.draw(given, "bidisperse", chart(samples.rows, ratios))
    verdict.end()


main()
