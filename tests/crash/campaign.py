#!/usr/bin/python3
"""Kills and fails a small run in a hundred ways, and looks whether a result is ever silently wrong; tests/damage/campaign.py
damages what runs left.

    tests/crash/campaign.py --program build/release/apps/suffuse [--trials 100] [--seed 1] [--only kill]

    kill     killed at the N-th call that changes a file: before it, after it, or in the middle of a write; resumed, and
             perhaps killed again
    signal   SIGINT, SIGTERM, SIGHUP or SIGKILL at a random time of the run; resumed with another number of threads
    error    the N-th call fails: no space, an I/O error, interrupted

What must hold: a run that ends well has the bits of the undisturbed one, and `verify` finds it whole; one that does not says
why. Prints a line a fault and a table of counts; ends with 1 where there was one.
"""

import argparse
import collections
import os
import pathlib
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time

from run_results import last_line, results_of

HERE = pathlib.Path(__file__).resolve().parent
CASE = HERE / "case.toml"
DONE, SAVED, CANNOT_WRITE = 0, (75, 129, 130, 143), 74


class Campaign:
    def __init__(self, given, folder):
        self.program, self.folder, self.random = given.program.resolve(), folder, random.Random(given.seed)
        self.shim = folder / "fault_at.so"
        subprocess.run(["cc", "-shared", "-fPIC", "-O1", "-o", self.shim, HERE / "fault_at.c", "-ldl"], check=True)
        count = folder / "count"
        whole = folder / "whole"
        begin = time.monotonic()
        code = self.run(["run", CASE, "-o", whole, "--no-cache"], FAULT_COUNT=count).returncode
        self.duration = time.monotonic() - begin
        if code != DONE:
            sys.exit(f"the undisturbed run ended with {code}")
        self.calls = int(count.read_text())
        self.truth = results_of(whole)

    def run(self, words, threads=1, timeout=300, **environment):
        """The program; with the shim where something of FAULT_* is given."""
        environment = {name: str(value) for name, value in environment.items()}
        if environment:
            environment["LD_PRELOAD"] = str(self.shim)
        return subprocess.run(
            [self.program, *map(str, words), "-q", "-j", str(threads)], env={**os.environ, **environment}, timeout=timeout,
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace",
        )

    def judge(self, run):
        """What is wrong with a run that ended well; empty: nothing."""
        found = results_of(run)
        wrong = [name for name in self.truth if found.get(name) != self.truth[name]]
        if wrong:
            return f"other results: {', '.join(wrong[:3])}"
        if subprocess.run([self.program, "verify", run, "-q"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL).returncode != DONE:
            return "verify finds it changed"
        left = [path.name for path in run.rglob("*.partial*")] + [path.name for path in run.rglob("partial.h5")]
        return f"left behind: {', '.join(left)}" if left else ""

    def resume(self, run, threads=1):
        """Resumes until the run has ended. @return what is wrong, or empty"""
        if not (run / "run_options.json").exists():  # killed before there was a run
            ended = self.run(["run", CASE, "-o", run, "--no-cache"], threads)
        else:
            ended = self.run(["resume", run], threads)
        return self.judge(run) if ended.returncode == DONE else f"resume ends with {ended.returncode}: {last_line(ended)}"

    def kill(self, run):
        way = self.random.choice(["before", "after", "half"])
        self.run(["run", CASE, "-o", run, "--no-cache"], FAULT_AT=self.random.randint(1, self.calls), FAULT_DO=way)
        for _ in range(self.random.randint(0, 2)):
            if (run / "run_options.json").exists():
                self.run(["resume", run], FAULT_AT=self.random.randint(1, self.calls // 2), FAULT_DO=way)
        return self.resume(run)

    def signal(self, run):
        sent = self.random.choice([signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGKILL])
        process = subprocess.Popen(
            [self.program, "run", CASE, "-o", run, "--no-cache", "-q", "-j", "1"],
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
        )
        try:
            process.wait(timeout=self.random.uniform(0, 1.2 * self.duration))
        except subprocess.TimeoutExpired:
            process.send_signal(sent)
            process.wait()
        # A signal before the program listens to any ends it as a program without work.
        if process.returncode not in (DONE, -sent, *SAVED):
            return f"{sent.name} ends it with {process.returncode}"
        return self.resume(run, threads=self.random.choice([1, 2, 3]))

    def error(self, run):
        what = self.random.choice(["EIO", "ENOSPC", "EINTR"])
        ended = self.run(["run", CASE, "-o", run, "--no-cache"], FAULT_AT=self.random.randint(1, self.calls), FAULT_DO=what)
        if ended.returncode == DONE:
            return self.judge(run)
        if ended.returncode != CANNOT_WRITE:
            return f"{what} ends it with {ended.returncode}: {last_line(ended)}"
        if str(run) not in ended.stdout and run.name not in ended.stdout:
            return f"{what}: the message names no file: {last_line(ended)}"
        return self.resume(run)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", type=pathlib.Path, default=pathlib.Path("build/release/apps/suffuse"))
    parser.add_argument("--trials", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", choices=["kill", "signal", "error"])
    given = parser.parse_args()
    counts, faults = collections.Counter(), collections.Counter()
    memory = pathlib.Path("/dev/shm")  # where there is one: files are synced, and disks are slow
    with tempfile.TemporaryDirectory(prefix="suffuse-crash-", dir=memory if memory.is_dir() else None) as folder:
        os.environ["TMPDIR"] = folder  # what is killed leaves its temporary files there
        campaign = Campaign(given, pathlib.Path(folder))
        for trial in range(given.trials):
            kind = given.only or ["kill", "signal", "error"][trial % 3]
            run = campaign.folder / f"run-{trial}"
            wrong = getattr(campaign, kind)(run)
            counts[kind] += 1
            if wrong:
                faults[kind] += 1
                print(f"trial {trial} ({kind}, seed {given.seed}): {wrong}", flush=True)
            shutil.rmtree(run, ignore_errors=True)
    for kind, count in counts.items():
        print(f"{kind:8} {count:5} trials, {faults[kind]} faults")
    sys.exit(1 if faults else 0)


main()
