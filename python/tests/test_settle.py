"""Settling: as a stage of a case does it, and where it ends."""

import os
import pathlib

import numpy
import pytest

import suffuse


def test_a_cloud_carries_nothing_and_settles_at_once():
    reached = suffuse.make_cloud(numpy.full(100, 1e-4)).settle()
    assert reached["collapsed"] and reached["steps"] <= 2 * suffuse.Balance().patience


def test_a_sample_that_loses_its_stress_has_collapsed(settled):
    settled.remove(numpy.arange(0, 500, 2))
    reached = settled.settle(max_steps=50_000)
    assert reached["collapsed"] and abs(settled.mean_stress) <= 0.1  # a millionth of 100 kPa
    again = settled.settle(suffuse.Loading(stress="100 kPa"))
    assert not again["collapsed"] and settled.mean_stress == pytest.approx(100e3, rel=5e-3)


def test_a_sample_without_stress_is_not_lowered(settled):
    settled.grains.velocity = numpy.random.default_rng(1).normal(size=(500, 3))
    with pytest.raises(suffuse.StateError, match="no stress is held"):
        settled.settle(max_steps=50)


def test_a_sample_comes_to_rest_under_its_weight_on_grains_that_are_held(settled):
    grains, weight = settled.grains, numpy.zeros((500, 3))
    weight[:, 2] = -1e4 * grains.mass  # some hundredths of a contact force
    grains.held = grains.position[:, 2] % settled.cell[2, 2] < 0.1 * settled.cell[2, 2]
    reached = settled.settle(force=weight)["equilibrium"]
    assert reached["unbalanced_force"] <= suffuse.Balance().unbalanced_force
    borne = ~grains.held & (grains.coordination >= 2)  # the others fall
    left = numpy.linalg.norm((grains.force + weight)[borne], axis=1).mean()
    assert left < 0.05 * numpy.linalg.norm(weight[borne], axis=1).mean()


def test_a_packing_settles_to_the_bits_of_a_stage(tmp_path):
    case = suffuse.Case(pathlib.Path(os.environ["SUFFUSE_SOURCE_DIR"]) / "examples/replay/case.toml")
    run = case.run(tmp_path / "run", until="settled")
    world = run["replay/start"].world.copy()
    world.settle(suffuse.Loading(stress="100 kPa"))
    assert world.hash == run["replay/settled"].world.hash


def test_grains_keep_their_rows_where_a_force_names_them(settled):
    settled.sort("id")
    before = settled.grains.id.copy()
    settled.settle(force=numpy.zeros((500, 3)))
    assert (settled.grains.id == before).all()
    hash_before = settled.hash
    settled.sort()
    assert settled.hash == hash_before and not (settled.grains.id == before).all()


def test_a_stress_that_pulls_is_refused_as_in_a_case():
    for stress in (-1e5, (1e5, "-1 Pa", None)):
        with pytest.raises(suffuse.CaseError, match="compression is positive"):
            suffuse.Loading(stress=stress)


def small_cloud():
    return suffuse.make_cloud(numpy.linspace(0.5, 1.5, 200) * 1e-4, 0.55, seed=1)


def test_a_rate_that_no_step_can_follow_is_refused():
    world = small_cloud()
    for rate in (1e9, -1e9):
        with pytest.raises(suffuse.StateError, match="in one step"):
            world.step(1000, suffuse.Loading(strain_rate=rate))


def test_squeezed_grains_are_warned_of_as_a_case_is():
    world = small_cloud()
    world.compact("100 kPa", friction="20 deg", protocol="swift")
    with pytest.warns(UserWarning, match="the largest overlap is"):
        world.settle(suffuse.Loading(stress="3.3 MPa"))


def test_a_stress_that_squeezes_grains_into_each_other_is_refused_as_in_a_case(packing):
    before = packing.hash
    for call in (
        lambda: packing.settle(suffuse.Loading(stress="100 MPa")),
        lambda: packing.step(1, suffuse.Loading(strain_rate=(None, None, 1), stress=("100 MPa", 1e5, None))),
        lambda: packing.compact("100 MPa"),
    ):
        with pytest.raises(suffuse.CaseError, match="overlap by about 147.1 % of their radius.* 53 GPa keeps it below 1 %"):
            call()
    assert packing.hash == before


@pytest.mark.parametrize("law", ["linear-rolling", "hertz-mindlin"])
def test_stiff_grains_find_their_balance_under_a_small_stress(law):
    radius = 1e-4 * numpy.exp(numpy.random.default_rng(2).uniform(0, numpy.log(2), 200))
    world = suffuse.make_cloud(radius, 0.6, material=suffuse.Material(law=law, modulus="70 GPa"), seed=2)
    world.compact("100 kPa")
    # Grains fall to new places in d sqrt(rho/p), here some 10,000 steps; under a drag alone they take a thousand times that.
    assert world.settle(suffuse.Loading(stress="1 kPa"), max_steps=400_000)["equilibrium"]["unbalanced_force"] < 1e-3
