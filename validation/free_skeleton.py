#!/usr/bin/python3
"""Two attempts at fines of weight in a skeleton that is free to move, on a uniform packing: docs/decisions has what they gave.

Weight and seepage are multiplied by K, so that weight presses two grains together by a thousandth of their radius."""

import numpy as np

import common
import suffuse

GRAINS, RADIUS = 800, 0.5e-3  # [m]
UP = np.array([0.0, 0.0, 1.0])
FLUID, GRAVITY = 1000.0, 9.81  # [kg/m3], [m/s2]


def packing(pressure, seed):
    """Equal grains, compacted to `pressure` [Pa]."""
    material = suffuse.Material(law="linear-rolling", modulus="700 MPa", friction="37 deg", rolling_friction=0.22)
    world = suffuse.make_cloud(np.full(GRAINS, RADIUS), 0.55, material=material, seed=seed)
    world.compact(pressure)
    return world


def body_forces(world, scale=None):
    """Buoyant weight of each grain, its seepage force at i = 1 [N], and the factor K unless `scale` is."""
    grains = world.grains
    weight = -np.outer((world.material.density - FLUID) * GRAVITY * grains.mass / world.material.density, UP)
    seepage = suffuse.seep(world, gradient=1, direction="z").grain_force
    stiffness = world.material.modulus * RADIUS  # of the normal spring, up to a factor near one
    return weight, seepage, scale or 1e-3 * RADIUS * stiffness / abs(weight[0, 2])


def critical(world):
    return (1 - world.porosity) * (world.material.density / FLUID - 1)


def supported_everywhere(world, gradient, depth):
    """Attempt 1: all periodic; what weight and seepage exert on the whole is taken up by all grains, by mass.

    @param depth that the stress is of [m]: it must grow with the forces, so that K follows from both"""
    scale = world.stress[2, 2] / (critical(world) * FLUID * GRAVITY * depth)
    weight, seepage, scale = body_forces(world, scale)
    pull = weight + gradient * seepage
    mass = world.grains.mass[:, None]
    force = scale * (pull - mass / mass.sum() * pull.sum(axis=0))
    before = world.grains.position.copy()
    stress = world.stress[2, 2]
    moved = world.copy()
    moved.step(20_000, suffuse.Loading(stress=[stress] * 3), force=force)
    fall = np.sqrt(2 * RADIUS / (scale * GRAVITY)) / moved.stable_time_step()  # steps in which a grain falls half a diameter
    return np.abs(moved.grains.position - before).max() / (2 * RADIUS), moved.stress[2, 2] / stress, scale, fall


class Column:
    """Attempt 2: the packing on a floor of held grains, with room above it, and a load on the grains of its top."""

    def __init__(self, world):
        self.weight, self.seepage, self.scale = body_forces(world)
        place, cell = world.grains.position.copy(), world.cell.copy()
        place[:, 2] %= cell[2, 2]
        self.height = cell[2, 2]
        cell[2, 2] *= 1.5
        self.world = suffuse.World(cell, place, world.grains.radius, material=world.material)
        self.floor = place[:, 2] < 4 * RADIUS
        self.top = place[:, 2] > self.height - 2 * RADIUS
        self.world.grains.held = self.floor.astype(np.uint8)
        self.area = cell[0, 0] * cell[1, 1]

    def heaves_at(self, load, gradients):
        """The first gradients at which one grain of a hundred, and half of all, have risen by a tenth of a diameter.

        @param load [Pa]"""
        world = self.world.copy()
        free = ~self.floor
        surcharge = np.zeros_like(self.weight)
        surcharge[self.top] = -load * self.area / self.top.sum() * UP
        world.step(30_000, suffuse.Loading(strain_rate=[0, 0, 0]), force=self.scale * (self.weight + surcharge))
        rest = world.grains.position[free, 2].copy()
        found = {}
        for gradient in gradients:
            force = self.scale * (self.weight + surcharge + gradient * self.seepage)
            world.step(10_000, suffuse.Loading(strain_rate=[0, 0, 0]), force=force)
            risen = (world.grains.position[free, 2] - rest > 0.2 * RADIUS).mean()
            for share in (0.01, 0.5):
                if risen >= share:
                    found.setdefault(share, gradient)
            if len(found) == 2:
                break
        return found.get(0.01, np.nan), found.get(0.5, np.nan)

    def expected(self, load):
        """Of the free part: its weight and the load, over its seepage force at i = 1."""
        free = ~self.floor
        return (-self.weight[free, 2].sum() + load * self.area) / self.seepage[free, 2].sum()


def main():
    given = common.options(__doc__)
    for seed in (1, 2) if not given.quick else (1,):
        world = packing("10 kPa", seed)
        heave = critical(world)
        print(f"seed {seed}: (1 - n)(Gs - 1) = {heave:.3f}")
        for depth in (0.1, 1, 10):
            for share in (0.5, 2):
                moved, stress, scale, fall = supported_everywhere(world, share * heave, depth)
                print(
                    f"  1, at {depth:g} m, i = {share:g} i_c: a grain moved {moved:.4f} d at most, stress {stress:.3f} of before;"
                    f" K = {scale:.3g}, {fall:,.0f} steps for half a diameter"
                )
        column = Column(world)
        for load in (0, 5, 20):
            expected = column.expected(load)
            first, half = column.heaves_at(load, expected * np.arange(0.3, 1.3, 0.02))
            print(
                f"  2, column of {column.height / (2 * RADIUS):.1f} d, load {load} Pa: 1 % of the grains rise at {first:.3f},"
                f" half at {half:.3f}, balance says {expected:.3f}"
            )


main()
