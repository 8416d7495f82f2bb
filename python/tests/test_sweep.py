"""Sweeps by executors: the samples in other processes, the same bits, one report."""

import concurrent.futures
import json

import pytest

import suffuse

CASE = """schema = 1
[soil.sand]
psd = { d = ["0.2 mm", "0.3 mm", "0.4 mm"], passing = ["0 %", "50 %", "100 %"] }
[study.s]
soil       = "sand"
particles  = 200
sweep      = { "stage.cloud.porosity" = [0.6, 0.65, 0.7] }
refine     = { key = "stage.cloud.porosity", around = "minimum", of = "void_ratio", at = ["moved"], add = 1 }
replicates = 1
[[study.s.stage]]
name     = "cloud"
do       = "pack"
porosity = 0.6
[[study.s.stage]]
name        = "moved"
do          = "advance"
steps       = 20
time_step   = "1e-9 s"
strain_rate = ["1 1/s", "0 1/s", "0 1/s"]
"""


class Broken(concurrent.futures.Executor):
    """An executor whose second worker dies."""

    def __init__(self):
        self.calls = []

    def submit(self, fn, /, *args, **kwargs):
        self.calls.append(args)
        future = concurrent.futures.Future()
        if len(self.calls) == 2:
            future.set_exception(concurrent.futures.BrokenExecutor("a worker died"))
        elif len(self.calls) == 1:
            future.set_result(fn(*args, **kwargs))
        return future


@pytest.fixture
def case(tmp_path):
    (tmp_path / "case.toml").write_text(CASE)
    return tmp_path / "case.toml"


def hashes(run):
    return {name: run[name]["state_hash"] for name in run.stages}


@pytest.fixture
def whole(case, tmp_path):
    """Without an executor, with the sample that `refine` adds."""
    run = suffuse.sweep(case, tmp_path / "whole")
    assert len(run) == 8
    return hashes(run)


@pytest.mark.parametrize("executor", [concurrent.futures.ProcessPoolExecutor, concurrent.futures.ThreadPoolExecutor])
def test_an_executor_gives_the_bits_of_a_run_and_one_report(case, whole, tmp_path, executor):
    threads = suffuse.threads()
    with executor(2) as pool:
        run = suffuse.sweep(case, tmp_path / "run", executor=pool)
    assert hashes(run) == whole
    assert (run.outcome, run.report.exists(), run.summary["samples"]["done"]) == ("done", True, 4)
    assert run.verify()["damages"] == [] and suffuse.threads() == threads
    assert (run.folder / "refinement.json").exists()


def test_a_worker_that_dies_ends_the_sweep_and_the_same_call_goes_on(case, whole, tmp_path):
    broken = Broken()
    with pytest.raises(concurrent.futures.BrokenExecutor):
        suffuse.sweep(case, tmp_path / "run", executor=broken)
    assert len(broken.calls) == 3 and len(list((tmp_path / "run/studies").rglob("stage.json"))) == 2
    with concurrent.futures.ProcessPoolExecutor(2) as pool:
        run = suffuse.sweep(suffuse.Case(case), tmp_path / "run", executor=pool)
        assert hashes(run) == whole
        assert suffuse.sweep(case, tmp_path / "run", executor=pool).outcome == "done"  # there was nothing left
    begun = [json.loads(line) for line in (run.folder / "studies" / run.stages[0]).parent.joinpath("events.jsonl").open()]
    assert sum(event["event"] == "sample begins" for event in begun) == 1


def test_a_sample_that_fails_is_in_the_report_and_the_others_are_done(case, whole, tmp_path):
    with pytest.raises(concurrent.futures.BrokenExecutor):
        suffuse.sweep(case, tmp_path / "run", executor=Broken())
    in_the_way = tmp_path / "run/studies/s/porosity=0.7/moved/state.h5"
    in_the_way.mkdir(parents=True)
    with concurrent.futures.ProcessPoolExecutor(2) as pool:
        run = suffuse.sweep(case, tmp_path / "run", executor=pool)
        assert run.outcome == "failed in part" and run.summary["samples"]["failed"] == 1
        assert run.summary["failures"][0]["sample"] == "s/porosity=0.7" and len(run) == 5
        in_the_way.rmdir()
        assert hashes(suffuse.sweep(case, tmp_path / "run", executor=pool)) == whole


def test_wrong_use_is_an_error_before_a_folder_is_made(case, tmp_path):
    with pytest.raises(TypeError, match="executor"):
        suffuse.sweep(case, tmp_path / "run", excutor=None)
    case.write_text(CASE.replace("particles", "partcles"))
    with pytest.raises(suffuse.CaseProblems):
        suffuse.sweep(case, tmp_path / "run", executor=Broken())
    assert not (tmp_path / "run").exists()
