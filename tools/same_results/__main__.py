"""Runs the jobs of jobs.py with two builds, side by side, and compares all that they leave; same_results.sh calls it."""

import argparse
import os
import pathlib
import shutil
import signal
import sys
import tempfile
import threading
import time

import jobs
import side
from compare import compare_job

SOURCE = pathlib.Path(__file__).resolve().parents[2]
SHOWN = 12  # files that differ, of each job


def say(text):
    print(f"same_results: {text}", file=sys.stderr, flush=True)


def read_words():
    parser = argparse.ArgumentParser(prog="tools/same_results.sh", description="exit code 0: the same; 1: not; 2: wrong use")
    parser.add_argument("before", help="a build folder, a checkout with build/release, or a revision of git")
    parser.add_argument("after", help="likewise")
    parser.add_argument("--only", metavar="NAME", action="append", default=[], help="this job alone; may be repeated")
    parser.add_argument("--ignore", metavar="KEY", action="append", default=[],
                        help="a key that may differ or be missing, as in digest or passes/*/removed; may be repeated")
    parser.add_argument("--texts", action="store_true", help="texts for people, too")
    parser.add_argument("--all", action="store_true", help="list all files and places that differ")
    parser.add_argument("--keep", metavar="DIR", type=pathlib.Path, help="work in this folder, and leave it")
    parser.add_argument("--list", action="store_true", help="the names of the jobs, and nothing more")
    return parser


def report(name, count, found, options):
    if not found:
        print(f"{name}: same, {count} files", flush=True)
        return
    print(f"{name}: {len(found)} of {count} files differ (before | after)")
    for file, wrong in list(found.items())[:None if options.all else SHOWN]:
        print(f"  {file}: {wrong[0]}" + (f"  and {len(wrong) - 1} more" if len(wrong) > 1 and not options.all else ""))
        for further in wrong[1:] if options.all else []:
            print(f"  {' ' * len(file)}  {further}")
    if len(found) > SHOWN and not options.all:
        print(f"  and {len(found) - SHOWN} more files; --all lists them")
    sys.stdout.flush()


class Work:
    """Both sides do the same jobs, each at its own pace; the first that has a job done waits for nobody."""

    def __init__(self, sides, chosen_jobs):
        self.sides, self.chosen_jobs = sides, chosen_jobs
        self.done = {(one.name, job.name): threading.Event() for one in sides for job in chosen_jobs}
        self.troubles, self.broken = {}, None

    def drive(self, one):
        try:
            for job in self.chosen_jobs:
                seconds, self.troubles[one.name, job.name] = one.do_job(job)
                say(f"{one.name}: {job.name} took {seconds:.0f} s")
                self.done[one.name, job.name].set()
        except side.Stopped:
            pass
        except Exception as error:  # reported by the main thread, which waits
            self.broken = error
        for event in (event for (name, _), event in self.done.items() if name == one.name):
            event.set()

    def results(self):
        """Yields each job when both sides have done it."""
        threads = [threading.Thread(target=self.drive, args=(one,), daemon=True) for one in self.sides]
        for thread in threads:
            thread.start()
        for job in self.chosen_jobs:
            for one in self.sides:
                self.done[one.name, job.name].wait()
            if self.broken:
                raise self.broken
            yield job, [text for one in self.sides for text in self.troubles.get((one.name, job.name), [])]
        for thread in threads:
            thread.join()


def prepare(work, builds):
    """The two sides, with the same examples and the same page."""
    shutil.copytree(SOURCE / "examples", work / "examples")
    shutil.copy2(pathlib.Path(__file__).with_name("rest.toml"), work)
    page = SOURCE / "build/report-page"
    if not (page / "page.js").exists():
        say(f"{page} is not built: figures are not drawn as files")
        page = None
    return [side.Side(name, build, work, page, work / "examples", SOURCE) for name, build in builds.items()]


def run(work, builds, chosen_jobs, options):
    sides = prepare(work, builds)
    without = [one.name for one in sides if not one.has_python]
    if without and any(job.name == "python" for job in chosen_jobs):
        say(f"without the Python module ({' and '.join(without)}), which is not compared")
        chosen_jobs = [job for job in chosen_jobs if job.name != "python"]
    is_same = True
    try:
        for job, troubles in Work(sides, chosen_jobs).results():
            for text in troubles:
                print(text)
            count, found = compare_job(job.name, sides[0].folder, sides[1].folder, options)
            report(job.name, count, found, options)
            is_same = is_same and not troubles and not found
    finally:
        for one in sides:
            one.stop()
    return is_same


def end_by(number, frame):
    raise SystemExit(128 + number)


def main():
    parser = read_words()
    if "--list" in sys.argv[1:]:
        print("\n".join(job.name for job in jobs.JOBS))
        return 0
    options = parser.parse_args()
    builds = {"before": side.build_of(options.before), "after": side.build_of(options.after)}
    for name, given in (("before", options.before), ("after", options.after)):
        if not builds[name]:
            parser.error(f"{given}: there is no apps/suffuse, nor build/release/apps/suffuse; build it first")
    unknown = set(options.only) - {job.name for job in jobs.JOBS}
    if unknown:
        parser.error(f"no such job: {', '.join(sorted(unknown))}; --list names them")
    chosen_jobs = [job for job in jobs.JOBS if not options.only or job.name in options.only]
    for number in (signal.SIGHUP, signal.SIGINT, signal.SIGTERM):
        signal.signal(number, end_by)
    begin = time.monotonic()
    work = options.keep or pathlib.Path(tempfile.mkdtemp(prefix="same-results-"))
    try:
        if options.keep:
            os.makedirs(work)  # of its own: what lies there already is not ours
        is_same = run(work.resolve(), builds, chosen_jobs, options)
    except FileExistsError:
        parser.error(f"--keep {work}: is there already; name a folder that is not")
    finally:
        if not options.keep:
            shutil.rmtree(work, ignore_errors=True)
    print(f"{len(chosen_jobs)} jobs in {time.monotonic() - begin:.0f} s: {'all the same' if is_same else 'not the same'}")
    return 0 if is_same else 1


if __name__ == "__main__":
    sys.exit(main())
