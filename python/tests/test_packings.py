"""Packings from and for other programs, to the bit where the format carries it."""

import warnings

import numpy
import pytest

import suffuse


@pytest.mark.parametrize("name", ["p.csv", "p.txt", "p.xyz", "p.data", "p.dump", "p.vtp"])
def test_a_packing_goes_out_and_comes_back(settled, tmp_path, name):
    settled.sort("id")
    # One format brings grains home into the cell: begin there, so that all carry the same.
    settled.grains.position = (numpy.linalg.solve(settled.cell, settled.grains.position.T) % 1).T @ settled.cell.T
    suffuse.write_packing(tmp_path / name, settled)
    carries_cell = name not in ("p.csv", "p.txt")
    back = suffuse.read_packing(tmp_path / name, cell=None if carries_cell else settled.cell)
    assert (back.cell == settled.cell).all() and (back.grains.radius == settled.grains.radius).all()
    assert (back.grains.position == settled.grains.position).all()
    if name != "p.txt":
        assert (back.grains.velocity == settled.grains.velocity).all()
        assert (back.grains.spin == settled.grains.spin).all()


def test_contacts_go_out_and_come_back_next_to_a_packing(settled, tmp_path):
    settled.sort("id")
    suffuse.write_packing(tmp_path / "p.vtp", settled, contacts=tmp_path / "c.csv")
    back = suffuse.read_packing(tmp_path / "p.vtp", contacts=tmp_path / "c.csv")
    alone = suffuse.read_packing(tmp_path / "p.vtp")
    assert len(back.contacts) == len(alone.contacts) > 500
    assert numpy.abs(back.contacts.shear_force).max() > 0 and (alone.contacts.shear_force == 0).all()
    forces = lambda contacts: {(i, j): tuple(force) for i, j, force in zip(contacts.i, contacts.j, contacts.shear_force)}
    own, read = forces(settled.contacts), forces(back.contacts)
    kept = own.keys() & read.keys()  # the last step moved a few apart
    assert len(kept) > 0.99 * len(own) and all(read[pair] == pytest.approx(own[pair], abs=1e-9) for pair in kept)


def test_contacts_beyond_friction_are_warned_of_with_their_line(settled, tmp_path):
    suffuse.write_packing(tmp_path / "p.vtp", settled, contacts=tmp_path / "c.csv")
    heading, *rows = (tmp_path / "c.csv").read_text().splitlines()
    large = [",".join([*row.split(",")[:2], "1e3", "1e3", "1e3", "0", "0", "0"]) for row in rows]
    (tmp_path / "c.csv").write_text("\n".join([heading, *large]) + "\n")
    with pytest.warns(UserWarning, match=r"c\.csv:\d+: the shear force of grains \d+ and \d+ is .* friction bears"):
        suffuse.read_packing(tmp_path / "p.vtp", contacts=tmp_path / "c.csv")


def test_an_imported_packing_knows_its_contacts_before_the_first_step(packing):
    stepped = packing.copy()
    stepped.step(1, time_step=1e-15)  # nothing moves
    assert len(packing.contacts) == len(stepped.contacts) > 500
    assert packing.contacts.overlap == pytest.approx(stepped.contacts.overlap, abs=1e-15)  # rounding of positions
    assert (packing.grains.coordination == stepped.grains.coordination).all()
    before, after = packing.measure(), stepped.measure()
    for name in ("contacts", "rattlers", "coordination", "backbone_rattlers", "max_overlap_ratio", "mean_stress"):
        assert before[name] == pytest.approx(after[name], rel=1e-6)
    assert (packing.contacts.shear_force == 0).all() and (packing.grains.force == 0).all()
    packing.grains.position *= 1.5  # and those of where the grains are now
    packing.cell = 1.5 * packing.cell
    assert len(packing.contacts) == 0 and packing.mean_stress == 0


def test_looking_before_the_first_step_changes_no_bit(packing):
    seen = packing.copy()
    seen.contacts, seen.stress, seen.balance
    for world in (packing, seen):
        world.settle(suffuse.Loading(stress="100 kPa"))
    assert seen.hash == packing.hash


def test_what_is_not_used_is_warned_of(tmp_path):
    (tmp_path / "p.csv").write_text("x,y,z,r,color\n0.5,0.5,0.5,0.1,1\n")
    with pytest.warns(UserWarning, match='column "color" ignored'):
        suffuse.read_packing(tmp_path / "p.csv", cell=(1, 1, 1))


def test_a_file_without_a_cell_requires_one(tmp_path):
    (tmp_path / "p.csv").write_text("x,y,z,r\n0.5,0.5,0.5,0.03\n")
    with pytest.raises(suffuse.CaseError, match="carries no cell; give cell="):
        suffuse.read_packing(tmp_path / "p.csv")
    with pytest.warns(UserWarning, match="check the cell and the unit of lengths"):  # one grain barely fills it
        assert len(suffuse.read_packing(tmp_path / "p.csv", cell=("1 m", 1, "100 cm"))) == 1


def test_a_file_in_millimeters_is_warned_of_and_read_with_its_unit(tmp_path):
    (tmp_path / "p.csv").write_text("x,y,z,r\n0.5,0.5,0.5,0.04\n")
    with pytest.warns(UserWarning, match="coarser than gravel"):
        suffuse.read_packing(tmp_path / "p.csv", cell=(1, 1, 1))
    for unit in ("mm", "1 mm", 1e-3):
        world = suffuse.read_packing(tmp_path / "p.csv", cell=("1 mm", "1 mm", "1 mm"), unit=unit)
        assert world.grains.radius[0] == pytest.approx(0.04e-3) and world.grains.position[0, 0] == pytest.approx(0.5e-3)
    for unit in ("kPa", "0 mm"):
        with pytest.raises(suffuse.UnitError, match="unit"):
            suffuse.read_packing(tmp_path / "p.csv", cell=(1, 1, 1), unit=unit)
    with pytest.raises(suffuse.CaseError, match="above 0"):
        suffuse.read_packing(tmp_path / "p.csv", cell=(1, 1, 1), unit=0)


def test_overlaps_and_cells_are_checked_as_in_a_case(tmp_path):
    (tmp_path / "p.txt").write_text("##PERIODIC:: 3e-3 3e-3 3e-3\n0 0 0 1e-4\n0 0 1.5e-4 1e-4\n")
    with pytest.raises(suffuse.CaseError, match="grains 0 and 1 overlap by 0.5"):
        suffuse.read_packing(tmp_path / "p.txt")
    assert len(suffuse.read_packing(tmp_path / "p.txt", max_overlap=0.6)) == 2
    with pytest.warns(UserWarning, match="the cell given, 0.002 x 0.002 x 0.002 m, is taken, not the file's own"):
        suffuse.read_packing(tmp_path / "p.txt", cell=(2e-3, 2e-3, 2e-3), max_overlap=0.6)
    with pytest.raises(suffuse.CaseError, match="max_overlap"):
        suffuse.read_packing(tmp_path / "p.txt", max_overlap=0)


def test_a_narrow_cell_is_warned_of(tmp_path):
    (tmp_path / "p.csv").write_text("x,y,z,r\n0.5,0.5,0.5,0.1\n")
    with pytest.warns(UserWarning, match="5.0 times as wide as the largest grain"):
        suffuse.read_packing(tmp_path / "p.csv", cell=(1, 1, 1))


def test_an_unknown_format_names_those_there_are(settled, tmp_path):
    with pytest.raises(suffuse.CaseError, match="csv, yade, xyz, lammps, dump, vtp"):
        suffuse.write_packing(tmp_path / "p.pdf", settled)


def test_a_cloud_is_the_same_for_a_seed_and_can_be_compacted():
    radius = numpy.full(200, 1e-4)
    cloud = suffuse.make_cloud(radius, porosity=0.65, seed=3)
    assert cloud.porosity == pytest.approx(0.65, rel=1e-9) and suffuse.largest_overlap(cloud) == 0
    assert suffuse.make_cloud(radius, porosity=0.65, seed=3).hash == cloud.hash
    assert suffuse.make_cloud(radius, porosity=0.65, seed=4).hash != cloud.hash
    cloud.compact("100 kPa", friction="5 deg")
    assert cloud.mean_stress == pytest.approx(100e3, rel=5e-3) and cloud.void_ratio < 0.8
    assert cloud.measure()["stiffness_to_pressure"] == pytest.approx(cloud.material.modulus / 2 / cloud.mean_stress)


def test_shear_stresses_are_released_on_request():
    cloud = suffuse.make_cloud(numpy.full(200, 1e-4), porosity=0.65, seed=3)
    cloud.compact("100 kPa", protocol="swift", shear_stresses="released")
    released = suffuse.Loading(stress="120 kPa", shear_stresses="released")
    cloud.settle(released)
    shear = cloud.stress - numpy.diag(numpy.diag(cloud.stress))
    assert 0 < numpy.abs(shear).max() < 0.005 * cloud.mean_stress  # what the balance allows
    assert released.shear_stresses == "released" and "released" in repr(released)
    assert suffuse.Loading().shear_stresses == "kept" and "kept" not in repr(suffuse.Loading())
    for wrong in ({"shear_stresses": "lost"}, {"shear_stresses": "released", "protocol": "slow"}):
        with pytest.raises(suffuse.CaseError, match="shear_stresses"):
            cloud.compact("100 kPa", **wrong)
    with pytest.raises(suffuse.CaseError, match="needs a stress"):
        suffuse.Loading(shear_stresses="released")


def test_a_protocol_is_chosen_by_its_name():
    steps = {}
    for protocol in ("faithful", "swift"):
        cloud = suffuse.make_cloud(numpy.full(200, 1e-4), porosity=0.65, seed=3)
        steps[protocol] = cloud.compact("100 kPa", protocol=protocol)["steps"]
    assert steps["swift"] < steps["faithful"]
    with pytest.raises(suffuse.CaseError, match="faithful, swift, slow or wide"):
        cloud.compact("100 kPa", protocol="quick")
    slow = suffuse.make_cloud(numpy.full(200, 1e-4), porosity=0.65, seed=3)
    assert slow.compact("100 kPa", max_rate="100 1/s")["steps"] > steps["faithful"]


def test_a_packing_read_back_keeps_its_mean_motion_once(tmp_path):
    world = suffuse.make_cloud(numpy.linspace(0.5, 1.5, 200) * 1e-4, 0.55, seed=1)
    gradient = numpy.array([[0, 0, 50.0], [0, 0, 0], [0, 0, 0]])
    loading = suffuse.Loading(velocity_gradient=gradient)
    world.step(500, loading)
    suffuse.write_packing(tmp_path / "p.csv", world)

    def slope(of):  # of the velocity in x over z, over that of the cell
        return numpy.polyfit(numpy.asarray(of.grains.position)[:, 2], numpy.asarray(of.grains.velocity)[:, 0], 1)[0] / 50

    with pytest.warns(UserWarning, match="velocity gradient"):
        found = suffuse.read_packing(tmp_path / "p.csv", cell=world.cell)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        given = suffuse.read_packing(tmp_path / "p.csv", cell=world.cell, velocity_gradient=gradient)
    for read in (found, given):
        read.material = world.material
        read.step(1, loading, time_step=1e-15)
    # The fitted mean motion gives way to the loading's; of the one that is given the grains keep what they had next to it.
    assert slope(found) == pytest.approx(1, abs=1e-9)
    assert slope(given) == pytest.approx(slope(world), abs=1e-9)
    assert numpy.array_equal(numpy.asarray(given.velocity_gradient), gradient)


def test_equal_grains_take_one_radius(tmp_path):
    (tmp_path / "p.txt").write_text("0.5 0.5 0.5\n1.5 0.5 0.5\n0.5 1.5 0.5\n")
    with pytest.raises(suffuse.CaseError, match="radius"):
        suffuse.read_packing(tmp_path / "p.txt", cell=(2, 2, 2))
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        world = suffuse.read_packing(tmp_path / "p.txt", cell=(2, 2, 2), radius=0.5)
    assert numpy.all(numpy.asarray(world.grains.radius) == 0.5)


def test_a_box_is_cut_out_of_a_bed(tmp_path):
    rows = ["0,0,0,1e-4", "1e-3,1e-3,1e-3,1e-4", "2e-3,1e-3,1e-3,1e-4"]
    (tmp_path / "bed.csv").write_text("x,y,z,r\n" + "\n".join(rows) + "\n")
    with pytest.warns(UserWarning, match="left out: 1 grain with the center outside"):
        world = suffuse.read_packing(tmp_path / "bed.csv", box=((0.5e-3,) * 3, ("2.5 mm",) * 3))
    assert len(world) == 2
    assert numpy.allclose(numpy.diag(world.cell), 2e-3)
    with pytest.raises(suffuse.CaseError, match="two corners"):
        suffuse.read_packing(tmp_path / "bed.csv", box=(1, 2, 3))
    with pytest.raises(suffuse.CaseError, match="leave the cell out"):
        suffuse.read_packing(tmp_path / "bed.csv", cell=(1, 1, 1), box=((0, 0, 0), (1, 1, 1)))
