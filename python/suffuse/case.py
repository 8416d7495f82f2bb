"""Cases: read, checked, changed, priced."""

import os
import pathlib
import tomllib

from suffuse import _core
from suffuse.spelling import spelled
from suffuse.views import show_plan


class Plan(dict):
    """What a case will cost: steps, seconds as ranges, memory and disk in bytes; `stages` lists the parts."""

    def __str__(self):
        return self["text"]

    def _repr_html_(self):
        return show_plan(self)


class CaseFile:
    """A case file, read and checked. Raises CaseProblems with everything that is wrong with it, at once.

    path: the case file
    preset: one of the case's [presets.*], instead of the one that it names
    changes: keys and values to set, as in {"study.erosion.particles": 4000}
    studies: names of the studies to keep, all of them unless given
    """

    @spelled
    def __init__(self, path, preset="", changes=None, studies=()):
        self._given_preset, self._changes, self._given_studies = preset, dict(changes or {}), list(studies)
        self._core = self._read(pathlib.Path(path), self._changes)

    @classmethod
    def load(cls, path, preset="", changes=None, studies=()):
        """The same as Case(path, preset, changes, studies)."""
        return cls(path, preset, changes, studies)

    def _read(self, path, changes):
        texts = [f"{key}={_as_toml(value)}" for key, value in changes.items()]
        return _core.CaseFile.load(path, self._given_preset, texts, self._given_studies)

    def check(self):
        """Reads the files of the case again, with the changes made since: what is doubtful, a list of Diagnostic.
        Raises CaseProblems with every error and its place."""
        self._core = self._read(self.path, self._changes)
        return self.warnings

    def change(self, changes):
        """Sets keys to values, as in {"study.erosion.particles": 4000}: all of them, or none where one is wrong."""
        wanted = {**self._changes, **changes}
        self._core = self._read(self.path, wanted)
        self._changes = wanted

    def __getitem__(self, table):
        """A table of the case, as in case["study.erosion"] or case["contact"]: a Table."""
        return Table(self, table)

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

    def __reduce__(self):
        """Pickled as its file, preset and changes, and read again in the other process."""
        return type(self), (self.path, self._given_preset, self._changes, self._given_studies)

    def __repr__(self):
        return f"<suffuse.Case {str(self.path)!r}: {len(self.stages)} stages, preset {self.preset}>"


class Table:
    """A table of a case: what it holds, with every default, and a way to change it."""

    def __init__(self, case, name):
        self._case, self.name = case, name
        self._values()

    def _values(self):
        values = tomllib.loads(self._case.resolved)
        for word in self.name.split("."):
            if isinstance(values, list):  # [[study.NAME.stage]], by name
                values = {stage["name"]: stage for stage in values}
            if not isinstance(values, dict) or word not in values:
                known = ", ".join(values) if isinstance(values, dict) else "no tables"
                raise KeyError(f"{self.name}: the case has no {word}; there are {known}")
            values = values[word]
        return values

    def __getitem__(self, key):
        return self._values()[key]

    def keys(self):
        return self._values().keys()

    def set(self, **values):
        """Sets keys of the table. A key that is none of a study's own is set in every stage of it that has the key.
        Raises CaseProblems, and changes nothing, where a value is wrong."""
        held = self._values()
        stages = held.get("stage", []) if self.name.startswith("study.") and self.name.count(".") == 1 else []
        changes = {}
        for key, value in values.items():
            owners = [] if key in held else [stage["name"] for stage in stages if key in stage]
            for owner in [f".stage.{name}" for name in owners] or [""]:
                changes[f"{self.name}{owner}.{key}"] = value
        self._case.change(changes)
        return self

    def __repr__(self):
        return f"<suffuse.Table {self.name}: {', '.join(self.keys())}>"


def _as_toml(value):
    if hasattr(value, "tolist"):  # NumPy's arrays and numbers
        value = value.tolist()
    if isinstance(value, os.PathLike):
        value = os.fspath(value)
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, dict):
        return "{" + ", ".join(f"{_as_toml(str(key))} = {_as_toml(part)}" for key, part in value.items()) + "}"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(_as_toml(part) for part in value) + "]"
    if isinstance(value, str):
        return '"' + value.replace("\\", "\\\\").replace('"', '\\"') + '"'
    return repr(value)
