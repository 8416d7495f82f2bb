"""Cases: read, checked, priced, run."""

import pathlib
import sys

from suffuse import _core

# Where tools/bootstrap.sh lets npm put the report's page, seen from build/release/python/suffuse.
_PAGE = pathlib.Path(__file__).resolve().parents[3] / "report-page"


def page_folder():
    """The built page of the report, or an empty path: the report is then plain."""
    return _PAGE if _PAGE.is_dir() else pathlib.Path()


class Plan(dict):
    """What a case will cost: steps, seconds as ranges, memory and disk in bytes; `stages` lists the parts."""

    def __str__(self):
        return self["text"]


class Case:
    """A case file, read and checked. Raises CaseProblems with everything that is wrong with it, at once.

    path: the case file
    preset: one of the case's [presets.*], instead of the one that it names
    changes: keys and values to set, as in {"study.erosion.particles": 4000}
    """

    def __init__(self, path, preset="", changes=None):
        self._changes = dict(changes or {})
        texts = [f"{key}={_as_toml(value)}" for key, value in self._changes.items()]
        self._core = _core.CaseFile.load(pathlib.Path(path), preset, texts)

    @property
    def path(self):
        return self._core.path

    @property
    def title(self):
        return self._core.title

    @property
    def preset(self):
        """The preset in force."""
        return self._core.preset

    @property
    def seed(self):
        return self._core.seed

    @property
    def warnings(self):
        """What is doubtful: a list of Diagnostic."""
        return self._core.warnings

    @property
    def stages(self):
        """"STUDY/STAGE" in the order in which they run."""
        return self._core.stages

    @property
    def resolved(self):
        """The case with every default and unit spelled out, as TOML."""
        return self._core.resolved

    @property
    def material(self):
        """A copy of the constants of the contact law."""
        return self._core.material

    @property
    def balance(self):
        return self._core.balance

    @property
    def fluid(self):
        return self._core.fluid

    @property
    def damping(self):
        return self._core.damping

    def plan(self):
        """What it will cost on this machine, measured now: a Plan."""
        return Plan(self._core.plan())

    def run(self, folder=None, until="", time_limit=None, on_progress=None):
        """Runs the case; returns its Run.

        folder: runs/NAME-0001 and so on unless given; a folder that holds this run already is gone on with
        until: stop after this stage
        time_limit: save and stop after this wall time, as in "2h"
        on_progress: called ten times a second at most with a dictionary: stage, part, steps, state, ...

        Ctrl-C, or an exception of on_progress, saves and stops; Run(folder).resume() goes on, to the same bits.
        """
        from suffuse.run import Run

        place = _core.new_run_folder(self._core, None if folder is None else pathlib.Path(folder))
        outcome, _ = _core.conduct(self._core, place, until, time_limit, page_folder(), on_progress)
        return Run(place, outcome)

    def __repr__(self):
        return f"<suffuse.Case {str(self.path)!r}: {len(self.stages)} stages, preset {self.preset}>"


def _as_toml(value):
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(_as_toml(part) for part in value) + "]"
    if isinstance(value, str):
        return '"' + value.replace("\\", "\\\\").replace('"', '\\"') + '"'
    return repr(value)


def print_progress(progress):
    """For Case.run(on_progress=...): a line at the end of each stage, on standard error."""
    if progress["stage_finished"]:
        print(
            f'{progress["stage_number"]}/{progress["stages"]} {progress["study"]}/{progress["stage"]} '
            f'done in {progress["stage_seconds"]:.1f} s',
            file=sys.stderr,
        )
