#!/usr/bin/python3
"""An undrained triaxial test driven step by step, and the same test by World.triaxial: the curves agree.

By hand as in a Yade script: choose a strain rate, step, look at the state. The program's own test chooses the rate from
an inertial number, as here. A drained test of the program also starts slowly, and waits whenever a stress that it holds is
off by more than 1 %.
"""

import pathlib

import numpy

import suffuse

EXAMPLE = pathlib.Path(__file__).parents[1] / "replay"
CELL = (1.4360856339985508e-3, 1.4358137235332051e-3, 1.436026846625529e-3)
STRAIN, PRESSURE, INERTIAL_NUMBER = 0.01, 100e3, 3e-3

world = suffuse.read_packing(EXAMPLE / "packing.csv", cell=CELL)
world.settle(suffuse.Loading(stress=PRESSURE))
world.sort()
world.reference_cell = world.cell
reference = world.copy()

# ---- by hand
start = numpy.diag(world.stress)
diameter, passing = world.gradation()
median = diameter[numpy.searchsorted(passing, 0.5)]
rate = INERTIAL_NUMBER * numpy.sqrt(world.mean_stress / world.material.density) / median
loading = suffuse.Loading(strain_rate=(-rate / 2, -rate / 2, rate))  # at constant volume

curve, bursts = [(0.0, start[2] - 0.5 * (start[0] + start[1]), 0.0)], 0
while world.strain[2] < STRAIN:
    if bursts % 20 == 0:
        time_step = world.stable_time_step()
    stress = world.step(50, loading, time_step=time_step)
    bursts += 1
    curve.append((world.strain[2], stress[2, 2] - 0.5 * (stress[0, 0] + stress[1, 1]), world.strain.sum()))
curve = numpy.array(curve)

# ---- by the program
test = reference.triaxial(STRAIN, path="undrained", inertial_number=INERTIAL_NUMBER, inertia="own")
theirs = numpy.array([(row["axial_strain"], row["deviator_stress"]) for row in test["curve"]])

print(" strain   q by hand   q by suffuse")
for strain in numpy.linspace(0.2, 1, 5) * STRAIN:
    ours = numpy.interp(strain, curve[:, 0], curve[:, 1]) / 1e3
    print(f"{100 * strain:5.1f} %  {ours:7.2f} kPa  {numpy.interp(strain, *theirs.T) / 1e3:7.2f} kPa")

difference = numpy.abs(numpy.interp(theirs[:, 0], curve[:, 0], curve[:, 1]) - theirs[:, 1])[1:-1].max()
print(f"largest difference {difference:.3g} Pa, of {theirs[:, 1].max() / 1e3:.1f} kPa")
