"""Every class of the module is taken apart by every protocol of pickle, or refused with a sentence; nothing ends the process."""

import copy
import copyreg
import inspect
import pickle
import subprocess
import sys

import pytest

import suffuse
from suffuse import _core

PROTOCOLS = range(pickle.HIGHEST_PROTOCOL + 1)
CLASSES = {name: one for name, one in vars(_core).items() if inspect.isclass(one) and not issubclass(one, BaseException)}
ERRORS = [one for one in vars(_core).values() if inspect.isclass(one) and issubclass(one, BaseException)]
NEVER_TRAVEL = {"Probe", "CaseFile", "Key"}


@pytest.fixture
def objects(soil, small_case):
    probes = []
    soil.copy().erode(0.5, rule=lambda probe: probes.append(probe) or probe.by_velocity, ramp=10, watch=10, size="none")
    with pytest.raises(suffuse.CaseProblems) as raised:
        suffuse.Case(small_case, changes={"contact.modulus": "1 kg"})
    return {
        "Material": suffuse.Material(friction=0.3), "Fluid": suffuse.Fluid(), "Balance": suffuse.Balance(),
        "Loading": suffuse.Loading(stress="100 kPa"), "Contacts": soil.contacts, "Grains": soil.grains, "World": soil,
        "Constrictions": suffuse.constrictions(soil), "PoreNetwork": suffuse.PoreNetwork(soil),
        "Seepage": suffuse.seep(soil, gradient=0.1), "ResolvedFlow": suffuse.resolve_flow(soil, boxes_across=4),
        "Probe": probes[0], "Diagnostic": raised.value.problems[0], "CaseFile": suffuse.Case(small_case)._core,
        "Key": suffuse.schema()[0],
    }  # fmt: skip


def test_every_class_by_every_protocol(objects):
    assert objects.keys() == CLASSES.keys() and all(type(objects[name]) is one for name, one in CLASSES.items())
    for name, one in objects.items():
        for protocol in PROTOCOLS:
            if name in NEVER_TRAVEL:
                for way in (lambda: pickle.dumps(one, protocol), lambda: one.__reduce_ex__(protocol), one.__reduce__):
                    with pytest.raises(TypeError, match=f"cannot pickle a suffuse.{name}: pickle what it was made from"):
                        way()
                continue
            again = pickle.loads(pickle.dumps(one, protocol))
            assert type(again) is type(one) and repr(again) == repr(one)
            make, arguments, *state = one.__reduce_ex__(protocol)
            assert type(make(*arguments)) is type(one)
        if name not in NEVER_TRAVEL:
            assert repr(copy.copy(one)) == repr(copy.deepcopy(one)) == repr(one) and one.__reduce__()


def test_a_world_of_protocol_0_has_the_same_bits(soil):
    assert pickle.loads(pickle.dumps(soil, 0)).hash == pickle.loads(pickle.dumps(soil)).hash == soil.hash


def test_errors_by_every_protocol():
    for kind in ERRORS:
        for protocol in PROTOCOLS:
            again = pickle.loads(pickle.dumps(kind("why"), protocol))
            assert type(again) is kind and str(again) == "why"


def test_ways_around_are_refused(objects):
    for one in objects.values():
        for way in (lambda: copyreg._reduce_ex(one, 0), lambda: copyreg._reduce_ex(one, 1), lambda: object.__reduce__(one)):
            with pytest.raises(TypeError, match="pickle.dumps"):
                way()
    with pytest.raises(TypeError, match="makes no objects"):
        suffuse.World.__base__()


def test_a_class_of_the_callers_travels_too():
    lines = "import pickle, suffuse\nclass Soil(suffuse.Material): pass\n"
    lines += "for p in range(6): assert type(pickle.loads(pickle.dumps(Soil(), p))) is Soil"
    done = subprocess.run([sys.executable, "-c", lines], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
