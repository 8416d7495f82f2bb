#!/usr/bin/python3
"""The flow between the grains themselves: lattices against Zick and Homsy 1982, random packings against van der Hoef et al. 2005, and the pore network's permeability and forces against it."""

import math

import numpy
import suffuse

import common
from permeability import WAYS, packed, van_der_hoef

EXACT = {  # drag on a grain over that on a lone one: lattice, solid fraction, Zick and Homsy
    "simple cubic": [
        (0.027, 2.008), (0.064, 2.810), (0.125, 4.292), (0.216, 7.442), (0.343, 15.4), (0.45, 28.1), (0.5236, 42.1)
    ],
    "body-centered": [(0.6802, 162.9)],
    "face-centered": [(0.7405, 435.0)],
}
SITES = {
    "simple cubic": [(0, 0, 0)],
    "body-centered": [(0, 0, 0), (0.5, 0.5, 0.5)],
    "face-centered": [(0, 0, 0), (0.5, 0.5, 0), (0.5, 0, 0.5), (0, 0.5, 0.5)],
}
DRIVE = {"gradient": 1.0, "direction": "x"}


def lattice(kind, solid_fraction):
    """Drag on a grain over that on a lone one, 6 pi viscosity radius velocity."""
    sites = numpy.array(SITES[kind]) + [0.123, 0.277, 0.391]  # off the grid's own places
    radius = (3 * solid_fraction / (4 * math.pi * len(sites))) ** (1 / 3)
    flow = suffuse.resolve_flow(numpy.eye(3), sites, numpy.full(len(sites), radius), boxes_across=32)
    exact = dict(EXACT[kind])[solid_fraction]
    drag = 1 / (len(sites) * 6 * math.pi * radius * flow.permeability)
    return {"drag": drag, "exact": exact, "error": drag / exact - 1}


def scatter(forces):
    """Standard deviation of the forces along the flow over their mean."""
    return forces[:, 0].std() / forces[:, 0].mean()


def random_packing(way, grains, seed):
    world = packed(way, grains, seed)
    water, flow = suffuse.seep(world, **DRIVE), suffuse.resolve_flow(world, **DRIVE)
    solid_fraction = 1 - world.porosity
    network, resolved = numpy.array(water.grain_force), numpy.array(flow.grain_force)
    return {
        "solid_fraction": solid_fraction,
        "to_van_der_hoef": flow.permeability / common.DIAMETER**2 / van_der_hoef(solid_fraction),
        "network_to_resolved": water.permeability / flow.permeability,
        "yade_to_resolved": suffuse.seep(world, conductance="yade", **DRIVE).permeability / flow.permeability,
        "grid": flow.finer_permeability / flow.permeability - 1,
        "scatter_network": scatter(network),
        "scatter_resolved": scatter(resolved),
        "correlation": numpy.corrcoef(network[:, 0], resolved[:, 0])[0, 1],
    }


def graded_packing(coarse, seed):
    """One row: of grains of two sizes, forces by what the grains do; rattlers have fewer than two contacts."""
    ratio, content = 3.5, 0.2
    fines = round(coarse * content / (1 - content) * ratio**3)
    radius = numpy.concatenate([numpy.full(int(coarse), ratio), numpy.ones(fines)]) * common.DIAMETER / 2
    material = suffuse.Material(density=common.DENSITY, modulus=2e4 * common.PRESSURE, friction=math.radians(10))
    world = suffuse.make_cloud(radius, porosity=0.5, fine=radius < radius.max(), material=material, seed=int(seed))
    common.compact(world)
    water = suffuse.seep(world, **DRIVE)
    flow = suffuse.resolve_flow(world, boxes_across=24, **DRIVE)  # ten across a fine grain
    row = {
        "solid_fraction": 1 - world.porosity,
        "network_to_resolved": water.permeability / flow.permeability,
        "grid": flow.finer_permeability / flow.permeability - 1,
        "across_smallest": flow.across_smallest,
    }
    network, resolved = numpy.array(water.grain_force), numpy.array(flow.grain_force)
    fine, free = numpy.array(world.grains.fine) > 0, numpy.array(world.grains.coordination) < 2
    for name, rows in (("coarse", ~fine), ("active", fine & ~free), ("free", fine & free)):
        ours, exact = network[rows], resolved[rows]
        row[f"{name}_grains"] = len(ours)
        row[f"{name}_mean"] = ours[:, 0].mean() / exact[:, 0].mean()
        row[f"{name}_correlation"] = numpy.corrcoef(ours[:, 0], exact[:, 0])[0, 1]
        row[f"{name}_difference"] = math.sqrt(((ours - exact) ** 2).sum() / (exact**2).sum())
        row[f"{name}_scatter_network"], row[f"{name}_scatter_resolved"] = scatter(ours), scatter(exact)
    return row


def chart(packings):
    x = {"field": "solid_fraction", "type": "quantitative", "title": "solid fraction",
         "scale": {"zero": False, "domain": [0.51, 0.65]}}
    points = [
        {"solid_fraction": row["solid_fraction"], "ratio": row["to_van_der_hoef"] * factor, "of": of}
        for row in packings
        for of, factor in (("resolved", 1), ("pore network", row["network_to_resolved"]))
    ]
    y = {"field": "ratio", "type": "quantitative", "title": "permeability over van der Hoef et al.",
         "scale": {"domain": [0.8, 1.6], "zero": False}}
    return {
        "description": "Permeability of random packings over van der Hoef et al., resolved and by the pore network.",
        "width": 420, "height": 280,
        "layer": [
            {"data": {"values": [{"ratio": 1}]}, "mark": {"type": "rule", "strokeDash": [5, 4], "color": "#666666"},
             "encoding": {"y": y}},
            {"data": {"values": points}, "mark": {"type": "point", "filled": True, "size": 50, "opacity": 0.85},
             "encoding": {"x": x, "y": y, "color": {"field": "of", "type": "nominal", "title": None},
                          "shape": {"field": "of", "type": "nominal", "title": None}}},
        ],
    }


def main():
    given = common.options(__doc__)
    lattices, packings, graded = (
        common.Samples(given, name) for name in ("resolved_lattices", "resolved_flow", "resolved_graded")
    )
    for kind, cases in EXACT.items():
        for solid_fraction, _ in cases[-1:] if given.quick else cases:
            lattices.measure(lattice, kind=kind, solid_fraction=solid_fraction)
    ways = ["frictionless"] if given.quick else list(WAYS)
    grains, seeds = (150, 1) if given.quick else (900, 2)
    for way in ways:
        for seed in range(1, seeds + 1):
            packings.measure(random_packing, way=way, grains=grains, seed=seed)
    for seed in range(1, 1 if given.quick else 3):
        graded.measure(graded_packing, coarse=40, seed=seed)

    print("lattice          solid fraction  drag     exact    error %")
    for row in lattices.rows:
        print(f"{row['kind']:15}  {row['solid_fraction']:.4f}          {row['drag']:7.2f}  {row['exact']:7.2f}  {100 * row['error']:+.2f}")
    m, s = common.mean, common.deviation
    print("way                       solid fraction  to van der Hoef  finer grid %  network/resolved  Yade/resolved  correlation of forces  scatter: network, resolved")
    for way in ways:
        rows = packings.of(way=way)
        print(
            f"{way:24}  {m(rows, 'solid_fraction'):.4f}          {m(rows, 'to_van_der_hoef'):.3f}            "
            f"{100 * m(rows, 'grid'):+.1f}          {m(rows, 'network_to_resolved'):.3f} ± {s(rows, 'network_to_resolved'):.3f}"
            f"     {m(rows, 'yade_to_resolved'):.3f}         {m(rows, 'correlation'):.3f}                  {m(rows, 'scatter_network'):.3f}, {m(rows, 'scatter_resolved'):.3f}"
        )
    for row in graded.rows:
        print(f"two sizes, seed {row['seed']:.0f}: solid fraction {row['solid_fraction']:.4f}, network/resolved {row['network_to_resolved']:.3f}")
        for name in ("coarse", "active", "free"):
            print(
                f"  {name:6}  {row[name + '_grains']:4.0f} grains  mean {row[name + '_mean']:.3f}  correlation {row[name + '_correlation']:.3f}"
                f"  difference {row[name + '_difference']:.3f}  scatter {row[name + '_scatter_network']:.3f}, {row[name + '_scatter_resolved']:.3f}"
            )
    verdict = common.Verdict()
    for row in lattices.rows:
        verdict.near(f"{row['kind']} {row['solid_fraction']:.4f}, drag over the exact one", row["drag"] / row["exact"], 1, 0.015)
    for way in ways:
        rows = packings.of(way=way)
        verdict.near(f"solid fraction {m(rows, 'solid_fraction'):.3f}, over van der Hoef's", m(rows, "to_van_der_hoef"), 1, 0.15)
    if not given.quick:
        print(f"{(lattices.seconds + packings.seconds + graded.seconds) / 60:.1f} min of one core")
        common.draw(given, "resolved_flow", chart(packings.rows))
    verdict.end()


main()
