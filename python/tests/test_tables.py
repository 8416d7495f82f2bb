"""A run as a table, and tables for other libraries."""

import math
import os

import numpy
import pytest

import suffuse
from conftest import PACKING
from suffuse.records import gather, read_records, unit_of


@pytest.fixture
def run(small_case, tmp_path):
    return suffuse.Case(small_case).run(tmp_path / "run")


def test_a_run_is_a_table_of_its_stages(run):
    table = run.table()
    assert table["stage"].tolist() == ["start", "settled", "compressed", "seep"]
    assert set(table["sample"]) == {"replay"}
    assert table["void_ratio"][1] == run["replay/settled"].void_ratio
    assert numpy.isnan(table["permeability_along"][:3]).all() and table["permeability_along"][3] > 0
    assert table["seconds.solve"][3] == run["replay/seep"]["seconds"]["solve"]
    assert table.units["mean_stress"] == "Pa" and table.units["seconds.solve"] == "s" and table.units["void_ratio"] == "-"
    assert "stage" not in table.units and set(table.units) <= set(table.dtype.names)
    with pytest.raises(suffuse.CaseError, match="expected one of stages, passes, samples"):
        run.table(rows="grains")


def test_a_table_of_one_verb_has_its_columns_alone(run):
    table = run.table(verb="flow")
    assert table["stage"].tolist() == ["seep"]
    assert not any(numpy.isnan(table[name]).any() for name in table.units), "each column is one that a flow fills"
    assert len(table.dtype.names) < len(run.table().dtype.names)
    assert len(run.table("passes", verb="flow")) == 0, "a verb of the run, which has no passes"
    with pytest.raises(suffuse.CaseError, match="verb: found 'seep', expected one of .*flow"):
        run.table(verb="seep")


def test_a_sample_is_a_row_of_its_stages(run):
    table = run.table("samples")
    assert len(table) == 1 and table["settled/void_ratio"][0] == run["replay/settled"].void_ratio
    assert table.units["settled/mean_stress"] == "Pa"
    assert len(run.table("passes")) == 0, "nothing was eroded"


SWEPT = """schema = 1
title = "A sweep"
[study.dense]
sweep = { "stage.settled.pressure" = ["100 kPa", "90 kPa"], "stage.settled.shear_stresses" = ["released", "kept"], "contact.friction" = ["30 deg"] }
[[study.dense.stage]]
name = "start"
do = "import"
packing = "packing.csv"
cell = ["1.436 mm", "1.436 mm", "1.436 mm"]
[[study.dense.stage]]
name = "settled"
do = "settle"
pressure = "100 kPa"
"""


def test_samples_are_in_the_order_of_the_sweep_with_their_values_as_numbers(tmp_path):
    (tmp_path / "case.toml").write_text(SWEPT)
    (tmp_path / "packing.csv").write_bytes(PACKING.read_bytes())
    run = suffuse.Case(tmp_path / "case.toml").run(tmp_path / "run")
    for name in reversed(run.case().stages):  # as if the last sample had been finished first
        os.utime(tmp_path / "run" / "studies" / name / "stage.json")
    for rows in ("samples", "stages"):
        table = run.table(rows)[:: 1 if rows == "samples" else 2]
        assert table["pressure"].tolist() == 2 * [100e3] + 2 * [90e3] and table.units["pressure"] == "Pa"
        assert table["shear_stresses"].tolist() == 2 * ["released", "kept"] and "shear_stresses" not in table.units
        assert table["friction"].tolist() == pytest.approx(4 * [math.pi / 6])
        assert table.units["friction"] == "rad" and table[:2].units["friction"] == "rad"


def test_keys_that_change_together_are_columns_too(tmp_path):
    sweep = next(line for line in SWEPT.splitlines() if line.startswith("sweep"))
    rows = 'rows = { "contact.friction" = ["20 deg", "30 deg"], "stage.settled.pressure" = ["100 kPa", "90 kPa"] }'
    (tmp_path / "case.toml").write_text(SWEPT.replace(sweep, rows))
    (tmp_path / "packing.csv").write_bytes(PACKING.read_bytes())
    table = suffuse.Case(tmp_path / "case.toml").run(tmp_path / "run").table("samples")
    assert table["pressure"].tolist() == [100e3, 90e3] and table.units["pressure"] == "Pa"
    assert table["friction"].tolist() == pytest.approx([math.pi / 9, math.pi / 6])


def test_rows_lack_what_others_have():
    table = gather([{"a": 1, "word": "x"}, {"a": 2, "b": True}, {}])
    assert table["a"][:2].tolist() == [1, 2] and numpy.isnan(table["a"][2])
    assert table["b"][1] == 1 and numpy.isnan(table["b"][0]) and table["word"].tolist() == ["x", "", ""]


def test_units_follow_the_object_that_a_number_is_in():
    units = {
        "wall_seconds.constrictions": "s", "constrictions": "-", "constrictions_by_merge.none.mean": "m",
        "constrictions_by_merge.none.count": "-", "flow_before.known_error.permeability": "-", "response.energy.work": "J/m3",
        "response.instability.q": "Pa", "permeability_before": "m2", "shear/response.stiffness": "Pa", "time/void_ratio": "-",
        "d [mm]": "mm", "eroded_mass_percent": "%", "preparation_adhesion.normal": "Pa",
        "measured.grading.d10": "m", "measured.grading.largest": "m", "measured.grading.uniformity": "-", "gravity": "m/s2",
        "measured.constrictions.mean": "m", "measured.constrictions.d35": "m", "measured.constrictions.count": "-",
        "wall_seconds.constrictions": "s", "probe.viscous_time": "s", "transport.filter_coefficient": "1/m",
    }
    assert {name: unit_of(name) for name in units} == units


def test_units_of_a_column_are_those_of_its_table(tmp_path):
    for table, name, unit in (
        ("migration.csv", "energy", "J"), ("migration.csv", "fed_mass", "kg"), ("ledger.csv", "x0", "m"),
        ("ledger.csv", "departed", "s"), ("throats.csv", "conductance", "m3/(Pa s)"), ("history.csv", "time", "s"),
    ):
        (tmp_path / table).write_text(f"{name}\n1\n")
        assert read_records(tmp_path / table).units == {name: unit}


def test_a_table_without_rows_keeps_its_columns(tmp_path):
    (tmp_path / "empty.csv").write_text("# remark\npass,id,d\n")
    table = read_records(tmp_path / "empty.csv")
    assert table.dtype.names == ("pass", "id", "d") and len(table) == 0


def test_pandas_takes_a_table_with_its_units(run):
    frame = run.table().to_pandas()
    assert frame.loc[frame.verb == "flow", "permeability_along"].item() == run["replay/seep"]["permeability_along"]
    assert frame.attrs["units"]["mean_stress"] == "Pa"
    assert len(run["replay/compressed"].history.to_pandas()) == len(run["replay/compressed"].history)


def test_xarray_takes_a_table_with_its_units(run):
    data = run["replay/compressed"].history.to_xarray()
    assert data["stress_1"].attrs["units"] == "Pa" and data.sizes["row"] == len(run["replay/compressed"].history)


def test_what_is_not_installed_is_named(run, monkeypatch):
    def missing(name):
        raise ImportError(name)

    monkeypatch.setattr("suffuse.records.importlib.import_module", missing)
    for call, library in ((run.table().to_pandas, "pandas"), (run.table().to_xarray, "xarray")):
        with pytest.raises(ImportError, match=f"needs {library}.*install it"):
            call()


def test_a_notebook_shows_numbers_of_a_run_a_plan_a_world_and_a_table(run, settled):
    page = run._repr_html_()
    assert "replay/compressed" in page and run.summary["title"] in page and "<table>" in page
    assert "replay/settled" in run.case().plan()._repr_html_()
    page = settled._repr_html_()
    assert ">500<" in page and f"{settled.void_ratio:.5g}" in page
    assert '<td style="text-align:right">500</td>' in page and '<td style="text-align:left">grains</td>' in page
    water = suffuse.seep(settled, gradient=0.1)
    assert f">{water.permeability:.5g}<" in water._repr_html_() and ">network<" in water._repr_html_()
    assert "mean_stress [Pa]" in run.table()._repr_html_()


def test_a_view_is_a_page_that_stands_by_itself(settled, tmp_path):
    view = settled.view("my grains")
    page = view.save(tmp_path / "grains.html").read_text()
    assert page.startswith("<!doctype html>") and "my grains" in page and "500" in page
    assert "http://" not in page.split("<script>")[0] and 'src="data:image/png;base64,' in page
    assert view._repr_html_().startswith("<iframe srcdoc=") and "&lt;!doctype" in view._repr_html_()
