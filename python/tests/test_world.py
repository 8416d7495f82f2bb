"""Worlds: views that never dangle, steps that meet closed forms."""

import copy
import gc
import pathlib
import pickle
import re

import numpy
import pytest

import suffuse


def test_columns_are_looked_at_without_a_copy(packing):
    x = packing.grains.position
    assert x.shape == (500, 3) and x.dtype == float and not x.flags.owndata
    assert packing.grains.position.__array_interface__["data"] == x.__array_interface__["data"]
    x[7] = [1e-3, 2e-3, 3e-3]
    assert packing.grains.position[7].tolist() == [1e-3, 2e-3, 3e-3]


def test_what_follows_from_others_cannot_be_written(packing):
    for name in ("radius", "mass", "inertia", "id", "force", "torque"):
        with pytest.raises(ValueError):
            getattr(packing.grains, name)[0] = 1
        with pytest.raises(AttributeError):
            setattr(packing.grains, name, 1)
    packing.grains.velocity = [1, 2, 3]
    assert (packing.grains.velocity == [1, 2, 3]).all()


def test_a_view_outlives_its_world(packing):
    x = packing.grains.position
    before = x.copy()
    gone = packing
    del packing
    del gone
    gc.collect()
    numpy.zeros(500 * 3 * 100)  # would reuse freed memory
    assert (x == before).all()


def test_views_stay_where_they_are_while_the_world_steps(settled):
    x, v = settled.grains.position, settled.grains.velocity
    place, before = x.__array_interface__["data"], x.copy()
    settled.step(500, suffuse.Loading(strain_rate=(0, 0, "50 1/s")))
    assert settled.grains.position.__array_interface__["data"] == place
    assert (x != before).any() and (x == settled.grains.position).all() and (v == settled.grains.velocity).all()


def test_a_column_of_0_and_1_is_not_taken_for_rows(settled):
    fine = settled.grains.fine
    for mask in (numpy.asarray(fine, dtype=float), numpy.asarray(fine, dtype=int), [1.5]):
        with pytest.raises(suffuse.CaseError, match="write MASK == 1"):
            settled.remove(mask)
    assert settled.remove([]) == 0 and len(settled) == 500
    assert settled.remove(numpy.asarray(fine, dtype=int) == 1) == numpy.count_nonzero(fine)


def test_views_keep_the_rows_of_before_when_grains_leave(settled):
    x, r, ids = settled.grains.position, settled.grains.radius, settled.grains.id
    before = x.copy(), r.copy(), ids.copy()
    leave = numpy.arange(0, 500, 10)
    assert settled.remove(leave) == 50
    assert len(settled) == 450 and len(settled.grains) == 450 and len(x) == 500
    assert set(settled.grains.id) == set(numpy.delete(ids, leave))
    settled.step(100)
    for view, kept in zip((x, r, ids), before):
        assert (view == kept).all()


def test_views_survive_sorting(settled):
    x = settled.grains.position
    before, state = x.copy(), settled.hash
    settled.sort("id")
    assert (x == before).all() and settled.hash == state
    assert (numpy.diff(settled.grains.id.astype(int)) > 0).all()


def test_the_force_of_two_grains_is_that_of_the_law(two_grains):
    two_grains.step(1, time_step=1e-12, damping=0)
    c = two_grains.contacts
    # kn = 2 E r r/(r + r) = E r; the overlap is 0.01 r.
    assert c.compression[0] == pytest.approx(356e6 * 1e-3 * 0.01e-3, rel=1e-9)
    assert two_grains.grains.force[0] == pytest.approx(c.normal_force[0])


def test_a_force_from_outside_accelerates(two_grains):
    apart = suffuse.World((10e-3,) * 3, [[2e-3] * 3, [8e-3] * 3], [1e-3, 1e-3])
    force = numpy.array([[1e-3, 0, 0], [0, 0, 0]])
    apart.step(100, time_step=1e-6, damping=0, force=force)
    assert apart.grains.velocity[0, 0] == pytest.approx(1e-3 / apart.grains.mass[0] * 1e-4, rel=1e-12)
    assert (apart.grains.velocity[1] == 0).all()
    apart.grains.held[0] = True
    before = apart.grains.velocity[0].copy()
    apart.step(100, time_step=1e-6, damping=0, force=force)
    assert (apart.grains.velocity[0] == before).all()


def test_grains_that_were_moved_by_hand_are_found(two_grains):
    two_grains.step(10, time_step=1e-9)
    assert len(two_grains.contacts) == 1
    two_grains.grains.position[1] = [8.9e-3, 8.9e-3, 8.9e-3]
    two_grains.grains.position[0] = [8.9e-3 - 1.995e-3, 8.9e-3, 8.9e-3]
    two_grains.step(1, time_step=1e-9)
    assert two_grains.contacts.overlap[0] == pytest.approx(0.005e-3, rel=1e-6)


def test_grains_that_progress_moves_by_hand_are_found():
    world = suffuse.World((10e-3,) * 3, [[2e-3] * 3, [8e-3] * 3], [1e-3, 1e-3])
    world.grains.held = True
    contacts = []

    class Enough(Exception):
        pass

    def move(part, steps):
        world.grains.position[1] = [2e-3 + 1.99e-3, 2e-3, 2e-3]
        contacts.append(len(world.contacts))
        if len(contacts) > 3:
            raise Enough

    with pytest.raises(Enough):
        world.step(10**9, time_step=1e-9, on_progress=move)
    assert contacts[0] == 0 and contacts[-1] == 1


def test_steps_do_not_depend_on_how_they_are_cut(settled):
    other = settled.copy()
    loading = suffuse.Loading(strain_rate=(0, 0, "20 1/s"))
    settled.step(300, loading, time_step="4e-8 s")
    for _ in range(30):
        other.step(10, loading, time_step=4e-8)
    assert other.hash == settled.hash


def test_a_step_is_at_least_one(settled):
    for steps in (0, -5):
        with pytest.raises(suffuse.CaseError, match="expected 1 or more"):
            settled.step(steps)


def test_an_axis_is_driven_in_one_way():
    with pytest.raises(suffuse.CaseError, match="axis 1 has a stress and a strain rate"):
        suffuse.Loading(strain_rate=(10, None, None), stress="100 kPa")


def test_a_sample_is_unloaded_to_no_stress(settled):
    settled.settle(suffuse.Loading(stress=0))
    assert abs(settled.mean_stress) < 1e-8 * settled.material.modulus


def test_a_saved_world_comes_back_to_the_bit(settled, tmp_path):
    settled.save(tmp_path / "state.h5")
    back = suffuse.World.load(tmp_path / "state.h5")
    assert back.hash == settled.hash and back.void_ratio == settled.void_ratio
    for world in (back, settled):
        world.step(100, time_step=4e-8)
    assert back.hash == settled.hash


def test_threads_change_no_bit(settled):
    other, threads = settled.copy(), suffuse.threads()
    try:
        suffuse.set_threads(1)
        settled.step(200, time_step=4e-8)
        suffuse.set_threads(3)
        other.step(200, time_step=4e-8)
    finally:
        suffuse.set_threads(threads)
    assert settled.hash == other.hash


def test_two_threads_of_python_may_compute_at_once(settled):
    from concurrent.futures import ThreadPoolExecutor

    worlds = [settled.copy() for _ in range(3)]
    with ThreadPoolExecutor(3) as pool:
        list(pool.map(lambda world: world.step(200, time_step=4e-8), worlds))
    assert len({world.hash for world in worlds}) == 1


def test_progress_is_reported_and_may_end_the_work(settled):
    reported_calls = []

    class Enough(Exception):
        pass

    def listener(part, steps):
        reported_calls.append((part, steps))
        raise Enough

    with pytest.raises(Enough):
        settled.step(10**9, on_progress=listener)
    assert reported_calls[0][0] == "step" and reported_calls[0][1] > 0
    settled.step(10)  # the world goes on from where it was


def test_fields_are_documented_by_the_schema():
    keys = {(key.table, key.name): key for key in suffuse.schema()}
    for table, owner, names in (
        ("contact", suffuse.Material, ("modulus", "shear_ratio", "friction", "rolling_friction")),
        ("balance", suffuse.Balance, ("unbalanced_force", "stress_error", "patience")),
        ("fluid", suffuse.Fluid, ("density", "viscosity")),
    ):
        for name in names:
            assert keys[table, name].text in getattr(owner, name).__doc__
            assert keys[table, name].default in getattr(owner, name).__doc__
    assert keys["stage.flow", "gradient"].text in suffuse.seep.__doc__


def test_quantities_may_be_texts_with_units():
    material = suffuse.Material(modulus="100 MPa", friction="30 deg", density=2650)
    assert material.modulus == 1e8 and material.density == 2650
    assert material.friction == pytest.approx(numpy.radians(30), rel=1e-15)
    assert suffuse.quantity("0.26 mm") == 2.6e-4
    with pytest.raises(suffuse.UnitError, match="modulus \"100 mm\".*"):
        material.modulus = "100 mm"
    with pytest.raises(TypeError, match="no field modulos"):
        suffuse.Material(modulos=1)


def test_errors_have_the_words_and_the_numbers():
    with pytest.raises(suffuse.CaseError, match="position: found 2 x 2, expected n x 3 numbers"):
        suffuse.World((1, 1, 1), [[1, 2], [3, 4]], [1, 1])
    with pytest.raises(suffuse.CaseError, match="radius: found -1"):
        suffuse.World((1, 1, 1), [[0, 0, 0]], [-1])
    with pytest.raises(suffuse.CaseError, match="span no volume"):
        suffuse.World((1, 0, 1), [[0, 0, 0]], [0.1])
    with pytest.raises(suffuse.IoError) as raised:
        suffuse.World.load(pathlib.Path("nowhere") / "state.h5")
    assert isinstance(raised.value, OSError) and isinstance(raised.value, suffuse.Error)
    assert issubclass(suffuse.CaseError, ValueError) and issubclass(suffuse.CaseProblems, suffuse.CaseError)




def test_grains_that_do_not_fit_into_their_cell_are_refused():
    position = numpy.random.default_rng(1).random((500, 3)) * 4e-3
    in_mm = r"radius: grain 0 has a radius of 0\.1 m and does not fit into a cell 0\.004 m wide; .*given in mm"
    with pytest.raises(suffuse.CaseError, match=in_mm):
        suffuse.World((4e-3, 4e-3, 4e-3), position, numpy.full(500, 0.1))
    with pytest.raises(suffuse.CaseError, match=r"radius: the grains have .* times the volume of the cell"):
        suffuse.World((4e-3, 4e-3, 4e-3), position, numpy.full(500, 1e-3))
    world = suffuse.World((4e-3, 4e-3, 4e-3), position, numpy.full(500, 1e-4))
    with pytest.raises(suffuse.CaseError, match=r"cell: grain 0 has a radius of 0\.0001 m and does not fit into a cell 4e-06"):
        world.cell = (4e-6, 4e-6, 4e-6)
    assert world.cell[0, 0] == 4e-3 and "500 grains" in repr(world)


def own_masses(world):
    mass = world.material.density * 4 / 3 * numpy.pi * world.grains.radius**3
    return mass, 0.4 * mass * world.grains.radius**2


def has_its_own_masses(world):
    mass, inertia = own_masses(world)  # written in another order of the same products: rounding
    return numpy.allclose(world.grains.mass, mass, rtol=1e-14, atol=0) and numpy.allclose(
        world.grains.inertia, inertia, rtol=1e-14, atol=0
    )


@pytest.mark.parametrize("adhesion", [None, "100 kPa"])
def test_an_interrupted_compaction_leaves_nothing_that_it_lent(adhesion):
    radius = numpy.random.default_rng(1).uniform(0.2e-3, 0.6e-3, 500)
    cloud = suffuse.make_cloud(radius, porosity=0.65)
    before = repr(cloud.material)
    lent = []

    class Enough(Exception):
        pass

    def listener(part, steps):
        lent.append(not has_its_own_masses(cloud) and repr(cloud.material) != before)
        raise Enough

    with pytest.raises(Enough):  # at this rate it would take for ever: progress comes, however fast the machine
        cloud.compact("100 kPa", friction="5 deg", adhesion_normal=adhesion, max_rate="1e-6 1/s", on_progress=listener)
    assert lent == [True]
    assert has_its_own_masses(cloud) and repr(cloud.material) == before
    cloud.step(100)


def test_a_void_ratio_is_met_by_searching_the_preparation(cloud):
    dense = cloud.copy()
    dense.compact("100 kPa", friction=0)
    loose = cloud.copy()
    loose.compact("100 kPa")
    wanted = (dense.void_ratio + loose.void_ratio) / 2
    found = cloud.compact("100 kPa", void_ratio=wanted, void_ratio_tolerance=0.02)  # so few grains scatter
    assert abs(found["void_ratio"] - wanted) <= 0.02 and found["void_ratio"] == cloud.void_ratio
    assert found["trials"] >= 1 and has_its_own_masses(cloud)
    start = loose.copy()
    with pytest.raises(suffuse.StateError, match="cannot be reached"):
        start.compact("100 kPa", void_ratio=0.1)
    assert start.hash == loose.hash  # not what the last trial left


def test_arguments_of_a_compaction_are_held_to_their_ranges_and_to_each_other(cloud):
    for wrong, message in (
        ({"pressure": 0}, "pressure: found 0 .*above 0"),
        ({"friction": 30}, "friction: found 30 rad, .*below 90 deg"),
        ({"adhesion_shear": "-1 kPa"}, "adhesion_shear: found"),
        ({"void_ratio": 60}, "void_ratio: found 60"),
        ({"void_ratio": 0.7, "void_ratio_tolerance": 0}, "void_ratio_tolerance: found 0"),
        ({"void_ratio": 0.7, "friction": "10 deg"}, "friction: found .*, together with a void_ratio, .*faithful.* searches the friction"),
    ):
        with pytest.raises(suffuse.CaseError, match=message):
            cloud.compact(**{"pressure": "100 kPa", **wrong})


def test_a_triaxial_test_without_stress_or_pace_is_refused(cloud, settled):
    with pytest.raises(suffuse.StateError, match="carries a stress"):
        cloud.triaxial()
    for wrong, message in (
        ({"inertial_number": 0}, "above 0"),
        ({"strain": 0}, "strain: .*above 0 and at most 2"),
        ({"strain": 20}, "strain: .*at most 2"),  # percent were meant
        ({"rows": 0}, "rows: found 0"),
        ({"time_step": -1e-8}, "time_step: .*above 0"),
        ({"stress_ratio": -0.5}, "stress_ratio: .*above 0"),
        ({"deviator_stress": "-50 kPa"}, "deviator_stress: .*above 0"),
        ({"stress_ratio": 0.5, "deviator_stress": "50 kPa"}, "keep one of them"),
        ({"path": "constant-deviator", "deviator_stress": "50 kPa"}, "give stress_ratio instead"),
        ({"path": "undrained", "b": 0.5}, "b belongs to a drained test"),
        ({"direction": "sideways"}, "expected one of compression, extension"),
    ):
        with pytest.raises(suffuse.CaseError, match=message):
            settled.triaxial(**wrong)


LOOKS = {
    "bytes": lambda world, folder: pickle.dumps(world),
    "constrictions": lambda world, folder: suffuse.constrictions(world, of="coarse"),
    "contacts": lambda world, folder: world.contacts.force_n,
    "coordination": lambda world, folder: world.grains.coordination,
    "copy": lambda world, folder: copy.deepcopy(world.copy()),
    "gradation": lambda world, folder: (world.gradation(), suffuse.assess(world)),
    "measure": lambda world, folder: (world.measure(), world.balance, world.stress, world.strain, world.void_ratio),
    "mobility": lambda world, folder: world.mobility([0.1]),
    "overlap": lambda world, folder: suffuse.largest_overlap(world),
    "pores": lambda world, folder: suffuse.PoreNetwork(world).widest_paths(),
    "resolved flow": lambda world, folder: suffuse.resolve_flow(world, gradient=0.1, boxes_across=6, tolerance=0.1),
    "save": lambda world, folder: world.save(folder / "state.h5"),
    "seep": lambda world, folder: suffuse.seep(world, gradient=0.1, tensor=True),
    "show": lambda world, folder: (repr(world), world._repr_html_(), str(world.view())),
    "stiffness": lambda world, folder: world.stiffness(),
    "stress probe": lambda world, folder: world.stress_probe("2 %", directions=4),
    "time step": lambda world, folder: world.stable_time_step(),
    "write": lambda world, folder: suffuse.write_packing(folder / "packing.csv", world),
}


@pytest.mark.parametrize("stepped", [False, True], ids=["before its first step", "stepped"])
@pytest.mark.parametrize("look", LOOKS)
def test_what_only_looks_leaves_the_world_and_its_rows_as_they_are(packing, tmp_path, look, stepped):
    packing.grains.fine = packing.grains.radius < numpy.median(packing.grains.radius)
    if stepped:
        packing.step(1, time_step=1e-9)
    before, known, ids = pickle.dumps(packing), packing.hash, packing.grains.id.copy()
    LOOKS[look](packing, tmp_path)
    assert packing.hash == known and (packing.grains.id == ids).all() and pickle.dumps(packing) == before


@pytest.mark.parametrize("safety", [-1, 0, float("nan"), float("inf")])
def test_a_time_step_has_a_safety_above_zero(packing, safety):
    with pytest.raises(suffuse.CaseError, match="safety: found"):
        packing.stable_time_step(safety)


def test_constants_out_of_their_range_are_refused():
    material = suffuse.Material()
    for name, wrong in (("friction", 30), ("modulus", -1), ("shear_ratio", 0), ("adhesion_normal", "-1 MPa")):
        before = getattr(material, name)
        with pytest.raises(suffuse.CaseError, match="expected it to be"):
            setattr(material, name, wrong)
        assert getattr(material, name) == before
    with pytest.raises(suffuse.CaseError, match="friction: found 30 rad, .*below 90 deg"):
        suffuse.Material(friction=30)  # degrees were meant
    with pytest.raises(suffuse.CaseError, match="above 0"):
        suffuse.Balance(unbalanced_force=0)


def test_masses_follow_the_density(two_grains):
    other = two_grains.copy()
    two_grains.material.density = 5200
    other.material = suffuse.Material(density="1300 kg/m3")
    for world in (two_grains, other):
        assert has_its_own_masses(world)
        world.step(1, time_step=1e-9, damping=0)
    # The same spring force: acceleration is as 1/density.
    assert other.grains.velocity[0, 0] == pytest.approx(4 * two_grains.grains.velocity[0, 0], rel=1e-12)


def test_a_state_of_which_a_bit_has_changed_is_refused_with_its_name(settled, tmp_path):
    file = tmp_path / "state.h5"
    settled.save(file)
    whole = file.read_bytes()
    for at in range(0, len(whole), len(whole) // 97):
        file.write_bytes(whole[:at] + bytes([whole[at] ^ 1 << at % 8]) + whole[at + 1 :])
        with pytest.raises(suffuse.IoError, match=re.escape(str(file))):
            suffuse.World.load(file)
    radius = whole.index(settled.grains.radius.tobytes())
    file.write_bytes(whole[:radius] + bytes([whole[radius] ^ 1]) + whole[radius + 1 :])
    with pytest.raises(suffuse.IoError, match="changed or damaged after it was written; use a whole copy of it"):
        suffuse.World.load(file)


def test_steps_after_a_new_density_are_those_of_a_world_that_had_it(settled, tmp_path):
    settled.step(10, time_step=1e-8)
    settled.material.density = 1e4
    assert has_its_own_masses(settled)
    settled.save(tmp_path / "state.h5")
    loaded = suffuse.World.load(tmp_path / "state.h5")
    for world in (settled, loaded):
        world.step(100, time_step=1e-8)
    assert loaded.hash == settled.hash


def test_a_density_that_cannot_be_is_refused(two_grains):
    material = two_grains.material
    with pytest.raises(suffuse.CaseError, match="density: found 0 kg/m.*above 0"):
        material.density = 0
    assert material.density == 2600 and has_its_own_masses(two_grains)
