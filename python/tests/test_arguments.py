"""Arguments of what moves a world: the ranges and the words of a case."""

import math

import numpy
import pytest

import suffuse
from suffuse.run import Tensor


def test_steps_are_held_to_the_ranges_of_a_case(settled):
    before = settled.hash
    calls = (
        lambda **given: settled.step(10, **given), settled.settle, settled.relax, settled.triaxial, settled.stress_probe,
        lambda **given: settled.compact("100 kPa", **given),
    )
    for call in calls:
        for wrong in (1, 1.5, -0.5, math.nan, "120 %"):
            with pytest.raises(suffuse.CaseError, match="damping"):
                call(damping=wrong)
    for call in calls[:-1]:
        for wrong in (0, -1e-8, math.nan, 2e-7, "1 ms"):
            with pytest.raises(suffuse.CaseError, match="time_step"):
                call(time_step=wrong)
    assert "beyond which this sample is unstable" in str(pytest.raises(suffuse.CaseError, settled.step, 1, time_step=2e-7).value)
    with pytest.raises(suffuse.CaseError, match="wanted"):
        settled.relax(math.nan)
    with pytest.raises(suffuse.CaseError, match="max_steps"):
        settled.settle(max_steps=0)
    with pytest.raises(suffuse.CaseError, match="patience"):
        suffuse.Balance(patience=0)
    with pytest.raises(suffuse.CaseError, match="max_rate"):
        suffuse.Loading(stress="100 kPa", max_rate=0)
    assert settled.hash == before
    settled.step(1, damping="20 %", time_step=4e-8)


def test_a_time_step_is_checked_again_where_the_sample_was_changed(settled):
    settled.step(1, time_step=4e-8)
    settled.material.modulus *= 100
    with pytest.raises(suffuse.CaseError, match="this sample is unstable"):
        settled.step(1, time_step=4e-8)
    settled.material.modulus /= 100
    settled.step(1, time_step=4e-8)
    settled.material.density /= 100
    with pytest.raises(suffuse.CaseError, match="this sample is unstable"):
        settled.step(1, time_step=4e-8)


def test_cells_and_vectors_that_are_none_are_named():
    for cell in (1.0, None, "1 m", {1, 2, 3}, (1, 2), ((1, 2), (3, 4), (5, 6))):
        with pytest.raises(suffuse.CaseError, match="^cell: "):
            suffuse.World(cell, [[0.5] * 3], [0.1])
    for wrong in (1.0, "1 1/s", ((1, 2, 3),)):
        with pytest.raises(suffuse.CaseError, match="^velocity_gradient: "):
            suffuse.Loading(velocity_gradient=wrong)


def test_a_world_without_grains_says_so():
    world = suffuse.World((1, 1, 1), numpy.zeros((0, 3)), [])
    for call in (lambda: world.step(1), world.settle, world.relax, lambda: world.compact("100 kPa"), world.triaxial):
        with pytest.raises(suffuse.StateError, match="has no grains"):
            call()
    with pytest.raises(suffuse.CaseError, match="of the 0 grains"):
        world.remove([0])


def test_words_of_a_case_are_taken(settled, packing):
    for direction in ("+x", "x", (1, 0, 0)):
        assert suffuse.seep(packing, direction=direction).permeability > 0
    for word, ratio in (("strict", 1e-4), ("loose", 1e-3)):
        rates = [settled.copy().triaxial(1e-5, inertial_number=n, rows=1)["strain_rate"] for n in (word, ratio)]
        assert rates[0] == rates[1]
    by_word, computed = settled.copy(), settled.copy()
    by_word.step(60, time_step="computed")
    computed.step(60)
    assert by_word.hash == computed.hash


def test_a_docstring_names_arguments_that_the_call_has():
    for name in ("step", "settle", "relax"):
        doc = getattr(suffuse.World, name).__doc__
        signature = doc.splitlines()[0]
        for word in ("time_step", "damping", "force", "mode", "on_progress"):
            assert (f"\n{word}: " in doc or f"\n    {word}: " in doc) == (f"{word}:" in signature), (name, word)


def test_a_cloud_of_nothing_is_refused():
    with pytest.raises(suffuse.CaseError, match="radius: found no grains"):
        suffuse.make_cloud([])


def test_the_velocity_gradient_is_the_loadings(settled):
    with pytest.raises(AttributeError):
        settled.velocity_gradient = [[-5, 0, 0], [0, 0, 0], [0, 0, 0]]
    gradient = [[-5, 0, 0], [0, 0, 0], [0, 0, 0]]
    settled.step(10, suffuse.Loading(velocity_gradient=gradient))
    assert settled.velocity_gradient.tolist() == gradient


def test_a_stress_is_reported_in_units_of_pressure_only():
    stress = (1e5 * numpy.eye(3)).view(Tensor)
    assert stress("kPa")[0, 0] == 100
    with pytest.raises(suffuse.UnitError, match="a pressure is expected"):
        stress("mm")
