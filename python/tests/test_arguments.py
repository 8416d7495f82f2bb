"""Arguments of what moves a world: the ranges and the words of a case."""

import math

import pytest

import suffuse


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
