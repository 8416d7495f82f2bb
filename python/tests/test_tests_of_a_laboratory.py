"""The tests of a laboratory on a World: their numbers, rows and refusals."""

import math

import numpy
import pytest

import suffuse


def test_triaxial_paths_bear_the_names_of_cases(settled):
    oedometer = settled.copy().triaxial("0.1 %", path="proportional", strain_ratio=1, inertial_number=3e-3)
    last = oedometer["curve"][-1]
    assert last["volumetric_strain"] == pytest.approx(last["axial_strain"], rel=1e-5)
    sheared = settled.copy()
    sheared.triaxial(stress_ratio=0.4, inertial_number=3e-3)
    rise = sheared.triaxial("0.2 %", path="constant-deviator", inertial_number=3e-3)
    assert rise["response"]["excess_pore_pressure"] > 0
    with pytest.raises(suffuse.CaseError, match="expected one of drained, .*, proportional"):
        settled.triaxial(path="oedometer")
    with pytest.raises(suffuse.CaseError, match="strain_ratio"):
        settled.triaxial(path="proportional")


def test_laboratory_tests_return_their_numbers_and_rows(settled):
    oedometer = settled.copy().oedometer(["200 kPa", "100 kPa"], inertial_number=3e-3)
    assert 0.2 < oedometer["k0"] < 0.9 and oedometer["swelling_index"] > 0
    assert settled.copy().isotropic([2e5], inertial_number=3e-3)["swelling_index"] is None
    assert settled.copy().plane_strain("1 %", inertial_number=3e-3)["response"]["peak_deviator"] > 0
    shear = settled.copy().shear("2 %", hold="stress", axes="xy", inertial_number=3e-3)
    assert shear["rows"][-1]["shear_strain"] == pytest.approx(0.02, rel=0.1)
    cyclic = settled.copy().cyclic(csr=0.1, cycles=1, inertial_number=3e-3)
    assert cyclic["cycles"] == 1 and {row["cycle"] for row in cyclic["rows"]} == {0, 0.5}
    assert cyclic["skempton_b"] == 1
    soft = suffuse.Fluid(bulk_modulus="20 MPa")
    cyclic = settled.copy().cyclic(csr=0.1, cycles=1, inertial_number=3e-3, fluid=soft)
    assert 0.3 < cyclic["skempton_b"] < 0.9
    extended = settled.copy().triaxial("1 %", direction="extension", inertial_number=3e-3)
    assert extended["response"]["peak_deviator"] < 0
    for wrong in ({}, {"csr": 0.1, "strain_amplitude": "1 %"}):
        with pytest.raises(suffuse.CaseError, match="one amplitude"):
            settled.cyclic(**wrong)
    with pytest.raises(suffuse.CaseError, match="stresses: found none"):
        settled.oedometer([])


def test_what_a_test_cannot_show_is_none(settled):
    unloaded = settled.copy().oedometer(["50 kPa"], inertial_number=3e-3)
    assert unloaded["swelling_index"] > 0 and unloaded["k0"] is None and unloaded["compression_index"] is None
    assert settled.copy().triaxial("0.2 %", inertial_number=3e-3)["response"]["dilatancy"] is None


def test_an_oedometer_out_of_reach_names_its_axial_stress(settled):
    with pytest.raises(suffuse.StateError, match="stress of 400 kPa: at 0.1.* the axial stress is .* or more `strain`"):
        settled.copy().oedometer(["400 kPa"], strain="0.1 %", inertial_number=3e-3)
    with pytest.raises(suffuse.CaseError, match="no contact law describes them"):
        settled.oedometer(["40 GPa"])
    with pytest.raises(suffuse.CaseError, match="no contact law describes them"):
        settled.triaxial(deviator_stress="40 GPa")


def test_grains_far_within_one_another_are_no_sample():
    place = numpy.random.default_rng(0).random((50, 3)) * 1e-2
    crowd = suffuse.World([1e-2] * 3, place, numpy.full(50, 2e-3))
    for test in (crowd.triaxial, crowd.stiffness, crowd.stress_probe, lambda: crowd.oedometer([2e5])):
        with pytest.raises(suffuse.StateError, match="overlap by .* % of the smaller radius in the mean"):
            test()


def test_stiffness_is_symmetric_and_below_the_mean_field(cloud, settled):
    found = settled.stiffness()
    tensor = numpy.array(found["stiffness"])
    assert tensor.shape == (6, 6) and (tensor == tensor.T).all() and (numpy.linalg.eigvalsh(tensor) > 0).all()
    assert 0 < found["shear_modulus"] < found["mean_field_shear"]
    assert found["young_moduli"][2] == pytest.approx(1 / numpy.linalg.inv(tensor)[2, 2])
    with pytest.warns(UserWarning, match="outside the elastic range"):
        settled.stiffness(0.005)
    with pytest.raises(suffuse.StateError):
        cloud.stiffness()
    with pytest.raises(suffuse.CaseError, match="increment"):
        settled.stiffness(0)


def test_a_stress_probe_answers_by_direction(cloud, settled):
    probes = settled.stress_probe("2 %", directions=4)
    assert [round(math.degrees(probe["angle"])) for probe in probes] == [0, 90, 180, 270]
    assert all(probe["answer"] == "rests" and probe["normalized"] > 0.9 for probe in probes)
    assert probes[1]["stress"][2] == pytest.approx(0.02 * settled.mean_stress, rel=0.02)
    with pytest.raises(suffuse.StateError, match="carries a stress"):
        cloud.stress_probe()
    with pytest.raises(suffuse.CaseError, match="directions: found 0"):
        settled.stress_probe(directions=0)
