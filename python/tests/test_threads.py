"""Threads of Python side by side: nobody reads what is half done, and nobody waits for a whole run to look."""

import _thread
import subprocess
import sys
import threading
import time

import numpy
import pytest

import suffuse
from conftest import PACKING


class Enough(Exception):
    """Ends a step from its on_progress."""


def step_in_a_thread(world, listener):
    def step():
        with pytest.raises(Enough):
            world.step(10**9, time_step=4e-8, on_progress=listener)

    thread = threading.Thread(target=step)
    thread.start()
    return thread


def message_of(world):
    return world.mean_stress, world.balance["kinetic_energy"], world.hash, world.grains.coordination.sum()


@pytest.fixture
def two_threads():
    before = suffuse.threads()
    suffuse.set_threads(2)
    yield
    suffuse.set_threads(before)


@pytest.fixture
def clones(settled_once):
    """A world of more grains than a parallel loop takes as one block: eight times 500."""
    shifts = numpy.array([[i, j, k] for i in range(2) for j in range(2) for k in range(2)]) @ settled_once.cell.T
    position = (settled_once.grains.position[None] + shifts[:, None]).reshape(-1, 3)
    world = suffuse.World(2 * settled_once.cell, position, numpy.tile(settled_once.grains.radius, 8))
    world.step(1, time_step=1e-12)
    return world


def test_fewer_than_no_threads_are_refused_and_so_are_more_than_any_machine_has():
    with pytest.raises(suffuse.CaseError, match="threads: found -1"):
        suffuse.set_threads(-1)
    before = suffuse.threads()
    with pytest.raises(suffuse.CaseError, match="expected 1 to 1024"):
        suffuse.set_threads(10**9)
    assert suffuse.threads() == before


def test_a_world_is_read_while_another_one_steps(clones, two_threads):
    stepped, straight = clones.copy(), clones.copy()
    truth, begun, enough, bursts = message_of(clones), threading.Event(), threading.Event(), []

    def step():
        while not enough.is_set():
            begun.set()
            stepped.step(100, time_step=4e-8)
            bursts.append(100)

    thread = threading.Thread(target=step)
    thread.start()
    begun.wait()
    try:
        for _ in range(20):
            assert message_of(clones) == truth
    finally:
        enough.set()
        thread.join()
    straight.step(sum(bursts), time_step=4e-8)
    assert stepped.hash == straight.hash


def test_progress_of_a_run_may_look_at_a_world(clones, small_case, tmp_path, two_threads):
    truth, looks = message_of(clones), []

    def look(progress):
        looks.append(message_of(clones) == truth)
        clones.save(tmp_path / "state.h5")  # does not wait for the run
        suffuse.set_threads(2)

    suffuse.Case(small_case).run(tmp_path / "run", on_progress=look)
    assert looks and all(looks)


def test_a_world_that_is_stepped_is_refused_to_other_threads(settled, tmp_path):
    stepping, looked, enough = threading.Event(), [], threading.Event()

    def listener(part, steps):
        looked.append(settled.mean_stress)  # by who steps it, between two bursts
        for change in (lambda: settled.remove([0]), settled.sort, lambda: settled.step(1), settled.settle):
            with pytest.raises(suffuse.StateError, match="in use by another call"):
                change()
        stepping.set()
        if enough.is_set():
            raise Enough

    thread = step_in_a_thread(settled, listener)
    stepping.wait()
    refused, rounds, limit = 0, 0, time.monotonic() + 120
    calls = (
        lambda: settled.hash, lambda: settled.copy(), lambda: settled.contacts, lambda: settled.grains.position,
        lambda: settled.remove([0]), lambda: settled.step(1), lambda: settled.save(tmp_path / "state.h5"),
    )
    while rounds < 20 or (refused == 0 and time.monotonic() < limit):
        rounds += 1
        for call in calls:
            try:
                call()
            except suffuse.StateError as error:
                refused += "in use by another call" in str(error)
            repr(settled)  # never refused
    enough.set()
    thread.join()
    assert refused > 0 and looked and len(settled) == 500
    settled.remove([0])
    settled.step(1)


def test_progress_of_a_run_may_step_another_world(clones, small_case, tmp_path, two_threads):
    straight, stepped, folder, before_the_end = clones.copy(), clones.copy(), tmp_path / "run", []

    def step(progress):
        stepped.step(10, time_step=4e-8)
        before_the_end.append(not (folder / "report.html").exists())

    suffuse.Case(small_case).run(folder, on_progress=step)
    straight.step(10 * len(before_the_end), time_step=4e-8)
    assert before_the_end[0] and stepped.hash == straight.hash
    alone = suffuse.Case(small_case).run(tmp_path / "alone")
    for stage in alone:
        assert alone[stage]["state_hash"] == suffuse.Run(folder)[stage]["state_hash"]


def test_progress_of_a_step_may_make_a_run(settled, small_case, tmp_path):
    def run(part, steps):
        outcomes.append(suffuse.Case(small_case).run(tmp_path / "run").outcome)
        raise Enough

    outcomes = []
    with pytest.raises(Enough):
        settled.step(10**9, time_step=4e-8, on_progress=run)
    assert outcomes == ["done"]


def join(target):
    """Calls it in a thread, and waits for that."""
    thread = threading.Thread(target=target, daemon=True)
    thread.start()
    thread.join(60)
    assert not thread.is_alive(), "the thread waits for who waits for it"


def test_a_function_of_progress_may_wait_for_a_thread_that_steps_another_world(settled, packing):
    def listener(part, steps):
        join(lambda: packing.step(5, time_step=1e-9))
        raise Enough

    straight = packing.copy()
    straight.step(5, time_step=1e-9)
    with pytest.raises(Enough):
        settled.step(10**9, time_step=4e-8, on_progress=listener)
    assert packing.hash == straight.hash
    settled.step(1, time_step=4e-8)  # the turn is free again


def test_a_rule_may_wait_for_a_thread_that_steps_another_world(soil, eroding_case, tmp_path):
    other, seen = soil.copy(), []

    def rule(probe):
        join(lambda: seen.append(other.step(5, time_step=4e-8)))
        return probe.by_velocity

    soil.erode(0.5, rule=rule, ramp=100, watch=100, size="none")
    suffuse.Case(eroding_case).run(tmp_path / "run", rules={"eroded": rule}, on_progress=lambda _: join(lambda: other.step(1)))
    assert len(seen) == 3


WAITING = """
import _thread, os, sys, threading, suffuse
forever, waiting = (suffuse.read_packing(sys.argv[1], cell=3 * (1.436e-3,)) for _ in range(2))
threading.Thread(target=lambda: forever.step(10**9, time_step=1e-12), daemon=True).start()
while True:  # until that steps
    try:
        threading.Timer(0.3, _thread.interrupt_main).start()
        waiting.step(1, time_step=1e-12)
        threading.Event().wait(1)
    except KeyboardInterrupt:
        try:
            forever.void_ratio
        except suffuse.StateError:
            os.write(1, b"interrupted")
            os._exit(0)
"""


def test_waiting_for_another_threads_steps_answers_to_ctrl_c():
    done = subprocess.run([sys.executable, "-c", WAITING, PACKING], capture_output=True, text=True, timeout=120)
    assert done.stdout == "interrupted", done.stderr


def test_a_cloud_of_many_grains_answers_to_ctrl_c():
    with pytest.raises(KeyboardInterrupt):  # a cloud so dense is sought for minutes, or until somebody has had enough
        threading.Timer(0.3, _thread.interrupt_main).start()
        suffuse.make_cloud(numpy.full(400_000, 1e-4), porosity=0.6)


def test_arrays_that_are_written_while_another_thread_steps_harm_nothing_but_the_numbers(settled):
    over, position, velocity = threading.Event(), settled.grains.position, settled.grains.velocity
    place, pace = position.copy(), velocity.copy()

    def write():
        random = numpy.random.default_rng(1)
        while not over.is_set():
            g = random.integers(500)
            position[g], velocity[g] = random.uniform(0, 1.4e-3, 3), random.normal(size=3)

    thread = threading.Thread(target=write)
    thread.start()
    try:
        for _ in range(20):
            settled.step(100, time_step=4e-8)
    except suffuse.Error:
        pass  # what was written may be no packing at all
    over.set()
    thread.join()
    position[:], velocity[:] = place, pace
    settled.grains.spin = 0
    settled.step(100, time_step=4e-8)
    assert len(settled) == 500 and numpy.isfinite(position).all()
