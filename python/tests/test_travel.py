"""Values that travel: copied, pickled, sent to other processes; the same bits there, and after further steps."""

import copy
import multiprocessing
import pickle

import numpy
import pytest

import suffuse

LOADING = suffuse.Loading(strain_rate=(None, None, "20 1/s"), stress=("100 kPa", "100 kPa", None))


def there_and_back(value):
    return pickle.loads(pickle.dumps(value))


def sheared(world):
    world.step(100, LOADING, time_step=4e-8)
    return world


def shear_copies(world):
    """In another process: the world as it arrived, and its hash after further steps."""
    before = world.hash
    sheared(world)
    return before, world.hash, world


SENDS = (there_and_back, copy.copy, copy.deepcopy, suffuse.World.copy)


@pytest.mark.parametrize("send", SENDS)
def test_a_world_goes_on_to_the_same_bits_wherever_it_is_sent(settled, send):
    sheared(settled)  # contacts remember, the servo too
    settled.material.friction = "30 deg"
    settled.material.twisting_stiffness, settled.material.twisting_friction = 1, 0.1
    settled.grains.held[3] = True
    settled.grains.fine[:50] = True
    sent = send(settled)
    for look in (
        lambda w: w.hash, lambda w: w.material, lambda w: w.step_number, lambda w: w.time, lambda w: w.seed,
        lambda w: w.cell.tolist(), lambda w: w.reference_cell.tolist(), lambda w: w.strain.tolist(),
        lambda w: w.stress.tolist(), lambda w: w.grains.fine.tolist(), lambda w: w.grains.held.tolist(),
        lambda w: w.grains.id.tolist(), lambda w: w.grains.force.tolist(), lambda w: sheared(w).hash,
    ):
        assert look(sent) == look(settled)
    sent.grains.position[0] += 1e-6
    assert sent.hash != settled.hash  # it is its own


def test_a_world_before_its_first_step_is_sent_too(packing):
    sent = there_and_back(packing)
    assert sent.hash == packing.hash and sheared(sent).hash == sheared(packing).hash


def test_worlds_go_to_other_processes_and_come_back(settled):
    sheared(settled)
    with multiprocessing.get_context("spawn").Pool(2, suffuse.set_threads, (1,)) as pool:
        there = pool.map(shear_copies, [settled, settled.copy()])
        [water] = pool.map(suffuse.seep, [settled])
    before = settled.hash
    sheared(settled)
    for arrived, stepped, world in there:
        assert arrived == before and stepped == settled.hash == world.hash
        assert sheared(world).hash == sheared(settled.copy()).hash
    assert water.permeability > 0


@pytest.mark.parametrize(
    "value",
    [
        suffuse.Material(friction="30 deg", adhesion_normal="1 kPa"), suffuse.Fluid(viscosity="2 mPa*s"),
        suffuse.Balance(patience=7), LOADING, suffuse.Loading(), suffuse.Loading(stress="50 kPa", max_rate=3),
        suffuse.Loading(stress="50 kPa", shear_stresses="released"),
        suffuse.Loading(velocity_gradient=[[0, 0, 1], [0, -2.5, 0], [0, 0, 0.1]]),
    ],
)
def test_settings_are_values(value):
    for send in (there_and_back, copy.copy, copy.deepcopy):
        assert send(value) == value and send(value) is not value
    assert eval(repr(value), vars(suffuse)) == value  # what is printed makes it again
    assert value != suffuse.Material(friction=0.1) and value != 3


def test_what_was_read_of_a_world_is_sent(settled):
    settled.grains.fine[:50] = True
    contacts, sizes = settled.contacts, suffuse.constrictions(settled)
    water = suffuse.seep(settled, gradient=0.05, direction=(1, 2, 0), tensor=True)
    for send in (there_and_back, copy.deepcopy):
        other = send(contacts)
        for name in ("i", "j", "image", "overlap", "normal", "normal_force", "shear_force", "moment", "sliding", "rolling"):
            assert (getattr(other, name) == getattr(contacts, name)).all()
        other = send(sizes)
        assert (other.diameter == sizes.diameter).all() and (other.center == sizes.center).all()
        assert (other.mean, other.median, other.d35) == (sizes.mean, sizes.median, sizes.d35)
        other = send(water)
        for name in ("pressure", "flux", "grain_force", "conductance", "pore_velocity", "tensor", "mean_velocity"):
            assert (getattr(other, name) == getattr(water, name)).all()
        assert other.reynolds_number == water.reynolds_number and other.fluid == water.fluid
        network = send(water.network)
        assert (network.inscribed_radius == water.network.inscribed_radius).all()
        assert network.constrictions(of="coarse").mean == water.network.constrictions(of="coarse").mean
        assert (send(settled.grains).position == settled.grains.position).all()


def test_cases_and_stages_are_sent_as_where_they_are(small_case, tmp_path):
    case = there_and_back(suffuse.Case(small_case, changes={"contact.friction": "30 deg"}))
    assert case.material.friction == pytest.approx(numpy.radians(30))
    run = there_and_back(case.run(tmp_path / "run"))
    stage = run["replay/settled"]
    assert stage.world.hash == copy.deepcopy(stage).world.hash == there_and_back(stage).world.hash
    assert len(pickle.dumps(stage)) < 1000  # without its world


def test_a_world_that_is_stepped_is_not_sent_half_done(settled):
    class Enough(Exception):
        pass

    sent = []

    def listener(part, steps):
        sent.append((there_and_back(settled).hash, settled.hash))  # between two bursts
        raise Enough

    with pytest.raises(Enough):
        settled.step(10**9, time_step=4e-8, on_progress=listener)
    assert sent[0][0] == sent[0][1]


def test_a_damaged_pickle_of_a_world_is_refused(settled):
    state = settled.__getstate__()
    with pytest.raises(suffuse.IoError, match="not an HDF5 file, or it is damaged"):
        suffuse.World.__new__(suffuse.World).__setstate__(state[: len(state) // 3])
    radius = state.index(settled.grains.radius.tobytes())
    with pytest.raises(suffuse.IoError, match="bytes of a state: it was changed or damaged"):
        suffuse.World.__new__(suffuse.World).__setstate__(state[:radius] + bytes([state[radius] ^ 1]) + state[radius + 1 :])
