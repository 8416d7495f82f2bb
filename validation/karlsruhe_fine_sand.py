#!/usr/bin/python3
"""Karlsruhe fine sand in the laboratory and in the model: tables and figure of validation/karlsruhe_fine_sand.md. Takes minutes.

The laboratory's curves are in karlsruhe_fine_sand_lab.csv, thinned. The parameters are those of an earlier fit to the drained
tests at 100 and 400 kPa by Hertz-Mindlin; the tests at 200 kPa, the oedometer and the undrained tests were not fitted."""

import csv
import pathlib

import common
import numpy as np
import suffuse

HERE = pathlib.Path(__file__).resolve().parent
SIZES, SHARES = np.array([0.10e-3, 0.14e-3, 0.20e-3]), np.array([0, 0.5, 1.0])
# log10 of Young's modulus of the grains [Pa], friction [deg], rolling friction, void ratio; drained, oedometer tests
STATES = {
    "loose": ((9.851, 27.837, 0.114, 0.767), {100e3: "TMD2", 200e3: "TMD3", 400e3: "TMD5"}, "OE4"),
    "medium": ((9.673, 20.805, 0.228, 0.638), {100e3: "TMD12", 200e3: "TMD13", 400e3: "TMD15"}, "OE8"),
    "dense": ((9.739, 20.012, 0.251, 0.576), {100e3: "TMD22", 200e3: "TMD23", 400e3: "TMD25"}, "OE11"),
}
STRAINS = np.array([0.005, 0.02, 0.05, 0.10])
GRID = np.arange(0, 0.1001, 0.0025)  # of the figure
SEEDS = (21, 22)


def laboratory():
    curves = {}
    with open(HERE / "karlsruhe_fine_sand_lab.csv", newline="", encoding="utf-8") as file:
        for row in csv.DictReader(line for line in file if not line.startswith("#")):
            curves.setdefault(row["test"], []).append((float(row["x"]), float(row["y"]), float(row["z"])))
    return {test: np.array(rows).T for test, rows in curves.items()}


def radii(seed, count=1000):
    random = np.random.default_rng(seed)
    diameters = np.exp(np.interp((np.arange(count) + random.random(count)) / count, SHARES, np.log(SIZES)))
    weights = diameters**-3
    return 0.5 * diameters[random.choice(count, size=count, p=weights / weights.sum())]


def sample(parameters, pressure, seed):
    modulus, friction, rolling, void_ratio = parameters
    sand = suffuse.make_cloud(radii(seed), seed=seed)
    material = sand.material
    material.law, material.poisson, material.density = "hertz-mindlin", 0.2, 2650
    material.modulus, material.friction, material.rolling_friction = 10**modulus, np.radians(friction), rolling
    sand.compact(pressure, void_ratio=void_ratio, protocol="swift", void_ratio_tolerance=0.005)
    return sand


def drained(parameters, pressure):
    """q/p0 and the volumetric strain [%] over GRID, the mean over the seeds."""
    ours = []
    for seed in SEEDS:
        curve = sample(parameters, pressure, seed).triaxial(0.101, rows=200, mode="fast")["curve"]
        strain, q, volume = (np.array([row[key] for row in curve])
                             for key in ("axial_strain", "deviator_stress", "volumetric_strain"))
        ours.append([np.interp(GRID, strain, q) / pressure, 100 * np.interp(GRID, strain, volume)])
    return np.mean(ours, axis=0)


def at_strains(values):
    return np.interp(STRAINS, GRID, values)


def chart(rows):
    """A column a state: q/p0 above, volumetric strain below; the laboratory dashed."""
    def panel(field, title):
        axis = {"field": field, "type": "quantitative", "title": title}
        return {
            "width": 200, "height": 170, "mark": {"type": "line", "strokeWidth": 1.6},
            "encoding": {
                "x": {"field": "strain", "type": "quantitative", "title": "axial strain [%]"}, "y": axis,
                "color": {"field": "pressure", "type": "nominal", "title": "lateral stress [kPa]"},
                "strokeDash": {"field": "source", "type": "nominal", "title": None,
                               "scale": {"domain": ["model", "laboratory"], "range": [[1, 0], [5, 3]]}},
                "column": {"field": "state", "title": None, "sort": list(STATES)},
            },
        }
    return {"data": {"values": rows}, "vconcat": [
        panel("ratio", "q over the lateral stress"), panel("volume", "volumetric strain [%]")]}


def show(values, digits):
    return " / ".join(f"{value:.{digits}f}" for value in values)


def main():
    given = common.options(__doc__)
    lab, rows = laboratory(), []

    def draw_later(state, pressure, source, strain, ratio, volume):
        rows.extend({"state": state, "pressure": f"{pressure / 1e3:.0f}", "source": source, "strain": float(x),
                     "ratio": float(y), "volume": float(z)} for x, y, z in zip(strain, ratio, volume))

    for state, (parameters, tests, oedometer) in STATES.items():
        for pressure, test in tests.items():
            try:
                ratio, volume = drained(parameters, pressure)
            except suffuse.Error as error:
                print(f"| {state} | {pressure / 1e3:.0f} | {test} | not made: {error} |")
                continue
            strain, q, contraction = lab[test]
            theirs = np.interp(100 * STRAINS, strain, q) / (pressure / 1e3)
            print(f"| {state} | {pressure / 1e3:.0f} | {test} | {show(theirs, 2)} | {show(at_strains(ratio), 2)} "
                  f"| {show(np.interp(100 * STRAINS, strain, contraction), 2)} | {show(at_strains(volume), 2)} |", flush=True)
            draw_later(state, pressure, "model", 100 * GRID, ratio, volume)
            shown = strain <= 10
            draw_later(state, pressure, "laboratory", strain[shown], q[shown] / (pressure / 1e3), contraction[shown])
        stress, strain, _ = lab[oedometer]
        theirs = np.interp([50, 100, 200, 400], stress, strain) - np.interp(25, stress, strain)
        found, k0 = [], []
        for seed in SEEDS:
            result = sample(parameters, 25e3, seed).oedometer([400e3], mode="fast")
            axial = np.array([row["stress"][2][2] for row in result["curve"]])
            found.append(100 * np.interp([50e3, 100e3, 200e3, 400e3], axial,
                                         [row["axial_strain"] for row in result["curve"]]))
            k0.append(result["k0"])
        print(f"| {state} | oedometer | {oedometer} | {show(theirs, 2)} | {show(np.mean(found, axis=0), 2)} "
              f"| K0 {np.mean(k0):.2f} |", flush=True)
    for test, pressure in (("TMU1", 100e3), ("TMU4", 400e3)):
        strain, q, p = lab[test]
        print(f"| {test} | laboratory | q/p0 {show(np.interp(100 * STRAINS[:3], strain, q) / pressure * 1e3, 2)} "
              f"| p/p0 {show(np.interp(100 * STRAINS[:3], strain, p) / pressure * 1e3, 2)} |")
        for state, (parameters, _, _) in STATES.items():
            ours = []
            for seed in SEEDS:
                curve = sample(parameters, pressure, seed).triaxial(0.051, path="undrained", mode="fast")["curve"]
                axial, deviator, mean = (np.array([row[key] for row in curve])
                                         for key in ("axial_strain", "deviator_stress", "mean_stress"))
                ours.append([np.interp(STRAINS[:3], axial, deviator) / pressure,
                             np.interp(STRAINS[:3], axial, mean) / pressure])
            ratio, effective = np.mean(ours, axis=0)
            print(f"| {test} | {state} | q/p0 {show(ratio, 2)} | p/p0 {show(effective, 2)} |", flush=True)
    common.draw(given, "karlsruhe_fine_sand", chart(rows))


main()
