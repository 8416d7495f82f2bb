"""Fines of a World that travel with the water."""

import numpy
import pytest
import suffuse
from test_mobility import pocket


def test_a_grain_that_the_water_carries_away_is_gone():
    world = pocket()
    mass = float(world.grains.mass[3])
    found = world.migrate([2.0], exit="0.3 mm")  # before it comes under the three grains of the next cell, which may hold it
    assert found["grains"]["fate"] == ["eroded"] and found["grains"]["left"][0] > found["grains"]["departed"][0] > 0
    assert found["grains"]["mass"][0] == mass and found["eroded_mass_share"] == 1
    assert len(world.grains.radius) == 3 and not numpy.array(world.grains.fine).any()
    rows = found["rows"]
    assert rows["eroded_mass_share"][-1] == 1 and (numpy.diff(rows["energy"]) > 0).all()
    assert rows["time"][-1] == pytest.approx(found["seconds"])


def test_a_grain_that_the_water_cannot_lift_stays():
    world = pocket()
    found = world.migrate([0.02], hold_at_most="0.2 s", still_for="0.05 s")
    assert found["grains"]["fate"] == ["stayed"] and found["holds"][0]["ended"]
    assert numpy.isnan(found["grains"]["departed"]).all() and len(world.grains.radius) == 4
    assert numpy.linalg.norm(found["grains"]["end"] - found["grains"]["start"]) < 1e-5


def test_a_hold_that_is_cut_is_a_warning():
    with pytest.warns(UserWarning, match="motion had not ended"):
        pocket().migrate([2.0], hold_at_most="0.01 s", still_for="0.005 s")


def test_fed_grains_enter_with_the_water_and_are_accounted_for():
    world = pocket()
    fine = float(world.grains.mass[3])
    with pytest.warns(UserWarning, match="motion had not ended"):
        found = world.migrate([0.5], exit="2 mm", feed="40 kg/m3", hold_at_most="0.2 s")
    grains = found["grains"]
    entered = ~numpy.isnan(grains["entered"])
    assert entered.sum() > 3 and not entered[0], "the one that was there has never entered"
    assert (numpy.diff(grains["entered"][entered]) > 0).all()
    assert found["fed_mass_share"] == pytest.approx(grains["mass"][entered].sum() / fine)
    left = numpy.array(grains["fate"]) == "eroded"
    assert found["eroded_mass_share"] == pytest.approx(grains["mass"][left].sum() / fine)
    assert len(world.grains.radius) == 3 + (~left).sum()


def test_what_ends_the_call_leaves_the_world_as_it_was():
    world = pocket()
    before = numpy.array(world.grains.position)

    def stop(part, steps):
        raise RuntimeError(part)

    with pytest.raises(RuntimeError):
        world.migrate([0.02], hold_at_most=1000, still_for=1000, on_progress=stop)
    assert numpy.array_equal(world.grains.position, before)


def test_impossible_settings_are_reported():
    with pytest.raises(suffuse.CaseError, match="gradients"):
        pocket().migrate([])
    with pytest.raises(suffuse.CaseError, match="softness"):
        pocket().migrate([0.1], softness=0.5)
    with pytest.raises(suffuse.CaseError, match="friction"):
        pocket().migrate([0.1], friction="90 deg")
    with pytest.raises(suffuse.StateError, match="exit"):
        pocket().migrate([0.1], exit="1 m")
