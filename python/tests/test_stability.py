"""assess: what the criteria say of a file, a packing, a pair of arrays."""

import json
import os
import subprocess

import numpy
import pytest

import suffuse

PROGRAM = os.environ["SUFFUSE_PROGRAM"]
GAP_GRADED = "d [mm],passing [%]\n0.02,0\n0.1,9\n0.3,21\n1,24\n2,31\n8,66\n31.5,100\n"


@pytest.fixture
def dyke(tmp_path):
    path = tmp_path / "dyke.csv"
    path.write_text(GAP_GRADED)
    return path


def test_says_what_the_program_says(dyke):
    ours = suffuse.assess(dyke, gradient=0.3)
    printed = subprocess.run(
        [PROGRAM, "assess", dyke, "-i", "0.3", "--json"], check=True, capture_output=True, text=True
    ).stdout
    theirs = json.loads(printed)["soils"][0]
    assert {key: ours[key] for key in theirs} == theirs
    assert ours.verdict("kenney-lau-1986") == "unstable" and ours.verdict("terzaghi") == "stable"
    assert "Kezdi" in str(ours)
    with pytest.raises(KeyError, match="there are .*kezdi-1979"):
        ours.verdict("kezdi")


def test_columns_of_a_file_may_be_named(dyke, tmp_path):
    named = tmp_path / "named.csv"
    named.write_text(GAP_GRADED.replace("d [mm],passing [%]", "A,B"))
    ours = suffuse.assess(named, size="A:mm", passing=2, rows="1-8")
    assert ours["criteria"] == suffuse.assess(dyke)["criteria"]
    with pytest.raises(suffuse.CaseError, match="there is no column `C`"):
        suffuse.assess(named, size="A:mm", passing="C")


def test_of_a_file_with_several_samples_one_is_named(tmp_path):
    path = tmp_path / "two.csv"
    path.write_text("d [mm],TP-1,TP-2\n0.1,0,0\n0.3,20,35\n1,40,60\n2,100,100\n")
    with pytest.raises(suffuse.CaseError, match="2 samples, and one is needed: give sample= one of TP-1, TP-2"):
        suffuse.assess(path)
    one, other = (suffuse.assess(path, sample=name, finer_than="0.3 mm") for name in ("TP-1", "TP-2"))
    assert one["fine_fraction"]["content"] == pytest.approx(0.2) and other["fine_fraction"]["content"] == pytest.approx(0.35)
    assert other["soil"].endswith("two.csv, TP-2")
    with pytest.raises(suffuse.CaseError, match="it has TP-1, TP-2"):
        suffuse.assess(path, sample="TP-3")
    with pytest.raises(suffuse.CaseError, match="only a file has samples"):
        suffuse.assess(([1e-4, 1e-3], [0, 1]), sample="TP-1")


def test_takes_arrays_and_texts_with_units(dyke):
    size = numpy.array([0.02, 0.1, 0.3, 1, 2, 8, 31.5]) * 1e-3
    finer = numpy.array([0, 0.09, 0.21, 0.24, 0.31, 0.66, 1])
    ours, theirs = suffuse.assess((size, finer), finer_than="0.3 mm"), suffuse.assess(dyke, finer_than=0.3e-3)
    for mine, other in zip(ours["criteria"], theirs["criteria"]):
        assert mine["verdict"] == other["verdict"] and mine["value"] == pytest.approx(other["value"], rel=1e-9)


def test_a_packing_of_nearly_equal_grains_is_stable(packing):
    found = suffuse.assess(packing)
    assert found["tally"]["unstable"] == 0 and found["tally"]["stable"] >= 4
    size = numpy.sort(packing.grains.diameter)
    finer = numpy.cumsum(size**3) / numpy.sum(size**3)  # by mass
    assert found["sizes"]["d50"] == pytest.approx(numpy.interp(0.5, finer, size), rel=2e-3)  # within one grain


def world_of(radius):
    place = numpy.random.default_rng(0).random((len(radius), 3)) * 1e-2
    return suffuse.World((1e-2,) * 3, place, radius)


def test_a_packing_of_two_sizes_is_a_curve_of_steps():
    radius = numpy.r_[numpy.full(1000, 1e-4), numpy.full(80, 5e-4)]  # 0.2 and 1 mm, 1/11 of the mass fine
    found = suffuse.assess(world_of(radius))
    # H = 0 at 0.2 mm, where F = 1/11; D15c/d85f = 5; the gap is five wide. Burenkova's d90/d60 = d90/d15 = 1.
    verdicts = {one["id"]: one["verdict"] for one in found["criteria"] if one["verified"]}
    assert [name for name, verdict in verdicts.items() if verdict == "unstable"] == [
        "kenney-lau-1985", "kenney-lau-1986", "li-fannin-2008", "kezdi-1979", "chang-zhang-2013"
    ]
    assert verdicts["burenkova-1993"] == "stable"
    assert found["sizes"]["d10"] == pytest.approx(1e-3, rel=1e-6) == found["sizes"]["d50"]
    assert found["gap"]["from"] == pytest.approx(0.2e-3) and found["gap"]["to"] == pytest.approx(1e-3, rel=1e-5)
    spread = suffuse.assess(world_of(radius * (1 + 0.01 * numpy.random.default_rng(1).random(1080))))
    assert spread["summary"] == found["summary"]


def test_the_psd_of_a_world_is_the_curve_that_is_assessed():
    world = world_of(numpy.r_[numpy.full(1000, 1e-4), numpy.full(80, 5e-4)])
    size, finer = world.psd
    assert size == pytest.approx([0.2e-3, 0.2e-3, 1e-3, 1e-3], rel=1e-5) and finer == pytest.approx([0, 1 / 11, 1 / 11, 1])
    assert suffuse.assess(world.psd)["criteria"] == suffuse.assess(world)["criteria"]
    with pytest.raises(suffuse.CaseError, match="without grains has no grading"):
        world_of(numpy.empty(0)).psd


def test_a_packing_of_equal_grains_is_stable():
    found = suffuse.assess(world_of(numpy.full(50, 1e-4)))
    assert found["tally"]["unstable"] == 0 and found["uniformity"] == pytest.approx(1, rel=1e-5)
    assert found.verdict("kenney-lau-1986") == "stable"  # H/F = 0.7/0.3 at F = 30 %


def test_an_open_curve_is_judged_where_it_can_be(dyke):
    dyke.write_text(GAP_GRADED.replace("0.02,0\n", ""))
    found = suffuse.assess(dyke)
    assert found["missing_fine"] == 0.09 and found["sizes"]["d5"] is None
    assert found.verdict("kezdi-1979") == "unstable"


def test_wrong_use_is_named(dyke):
    with pytest.raises(suffuse.CaseError, match="gradient"):
        suffuse.assess(dyke, porosity=0.4)
    for wrong in (([1], [2], [3]), None, 3):
        with pytest.raises(suffuse.CaseError, match="pair"):
            suffuse.assess(wrong)
    with pytest.raises(suffuse.Error):
        suffuse.assess((numpy.array([1e-3, 2e-3]), numpy.array([0.5, 0.2])))


def test_of_level_flow_only_the_atlas_says_something(dyke):
    found = suffuse.assess(dyke, gradient=0.3, flow="level")
    assert found["gradients"] == [] and {entry["flow"] for entry in found["atlas"]} == {"level"}
    with pytest.raises(suffuse.CaseError, match="expected up, down, level, or the angle"):
        suffuse.assess(dyke, gradient=0.3, flow="sideways")
    with pytest.raises(suffuse.CaseError, match="give gradient= too"):
        suffuse.assess(dyke, flow="level")


def test_the_atlas_is_a_table_of_samples():
    rows = suffuse.atlas()
    assert len(rows) > 0 and set(rows["flow"]) <= {"up", "level"} and set(rows["density"]) <= {"loose", "medium", "dense"}
    heave = 1.65 * (1 - rows["porosity"])  # grains of 2650 kg/m3
    upward = rows["flow"] == "up"
    assert rows["i_c"][upward] == pytest.approx(heave[upward], rel=1e-4) and numpy.isnan(rows["i_c"][~upward]).all()
    assert set(rows.units.values()) == {"-"}


def test_the_atlas_of_filters_has_shares_of_the_base():
    rows = suffuse.atlas("filters")
    assert set(rows.units.values()) == {"-"}
    assert set(rows["ended"]) <= {0, 1} and (rows["ratio"] >= 3).all()
    for share in ("passed", "moving", "entered"):
        assert ((rows[share] >= 0) & (rows[share] <= 1)).all()
    with pytest.raises(suffuse.CaseError, match="expected gradients or filters"):
        suffuse.atlas("rivers")
