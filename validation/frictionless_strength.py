#!/usr/bin/python3
"""Friction angle of frictionless equal spheres: 5.76 degrees in plane strain [Peyneau and Roux 2008], and no dilatancy."""

import math

import numpy
import suffuse

import common

ANGLE, WITHIN = 5.76, 0.22  # theirs, quasi-static simple shear [degrees]
EXPONENT = 0.39  # theirs: the friction coefficient grows as this power of the inertial number
STIFFNESS = 4000  # to pressure
STRAIN, STEADY = 0.3, 0.1  # axial strain at the end, and from where on it is averaged
# Lateral stress held, or lateral length: x, y; z is compressed.
PATHS = {"plane strain": (True, False), "triaxial": (True, True)}


def angle_of(high, low):
    return math.degrees(math.asin((high - low) / (high + low)))


def measure(path, inertial_number, grains, seed):
    radius = numpy.full(int(grains), common.DIAMETER / 2)
    material = common.stiff(STIFFNESS, friction=0, shear_ratio=1e-3)
    world = suffuse.make_cloud(radius, porosity=0.5, material=material, seed=int(seed))
    common.compact(world)
    packed = common.state_of(world)["solid_fraction"]
    rate = common.rate_of(inertial_number)
    held = PATHS[path]
    loading = suffuse.Loading(
        strain_rate=(*(None if hold else 0 for hold in held), rate),
        stress=(*(common.PRESSURE if hold else None for hold in held), None), max_rate=max(50, 2 * rate),
    )
    world.reference_cell = world.cell
    stresses, fractions = [], []
    while world.strain[2] < STRAIN:
        stress = world.step(100, loading)
        if world.strain[2] > STEADY:
            stresses.append(numpy.diag(stress))
            fractions.append(1 - world.porosity)
    x, y, z = numpy.mean(stresses, axis=0)
    return {
        "angle": angle_of(z, x if path == "plane strain" else (x + y) / 2),
        "ratio": (z - (x + y) / 2) / ((x + y + z) / 3),
        "middle": y / ((x + z) / 2),
        "solid_fraction": float(numpy.mean(fractions)),
        "packed": packed,
    }


def limit(rows, name="angle"):
    """The value at no rate, its standard error, and the slope over the power of the inertial number."""
    x = numpy.array([row["inertial_number"] ** EXPONENT for row in rows])
    y = numpy.array([row[name] for row in rows])
    design = numpy.stack([numpy.ones_like(x), x], axis=1)
    fit, *_ = numpy.linalg.lstsq(design, y, rcond=None)
    spread = ((y - design @ fit) ** 2).sum() / max(1, len(y) - 2)
    return fit[0], math.sqrt(spread * numpy.linalg.inv(design.T @ design)[0, 0]), fit[1]


def lade_duncan(angle):
    """Friction angle in triaxial compression of the yield surface of Lade and Duncan, I1^3/I3 constant, that has `angle`
    in simple shear, where the middle stress is the mean of the others [degrees]."""
    sine = math.sin(math.radians(angle))
    invariant = 27 / (1 - sine * sine)
    low, high = 0.0, 0.5  # of s3 = 1 - x, s1 = 1 + 2 x
    for _ in range(60):
        x = (low + high) / 2
        low, high = (x, high) if 27 / ((1 + 2 * x) * (1 - x) ** 2) < invariant else (low, x)
    return angle_of(1 + 2 * x, 1 - x)


def chart(samples, fits):
    x = {"type": "quantitative", "title": "inertial number to the power 0.39"}
    y = {"type": "quantitative", "title": "friction angle [deg]", "scale": {"zero": False}}
    color = {"field": "path", "type": "nominal", "title": None}
    points = [{**row, "x": row["inertial_number"] ** EXPONENT} for row in samples]
    most = max(point["x"] for point in points)
    lines = [{"path": path, "x": at, "y": fit[0] + fit[2] * at} for path, fit in fits.items() for at in (0, most)]
    theirs = [{"x": 0, "y": ANGLE, "low": ANGLE - WITHIN, "high": ANGLE + WITHIN}]
    return {
        "description": "Friction angle of frictionless spheres against the rate, extrapolated to no rate.",
        "width": 460, "height": 280,
        "layer": [
            {"data": {"values": lines}, "mark": {"type": "line", "strokeWidth": 1.3},
             "encoding": {"x": {"field": "x", **x}, "y": {"field": "y", **y}, "color": color}},
            {"data": {"values": points}, "mark": {"type": "point", "filled": True, "size": 50, "opacity": 0.85},
             "encoding": {"x": {"field": "x", **x}, "y": {"field": "angle", **y}, "color": color}},
            {"data": {"values": theirs}, "mark": {"type": "rule", "color": "#111111", "strokeWidth": 2},
             "encoding": {"x": {"field": "x", **x}, "y": {"field": "low", **y}, "y2": {"field": "high"}}},
            {"data": {"values": theirs}, "mark": {"type": "point", "shape": "diamond", "size": 110, "color": "#111111"},
             "encoding": {"x": {"field": "x", **x}, "y": {"field": "y", **y}}},
        ],
    }


def main():
    given = common.options(__doc__)
    samples = common.Samples(given, "frictionless_strength")
    grains, seeds = (500, 6) if given.quick else (1000, 8)  # one sample's ratio of solid fractions scatters by 0.006
    rates = (1e-2, 1e-3) if given.quick else (1e-2, 3e-3, 1e-3)
    paths = ("plane strain",) if given.quick else tuple(PATHS)
    for rate in rates:
        for seed in range(1, seeds + 1):
            for path in paths:
                samples.measure(measure, path=path, inertial_number=rate, grains=grains, seed=seed)
    print("path          inertial number  angle          middle / mean of others  solid fraction sheared, packed")
    for path in paths:
        for rate in rates:
            rows = samples.of(path=path, inertial_number=rate)
            m, s = common.mean, common.deviation
            print(
                f"{path:12}  {rate:15.0e}  {m(rows, 'angle'):.2f} ± {s(rows, 'angle'):.2f}    {m(rows, 'middle'):.3f}"
                f"                    {m(rows, 'solid_fraction'):.4f}, {m(rows, 'packed'):.4f}"
            )
    fits = {path: limit(samples.of(path=path)) for path in paths}
    fractions = {path: limit(samples.of(path=path), "solid_fraction")[0] for path in paths}
    for path, fit in fits.items():
        print(f"{path}, no rate: {fit[0]:.2f} ± {fit[1]:.2f} deg, solid fraction {fractions[path]:.4f}")
    print(f"{samples.seconds / 60:.1f} min of one core")
    verdict = common.Verdict()
    verdict.near("friction angle in plane strain, no rate", fits["plane strain"][0], ANGLE, 2 if given.quick else 2 * WITHIN)
    verdict.near("solid fraction, no rate / packed", fractions["plane strain"] / common.mean(samples.rows, "packed"), 1, 0.01)
    if not given.quick:
        verdict.near("friction angle in triaxial compression, no rate; Lade-Duncan", fits["triaxial"][0], lade_duncan(ANGLE), 2 * WITHIN)
        common.draw(given, "frictionless_strength", chart(samples.rows, fits))
    verdict.end()


main()
