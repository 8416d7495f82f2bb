"""Gradients that move fines of the fines of a World, against their weight."""

import numpy
import pytest
import suffuse


def pocket():
    """A fine grain above three coarse ones that touch: r = R."""
    radius, angle = 0.5e-3, 2 * numpy.pi / 3 * numpy.arange(3)
    ring = 2 * radius / numpy.sqrt(3) * numpy.column_stack([numpy.cos(angle), numpy.sin(angle), 0 * angle])
    level = 1.0005 * numpy.sqrt(8 / 3) * radius
    position = numpy.vstack([ring, [[0, 0, level]]]) + 2.5 * radius
    material = suffuse.Material(density=2650, rolling_stiffness=0)
    return suffuse.World(numpy.full(3, 5 * radius), position, numpy.full(4, radius), fine=[0, 0, 0, 1], material=material)


def test_a_grain_in_a_pocket_is_lifted_before_the_soil_heaves():
    world = pocket()
    before = numpy.array(world.grains.position)
    found = world.mobility([0.02, 0.1, 0.2], asked_gradient=0.1)
    assert numpy.array_equal(world.grains.position, before), "the world itself does not change"
    assert numpy.isnan(found["mobile_gradient"][numpy.array(world.grains.fine) == 0]).all()
    assert {0.02, 0.1, 0.2} <= set(found["gradient"])
    assert (numpy.diff(found["gradient"]) > 0).all() and numpy.diff(found["gradient"]).max() < 0.0501
    assert not found["still_growing"].any() and not any(found["critical_gradient_at_most"].values())
    share = found["mobile_mass_share"]
    assert (numpy.diff(share) >= 0).all() and set(share) <= {0.0, 1.0}
    solid = 4 * 4 / 3 * numpy.pi * 0.5**3 / 2.5**3
    assert found["heave_gradient"] == pytest.approx(1.65 * solid)


def test_the_motion_of_the_fines_has_keys():
    usual, softer = pocket().mobility([0.02, 0.2]), pocket().mobility([0.02, 0.2], softness=1e-4, fluid_drag=2)
    assert softer["weight_scale"] == pytest.approx(0.1 * usual["weight_scale"])
    assert softer["critical_gradient"]["1 %"] == pytest.approx(usual["critical_gradient"]["1 %"], abs=0.01)
    hasty = pocket().mobility([0.02, 0.2], hold_at_most=4)
    assert hasty["held_for"].max() == 4
    assert (pocket().mobility([0.02, 0.2], moved=10, hold_at_most=4)["mobile_mass_share"] == 0).all()


def test_impossible_input_is_reported():
    with pytest.raises(suffuse.CaseError, match="hold_at_most"):
        pocket().mobility([0.1], hold_at_most=1)
    with pytest.raises(suffuse.CaseError, match="above the one before"):
        pocket().mobility([0.2, 0.1])
    with pytest.raises(suffuse.CaseError, match="do not sink"):
        pocket().mobility([0.1], fluid=suffuse.Fluid(density=3000))
    world = pocket()
    world.grains.fine[:] = 0
    with pytest.raises(suffuse.StateError, match="no grain is fine"):
        world.mobility([0.1])
