"""Pictures of grains for ParaView and OVITO: their columns, and the collection over stages and passes."""

import re
import xml.etree.ElementTree as xml

import numpy
import pytest

import suffuse

KINDS = {"Float32": "<f4", "UInt8": "u1", "UInt32": "<u4", "Int64": "<i8"}


def arrays_of(path):
    """The point arrays of a .vtp whose data stand raw behind the XML."""
    data = path.read_bytes()
    head, _, rest = data.partition(b'<AppendedData encoding="raw">')
    raw = rest[rest.index(b"_") + 1 :]
    found = {}
    for one in re.findall(rb"<DataArray[^>]*>", head):
        about = xml.fromstring(one.decode() if one.endswith(b"/>") else one.decode()[:-1] + "/>").attrib
        at = int(about["offset"])
        size = int(numpy.frombuffer(raw[at : at + 8], "<u8")[0])
        values = numpy.frombuffer(raw[at + 8 : at + 8 + size], KINDS[about["type"]])
        found[about["Name"]] = values.reshape(-1, int(about.get("NumberOfComponents", 1)))
    return found


@pytest.fixture
def run(eroding_case, tmp_path):
    text = eroding_case.read_text() + """[[study.erosion.stage]]
name = "seep"
do = "flow"
gradient = 0.5
[output]
formats = ["vtp", "xyz", "csv"]
"""
    eroding_case.write_text(text)
    return suffuse.Case(eroding_case).run(tmp_path / "run")


def test_pictures_show_stress_forces_and_who_leaves(run):
    folder = run.folder / "studies" / "erosion"
    before, after = (arrays_of(folder / "eroded" / name) for name in ("pass-0.vtp", "grains.vtp"))
    stage = run["erosion/eroded"]
    ledger = stage.table("eroded.csv")
    leaving = dict(zip(before["id"][:, 0], before["leaves_in_pass"][:, 0]))
    assert {grain for grain, one in leaving.items() if one == 1} == set(ledger["id"][ledger["pass"] == 1])
    assert stage.passes[0].removed > 0 and len(before["id"]) == 500 > len(after["id"])
    fine = before["fine"][:, 0] == 1
    assert (before["probe_fluid_force"][fine] > 0).all() and numpy.isnan(before["probe_fluid_force"][~fine]).all()

    # A grain's stress times its volume, over all grains, is the stress of the cell.
    volume = 4 / 3 * numpy.pi * before["radius"].astype(float) ** 3
    settled = run["erosion/settled"].world
    total = (before["stress"] * volume).sum(axis=0).reshape(3, 3) / numpy.linalg.det(settled.cell)
    assert total == pytest.approx(settled.stress, rel=1e-5, abs=1e-5 * settled.mean_stress)
    assert before["mean_stress"][:, 0] == pytest.approx(before["stress"][:, [0, 4, 8]].mean(axis=1), rel=1e-5, abs=1)

    seep = arrays_of(folder / "seep" / "grains.vtp")
    forces = run["erosion/seep"].table("grain_forces.csv")
    order = numpy.argsort(seep["id"][:, 0])
    assert seep["fluid_force"][order, 2] == pytest.approx(forces["fz"], rel=1e-6)


def test_one_collection_leads_through_stages_and_passes(run):
    folder = run.folder / "studies" / "erosion"
    frames = xml.parse(folder / "grains.pvd").getroot().findall("Collection/DataSet")
    names = [frame.attrib["file"] for frame in frames]
    passes = [f"eroded/pass-{k}.vtp" for k in range(len(run["erosion/eroded"].passes))]
    assert names == ["start/grains.vtp", "settled/grains.vtp", *passes, "eroded/grains.vtp", "seep/grains.vtp"]
    assert [float(frame.attrib["timestep"]) for frame in frames] == list(range(len(frames)))
    assert all((folder / name).exists() for name in names)
    compile((folder / "view.py").read_text(), "view.py", "exec")
    assert run.verify()["damages"] == [] and run.verify()["came_later"] == []


def test_extended_xyz_has_the_colors_that_ovito_takes(run):
    lines = (run.folder / "studies" / "erosion" / "eroded" / "pass-0.xyz").read_text().splitlines()
    properties = re.search(r"Properties=(\S+)", lines[1])[1].split(":")
    columns = {name: int(width) for name, width in zip(properties[::3], properties[2::3])}
    assert columns["color"] == 3 and columns["leaves_in_pass"] == columns["mean_stress"] == 1
    rows = [line.split() for line in lines[2:]]
    assert all(len(row) == sum(columns.values()) for row in rows)
    assert {(row[0], tuple(row[-3:])) for row in rows} == {
        ("fine", ("0.78", "0.2", "0.17")), ("coarse", ("0.81", "0.64", "0.34"))
    }


def test_who_wants_no_pictures_gets_none(eroding_case, tmp_path):
    run = suffuse.Case(eroding_case, changes={"output.snapshots": "none"}).run(tmp_path / "run")
    assert not list(run.folder.rglob("*.vtp")) and not list(run.folder.rglob("grains.pvd"))
