#!/usr/bin/python3
"""The erosion loop by hand, in thirty lines: flow, probe, constrictions, removal, new equilibrium.

A sketch of what `do = "erode"` does with more care (a twin without water, a ledger, two detachment rules): start here to
try a rule of your own.
"""

import numpy

import suffuse

# A gap-graded soil: 120 coarse grains of 1 mm, and fines of 0.3 mm, a quarter of the mass; compacted to 50 kPa.
coarse, fine = numpy.full(120, 0.5e-3), numpy.full(int(120 / 3 / 0.3**3), 0.15e-3)
radius = numpy.concatenate([coarse, fine])
world = suffuse.make_cloud(radius, porosity=0.6, fine=radius < 0.3e-3, seed=2016)
world.compact("50 kPa", friction="10 deg", balance=suffuse.Balance(unbalanced_force=1e-2))
held_stress = suffuse.Loading(stress=numpy.diag(world.stress))
initial_mass = world.grains.mass.sum()
print(f"{len(world)} grains, void ratio {world.void_ratio:.4f}, mean stress {world.mean_stress / 1e3:.1f} kPa")

for turn in (1, 2):
    world.relax(1e-6)
    water = suffuse.seep(world, gradient=0.5, direction="z")
    dt = world.stable_time_step()

    # Probe a copy: coarse grains held, the water's force on the fines, as long as their free flight would take 2e-4 s.
    probe = world.copy()
    probe.grains.held = ~probe.grains.fine
    probe.grains.velocity, probe.grains.spin = 0, 0
    probe.step(2000, time_step=dt, force=water.grain_force)
    free = 2000 * dt * numpy.linalg.norm(water.grain_force, axis=1) / world.grains.mass
    detached = world.grains.fine & (numpy.linalg.norm(probe.grains.velocity, axis=1) > 0.5 * free)

    # The detached that fit through the mean constriction of the coarse skeleton leave.
    leave = detached & (world.grains.diameter < suffuse.constrictions(world, of="coarse").mean)
    lost = world.grains.mass[leave].sum() / initial_mass
    before = world.mean_stress
    removed = world.remove(leave)
    world.settle(balance=suffuse.Balance(unbalanced_force=1e-2))  # at constant volume: how much stress is lost
    at_constant_volume = world.mean_stress
    world.settle(held_stress, balance=suffuse.Balance(unbalanced_force=1e-2))  # then under the stresses of before
    print(f"pass {turn}: {detached.sum()} of {world.grains.fine.sum() + removed} fines detached, {removed} removed "
          f"({100 * lost:.2f} % of the mass); p {before / 1e3:.1f} -> {at_constant_volume / 1e3:.1f} kPa at constant "
          f"volume; void ratio {world.void_ratio:.4f}")
    if removed == 0:
        break
