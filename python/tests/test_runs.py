"""Cases and runs: the same bits, words and folders as the program's."""

import json
import math
import os
import pathlib
import pickle
import shutil
import signal
import subprocess
import sys
import xml.etree.ElementTree

import numpy
import pytest

import suffuse
from suffuse.run import page_folder

PROGRAM = os.environ["SUFFUSE_PROGRAM"]


def test_an_imported_stage_has_its_contacts(small_case, tmp_path):
    run = suffuse.Case(small_case).run(tmp_path / "run", until="start")
    start = run["replay/start"]
    assert start["contacts"] == len(start.contacts) > 500 and 0 < start.rattlers < 500
    assert start.max_overlap_ratio == pytest.approx(start.imported_overlap_ratio, rel=1e-12)  # rounding
    assert start.mean_stress == pytest.approx(100e3, rel=5e-3)  # it was settled there


def test_a_case_is_read_checked_and_priced(small_case):
    case = suffuse.Case(small_case, changes={"contact.modulus": "300 MPa"})
    assert case.title == "Replay of an imported packing" and case.material.modulus == 300e6
    assert case.stages == ["replay/start", "replay/settled", "replay/compressed", "replay/seep"]
    plan = case.plan()
    assert len(plan["stages"]) == 4 and plan["steps"][0] >= 200 and "4 stages" in str(plan)
    assert "[contact]" in case.resolved


def test_all_that_is_wrong_is_reported_at_once_with_places(small_case):
    small_case.write_text(small_case.read_text().replace("friction", "frction").replace('"100 kPa"', "100"))
    with pytest.raises(suffuse.CaseProblems) as raised:
        suffuse.Case(small_case)
    problems = raised.value.problems
    assert len(problems) >= 2 and all(problem.line > 0 and problem.code for problem in problems)
    checked = subprocess.run([PROGRAM, "check", small_case], capture_output=True, text=True, check=False)
    assert str(raised.value).strip() in checked.stderr  # the same words as the program's
    assert suffuse.explain(problems[0].code)
    sent = pickle.loads(pickle.dumps(raised.value))  # as a process of a pool sends it home
    assert str(sent) == str(raised.value) and [str(one) for one in sent.problems] == [str(one) for one in problems]


def test_bytes_that_are_no_text_are_an_error_of_the_case(small_case):
    small_case.write_bytes(small_case.read_bytes().replace(b"Replay", b"D\xfcne"))  # as older programs save it
    with pytest.raises(suffuse.CaseProblems, match="not UTF-8") as raised:
        suffuse.Case(small_case)
    assert raised.value.problems[0].code == "E100" and "D?ne" in str(raised.value)
    with pytest.raises(suffuse.IoError, match="no such file"):
        suffuse.assess("d\udcfcne.csv")


def test_a_run_is_that_of_the_program(small_case, tmp_path):
    events = []
    run = suffuse.Case(small_case).run(tmp_path / "ours", on_progress=events.append)
    assert run.outcome == "done" and [p["stage"] for p in events if p["stage_finished"]][-1] == "seep"
    subprocess.run(
        [PROGRAM, "run", small_case, "-o", tmp_path / "theirs", "-q"], check=True, capture_output=True
    )
    theirs = suffuse.Run(tmp_path / "theirs")
    assert run.stages == theirs.stages == ["replay/start", "replay/settled", "replay/compressed", "replay/seep"]
    for name in run:
        assert run[name]["state_hash"] == theirs[name]["state_hash"]
    stage = run["replay/compressed"]
    assert format(stage.world.hash, "016x") == stage["state_hash"]
    assert stage.world.measure()["void_ratio"] == stage["void_ratio"]
    assert stage.history["step"][-1] == stage.world.step_number and len(stage.history) >= 3
    assert stage.table("grains.csv")["r"].sum() == pytest.approx(stage.grains.radius.sum(), rel=1e-12)
    assert run.summary["title"] and run.report.exists() and run.events[-1]["event"] == "run ends"
    for name in run.figures:
        assert len(run.figure(name).data.dtype.names) > 1
    with pytest.raises(suffuse.UsageError, match=".svg, .png or .pdf"):
        suffuse.Figure(run.folder / "figures", "fig09").save(tmp_path / "figure.gif")
    assert stage.void_ratio == stage["void_ratio"] and "void_ratio" in dir(stage)
    with pytest.raises(AttributeError, match="no void_ration"):
        stage.void_ration
    with pytest.raises(KeyError, match="not a finished stage"):
        run["replay/nothing"]


def test_by_hand_and_by_case_are_the_same_bits(small_case, tmp_path):
    case = suffuse.Case(small_case)
    run = case.run(tmp_path / "run")
    by_hand = run["replay/settled"].world
    by_hand.reference_cell = by_hand.cell
    loading = suffuse.Loading(strain_rate=("10 1/s", None, None), stress=(None, "100 kPa", "100 kPa"))
    by_hand.step(200, loading, time_step="4.1e-8 s", damping=case.damping)
    theirs = run["replay/compressed"].world
    assert (by_hand.grains.position == theirs.grains.position).all() and (by_hand.cell == theirs.cell).all()


def test_a_figure_is_saved_as_svg_or_says_what_to_install(small_case, tmp_path):
    run = suffuse.Case(small_case).run(tmp_path / "run")
    figure = run.figure("own-throat-flux")
    drawing = tmp_path / "flux.svg"
    if not (page_folder() / "figures.mjs").exists() or shutil.which("node") is None:
        with pytest.raises(OSError, match="npm|node"):
            figure.save(drawing)
        return
    assert figure.save(drawing) == drawing
    root = xml.etree.ElementTree.parse(drawing).getroot()
    assert root.tag == "{http://www.w3.org/2000/svg}svg" and float(root.get("width")) > 300
    words = " ".join(text.strip() for text in root.itertext())
    assert "flux over the mean flux" in words and "[mm]" in words  # its axes
    assert figure.specification["description"].split(".")[0] in words  # for readers that cannot see it
    assert len(list(root.iter("{http://www.w3.org/2000/svg}path"))) >= 2  # a line and its band
    png = figure.save(tmp_path / "flux.png").read_bytes()
    assert png.startswith(b"\x89PNG") and len(png) > 10_000


def test_nothing_is_written_over_the_files_of_a_run(small_case, tmp_path):
    run = suffuse.Case(small_case).run(tmp_path / "run", until="start")
    stage = run["replay/start"]
    before = {file: file.read_bytes() for file in run.folder.rglob("*") if file.is_file()}
    world, state = stage.world, run.folder / "studies/replay/start/state.h5"
    for write in (
        lambda: suffuse.write_packing(run.folder / "case.toml", world, format="csv"),
        lambda: suffuse.write_packing(tmp_path / "grains.csv", world, contacts=run.folder / "contacts.csv"),
        lambda: world.save(state),
        lambda: suffuse.Figure(run.folder / "figures", "own-grains").save(run.folder / "figures/fig09.svg"),
    ):
        with pytest.raises(suffuse.UsageError, match="would be written into the run folder"):
            write()
    assert before == {file: file.read_bytes() for file in run.folder.rglob("*") if file.is_file()}
    assert not (tmp_path / "grains.csv").exists()


def test_an_exception_of_the_progress_function_saves_and_stops(small_case, tmp_path):
    def stop(progress):
        if progress["stage"] == "settled":
            raise ZeroDivisionError

    with pytest.raises(ZeroDivisionError):
        suffuse.Case(small_case).run(tmp_path / "run", on_progress=stop)
    events = []
    run = suffuse.Run(tmp_path / "run").resume(threads=1, on_event=events.append)
    if events:  # the function is heard next to the work, which may have ended meanwhile: then nothing was left to do
        assert events[-1]["sample_ended"] and events[-1]["failure"] is None
    whole = suffuse.Case(small_case).run(tmp_path / "whole")
    assert run["replay/seep"]["state_hash"] == whole["replay/seep"]["state_hash"]


def test_control_c_saves_and_resuming_gives_the_same_bits(small_case, tmp_path):
    text = small_case.read_text()
    assert "steps       = 200" in text
    small_case.write_text(text.replace("steps       = 200", "steps       = 1_000_000_000"))  # no machine is through
    script = (
        "import os, signal, sys, suffuse\n"
        "def press(progress):\n"
        "    if progress['stage'] == 'compressed' and progress['steps'] > 0:\n"
        "        os.kill(os.getpid(), signal.SIGINT)\n"
        "case, folder = sys.argv[1:]\n"
        "try:\n"
        "    if os.path.exists(folder):\n"
        "        suffuse.Run(folder).resume(on_progress=press)\n"
        "    else:\n"
        "        suffuse.Case(case).run(folder, on_progress=press)\n"
        "except KeyboardInterrupt:\n"
        "    sys.exit(42)\n"
    )
    stage, case, saved = tmp_path / "run" / "studies" / "replay" / "compressed", suffuse.Case(small_case), []
    for _ in range(2):
        done = subprocess.run([sys.executable, "-c", script, small_case, tmp_path / "run"], check=False)
        assert done.returncode == 42
        assert not (stage / "stage.json").exists()
        saved.append(suffuse.World.load(stage / "partial.h5"))
    straight = suffuse.Run(tmp_path / "run")["replay/settled"].world
    straight.reference_cell = straight.cell
    loading = suffuse.Loading(strain_rate=("10 1/s", None, None), stress=(None, "100 kPa", "100 kPa"))
    for world in saved:
        assert world.step_number > straight.step_number
        straight.step(world.step_number - straight.step_number, loading, time_step="4.1e-8 s", damping=case.damping)
        assert (straight.grains.position == world.grains.position).all() and (straight.cell == world.cell).all()


def test_signals_are_left_to_the_program_that_imports_it(small_case, tmp_path):
    script = (
        "import sys\n"
        "def signals():\n"
        "    lines = [line.split() for line in open('/proc/self/status') if line.startswith(('SigBlk', 'SigIgn', 'SigCgt'))]\n"
        "    return [int(mask, 16) % 2**31 for _, mask in lines]\n"  # those above 31 are the threads' own
        "before = signals()\n"
        "import suffuse\n"
        "suffuse.Case(sys.argv[1]).run(sys.argv[2])\n"
        "assert signals() == before, (before, signals())\n"
    )
    subprocess.run([sys.executable, "-c", script, small_case, tmp_path / "run"], check=True)


def test_until_and_time_limit(small_case, tmp_path):
    run = suffuse.Case(small_case).run(tmp_path / "run", until="settled")
    assert run.stages == ["replay/start", "replay/settled"]
    assert suffuse.Case(small_case).run(tmp_path / "run", time_limit=1e-9).outcome == "time limit reached"
    with pytest.raises(suffuse.UnitError):
        suffuse.Case(small_case).run(tmp_path / "run", time_limit="3 kPa")


def test_a_stage_that_the_case_has_not_is_refused_before_anything_runs(small_case, tmp_path):
    with pytest.raises(suffuse.UsageError, match="setled.*settled"):
        suffuse.Case(small_case).run(tmp_path / "run", until="setled")
    assert not (tmp_path / "run").exists()


def test_keys_are_set_to_dictionaries_and_arrays(small_case):
    case = suffuse.Case(small_case)
    case.change({"study.replay.stage.compressed.record": {"every": 50}})
    case.change({"study.replay.stage.seep.direction": numpy.array([0.0, 0.0, 1.0])})
    case.change({"study.replay.stage.seep.gradient": numpy.float64(0.125)})
    assert "every = 50" in case.resolved and case["study.replay.stage.seep"]["gradient"] == 0.125
    with pytest.raises(suffuse.CaseProblems):
        case.change({"study.replay.stage.compressed.record": {"evry": 50}})


def test_a_failure_is_reported_while_the_run_goes_on(small_case, tmp_path):
    events = []
    packing = small_case.parent / "packing.csv"
    case = suffuse.Case(small_case)
    packing.write_text("x,y,z,r\n1,2,3,0\n")
    run = case.run(tmp_path / "run", on_event=events.append)
    assert run.outcome == "failed in part"
    assert [p["failure"] for p in events if p["sample_ended"]][0].startswith(str(packing))


def test_a_cache_spares_what_was_run_before(small_case, tmp_path):
    first = suffuse.Case(small_case).run(tmp_path / "first", cache=tmp_path / "cache", until="settled")
    events = []
    second = suffuse.Case(small_case).run(tmp_path / "second", cache=tmp_path / "cache", until="settled", on_progress=events.append)
    assert any(p["from_cache"] for p in events)
    assert first["replay/settled"]["state_hash"] == second["replay/settled"]["state_hash"]


def test_a_misspelt_number_is_answered_with_the_nearest(small_case, tmp_path):
    stage = suffuse.Case(small_case).run(tmp_path / "run", until="settled")["replay/settled"]
    with pytest.raises(KeyError, match="did you mean void_ratio"):
        stage["void_ration"]
    with pytest.raises(AttributeError, match="did you mean coordination"):
        stage.cordination


def test_what_a_run_has_not_is_reported_with_what_it_has(small_case, tmp_path):
    run = suffuse.Case(small_case).run(tmp_path / "run", until="settled")
    with pytest.raises(KeyError, match="has not come to it: run.resume.*finished: replay/start, replay/settled"):
        run["replay/seep"]
    with pytest.raises(KeyError, match="nor one of its case"):
        run["replay/seap"]
    stage = run["replay/settled"]
    with pytest.raises(suffuse.IoError, match="throats.csv: this run did not write it; there are .*history.csv"):
        stage.table("throats.csv")
    (stage.folder / "state.h5").unlink()
    with pytest.raises(suffuse.IoError, match="state.h5 is missing since its stage ended; remove .*settled and resume"):
        stage.world


def test_two_runs_are_compared_up_to_a_share(small_case, tmp_path):
    run = suffuse.Case(small_case).run(tmp_path / "run")
    for tolerance in (0, 0.01, "1 %"):
        assert run.compare(run, tolerance=tolerance)["differences"] == []
    for tolerance in (-1, 1, float("nan"), "100 %", "1 mm", None):
        with pytest.raises(ValueError, match="tolerance"):
            run.compare(run, tolerance=tolerance)


def test_what_is_damaged_is_not_read(small_case, tmp_path):
    run = suffuse.Case(small_case).run(tmp_path / "run")

    def damage(file):
        text = file.read_bytes()
        place = max(text.rfind(digit) for digit in (b"1", b"2", b"3"))
        file.write_bytes(text[:place] + b"9" + text[place + 1:])

    stage = run["replay/settled"]
    for file, read in (("stage.json", lambda: stage.void_ratio), ("history.csv", lambda: stage.history),
                       ("state.h5", lambda: stage.world)):
        damage(stage.folder / file)
        with pytest.raises(suffuse.IoError, match=f"{file} was changed since its stage ended; remove .*settled and"):
            read()
    with pytest.raises(suffuse.IoError, match="and resume"):
        run.resume()
    with pytest.raises(suffuse.IoError, match="and resume"):
        run.rebuild_report()
    damage(run.folder / "summary.json")
    with pytest.raises(suffuse.IoError, match="summary.json was changed since the run ended; suffuse report"):
        run.findings
    name = run.figures[0]
    damage(run.folder / "figures" / f"{name}.csv")
    with pytest.raises(suffuse.IoError, match="since the run ended"):
        run.figure(name).data


def test_a_folder_that_is_taken_is_refused(small_case, tmp_path):
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine" / "letter.txt").write_text("dear")
    with pytest.raises(suffuse.UsageError, match="holds no run"):
        suffuse.Case(small_case).run(tmp_path / "mine")
    with pytest.raises(suffuse.IoError, match="holds no run"):
        suffuse.Run(tmp_path / "mine")


def test_a_triaxial_test_leaves_its_curve(small_case, tmp_path):
    text = small_case.read_text()
    head = text[: text.index('[[study.replay.stage]]\nname        = "compressed"')]
    small_case.write_text(head + '[[study.replay.stage]]\nname = "shear"\ndo = "triaxial"\nstrain = "0.5 %"\n'
                                 'inertial_number = 5e-3\n')
    run = suffuse.Case(small_case).run(tmp_path / "run")
    curve = run["replay/shear"].curve
    assert curve["axial_strain"][-1] >= 0.005 and curve["deviator_stress"].max() > 10e3
    world = run["replay/settled"].world
    world.reference_cell = world.cell
    again = world.triaxial("0.5 %", inertial_number=5e-3)
    assert [row["deviator_stress"] for row in again["curve"]] == curve["deviator_stress"].tolist()


def test_a_path_is_a_text_of_a_case(small_case):
    packing = small_case.parent / "packing.csv"
    assert suffuse.Case(small_case, changes={"study.replay.stage.start.packing": packing}).stages[0] == "replay/start"


@pytest.mark.parametrize("limit", [-1, 0, math.nan, math.inf, 1e300, "-5 s", "0 h", "1e300 h", -math.inf])
def test_a_time_limit_that_is_no_time_is_refused(limit, small_case, tmp_path):
    case = suffuse.Case(small_case)
    with pytest.raises(suffuse.CaseError, match="time_limit"):
        case.run(tmp_path / "run", time_limit=limit)
    assert not (tmp_path / "run").exists()
    run = case.run(tmp_path / "begun", until="start")
    before = sorted(tmp_path.glob("begun/**/*"))
    with pytest.raises(suffuse.CaseError, match="time_limit"):
        run.resume(time_limit=limit)
    assert sorted(tmp_path.glob("begun/**/*")) == before


def test_a_time_limit_that_is_none_leaves_no_folder(small_case, tmp_path):
    with pytest.raises(suffuse.UnitError, match="time_limit"):
        suffuse.Case(small_case).run(tmp_path / "run", time_limit="2 kPa")
    assert not (tmp_path / "run").exists()
