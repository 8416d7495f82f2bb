#!/usr/bin/python3
"""Frictionless equal spheres: solid fraction 0.639 and 6 contacts per grain of the backbone [Agnolin and Roux 2007]."""

import math

import numpy
import suffuse

import common

SOLID_FRACTION, Z_STAR = 0.639, 6.0  # of large samples in the limit of rigid grains
THEIR_4000 = (0.6370, 6.074, 0.013)  # theirs at 4,000 grains and a stiffness to pressure of 39,000


def measure(grains, stiffness, seed):
    # Without friction there is no shear force: its stiffness is of no effect but on the time step.
    material = common.stiff(common.SOFT, friction=0, shear_ratio=1e-3)
    radius = numpy.full(int(grains), common.DIAMETER / 2)
    world = suffuse.make_cloud(radius, porosity=0.5, material=material, seed=int(seed))
    common.densest(world, stiffness, unbalanced=1e-4)
    return common.state_of(world)


def fit_of_sizes(samples):
    """Solid fraction of an infinite sample and its standard error, by least squares over 1/sqrt(N): the correction that
    O'Hern et al. 2003 and Agnolin and Roux 2007 use."""
    x = numpy.array([1 / math.sqrt(row["grains"]) for row in samples])
    y = numpy.array([row["solid_fraction"] for row in samples])
    design = numpy.stack([numpy.ones_like(x), x], axis=1)
    fit, *_ = numpy.linalg.lstsq(design, y, rcond=None)
    spread = ((y - design @ fit) ** 2).sum() / max(1, len(y) - 2)
    return fit, math.sqrt(spread * numpy.linalg.inv(design.T @ design)[0, 0])


def chart(samples, fit):
    most = max(1 / math.sqrt(row["grains"]) for row in samples)
    points = [{**row, "x": 1 / math.sqrt(row["grains"]), "N": f"{row['grains']:.0f}"} for row in samples]
    line = [{"x": x, "y": fit[0] + fit[1] * x} for x in (0, most)]
    axis = {"field": "x", "type": "quantitative", "title": "1/√N, N grains", "scale": {"domain": [0, 1.08 * most]}}

    def panel(field, title, low, high, theirs):
        vertical = {"type": "quantitative", "title": title, "scale": {"domain": [low, high], "zero": False}}
        layers = [
            {"data": {"values": [{"y": theirs[0]}]}, "mark": {"type": "rule", "strokeDash": [5, 4], "color": "#666666"},
             "encoding": {"y": {"field": "y", **vertical}}},
            {"data": {"values": points}, "mark": {"type": "point", "filled": True, "size": 45, "opacity": 0.8},
             "encoding": {"x": axis, "y": {"field": field, **vertical}, "color": {"value": "#3b82b8"}}},
            {"data": {"values": [{"x": 1 / math.sqrt(4000), "y": theirs[1]}]},
             "mark": {"type": "point", "shape": "diamond", "size": 110, "strokeWidth": 2, "color": "#d55e00"},
             "encoding": {"x": axis, "y": {"field": "y", **vertical}}},
        ]
        if field == "solid_fraction":
            layers.append({"data": {"values": line}, "mark": {"type": "line", "strokeWidth": 1.2, "color": "#3b82b8"},
                           "encoding": {"x": axis, "y": {"field": "y", **vertical}}})
        return {"width": 300, "height": 260, "layer": layers}

    return {
        "description": "Solid fraction and backbone coordination of frictionless packings against sample size.",
        "hconcat": [
            panel("solid_fraction", "solid fraction", 0.625, 0.645, (SOLID_FRACTION, THEIR_4000[0])),
            panel("z_star", "contacts per grain of the backbone, z*", 5.9, 6.15, (Z_STAR, THEIR_4000[1])),
        ],
    }


def main():
    given = common.options(__doc__)
    samples = common.Samples(given, "frictionless")
    sizes = {1000: 3} if given.quick else {500: 8, 1000: 8, 2000: 6}
    for grains, seeds in sizes.items():
        for seed in range(1, seeds + 1):
            samples.measure(measure, grains=grains, stiffness=1.05e5, seed=seed)
    print("grains  samples  solid fraction     z*               rattlers %  stiffness/p  unbalanced")
    for grains in sizes:
        rows = samples.of(grains=grains)
        m, s = common.mean, common.deviation
        print(
            f"{grains:6}  {len(rows):7}  {m(rows, 'solid_fraction'):.4f} ± {s(rows, 'solid_fraction'):.4f}"
            f"   {m(rows, 'z_star'):.3f} ± {s(rows, 'z_star'):.3f}   {100 * m(rows, 'rattlers'):.1f}"
            f"         {m(rows, 'stiffness_to_pressure'):.3g}     {max(row['unbalanced'] for row in rows):.0e}"
        )
    verdict = common.Verdict()
    verdict.between("least stiffness to pressure", min(r["stiffness_to_pressure"] for r in samples.rows), 1e5, 1e7)
    verdict.near("z*", common.mean(samples.rows, "z_star"), Z_STAR, 0.05)
    if given.quick:  # a small sample is looser than an infinite one, by 0.002 [frictionless.md]
        verdict.near("solid fraction of 1,000 grains", common.mean(samples.rows, "solid_fraction"), 0.637, 0.004)
    else:
        fit, error = fit_of_sizes(samples.rows)
        print(f"infinite sample: solid fraction {fit[0]:.4f} ± {error:.4f}; {samples.seconds / 60:.1f} min of one core")
        verdict.near("solid fraction of an infinite sample", fit[0], SOLID_FRACTION, 0.002)
        common.draw(given, "frictionless", chart(samples.rows, fit))
    verdict.end()


main()
