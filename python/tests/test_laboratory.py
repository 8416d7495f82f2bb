"""read_test: rows of a laboratory's tests."""

import os
import pathlib

import numpy
import pytest

import suffuse

SHEETS = pathlib.Path(os.environ["SUFFUSE_SOURCE_DIR"]) / "tests" / "laboratory"


def test_rows_are_in_si_and_compression_is_positive():
    with pytest.warns(UserWarning, match="assumed"):
        rows = suffuse.read_test(SHEETS / "karlsruhe-drained.csv", "triaxial")
    first = rows[rows["test"] == "TMD1"]
    assert first["deviator_stress"][:2] == pytest.approx([2130, 9680])
    assert first["axial_strain"][2] == pytest.approx(0.001648)
    assert rows.units["deviator_stress"] == "Pa" and rows.units["axial_strain"] == "-"
    # a drained test keeps its radial stress: p = radial stress + q/3
    radial = first["mean_stress"] - first["deviator_stress"] / 3
    assert numpy.ptp(radial) < 0.02 * radial.mean()


def test_a_wrong_word_names_those_that_are_right(tmp_path):
    with pytest.raises(suffuse.UsageError, match="triaxial, oedometer, permeameter"):
        suffuse.read_test(SHEETS / "karlsruhe-drained.csv", "biaxial")
    with pytest.raises(suffuse.UsageError, match="positive or negative"):
        suffuse.read_test(SHEETS / "karlsruhe-drained.csv", "triaxial", contraction="up")
    with pytest.raises(suffuse.IoError):
        suffuse.read_test(tmp_path / "none.csv", "triaxial")


def test_a_permeameter_test_has_its_discharge():
    rows = suffuse.read_test(SHEETS / "permeameter.csv", "permeameter")
    assert rows.units["gradient"] == "-"
    assert (rows["gradient"] > 0).all()
