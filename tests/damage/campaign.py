#!/usr/bin/env python3
"""Damages files of runs in ways that a fixed seed chooses, and looks at what the program makes of them.

    tests/damage/campaign.py PROGRAM [--tries N] [--seed N] [--only cache|stages|partial|foreign|links|pipes] [-v]

PROGRAM is suffuse. Three parts damage files: entries of the cache, finished stages before a resume, partial.h5 before a
resume. Each try damages one file of a copy: bits flipped, a digit changed, a part zeroed, cut off, emptied, removed, or
exchanged with another file. Three parts put in what somebody else made: stages, states and cases of runs of other
settings; links to files of the user, soft and hard; pipes. Every byte that a stage left, and every number, is then
compared with those of an undamaged run; files of the user, with what they were. A try ends as

    refused     an exit code that says so, with the file's name; what the message advises then gives the undamaged results
    made anew   the same results, and the program said that it found damage
    harmless    the same results
    SILENT      other results, or a damaged file that is signed or called whole: the program has failed
    CRASHED     a signal, or a defect of the program's own

The exit code is 1 where one is silent or crashed."""

import argparse
import collections
import hashlib
import json
import os
import pathlib
import random
import re
import shlex
import shutil
import struct
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "crash"))
from stopped_run import stop_in_stage

CASE = """schema = 1
title  = "damage"
[grain]
density = "2600 kg/m^3"
[contact]
modulus           = "356 MPa"
shear_ratio       = 0.42
friction          = "37 deg"
rolling_stiffness = 7.5
rolling_friction  = 0.22
[balance]
unbalanced_force = 1e-2
[fluid]
viscosity = "1 mPa*s"
[soil.mixture]
coarse            = { psd = { d = ["0.28 mm", "0.32 mm"], passing = ["0 %", "100 %"] } }
fines             = { psd = { d = ["0.14 mm", "0.16 mm"], passing = ["0 %", "100 %"] } }
fines_content     = "15 %"
grading_tolerance = "10 %"
[output]
formats = ["csv"]
[study.s]
soil      = "mixture"
particles = 300
[[study.s.stage]]
name     = "cloud"
do       = "pack"
porosity = 0.6
[[study.s.stage]]
name     = "initial"
do       = "compact"
pressure = "100 kPa"
protocol = "swift"
[[study.s.stage]]
name     = "erosion"
do       = "erode"
passes   = 1
gradient = 0.5
[[study.s.stage]]
name            = "sheared"
do              = "triaxial"
strain          = "1 %"
inertial_number = 1e-2
"""

# What no two runs share.
TIMES = {"wall_seconds", "particle_steps_per_second", "seconds", "from_cache", "checksums", "threads"}

IO_ERROR, DEFECT = 74, 70


def without_times(value):
    if isinstance(value, dict):
        return {key: without_times(part) for key, part in value.items() if key not in TIMES}
    return [without_times(part) for part in value] if isinstance(value, list) else value


def cbor(data, at=0):
    """What stands at a place of results.cbor, and the place behind it; Python has no reader of its own."""
    kind, size = data[at] >> 5, data[at] & 31
    at += 1
    if size >= 24:
        width = 1 << (size - 24)
        bits, at = data[at:at + width], at + width
        if kind == 7:
            return struct.unpack({2: ">e", 4: ">f", 8: ">d"}[width], bits)[0], at
        size = int.from_bytes(bits, "big")
    if kind == 7:
        return {20: False, 21: True, 22: None}[size], at
    if kind in (0, 1):
        return (size if kind == 0 else -1 - size), at
    if kind in (2, 3):
        return data[at:at + size].decode() if kind == 3 else data[at:at + size], at + size
    items = []
    for _ in range(size * (kind - 3)):  # 4: a list; 5: keys and values in turn
        item, at = cbor(data, at)
        items.append(item)
    return (items if kind == 4 else dict(zip(items[::2], items[1::2]))), at


class Campaign:
    def __init__(self, program, folder, seed, verbose):
        self.program, self.folder, self.verbose = program, folder, verbose
        self.chance = random.Random(seed)
        self.case = folder / "case.toml"
        self.case.write_text(CASE)
        self.whole = folder / "whole"
        self.cache = folder / "cache"
        self.must("run", self.case, "-o", self.whole, "--cache", self.cache)
        self.truth = self.results(self.whole)

    def call(self, *words, timeout=300):
        return subprocess.run([self.program, *map(str, words)], capture_output=True, text=True, errors="replace",
                              cwd=self.folder, timeout=timeout)

    def must(self, *words):
        output = self.call(*words)
        if output.returncode not in (0, 4):  # 4: a quality bar was missed, which a sample of 300 grains may
            sys.exit(f"{shlex.join(map(str, words))}: {output.returncode}\n{output.stdout}{output.stderr}")
        return output

    def results(self, run):
        """Every number of a run, and every byte that its stages left."""
        found = {}
        for stage in sorted((run / "studies").rglob("stage.json")):
            place = stage.parent.relative_to(run).as_posix()
            found[place] = without_times(json.loads(stage.read_text()))
            for file in stage.parent.iterdir():
                if file.name == "results.cbor":
                    found[f"{place}/{file.name}"] = repr(without_times(cbor(file.read_bytes())[0]))
                elif file.name not in ("stage.json", "SHA256SUMS", "partial.h5"):
                    found[f"{place}/{file.name}"] = hashlib.sha256(file.read_bytes()).hexdigest()
        summary = json.loads((run / "summary.json").read_text())
        found["summary"] = without_times(summary)
        for figure in sorted((run / "figures").glob("*.csv")):
            found[figure.name] = [line for line in figure.read_text().splitlines() if not line.startswith("#")]
        return found

    def damage(self, file, others):
        """Damages a file; returns how, or None where it is as before."""
        before = file.read_bytes()
        kind = self.chance.choice(["bit", "bit", "bits", "digit", "digit", "digit", "zeros", "cut", "empty", "more",
                                   "gone", "swap", "swap"])
        after = bytearray(before)
        if kind == "gone":
            file.unlink()
            return kind
        if kind == "swap":
            other = self.chance.choice(others)
            theirs = other.read_bytes()
            other.write_bytes(before)
            file.write_bytes(theirs)
            return f"swap with {other.parent.name}/{other.name}" if theirs != before else None
        digits = [match.start() for match in re.finditer(rb"[0-9]", before)]
        if kind == "digit" and digits:
            place = self.chance.choice(digits)
            after[place:place + 1] = self.chance.choice([d for d in b"0123456789" if d != before[place]]).to_bytes()
        elif kind == "cut":
            del after[self.chance.randrange(len(after)):]
        elif kind == "empty":
            after.clear()
        elif kind == "more":
            after += self.chance.randbytes(self.chance.randrange(1, 600))
        elif kind == "zeros":
            place = self.chance.randrange(len(after))
            after[place:place + 512] = bytes(min(512, len(after) - place))
        else:
            for _ in range(8 if kind == "bits" else 1):
                after[self.chance.randrange(len(after))] ^= 1 << self.chance.randrange(8)
        file.write_bytes(after)
        return kind if bytes(after) != before else None

    def judge(self, output, run, damaged, how):
        """What a call on a damaged run or cache came to."""
        if output.returncode < 0 or output.returncode == DEFECT:
            return "CRASHED"
        words = output.stdout + output.stderr
        if output.returncode not in (0, 4):
            names = [damaged.name, damaged.parent.name]
            if how and how.startswith("swap with "):
                names.append(how.removeprefix("swap with ").split("/")[0])  # either may be met first
            names_it = any(name in words for name in names)
            return "refused" if output.returncode == IO_ERROR and names_it else "CRASHED"
        if self.results(run) != self.truth or self.call("verify", run).returncode != 0:
            return "SILENT"
        return "made anew" if "damaged" in words else "harmless"

    def follow_advice(self, output, run):
        """Removes what the message says and goes on. @return whether the results are the undamaged ones"""
        for _ in range(4):  # damage may lie in two stages, reported one after the other
            advice = re.search(r"remove (.+?) and resume", output.stderr)
            if not advice:
                return False
            for place in map(pathlib.Path, shlex.split(advice.group(1))):
                shutil.rmtree(place) if place.is_dir() else place.unlink()
            output = self.call("resume", run)
            if output.returncode in (0, 4):
                return self.results(run) == self.truth and self.call("verify", run).returncode == 0
        return False

    def try_cache(self, number):
        cache, run = self.folder / "damaged-cache", self.folder / "run"
        shutil.copytree(self.cache, cache)
        files = sorted(file for file in cache.rglob("*") if file.is_file() and file.parent != cache)
        damaged, how = self.damage_one(files)
        output = self.call("run", self.case, "-o", run, "--cache", cache)
        verdict = self.judge(output, run, damaged, how)
        if verdict == "harmless" and how and not self.is_same(self.cache, cache, damaged):
            # What is still in the cache must not be taken the next time either.
            shutil.rmtree(run)
            verdict = self.judge(self.call("run", self.case, "-o", run, "--cache", cache), run, damaged, how)
        return verdict, damaged.relative_to(cache), how

    def is_same(self, before, after, file):
        place = file.relative_to(after)
        return file.exists() and (before / place).exists() and file.read_bytes() == (before / place).read_bytes()

    def try_stage(self, number):
        run = self.folder / "run"
        shutil.copytree(self.whole, run)
        files = sorted(file for file in (run / "studies").rglob("*") if file.is_file())
        damaged, how = self.damage_one(files)
        if how and self.call("verify", run).returncode == 0:
            return "SILENT", damaged.relative_to(run), how
        output = self.call("resume", run, "--no-cache")
        verdict = self.judge(output, run, damaged, how)
        if verdict == "refused":
            if self.call("report", run).returncode == 0 or self.call("verify", run).returncode == 0:
                verdict = "SILENT"
            elif not self.follow_advice(output, run):
                verdict = "SILENT"
        return verdict, damaged.relative_to(run), how

    def try_partial(self, number):
        run = self.folder / "run"
        shutil.copytree(self.stopped, run)
        damaged, how = self.damage_one([next(run.rglob("partial.h5"))], list((run / "studies").rglob("state.h5")))
        output = self.call("resume", run, "--no-cache")
        verdict = self.judge(output, run, damaged, how)
        if verdict == "refused" and not self.follow_advice(output, run):
            verdict = "SILENT"
        return verdict, damaged.relative_to(run), how

    # ---- what somebody else made

    def make_foreign_runs(self):
        """Runs of other settings, whole and stopped half-way; and one of the case itself."""
        self.stop_in_a_stage()
        own = self.stopped.rename(self.folder / "own-stopped")
        self.foreign = []
        for number, change in enumerate(["seed=77", 'contact.friction="20 deg"', "study.s.stage.erosion.gradient=0.2",
                                         "study.s.stage.sheared.inertial_number=2e-2"]):
            run = self.folder / f"foreign-{number}"
            self.must("run", self.case, "-o", run, "--cache", self.cache, "--set", change)
            self.stop_in_a_stage("--set", change)
            self.foreign.append((run, self.stopped.rename(self.folder / f"foreign-stopped-{number}")))
        self.stopped = own

    def try_foreign(self, number):
        run = self.folder / "run"
        theirs, their_half = self.chance.choice(self.foreign)
        kind = self.chance.choice(["stage", "stage", "stage", "state", "partial", "case", "options"])
        shutil.copytree(self.stopped if kind in ("partial", "case", "options") else self.whole, run)
        stage = self.chance.choice(sorted(place.parent for place in (theirs / "studies").rglob("stage.json")))
        place = run / stage.relative_to(theirs)
        if kind == "stage":
            shutil.rmtree(place)
            shutil.copytree(stage, place)
        elif kind == "state":
            shutil.copy(stage / "state.h5", place / "state.h5")
        elif kind == "partial":
            place, theirs = next(run.rglob("partial.h5")), next(their_half.rglob("partial.h5"))
            if place.parent.name != theirs.parent.name:
                return "harmless", place.relative_to(run), None
            shutil.copy(theirs, place)
        else:
            place = run / ("case.resolved.toml" if kind == "case" else "run_options.json")
            shutil.copy(theirs / place.name, place)
        if self.chance.random() < 0.5:
            (run / "SHA256SUMS").unlink(missing_ok=True)
        output = self.call("resume", run, "--no-cache")
        if output.returncode not in (0, 4):
            signs = self.call("report", run).returncode == 0 and self.call("verify", run).returncode == 0
            refused = output.returncode == IO_ERROR or (output.returncode == 2 and kind == "case")
            verdict = "SILENT" if signs and self.results(run) != self.truth else "refused" if refused else "CRASHED"
        else:
            verdict = "harmless" if self.results(run) == self.truth else "SILENT"
        return verdict, place.relative_to(run), f"{kind} of {theirs.name}"

    def try_link(self, number):
        run, home = self.folder / "run", self.folder / "home"
        shutil.rmtree(home, ignore_errors=True)
        (home / "folder").mkdir(parents=True)
        (home / "file").write_text("mine\n")
        shutil.copytree(self.chance.choice([self.whole, self.stopped]), run)
        place = self.chance.choice(sorted(place for place in run.rglob("*")))
        was_folder = place.is_dir()
        shutil.rmtree(place) if was_folder else place.unlink()
        is_hard = not was_folder and self.chance.random() < 0.4
        if is_hard:
            place.hardlink_to(home / "file")
        else:
            place.symlink_to(home / ("folder" if was_folder else "file"))
        verbs = [["resume", run, "--no-cache"], ["report", run], ["figures", run], ["resume", run, "--no-cache"]]
        calls = [self.call(*words) for words in verbs]
        how = ("hard" if is_hard else "soft") + " link"
        untouched = (home / "file").read_text() == "mine\n" and not any((home / "folder").iterdir())
        if not untouched:
            return "SILENT", place.relative_to(run), how
        if any(output.returncode < 0 or output.returncode == DEFECT for output in calls):
            return "CRASHED", place.relative_to(run), how
        return ("refused" if calls[0].returncode == IO_ERROR else "harmless"), place.relative_to(run), how

    def try_pipe(self, number):
        run = self.folder / "run"
        shutil.copytree(self.chance.choice([self.whole, self.stopped]), run)
        place = self.chance.choice(sorted(place for place in run.rglob("*") if place.is_file()))
        place.unlink()
        os.mkfifo(place)
        verb = self.chance.choice(["resume", "report", "verify", "figures", "watch"])
        try:
            output = self.call(verb, run, timeout=60)
        except subprocess.TimeoutExpired:
            return "CRASHED", place.relative_to(run), f"a pipe; {verb} hangs"
        names_it = place.name in output.stderr
        return ("refused" if output.returncode == IO_ERROR and names_it else "CRASHED"), place.relative_to(run), verb

    def damage_one(self, files, others=None):
        by_name = collections.defaultdict(list)
        for file in files:
            by_name[re.sub(r"[0-9]+", "N", file.name)].append(file)
        damaged = self.chance.choice(by_name[self.chance.choice(sorted(by_name))])  # each kind of file as often
        return damaged, self.damage(damaged, [file for file in others or files if file != damaged])

    def stop_in_a_stage(self, *options):
        """A run that was stopped in the middle of a stage that saves itself."""
        self.stopped = self.folder / "stopped"
        stop_in_stage("s/sheared", [self.program, "run", self.case, "-o", self.stopped, "--no-cache", *options],
                      cwd=self.folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        if not list(self.stopped.rglob("partial.h5")):
            sys.exit("the stopped run saved no partial.h5")

    def part(self, name, title, tries):
        if name == "foreign":
            self.make_foreign_runs()
        elif name in ("partial", "links", "pipes"):
            self.stop_in_a_stage()
        one = {"cache": self.try_cache, "stages": self.try_stage, "partial": self.try_partial,
               "foreign": self.try_foreign, "links": self.try_link, "pipes": self.try_pipe}[name]
        counts = collections.Counter()
        for number in range(tries):
            for left in ("run", "damaged-cache"):
                shutil.rmtree(self.folder / left, ignore_errors=True)
            verdict, file, how = one(number)
            counts[verdict] += 1
            if self.verbose or verdict in ("SILENT", "CRASHED"):
                print(f"  {verdict:10} {file}   {how or 'as before'}", flush=True)
        print(f"{title}: {tries} tries: " + ", ".join(
            f"{counts[verdict]} {words}" for verdict, words in (
                ("refused", "refused"), ("made anew", "made anew"), ("harmless", "harmless"),
                ("SILENT", "silently different"), ("CRASHED", "crashed"))), flush=True)
        return counts["SILENT"] + counts["CRASHED"]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("--tries", type=int, default=100, help="of each part")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", choices=["cache", "stages", "partial", "foreign", "links", "pipes"])
    parser.add_argument("-v", "--verbose", action="store_true", help="tell every try")
    arguments = parser.parse_args()
    parts = [("cache", "damage to cache entries"), ("stages", "damage to finished stages, then resume"),
             ("partial", "damage to partial.h5, then resume"), ("foreign", "parts of other runs, then resume"),
             ("links", "links to files of the user, then resume and report"), ("pipes", "pipes in a run")]
    memory = pathlib.Path("/dev/shm")  # where there is one: files are synced, and disks are slow
    with tempfile.TemporaryDirectory(dir=memory if memory.is_dir() else None) as folder:
        campaign = Campaign(arguments.program.resolve(), pathlib.Path(folder), arguments.seed, arguments.verbose)
        bad = sum(campaign.part(name, title, arguments.tries) for name, title in parts if arguments.only in (None, name))
    sys.exit(1 if bad else 0)


if __name__ == "__main__":
    main()
