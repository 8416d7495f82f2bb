#!/usr/bin/python3
"""Cuts the power of a small run, in hundreds of ways, and looks whether `suffuse resume` still reaches the same bits.

    tests/crash/power_loss.py --program build/release/apps/suffuse [--states 100] [--seed 1] [--lying]

Three runs are recorded call by call (record_writes.c): one to its end, one that SIGTERM stopped in the middle of a stage and
`resume` took up, and one that ended with an early stage, went on and had its report written anew.
Each state is what a disk may hold after a cut at some moment of one of them (unpowered_disk.py). What must hold:

    signed   what `verify` calls whole before anything is done has the results of the undisturbed run
    ended    a cut after the program has said that it is done loses nothing
    resumed  `resume` (or `run`, where the cut took the run) ends well, with the same bits, and leaves nothing half-written
    cached   another run with the cache that is left ends with the same bits

With --lying, a disk forgets what it said it had synced, the case of the run too; the program may then refuse the folder by its
name, and must not pass on what is damaged.
Prints a line a fault and a table of counts; ends with 1 where there was one.
"""

import argparse
import collections
import os
import pathlib
import random
import shutil
import subprocess
import sys
import tempfile

from unpowered_disk import WAYS, disk_after, lay_out, read_calls
from run_results import last_line, results_of
from stopped_run import stop_in_stage

HERE = pathlib.Path(__file__).resolve().parent
CASE = HERE / "case.toml"
DONE, NO_RUN, ANOTHER_CASE, CANNOT_READ, STOPPED = 0, 2, 3, 74, 143


class PowerLoss:
    def __init__(self, given, folder):
        self.program, self.folder, self.lying = given.program.resolve(), folder, given.lying
        self.random = random.Random(given.seed)
        self.shim = folder / "record_writes.so"
        subprocess.run(["cc", "-shared", "-fPIC", "-O1", "-o", self.shim, HERE / "record_writes.c", "-ldl"], check=True)
        self.recordings = [
            self.record("straight", []),
            self.record("stopped", [], ["resume"], stop_in="small/particles=200/initial"),
            self.record("extended", ["--until", "initial"], ["resume", "report"]),
        ]

    def call(self, *words, log=None):
        environment = {"RECORD_TO": str(log), "LD_PRELOAD": str(self.shim)} if log else {}
        return subprocess.run(
            [self.program, *map(str, words), "-q"], env={**os.environ, **environment}, timeout=300,
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace",
        )

    def record(self, name, limit, more=(), stop_in=None):
        """The calls of a run in a folder of this name, and of what else the program then does there."""
        root, log = self.folder / name, self.folder / f"{name}.log"
        root.mkdir()
        there = root.stat()
        words = ["run", CASE, "-o", root / "run", "-j", 1, *limit]
        if stop_in:
            code = stop_in_stage(stop_in, [self.program, *words], {"RECORD_TO": str(log), "LD_PRELOAD": str(self.shim)})
            if code != STOPPED:
                sys.exit(f"the run that was to be stopped ended with {code}")
        else:
            ended = self.call(*words, log=log)
        for verb in more:
            ended = self.call(verb, root / "run", log=log)
            if ended.returncode != DONE:
                break
        if ended.returncode != DONE:
            sys.exit(f"the undisturbed run ended with {ended.returncode}: {ended.stdout}")
        found = results_of(root / "run")
        self.truth = getattr(self, "truth", found)
        if found != self.truth:
            sys.exit("the undisturbed runs differ")
        return read_calls(log.read_bytes(), f"{there.st_dev}:{there.st_ino}", self.lying)

    def states(self, count):
        """(recording, moment, way): the ends in every way, then as chance has it."""
        ends = [(calls, len(calls) - 1, way) for calls in self.recordings for way in WAYS]
        for number in range(count):
            if number < min(len(ends), count // 5):
                yield ends[number]
            else:
                calls = self.random.choice(self.recordings)
                yield calls, self.random.randrange(len(calls)), self.random.choice(WAYS)

    def judge(self, root, is_end, tries_cache):
        """What is wrong with the folder of a state; empty: nothing."""
        run = root / "run"
        is_signed = self.call("verify", run).returncode == DONE
        if is_signed and not results_of(run).items() <= self.truth.items():
            return "signed: verify calls it whole, and its results are others"
        if is_end and not self.lying and not is_signed:
            return f"ended: {last_line(self.call('verify', run))}"
        is_begun = (run / "run_options.json").exists()
        ended = self.call(*(["resume", run] if is_begun else ["run", CASE, "-o", run]), "-j", 2)
        if self.lying and ended.returncode in (NO_RUN, ANOTHER_CASE, CANNOT_READ) and str(run) in ended.stdout:
            return "signed: verify calls it whole" if self.call("verify", run).returncode == DONE else ""
        if ended.returncode != DONE:
            return f"resumed: ends with {ended.returncode}: {last_line(ended)}"
        wrong = self.differs(run)
        if wrong or not tries_cache:
            return wrong and f"resumed: {wrong}"
        ended = self.call("run", CASE, "-o", root / "again", "-j", 2)
        wrong = self.differs(root / "again") if ended.returncode == DONE else f"ends with {ended.returncode}: {last_line(ended)}"
        return wrong and f"cached: {wrong}"

    def differs(self, run):
        if results_of(run) != self.truth:
            return "other results"
        verified = self.call("verify", run)
        if verified.returncode != DONE:
            return f"verify: {last_line(verified)}"
        left = [path.name for path in run.rglob("*.partial*")] + [path.name for path in run.rglob("partial.h5")]
        return f"left behind: {', '.join(left)}" if left else ""


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", type=pathlib.Path, default=pathlib.Path("build/release/apps/suffuse"))
    parser.add_argument("--states", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--lying", action="store_true", help="a disk that forgets what it has synced")
    parser.add_argument("--keep", type=pathlib.Path, help="a folder to copy states into that show a fault")
    given = parser.parse_args()
    counts, faults = collections.Counter(), collections.Counter()
    memory = pathlib.Path("/dev/shm")  # where there is one: files are synced, and disks are slow
    with tempfile.TemporaryDirectory(prefix="suffuse-power-", dir=memory if memory.is_dir() else None) as folder:
        os.environ["TMPDIR"] = folder  # what is killed leaves its temporary files there
        loss = PowerLoss(given, pathlib.Path(folder))
        for number, (calls, moment, way) in enumerate(loss.states(given.states)):
            root = loss.folder / f"state-{number}"
            disk = disk_after(calls, moment, way, loss.random)
            lay_out(disk, root)
            wrong = loss.judge(root, moment == len(calls) - 1, tries_cache=number % 3 == 0)
            counts[way] += 1
            if wrong:
                faults[way] += 1
                print(f"state {number} (seed {given.seed}, call {moment} of {len(calls)}, {way}): {wrong}", flush=True)
                if given.keep:
                    lay_out(disk, given.keep / root.name)
            shutil.rmtree(root)
    for way, count in counts.items():
        print(f"{way:9} {count:5} states, {faults[way]} faults")
    sys.exit(1 if faults else 0)


main()
