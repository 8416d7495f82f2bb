"""One of the two builds at work: its program and Python module in a folder of their own, and the jobs done by them."""

import json
import os
import pathlib
import shutil
import subprocess
import threading
import time

LONGEST = 900  # [s] of a step; none takes a tenth of it
PYTHON = "/usr/bin/python3"  # for which the module is built
# A page that draws nothing, but makes the report carry its data.
STAND_IN = {"page.js": "0;\n", "page.js.sha256": "c3RhbmQtaW4=\n", "notices.txt": ""}


class Stopped(Exception):
    """The other side has failed, or a signal has come."""


class Side:
    def __init__(self, name, build, work, page, examples, source):
        self.name, self.folder = name, work / name
        self.places = {"@examples": str(examples), "@source": str(source)}
        self.program = self.folder / "release/apps/suffuse"
        self.program.parent.mkdir(parents=True)
        shutil.copy2(build / "apps/suffuse", self.program)
        self.python = self.folder / "release/python"
        self.has_python = (build / "python/suffuse/__init__.py").exists()
        if self.has_python:
            shutil.copytree(build / "python/suffuse", self.python / "suffuse")
        self.bring_page(page)
        self.child, self.stopped, self.lock = None, False, threading.Lock()

    def bring_page(self, page):
        """Where the program looks for the report's page, two folders above its own."""
        own = self.folder / "report-page"
        own.mkdir()
        for name, text in STAND_IN.items():
            if page:
                shutil.copy2(page / name, own)
            else:
                (own / name).write_text(text)
        if page and (page / "figures.mjs").exists():
            shutil.copy2(page / "figures.mjs", own)

    def environment(self):
        kept = {key: os.environ[key] for key in ("PATH",) if key in os.environ}
        return {**kept, "HOME": str(self.folder), "TMPDIR": str(self.folder), "LC_ALL": "C.UTF-8", "TZ": "UTC",
                "PYTHONPATH": str(self.python), "PYTHONDONTWRITEBYTECODE": "1"}

    def line_of(self, step):
        words = list(step.words)
        for mark, place in self.places.items():
            words = [word.replace(mark, place) for word in words]
        return [PYTHON, *words] if words[0].endswith(".py") else [str(self.program), *words]

    def do_step(self, step, folder):
        """The exit code. Standard output is kept for comparison, standard error to find a cause."""
        ending = "json" if "--json" in step.words or step.name == "numbers" else "txt"
        with open(folder / f"{step.name}.{ending}", "wb") as out, open(folder / f"{step.name}.err", "wb") as errors:
            with self.lock:
                if self.stopped:
                    raise Stopped
                self.child = subprocess.Popen(
                    self.line_of(step), cwd=folder, env=self.environment(), stdin=subprocess.DEVNULL, stdout=out,
                    stderr=errors, start_new_session=True
                )
            try:
                return self.child.wait(LONGEST)
            except subprocess.TimeoutExpired:
                self.child.kill()
                return self.child.wait()

    def do_job(self, job):
        """Seconds, and what did not end as it should: a list of sentences."""
        folder, begin, troubles, codes = self.folder / job.name, time.monotonic(), [], {}
        folder.mkdir()
        for step in job.steps:
            codes[step.name] = self.do_step(step, folder)
            if self.stopped:
                raise Stopped
            if codes[step.name] not in step.codes:
                lines = (folder / f"{step.name}.err").read_text(errors="replace").strip().splitlines()
                wanted = " or ".join(map(str, step.codes))
                troubles.append(f"{self.name}: {job.name}/{step.name} ended with {codes[step.name]} instead of {wanted}: "
                                f"{lines[-1] if lines else 'no word on standard error'}")
        (folder / "codes.json").write_text(json.dumps(codes))
        return time.monotonic() - begin, troubles

    def stop(self):
        with self.lock:
            self.stopped = True
            if self.child and self.child.poll() is None:
                self.child.kill()


def build_of(given):
    """The build folder that is meant: itself, or that of a checkout. None where it has no program."""
    for folder in (pathlib.Path(given), pathlib.Path(given) / "build/release"):
        if (folder / "apps/suffuse").exists():
            return folder.resolve()
    return None
