"""calibrate: parameters from tests of a laboratory, with samples of few grains."""

import math

import numpy
import pytest

import suffuse

CASE = """schema = 1
title = "few grains"
seed = 2
[grain]
density = "2650 kg/m^3"
[contact]
shear_ratio = 0.42
rolling_stiffness = 7.5
rolling_friction = 0.2
[soil.sand]
psd = { d = ["0.13 mm", "0.14 mm", "0.15 mm"], passing = ["0 %", "50 %", "100 %"] }
[calibrate]
soil = "sand"
particles = 120
samples = 8
targets = [
  { name = "u", file = "undrained.csv", test = "undrained", pressure = "100 kPa", strain = 0.01, void_ratio_tolerance = 0.03 },
  { name = "o", file = "oedometer.csv", test = "oedometer", pressure = "50 kPa", void_ratio_tolerance = 0.03, void_ratio_of = "u" },
]
unknowns = { "contact.modulus" = ["100 MPa", "1 GPa", "log"], "contact.friction" = ["20 deg", "40 deg"], void_ratio = [0.6, 0.75] }
"""


@pytest.fixture
def case(tmp_path):
    rows = [f"{0.1 * k},{200 * (1 - math.exp(-0.4 * k))},{20 * (1 - math.exp(-0.2 * k))}" for k in range(21)]
    (tmp_path / "undrained.csv").write_text("\n".join(["axial strain [%],q [kPa],pore pressure [kPa]", *rows]))
    rows = [f"{25 * 2**k},{0.3 * k}" for k in range(5)]
    (tmp_path / "oedometer.csv").write_text("\n".join(["axial stress [kPa],axial strain [%]", *rows]))
    (tmp_path / "case.toml").write_text(CASE)
    return tmp_path / "case.toml"


def test_undrained_and_oedometer_tests_give_parameters_and_a_stopped_one_goes_on(case, tmp_path):
    with pytest.raises(suffuse.Interrupted, match="goes on"):
        suffuse.calibrate(case, tmp_path / "part", time_limit="1 ms")
    with pytest.raises(suffuse.IoError, match="has not ended"):
        suffuse.Calibration(tmp_path / "part", {"complete": False}).verify()
    heard = []
    with pytest.warns(UserWarning, match='assumed: "axial stress.*is effective') as warned:
        found = suffuse.calibrate(case, tmp_path / "part", on_progress=heard.append)
    assert warned[0].filename == __file__
    assert heard and {letter["verb"] for letter in heard} >= {"compact"}
    assert found.is_complete and set(found.parameters) == {"contact.modulus", "contact.friction", "void_ratio"}
    for parameter in found.parameters.values():
        assert parameter["range"][0] <= parameter["low"] <= parameter["high"] <= parameter["range"][1]
        assert parameter["identified"] == (parameter["information"] >= 1)
    posterior = found.posterior
    assert len(posterior) == 2000 and posterior.units["contact.modulus"] == "Pa"
    assert posterior.units["contact.friction"] == "rad" and posterior.units["void_ratio"] == "-"
    low, high = (found.parameters["contact.friction"][end] for end in ("low", "high"))
    assert numpy.mean((posterior["contact.friction"] >= low) & (posterior["contact.friction"] <= high)) == pytest.approx(0.9, abs=0.01)
    assert set(found.not_identified) == {key for key, one in found.parameters.items() if one["information"] < 1}
    assert "[contact]" in found.contact and "contact.modulus" in str(found)
    assert suffuse.Calibration(tmp_path / "part") == found
    twenty = found.samples()
    assert len(twenty) == 20 and set(twenty[0]) == set(found.parameters)
    number, unit = twenty[1]["contact.friction"].split()
    assert unit == "deg" and math.radians(float(number)) == pytest.approx(posterior["contact.friction"][100], rel=1e-5)
    assert twenty[1]["void_ratio"] == pytest.approx(posterior["void_ratio"][100], rel=1e-5)
    with pytest.raises(ValueError, match="1 to 2000"):
        found.samples(0)
    assert [curve["quantity"] for fit in found["fit"] for curve in fit["curves"]] == [
        "stress_ratio", "mean_stress_ratio", "axial_strain"]

    again = suffuse.calibrate(case, tmp_path / "part")  # all of it is there
    assert again == found
    with pytest.raises(suffuse.CaseError, match="other settings"):
        suffuse.calibrate(case, tmp_path / "part", changes={"calibrate.particles": 5000})
    assert again.verify()["damages"] == [] and again.verify()["states"] > 0
    with open(tmp_path / "part" / "posterior.csv", "a") as table:
        table.write("\n")
    assert [damage["file"] for damage in again.verify()["damages"]] == ["posterior.csv"]


def test_what_is_wrong_leaves_no_folder(case, tmp_path):
    with pytest.raises(suffuse.CaseProblems, match="samples"):
        suffuse.calibrate(case, tmp_path / "run", changes={"calibrate.samples": 2})
    with pytest.raises(suffuse.CaseError, match="time_limit"):
        suffuse.calibrate(case, tmp_path / "run", time_limit="-1 s")
    with pytest.raises(TypeError, match="changes"):
        suffuse.calibrate(case, tmp_path / "run", change={})
    assert not (tmp_path / "run").exists()
    with pytest.raises(suffuse.IoError, match="calibration.json"):
        suffuse.Calibration(tmp_path)


def test_what_a_function_raises_stops_it(case, tmp_path):
    def refuse(_):
        raise ValueError("enough")

    with pytest.raises(ValueError, match="enough"):
        suffuse.calibrate(case, tmp_path / "run", on_progress=refuse)
    assert not (tmp_path / "run" / "calibration.json").exists()
