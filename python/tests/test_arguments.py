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
        said = getattr(suffuse.World, name).__doc__
        signature = said.splitlines()[0]
        for word in ("time_step", "damping", "force", "mode", "on_progress"):
            assert (f"\n{word}: " in said or f"\n    {word}: " in said) == (f"{word}:" in signature), (name, word)


def test_a_cloud_of_nothing_is_refused():
    with pytest.raises(suffuse.CaseError, match="radius: found no grains"):
        suffuse.make_cloud([])


def test_the_velocity_gradient_is_the_loadings(settled):
    with pytest.raises(AttributeError):
        settled.velocity_gradient = [[-5, 0, 0], [0, 0, 0], [0, 0, 0]]
    gradient = [[-5, 0, 0], [0, 0, 0], [0, 0, 0]]
    settled.step(10, suffuse.Loading(velocity_gradient=gradient))
    assert settled.velocity_gradient.tolist() == gradient


def test_a_stress_is_told_in_units_of_pressure_only():
    stress = (1e5 * numpy.eye(3)).view(Tensor)
    assert stress("kPa")[0, 0] == 100
    with pytest.raises(suffuse.UnitError, match="a pressure is expected"):
        stress("mm")
