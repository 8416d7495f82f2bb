"""Erosion of a World and of a case, with the rules of a case and with custom rules."""

import json
import pickle
import warnings

import numpy
import pytest

import suffuse


QUICK = {"gradient": 0.5, "ramp": 100, "watch": 100, "size": "none"}


def lightly_held(probe):
    return probe.coordination <= 1


def none_of_them(probe):
    return numpy.zeros(len(probe), bool)


def test_a_custom_rule_decides_which_fines_leave(soil):
    seen = []

    def rule(probe):
        seen.append(probe)
        return lightly_held(probe)

    fines = int(soil.grains.fine.sum())
    found = soil.erode(rule=rule, **QUICK)
    probe = seen[0]
    wanted = probe.id[lightly_held(probe)]
    assert 0 < len(wanted) < len(probe) == fines
    assert sorted(found["removed"]["id"]) == sorted(wanted) and len(soil) == 500 - len(wanted)
    assert found["removed"]["coordination"].max() <= 1 and found["rule"].endswith("rule")
    assert (found["removed"]["mass"] > 0).all()
    assert probe.speed.shape == (fines, 11) and probe.gradient == 0.5
    assert numpy.array_equal(probe.world.grains.id[probe.row], probe.id), "rows of the equilibrium"
    assert len(probe.world) == 500, "it stays as it was"


def test_a_world_without_fines_is_refused(soil):
    soil.grains.fine[:] = 0
    with pytest.raises(suffuse.StateError, match="no grain is fine"):
        soil.erode(**QUICK)


def test_a_rule_that_says_what_the_built_in_one_says_gives_its_bits(soil):
    other = soil.copy()
    soil.erode(rule=lambda probe: probe.by_velocity, **QUICK)
    assert other.erode(**QUICK)["rule"] == "velocity"
    assert other.hash == soil.hash and len(other) < 500


def test_what_a_rule_returns_is_one_truth_value_a_fine_grain(soil):
    before = soil.hash
    for wrong in (lambda probe: probe.id, lambda probe: probe.by_velocity[1:], lambda probe: None, lambda probe: True):
        with pytest.raises(suffuse.CaseError, match="a truth value for each of the 240 fines"):
            soil.erode(rule=wrong, **QUICK)
    with pytest.raises(ZeroDivisionError):
        soil.erode(rule=lambda probe: 1 / 0, **QUICK)
    with pytest.raises(suffuse.CaseError, match="expected one of velocity, displacement"):
        soil.erode(rule="velocty")
    with pytest.raises(suffuse.CaseError, match="a function from a Probe"):
        soil.erode(rule=3)
    assert soil.hash == before


def test_a_pass_that_is_interrupted_leaves_the_rows_in_their_order(packing):
    packing.grains.fine = packing.grains.radius < numpy.median(packing.grains.radius)
    before = pickle.dumps(packing)
    with pytest.raises(ZeroDivisionError):
        packing.erode(rule=lambda probe: 1 / 0, **QUICK)
    assert pickle.dumps(packing) == before


def test_a_gradient_so_steep_that_fines_hit_others_is_warned_of(soil):
    def taken(gradient):
        eroded = soil.copy().erode(gradient, ramp=1_000, size="none", max_strain=1)
        return eroded["passes"][0]["probe"]["detachable_by_velocity"]

    with warnings.catch_warnings():
        warnings.simplefilter("error")
        gentle = taken(0.05)  # the paper's gradient and watch
    with pytest.warns(UserWarning, match="at i = 100 one fine grain in 20 would travel 0.02.* of its diameter"):
        assert taken(100) < 0.9 * gentle


def test_arrays_taken_in_a_rule_keep_the_rows_of_before(soil):
    kept = []
    soil.erode(rule=lambda probe: kept.append(soil.grains.radius) or lightly_held(probe), **QUICK)
    assert len(kept[0]) == 500 and (kept[0] > 0).all() and len(soil.grains.radius) < 500


def test_a_run_with_a_custom_rule_says_so(eroding_case, tmp_path):
    case = suffuse.Case(eroding_case)
    run = case.run(tmp_path / "run", rules={"eroded": lightly_held})
    stage = run["erosion/eroded"]
    assert stage["own_rule"]["name"] == "lightly_held" and "coordination <= 1" in stage["own_rule"]["source"]
    assert set(stage.table("eroded.csv")["reason"]) == {"own rule"} and stage.passes[0].removed > 0
    assert any("a custom rule, lightly_held" in text for text in run.summary["warnings"])
    assert "erosion/eroded by the rule lightly_held" in run.provenance["command"]
    assert "own_rule" not in run["erosion/settled"].numbers
    own_rules = json.loads((tmp_path / "run" / "own_rules.json").read_text())
    assert own_rules["erosion/eroded"]["name"] == "lightly_held"
    assert "decided which fines are detachable" in run.report.read_text()


def test_the_cache_never_mixes_rules(eroding_case, tmp_path):
    case, cache = suffuse.Case(eroding_case), tmp_path / "cache"

    def from_cache(run):
        return {event["stage"] for event in run.events if event["event"] == "stage taken from the cache"}

    own = case.run(tmp_path / "own", cache=cache, rules={"eroded": none_of_them})
    built_in = case.run(tmp_path / "built-in", cache=cache)
    assert from_cache(built_in) == {"erosion/settled"}
    assert built_in["erosion/eroded"].passes[0].removed > 0 == own["erosion/eroded"].passes[0].removed
    again = case.run(tmp_path / "again", cache=cache, rules={"erosion/eroded": none_of_them})
    assert from_cache(again) == {"erosion/settled"}
    assert from_cache(case.run(tmp_path / "third", cache=cache)) == {"erosion/settled", "erosion/eroded"}


def test_a_stopped_run_goes_on_with_the_same_rule_only(eroding_case, tmp_path):
    calls = []

    def rule(probe):
        calls.append(len(probe))
        if len(calls) == 2:
            raise KeyboardInterrupt
        return probe.coordination <= 1

    case = suffuse.Case(eroding_case)
    with pytest.raises(KeyboardInterrupt):
        case.run(tmp_path / "run", rules={"eroded": rule})
    run = suffuse.Run(tmp_path / "run")
    assert "erosion/eroded" not in run.stages
    with pytest.raises(suffuse.UsageError, match="was requested with the rule .*rule from Python"):
        run.resume()
    with pytest.raises(suffuse.UsageError, match="was requested with the rule"):
        case.run(tmp_path / "run")
    run.resume(rules={"eroded": lightly_held})
    assert run.outcome == "done" or "another detachment rule" in run.summary["failures"][0]["message"]
    assert "erosion/eroded" not in run.stages
    run.resume(rules={"eroded": rule})
    whole = case.run(tmp_path / "whole", rules={"eroded": lightly_held})
    assert run["erosion/eroded"].world.hash == whole["erosion/eroded"].world.hash
    with pytest.raises(suffuse.UsageError, match="was computed with the rule .*another folder"):
        run.resume(rules={"eroded": lightly_held})
    assert run.resume().outcome.startswith("done"), "nothing is left to compute"


def test_a_finished_stage_takes_no_rule_afterwards(eroding_case, tmp_path):
    case = suffuse.Case(eroding_case)
    case.run(tmp_path / "run")
    with pytest.raises(suffuse.UsageError, match="was computed with the rule of the case"):
        case.run(tmp_path / "run", rules={"eroded": lightly_held})


def test_rules_are_for_stages_that_erode(eroding_case, tmp_path):
    for changes, name, words in (
        ({}, "erodde", "a similar one exists: erosion/eroded|there are erosion/eroded"),
        ({}, "settled", "no stage that does \"erode\""),
        ({"study.erosion.stage.eroded.forced": {"max_contacts": 1}}, "eroded", "takes fines out without one"),
    ):
        case = suffuse.Case(eroding_case, changes=changes)
        with pytest.raises(suffuse.UsageError, match=words):
            case.run(tmp_path / f"run-{name}-{len(changes)}", rules={name: lightly_held})
    with pytest.raises(suffuse.CaseError, match="a function from a Probe"):
        suffuse.Case(eroding_case).run(tmp_path / "no-function", rules={"eroded": "velocity"})


def test_an_exception_of_a_rule_stops_the_run_and_is_raised(eroding_case, tmp_path):
    def rule(probe):
        raise LookupError("no such grain")

    with pytest.raises(LookupError, match="no such grain"):
        suffuse.Case(eroding_case).run(tmp_path / "run", rules={"eroded": rule})
    assert suffuse.Run(tmp_path / "run").stages == ["erosion/start", "erosion/settled"]


def test_a_rule_may_step_worlds_while_the_run_waits(eroding_case, tmp_path):
    def rule(probe):
        world = probe.world.copy()
        world.step(10)
        return probe.coordination <= 1 if world.step_number >= 10 else probe.by_velocity

    run = suffuse.Case(eroding_case).run(tmp_path / "run", rules={"eroded": rule})
    assert run["erosion/eroded"].passes[0].removed > 0
