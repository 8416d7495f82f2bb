"""The interpreter ends, or Ctrl-C comes, while threads compute: no abort, and what can be saved is."""

import functools
import re
import signal
import subprocess
import sys

import numpy
import pytest

import suffuse
from conftest import CELL, PACKING

HEAD = f"""
import os, sys, threading, time
import numpy, suffuse
suffuse.set_threads(2)
packing, cell = {str(PACKING)!r}, {CELL!r}
world = suffuse.read_packing(packing, cell=cell)
many = numpy.random.default_rng(1).uniform(0, 1, (20000, 3)), numpy.full(20000, 1e-3)
begun = threading.Event()

def again(work):
    def go_on():
        while True:
            begun.set()
            work()
    return go_on

def on_progress(*what):
    begun.set()
"""
TAIL = """
thread = threading.Thread(target=work, daemon=True)
thread.start()
begun.wait()
time.sleep(float(sys.argv[1]))
"""
VERBS = {
    "step": "work = lambda: world.step(10**9, time_step=1e-12, on_progress=on_progress)",
    "step without a word": "work = again(lambda: world.step(10**9, time_step=1e-12))",
    "short steps": "work = again(lambda: world.step(1, time_step=1e-12))",
    "settle": "work = lambda: world.settle(suffuse.Loading(stress='100 kPa'), max_steps=10**9, balance="
    "suffuse.Balance(unbalanced_force=1e-300), on_progress=on_progress)",
    "relax": "world.settle(suffuse.Loading(stress='100 kPa'))\nwork = again(lambda: world.copy().relax(1e-300))",
    "compact": "work = lambda: world.compact('100 kPa', balance=suffuse.Balance(unbalanced_force=1e-300), on_progress=on_progress)",
    "triaxial": "world.settle(suffuse.Loading(stress='100 kPa'))\nwork = lambda: world.triaxial(0.3, inertial_number=1e-9, "
    "on_progress=on_progress)",
    "erode": "world.settle(suffuse.Loading(stress='100 kPa'))\nworld.grains.fine = world.grains.radius < 1e-4\n"
    "work = lambda: world.erode(0.5, ramp=10**8, on_progress=on_progress)",
    "a rule": "world.settle(suffuse.Loading(stress='100 kPa'))\nworld.grains.fine = world.grains.radius < 1e-4\n"
    "def rule(probe):\n    begun.set()\n    time.sleep(2)\n    return probe.by_velocity\n"
    "work = lambda: world.erode(0.5, rule=rule, ramp=10, watch=10)",
    "make_cloud": "work = again(lambda: suffuse.make_cloud(numpy.full(400_000, 1e-4), porosity=0.6))",
    "seep": "work = again(lambda: suffuse.seep((1, 1, 1), *many, gradient=0.1))",
    "resolve_flow": "work = again(lambda: suffuse.resolve_flow(world, gradient=0.1))",
    "constrictions": "work = again(lambda: suffuse.constrictions((1, 1, 1), *many))",
    "read_packing": "work = again(lambda: suffuse.read_packing(packing, cell=cell))",
    "pickle": "import pickle\nwork = again(lambda: pickle.dumps(world))",
    "threads that wait for their turn": "for _ in range(3): threading.Thread(target=again(lambda: world.copy().step(100, "
    "time_step=1e-12)), daemon=True).start()\nwork = again(lambda: world.copy().step(100, time_step=1e-12))",
    "a function of progress that never returns": "def hang(*_):\n    begun.set()\n    threading.Event().wait()\n"
    "work = lambda: world.step(10**9, time_step=1e-12, on_progress=hang)",
    "a function of progress that computes": "def count(*_):\n    begun.set()\n    while True: sum(range(1000))\n"
    "work = lambda: world.step(10**9, time_step=1e-12, on_progress=count)",
}  # fmt: skip


def end_meanwhile(lines, seconds):
    script = HEAD + lines + TAIL
    return subprocess.run([sys.executable, "-W", "ignore", "-c", script, str(seconds)], capture_output=True, text=True, timeout=300)


@pytest.mark.parametrize("verb", VERBS)
@pytest.mark.parametrize("seconds", [0, 0.15])
def test_the_interpreter_ends_while_a_thread_computes(verb, seconds):
    done = end_meanwhile(VERBS[verb], seconds)
    assert (done.returncode, done.stderr) == (0, "")


def test_a_run_of_a_daemon_thread_is_saved_when_the_interpreter_ends(small_case, tmp_path):
    text = re.sub("steps( *)= 200", r"steps\1= 1_000_000_000", small_case.read_text())
    small_case.write_text(text)
    listing = "def tell(progress):\n    if progress['verb'] == 'advance': begun.set()\n"
    run = f"work = lambda: suffuse.Case({str(small_case)!r}).run({str(tmp_path / 'run')!r}, on_progress=tell)"
    done = end_meanwhile(listing + run, 0)
    assert (done.returncode, done.stderr) == (0, "")
    assert "1_000_000_000" in text and list((tmp_path / "run").glob("**/partial.h5")), "a resume goes on from there"


def test_work_of_the_thread_that_ends_the_interpreter_goes_on():
    lines = "import atexit\n" + HEAD  # registered before suffuse is imported: called after what it registers
    lines = lines.replace("import atexit\n", "import atexit\natexit.register(lambda: print(world.step(5, time_step=1e-12).shape))\n")
    done = subprocess.run([sys.executable, "-W", "ignore", "-c", lines], capture_output=True, text=True, timeout=300)
    assert (done.returncode, done.stdout, done.stderr) == (0, "(3, 3)\n", "")


def test_a_process_that_was_forked_waits_for_no_thread_of_its_parent():
    lines = VERBS["step"] + TAIL + "child = os.fork()\nif child: assert os.waitpid(child, 0)[1] == 0\n"
    done = subprocess.run([sys.executable, "-W", "ignore", "-c", HEAD + lines, "0"], capture_output=True, text=True, timeout=300)
    assert (done.returncode, done.stderr) == (0, "")


class Enough(Exception):
    """Raised by the handler of a signal."""


def interrupt(make, sizes):
    """Does the work make(size) until a signal's third call of its handler has ended it. Where signals wait for the end of
    the work, they are seen once, however many came: only work that looks while it computes sees three. The size grows where
    the work was too short."""
    for size in sizes:
        work, seen = make(size), []

        def look(*_, seen=seen):
            seen.append(size)
            if len(seen) == 3:
                raise Enough

        before = signal.signal(signal.SIGALRM, look)
        signal.setitimer(signal.ITIMER_REAL, 0.06, 0.06)
        try:
            work()
        except Enough:
            return True
        finally:
            signal.setitimer(signal.ITIMER_REAL, 0)
            signal.signal(signal.SIGALRM, before)
    return False


def grains(count):
    radius = 0.25 * count ** (-1 / 3)
    return (1, 1, 1), numpy.random.default_rng(1).uniform(0, 1, (count, 3)), numpy.full(count, radius)


SIZES = [20_000, 60_000, 180_000, 540_000]


@pytest.mark.parametrize("threads", [1, 2])
@pytest.mark.parametrize("work", [
    suffuse.constrictions,
    suffuse.PoreNetwork,
    lambda *packing: suffuse.seep(*packing, gradient=0.1),
    lambda *packing: suffuse.resolve_flow(*packing, gradient=0.1),
], ids=["constrictions", "PoreNetwork", "seep", "resolve_flow"])
def test_a_signal_ends_work_between_its_parts(work, threads):
    before = suffuse.threads()
    suffuse.set_threads(threads)
    try:
        assert interrupt(lambda count: functools.partial(work, *grains(count)), SIZES)
    finally:
        suffuse.set_threads(before)


@pytest.mark.parametrize("ending", [".csv", ".xyz", ".data", ".dump", ".vtp"])
def test_a_signal_ends_the_reading_of_a_large_packing(ending, tmp_path):
    def write(count):
        path = tmp_path / f"{count}{ending}"
        suffuse.write_packing(path, suffuse.World(*grains(count)))
        return lambda: suffuse.read_packing(path, cell=(1, 1, 1), max_overlap=2)

    assert interrupt(write, SIZES)
