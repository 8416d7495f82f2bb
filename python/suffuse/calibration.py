"""Calibrations: parameters that reproduce a laboratory's tests, with their intervals."""

import json
import pathlib

from suffuse import _core
from suffuse.case import _as_toml
from suffuse.records import read_records
from suffuse.spelling import spelled


class Calibration(dict):
    """What a calibration left in its folder: keys of calibration.json, as docs/formats.md has them."""

    def __init__(self, folder, values=None):
        self.folder = pathlib.Path(folder)
        try:
            super().__init__(values or json.loads((self.folder / "calibration.json").read_text(encoding="utf-8")))
        except OSError as error:
            raise _core.IoError(
                f"{self.folder / 'calibration.json'}: cannot be read; did the first round of this calibration end?"
            ) from error

    @property
    def parameters(self):
        """What was found of each key: mean, low and high of the 90 % interval, best, information in bits, identified."""
        return self["parameters"]

    @property
    def is_complete(self):
        """Whether it came to its end; calibrate() with the same folder goes on where it was stopped."""
        return self["complete"]

    @property
    def not_identified(self):
        """Keys of which these tests say less than a bit."""
        return [key for key, found in self.parameters.items() if not found["identified"]]

    @property
    def contact(self):
        """A [contact] block for a case, with the likeliest parameters, as TOML."""
        return self["contact"]

    @property
    def posterior(self):
        """Equally likely sets of parameters, a row each: Records with a column a key, in SI."""
        rows = read_records(self.folder / "posterior.csv")
        rows._known_units = {key: found["si_unit"] for key, found in self.parameters.items()}
        return rows

    def samples(self, count=20):
        """Sets of parameters evenly out of the posterior, a dictionary each, with values as a case has them: "31.2 deg".
        Rows of a study (key `rows`) carry what the calibration leaves open to the study's results."""
        rows = list(self.posterior)
        if not 1 <= count <= len(rows):
            raise ValueError(f"count is 1 to {len(rows)}, the number of sets that there are")

        def written(key, value):
            unit, size = self.parameters[key]["unit"], self.parameters[key]["unit_size"]
            number = float(f"{float(value) / size:.6g}")
            return f"{number!r} {unit}" if unit else number

        return [{key: written(key, rows[k * len(rows) // count][key]) for key in self.parameters} for k in range(count)]

    def verify(self):
        """Whether all files are as they were when the calibration ended: damages, files, states, came_later. Raises IoError
        where it has not ended."""
        return _core.verify_calibration(self.folder)

    def __str__(self):
        lines = [f"{'parameter':28s} {'mean':>10s}   90 % interval"]
        for key, found in self.parameters.items():
            note = "" if found["identified"] else "   not identified"
            note += "   at a bound" if found["at_bound"] else ""
            lines.append(f"{key:28s} {found['mean']:10.4g}   {found['low']:.4g} to {found['high']:.4g}{note}")
        return "\n".join(lines)

    def __repr__(self):
        return f"<suffuse.Calibration {str(self.folder)!r}: {', '.join(self.parameters)}>"


@spelled
def calibrate(case, folder=None, changes=None, time_limit=None, on_progress=None, threads=None, cache=None):
    """Finds the parameters whose samples reproduce the tests of a laboratory, as `suffuse calibrate` does; returns a
    Calibration. Raises CaseProblems with everything that is wrong with the case.

    case: a case file with [calibrate]
    folder: runs/NAME-0001 and so on unless given; a calibration that was stopped there is gone on with
    changes: keys and values to set, as in {"calibrate.samples": 32}
    time_limit: save and stop after this wall time, as in "2h"
    on_progress: called ten times a second at most with a dictionary, as by Case.run
    threads: for this calibration; suffuse.threads() unless given. Results do not depend on it
    cache: a folder in which finished stages are stored for reuse; by default none

    Ctrl-C, or an exception of on_progress, saves and stops. A calibration that its time limit ends before its first round
    raises Interrupted; with the same folder it goes on.
    """
    texts = [f"{key}={_as_toml(value)}" for key, value in (changes or {}).items()]
    before = _core.threads()
    _core.set_threads(threads or before)
    try:
        place, values = _core.calibrate(
            pathlib.Path(case), texts, None if folder is None else pathlib.Path(folder), time_limit, on_progress,
            str(cache or ""),
        )
    finally:
        _core.set_threads(before)
    if values is None:
        raise _core.Interrupted(f"{place}: stopped before the first round ended; calibrate with this folder goes on")
    return Calibration(place, values)
