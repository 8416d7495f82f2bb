#!/usr/bin/python3
"""The tests of a laboratory at four inertial numbers, of eight seeds and of three numbers of grains, and how long some of them
take: the tables of docs/how-to/test-a-soil.md. Takes minutes."""

import time

import common
import numpy as np
import suffuse

NUMBERS = ("compression", "extension", "stress_ratio", "k0", "compression_index", "swelling_index", "cycles")
RATES = (4e-3, 2e-3, 1e-3, 5e-4)
SEEDS = {1000: range(5, 13), 3000: range(5, 9), 10000: range(5, 7)}  # of each number of grains


def sample(grains, seed, void_ratio=0.75):
    """Radii 0.05 to 0.1 mm, 30 deg, at 100 kPa."""
    sand = suffuse.make_cloud(np.random.default_rng(seed).uniform(0.05e-3, 0.1e-3, grains), seed=seed)  # radii [m]
    sand.material.friction = np.radians(30)
    sand.compact("100 kPa", void_ratio=void_ratio, protocol="swift", void_ratio_tolerance=0.004)
    return sand


def measure(grains, seed, rate):
    """All tests, each of a copy of one sample."""
    begin = time.process_time()
    sand = sample(grains, seed)
    prepared = time.process_time()
    pace = {"inertial_number": rate, "mode": "fast"}
    compression = sand.copy().triaxial("5 %", **pace)["response"]
    extension = sand.copy().triaxial("5 %", direction="extension", **pace)["response"]
    shear = sand.copy().shear("10 %", hold="stress", **pace)
    oedometer = sand.copy().oedometer(["400 kPa", "50 kPa"], **pace)
    cyclic = sand.copy().cyclic(csr=0.25, cycles=40, **pace)
    angles = np.degrees([compression["friction_angle"], extension["friction_angle"]])
    found = (*angles, shear["peak_stress_ratio"], oedometer["k0"], oedometer["compression_index"],
             oedometer["swelling_index"], cyclic["cycles_to_liquefaction"] or 40)
    return {**dict(zip(NUMBERS, map(float, found))), "preparation": round(prepared - begin, 1)}


def line(name, rows):
    """A row of a table: means, and deviations of single samples where there are several."""
    cells = [name, str(len(rows))]
    for number in NUMBERS:
        scatter = f" ± {common.deviation(rows, number):.2g}" if len(rows) > 1 else ""
        cells.append(f"{common.mean(rows, number):.3g}{scatter}")
    seconds = common.mean(rows, "seconds") - common.mean(rows, "preparation")
    print("| " + " | ".join([*cells, f"{seconds:.1f} s"]) + " |")


def show_time(name, test):
    begin = time.perf_counter()
    test()
    print(f"| {name} | {time.perf_counter() - begin:.1f} s |")


given = common.options(__doc__)
samples = common.Samples(given, "laboratory_rates")
for number in RATES:
    line(f"{number:g}", [samples.measure(measure, grains=1000, seed=5, rate=number)])
for count, seeds in SEEDS.items():
    line(f"{count:,}", [samples.measure(measure, grains=count, seed=seed, rate=1e-3) for seed in seeds])
suffuse.set_threads(2)
large, small = sample(10000, 5), sample(2000, 5, void_ratio=0.70)
show_time("drained compression of 10,000 grains to 20 %", lambda: large.copy().triaxial("20 %", mode="fast"))
show_time("stiffness of 10,000 grains", large.stiffness)
show_time("ten undrained cycles of 2,000 grains", lambda: small.cyclic(csr=0.15, cycles=10, mode="fast"))
