"""Each example runs and says what it should."""

import os
import pathlib
import re
import subprocess
import sys

import pytest

FOLDER = pathlib.Path(os.environ["SUFFUSE_SOURCE_DIR"]) / "examples" / "python"


def run(name, folder, *words):
    done = subprocess.run(
        [sys.executable, FOLDER / name, *words], capture_output=True, text=True, cwd=folder, check=False, timeout=300
    )
    assert done.returncode == 0, done.stderr
    return done.stdout


def test_flow_on_a_yade_packing(tmp_path):
    text = run("flow_on_a_yade_packing.py", tmp_path)
    total, push = re.search(r"sum of forces (\S+) N, pressure gradient x volume (\S+) N", text).groups()
    assert float(total) == pytest.approx(float(push), rel=1e-5)
    assert "500 grains" in text and "can travel along x" in text


def test_triaxial_by_hand(tmp_path):
    text = run("triaxial_by_hand.py", tmp_path)
    difference, peak = re.search(r"largest difference (\S+) Pa, of (\S+) kPa", text).groups()
    # The same steps of the same world; the curve of the program is sampled more coarsely.
    assert float(difference) < 1e-6 * 1e3 * float(peak), text


def test_read_a_run(tmp_path):
    assert "replay/compressed" in run("read_a_run.py", tmp_path)
    drawn = list(tmp_path.glob("read_a_run.*"))
    assert len(drawn) == 1 and drawn[0].stat().st_size > 1000


def test_erosion_by_hand(tmp_path):
    text = run("erosion_by_hand.py", tmp_path)
    first = re.search(r"pass 1: (\d+) of (\d+) fines detached, (\d+) removed", text)
    detached, fines, removed = map(int, first.groups())
    assert 0 < removed <= detached < fines


def test_twenty_lines(tmp_path):
    text = run("twenty_lines.py", tmp_path, "1000")
    strong, share = re.search(r"(\d+) strong contacts carry (\S+) of the force", text).groups()
    assert int(strong) > 100 and 0.5 < float(share) < 1
    permeability, constriction = map(float, re.search(r"^(\S+e-1\d) (\S+)$", text, re.M).groups())
    assert 1e-12 < permeability < 1e-9 and 1e-5 < constriction < 1e-3
    assert re.search(r"^1 \d+\.\d+ \{'", text, re.M) and "whole" in text


def test_every_example_is_tested_and_listed():
    names = {path.name for path in FOLDER.glob("*.py")}
    page = (FOLDER / "README.md").read_text()
    here = pathlib.Path(__file__).read_text()
    assert names and all(name in page and name in here for name in names)
