"""tools/same_results, which compares two builds: it passes over no difference, and separates times from results."""

import importlib
import json
import os
import pathlib
import re
import shutil
import sys
import types

import pytest

import suffuse

ROOT = pathlib.Path(os.environ["SUFFUSE_SOURCE_DIR"])


@pytest.fixture(scope="module")
def compare():
    sys.path.insert(0, str(ROOT / "tools/same_results"))
    yield importlib.import_module("compare")
    sys.path.pop(0)


@pytest.fixture(scope="module")
def two_runs(tmp_path_factory):
    """Two runs of one case, as two builds leave them."""
    folder = tmp_path_factory.mktemp("runs")
    case = suffuse.Case(ROOT / "examples/replay/case.toml", changes={"study.replay.stage.compressed.steps": 200})
    for side in ("before", "after"):
        case.run(folder=folder / side / "job" / "run", threads=1)
    return folder


@pytest.fixture
def sides(two_runs, tmp_path):
    shutil.copytree(two_runs, tmp_path, dirs_exist_ok=True)
    return tmp_path / "before", tmp_path / "after"


def found(compare, sides, ignore=(), texts=False):
    _, files = compare.compare_job("job", *sides, types.SimpleNamespace(ignore=list(ignore), texts=texts))
    return {name: ["/".join(map(str, one.path)) for one in wrong] for name, wrong in files.items()}


def change_bytes(path, old, new):
    data = path.read_bytes()
    assert data.count(old) >= 1 and len(old) == len(new)
    path.write_bytes(data.replace(old, new, 1))


def change_json(path, change):
    tree = json.loads(path.read_text())
    change(tree)
    path.write_text(json.dumps(tree))


def stage(sides, name):
    return sides[1] / "job/run/studies/replay" / name


def test_two_runs_of_one_build_are_the_same(compare, sides):
    assert (stage(sides, "seep") / "results.cbor").exists()
    assert found(compare, sides) == {}


def test_one_bit_of_a_state_is_found_where_it_is(compare, sides):
    state = stage(sides, "settled") / "state.h5"
    world = suffuse.World.load(state)
    value = world.grains.position[7, 1].tobytes()
    change_bytes(state, value, bytes([value[0] ^ 1]) + value[1:])
    assert found(compare, sides) == {"run/studies/replay/settled/state.h5": ["grains/position/values/7/1"]}


def test_one_digit_of_a_table_and_of_a_picture_is_found(compare, sides):
    history = stage(sides, "compressed") / "history.csv"
    lines = history.read_text().splitlines()
    head = lines[0].split(",")
    cells = lines[2].split(",")
    cells[3] += "1"
    history.write_text("\n".join([*lines[:2], ",".join(cells), *lines[3:]]) + "\n")
    picture = stage(sides, "compressed") / "grains.vtp"
    data = bytearray(picture.read_bytes())
    data[data.index(b"\n_") + 2 + 8] ^= 1  # behind the size of the first array
    picture.write_bytes(data)
    wrong = found(compare, sides)
    assert wrong["run/studies/replay/compressed/history.csv"] == [f"columns/{head[3]}/1"]
    assert wrong["run/studies/replay/compressed/grains.vtp"] == ["arrays/PointData/radius/0"]


def test_a_changed_result_is_found_in_json_and_in_cbor(compare, sides):
    change_json(stage(sides, "settled") / "stage.json", lambda tree: tree.update(void_ratio=tree["void_ratio"] * (1 + 1e-15)))
    results = stage(sides, "seep") / "results.cbor"
    change_bytes(results, b"\x67throats", b"\x67throatz")
    wrong = found(compare, sides)
    assert wrong["run/studies/replay/settled/stage.json"] == ["void_ratio"]
    assert wrong["run/studies/replay/seep/results.cbor"] == ["throat_flux/throats", "throat_flux/throatz"]


def test_a_file_and_a_key_that_only_one_side_has_are_reported(compare, sides):
    (stage(sides, "seep") / "pores.csv").unlink()
    change_json(stage(sides, "seep") / "stage.json", lambda tree: tree.update(digest="f00d"))
    seep = "run/studies/replay/seep"
    assert found(compare, sides) == {f"{seep}/pores.csv": [""], f"{seep}/stage.json": ["digest"]}
    assert found(compare, sides, ignore=["digest"]) == {f"{seep}/pores.csv": [""]}


def test_sentences_may_be_other_ones_but_not_more_or_fewer(compare, sides):
    start = stage(sides, "start") / "stage.json"
    kept = start.read_text()
    change_json(start, lambda tree: tree.update(warnings=["otherwise"] * len(tree["warnings"])))
    assert found(compare, sides) == {}
    assert found(compare, sides, texts=True)["run/studies/replay/start/stage.json"][0] == "warnings/0"
    start.write_text(kept)
    change_json(start, lambda tree: tree["warnings"].append("one more"))
    assert found(compare, sides) == {"run/studies/replay/start/stage.json": ["warnings/length"]}


def test_what_cannot_be_read_is_a_difference(compare, sides):
    (stage(sides, "seep") / "stage.json").write_text("{")
    (stage(sides, "seep") / "results.cbor").write_bytes(b"\xff")
    (stage(sides, "seep") / "state.h5").write_bytes(b"no state")
    assert len(found(compare, sides)) == 3


def test_the_numbers_of_a_report_are_compared(compare, sides):
    files = importlib.import_module("files")
    page = files.of_page((sides[0] / "job/run/report.html").read_text())
    cells = [cell["number"] for table in page["tables"] for row in table["rows"] for cell in row if "number" in cell]
    report = sides[1] / "job/run/report.html"
    text = report.read_text()
    once = next(cell for cell in cells if len(cell) > 4 and text.count(f">{cell}<") == 1)
    report.write_text(text.replace(f">{once}<", f">{once}1<"))
    (wrong,) = found(compare, sides)["run/report.html"]
    assert wrong.startswith("tables/") and wrong.endswith("/number")


def test_how_long_a_call_took_is_not_compared(compare, sides):
    report = sides[1] / "job/run/report.html"
    changed, count = re.subn(r">[\d.]+ s<", ">12345 s<", report.read_text())
    assert count == 2  # of the call, and of all calls
    report.write_text(changed)
    assert found(compare, sides) == {}
