"""Runs: what a run folder holds, as numbers and arrays."""

import difflib
import functools
import json
import pathlib
import webbrowser

import numpy

from suffuse import _core
from suffuse.case import CaseFile
from suffuse.records import gather, numbers_in, read_records
from suffuse.spelling import spelled
from suffuse.views import page_folder, show_run

def conduct(case, folder, until, time_limit, on_progress, threads, cache, rules, at_once):
    """Runs a case in a folder with so many threads; returns the outcome."""
    before = _core.threads()
    _core.set_threads(threads or before)
    try:
        return _core.conduct(
            case, folder, until, time_limit, page_folder(), on_progress, str(cache or ""), _by_stage(rules, case.stages),
            at_once,
        )[0]
    finally:
        _core.set_threads(before)


def _at_once(case, memory, folder, cache, until, threads):
    """How many samples run side by side. @raises IoError where the memory is too little for one."""
    before = _core.threads()
    _core.set_threads(threads or before)
    try:
        return _core.samples_within(case, memory, None if folder is None else pathlib.Path(folder), str(cache or ""), until)
    finally:
        _core.set_threads(before)


def _by_stage(rules, stages):
    """Rules by "STUDY/STAGE", of stages with the swept values between: a stage alone means the one of that name in
    every study."""
    names = {(path[0], path[-1]) for path in (stage.split("/") for stage in stages)}
    found = {}
    for name, rule in (rules or {}).items():
        meant = [f"{study}/{stage}" for study, stage in names if stage == name] or [name]
        found.update({one: rule for one in meant})
    return found


def _there(path, folder, pattern):
    """The path of a file of a stage. @raises IoError, naming those that there are, where it was not written, and where it
    is not as the stage left it."""
    _core.check_file(path)
    if not path.exists():
        found = sorted(other.name for other in folder.glob(pattern))
        raise _core.IoError(
            f"{path}: this run did not write it; there {'are ' + ', '.join(found) if found else 'is none of its kind'}"
        )
    return path


def _read_json(path):
    try:
        return json.loads(path.read_text(encoding="utf-8"))
    except OSError as error:
        raise _core.IoError(f"{path}: cannot be read; is this a run folder?") from error


class Case(CaseFile):
    __doc__ = CaseFile.__doc__

    @spelled
    def run(
        self, folder=None, until="", time_limit=None, on_progress=None, threads=None, on_event=None, cache=None, rules=None,
        memory=None,
    ):
        """Runs the case; returns its Run.

        folder: runs/NAME-0001 and so on unless given; a folder that holds this run already is gone on with
        until: stop after this stage
        time_limit: save and stop after this wall time, as in "2h"
        on_progress: called ten times a second at most with a dictionary: stage, part, steps, state, ...; and once when
            a sample has ended, with `sample_ended`, and `failure`: why it failed, or None
        threads: for this run; suffuse.threads() unless given. Results do not depend on it
        on_event: another word for on_progress
        cache: a folder in which finished stages are stored for reuse; by default none
        rules: detachment rules of your own by stages that do "erode", as in {"erosion": fn} or {"STUDY/STAGE": fn}:
            functions from a Probe to a truth value for each of its fines, as in World.erode. A stage with one is neither
            taken from the cache nor kept there, and `own_rule` of its stage.json and a warning say whose it is
        memory: most that the run may take, as in "16GB"; 80 % of the machine's unless given. A case that needs more raises
            IoError before a folder is made; where all samples side by side need more, fewer run at once

        Ctrl-C, or an exception of on_progress or a rule, saves and stops; Run(folder).resume() goes on, to the same bits.
        """
        _core.check_until(self._core, until)  # all before a folder is made
        _core.check_time_limit(time_limit)
        at_once = _at_once(self._core, memory, folder, cache, until, threads)
        place = _core.new_run_folder(self._core, None if folder is None else pathlib.Path(folder))
        return Run(place, conduct(self._core, place, until, time_limit, on_progress or on_event, threads, cache, rules, at_once))


class Tensor(numpy.ndarray):
    """An array in SI; called with a unit, the same in it: stage.stress("kPa")."""

    def __call__(self, unit):
        return numpy.asarray(self) / _core.pressure_unit(unit)


class Pass(dict):
    """A pass of an erosion: keys of stage.json, also as attributes; `index` counts from 1."""

    def __getattr__(self, name):
        key = "pass" if name == "index" else name
        if key not in self:
            raise AttributeError(f"a pass has no {name}; there are {', '.join(self)}")
        return self[key]


class Report(type(pathlib.Path())):
    """The path of report.html. open() without a word shows it in the browser."""

    def open(self, *args, **settings):
        if args or settings:
            return super().open(*args, **settings)
        return webbrowser.open(self.absolute().as_uri())

    def __call__(self):
        return self


class Stage:
    """A finished stage: its numbers, its state, its tables."""

    def __init__(self, folder, name):
        self.folder, self.name = folder, name

    @functools.cached_property
    def numbers(self):
        """stage.json: void_ratio, mean_stress, steps, wall_seconds, ..."""
        _core.check_file(self.folder / "stage.json")
        return _read_json(self.folder / "stage.json")

    def __getitem__(self, key):
        if key not in self.numbers:
            raise KeyError(self._no(key))
        return self.numbers[key]

    def _no(self, key):
        """What to say of a number that the stage has not: those that are spelled alike, or all."""
        near = difflib.get_close_matches(str(key), self.numbers)
        known = f"did you mean {' or '.join(near)}?" if near else f"there are {', '.join(sorted(self.numbers))}"
        return f"{self.name}: no {key} among its numbers; {known}"

    def __getattr__(self, name):
        """A number of stage.json: stage.void_ratio is stage["void_ratio"]."""
        if name.startswith("_"):  # pickle and copy ask for such before the stage knows its folder
            raise AttributeError(name)
        if name not in self.numbers:
            raise AttributeError(self._no(name))
        return self.numbers[name]

    def __getstate__(self):
        """For another process: where the stage is, not what was read of it."""
        return {"folder": self.folder, "name": self.name}

    def __dir__(self):
        return sorted(set(super().__dir__()) | set(self.numbers))

    @property
    def stress(self):
        """Mean stress, 3 x 3, compression positive [Pa]; stress("kPa") in another unit."""
        return numpy.array(self.numbers["stress"]).view(Tensor)

    @functools.cached_property
    def world(self):
        """The state at the end of the stage: a World."""
        return _core.World.load(_there(self.folder / "state.h5", self.folder, "*.h5"))

    @property
    def grains(self):
        return self.world.grains

    @property
    def contacts(self):
        return self.world.contacts

    @functools.cached_property
    def history(self):
        """history.csv as a structured array: step, time, strain_1, stress_1, void_ratio, ..."""
        return self.table("history.csv")

    def table(self, name):
        """A CSV table of the stage ("throats.csv", "constrictions.csv") as a structured array."""
        return read_records(_there(self.folder / name, self.folder, "*.csv"))

    @functools.cached_property
    def results(self):
        """What the report draws from the stage: `curve` of a triaxial test, `probes`, `erosion`."""
        path = self.folder / "results.cbor"
        _core.check_file(path)
        return _core.read_cbor(path) if path.exists() else {}

    @property
    def curve(self):
        """The stress-strain curve of a triaxial test as a structured array of its numbers, or None."""
        rows = self.results.get("curve")
        if not rows:
            return None
        names = [name for name, value in rows[0].items() if isinstance(value, (int, float))]
        return numpy.array([tuple(row[name] for name in names) for row in rows], [(name, float) for name in names])

    @property
    def passes(self):
        """The passes of an erosion: a list of Pass."""
        return [Pass(one) for one in self.numbers.get("passes", [])]

    def __repr__(self):
        return f"<suffuse.Stage {self.name}: {self.numbers.get('verb')}>"


class Figure:
    """A figure of the report: its data and its Vega-Lite specification."""

    def __init__(self, folder, name):
        self.name, self._folder = name, folder

    @functools.cached_property
    def data(self):
        """A structured array, a column a variable; names carry the unit."""
        _core.check_result(self._folder.parent, f"figures/{self.name}.csv")
        return read_records(self._folder / f"{self.name}.csv")

    @functools.cached_property
    def specification(self):
        """Vega-Lite, with its data: for notebooks (altair, JupyterLab) and editors; None where there is a drawing."""
        path = self._folder / f"{self.name}.vl.json"
        _core.check_result(self._folder.parent, f"figures/{path.name}")
        return _read_json(path) if path.exists() else None

    def save(self, path):
        """Draws the figure as path says: .svg, .png or .pdf. Needs Node, and rsvg-convert for the latter two."""
        path = pathlib.Path(path)
        _core.require_outside_runs(path)
        _core.draw_figure(self._folder.parent, self.name, path, page_folder())
        return path

    def _repr_mimebundle_(self, include=None, exclude=None):
        if self.specification is None:
            return {"text/plain": repr(self)}
        return {"application/vnd.vegalite.v5+json": self.specification, "text/plain": repr(self)}

    def __repr__(self):
        return f"<suffuse.Figure {self.name}>"


class Run:
    """A run folder. run["STUDY/STAGE"] is a finished stage; run.figure(9) a figure of the report.

    outcome: "done", "done with flaws" or "time limit reached", where this session ran it
    """

    def __init__(self, folder, outcome=None):
        self.folder, self.outcome = pathlib.Path(folder), outcome
        if not (self.folder / "case.resolved.toml").exists() and not (self.folder / "run_options.json").exists():
            raise _core.IoError(f"{self.folder}: holds no run; runs are made by Case.run() or suffuse run")

    @property
    def summary(self):
        """summary.json: title, seed, warnings, findings, stages."""
        _core.check_result(self.folder, "summary.json")
        return _read_json(self.folder / "summary.json")

    @property
    def provenance(self):
        """provenance.json: version, commit, seed, threads, calls, ..."""
        _core.check_result(self.folder, "provenance.json")
        return _read_json(self.folder / "provenance.json")

    @property
    def findings(self):
        """The paper's findings: id, claim, paper, ours, met, verdict, our_numbers, why."""
        return self.summary["findings"]

    @property
    def events(self):
        """events.jsonl: what happened when."""
        path = self.folder / "events.jsonl"
        return [json.loads(line) for line in path.read_text(encoding="utf-8").splitlines()] if path.exists() else []

    @property
    def report(self):
        """The path of report.html; run.report.open() shows it."""
        return Report(self.folder / "report.html")

    @property
    def stages(self):
        """Names of the finished stages, "STUDY/STAGE", in the order in which they were finished."""
        root = self.folder / "studies"
        done = sorted(root.rglob("stage.json"), key=lambda path: (path.stat().st_mtime_ns, str(path)))
        return [path.parent.relative_to(root).as_posix() for path in done]

    def __getitem__(self, name):
        folder = self.folder / "studies" / name
        if not (folder / "stage.json").exists():
            raise KeyError(self._why_missing(name))
        return Stage(folder, name)

    def _why_missing(self, name):
        resolved = self.folder / "case.resolved.toml"
        planned = Case(resolved).stages if resolved.exists() else []
        done = ", ".join(self.stages) or "none yet"
        if name in planned:
            return f"{name}: not a finished stage of this run, which has not come to it: run.resume(); finished: {done}"
        return f"{name}: not a finished stage of this run, nor one of its case; finished: {done}"

    def __iter__(self):
        return iter(self.stages)

    def __len__(self):
        return len(self.stages)

    @property
    def figures(self):
        """Names of the figures."""
        return sorted(path.stem for path in (self.folder / "figures").glob("*.csv"))

    def figure(self, which):
        """A figure by its number in the paper (9) or its name ("own-rules")."""
        name = f"fig{which:02d}" if isinstance(which, int) else which
        if name not in self.figures:
            raise KeyError(f"{name}: this run has no such figure; there are {', '.join(self.figures)}")
        return Figure(self.folder / "figures", name)

    @spelled
    def table(self, rows="stages", verb=""):
        """Numbers of all finished stages as Records: a structured array with `units` and `to_pandas()`.

        rows: "stages", a row each with the numbers of its stage.json; "passes", a row a pass of each erosion; "samples", a
            row a sample with the numbers of its stages as "STAGE/void_ratio"
        verb: of stages of this verb alone ("shear"), and so without the columns that others fill
        Rows are in the order of the sweep, and of the stages within a sample. In front stand `study`, `sample`, the swept
        values (numbers in SI, `fc` in percent; words as written), and `stage` and `verb`, or `pass`. Objects within are
        "response.peak_ratio". A number that a row lacks is not one (NaN).
        """
        kinds = ("stages", "passes", "samples")
        if rows not in kinds:
            raise _core.CaseError(f"rows: found {rows!r}, expected one of {', '.join(kinds)}")
        finished = {name: self[name].numbers for name in self.stages}
        verbs = {numbers["verb"] for numbers in finished.values()}
        if verb and verb not in verbs:
            raise _core.CaseError(f"verb: found {verb!r}, expected one of {', '.join(sorted(verbs))}")
        found, units = {}, {}
        for sample, stages, swept in _core.samples_of(self.folder) if finished else []:
            head = {"study": sample.split("/")[0], "sample": sample, **{name: value for name, (value, _) in swept.items()}}
            units.update({name: unit for name, (_, unit) in swept.items() if unit})
            for stage in stages:
                name = f"{sample}/{stage}"
                numbers = finished.get(name)
                if numbers is None or verb not in ("", numbers["verb"]):
                    continue
                if rows == "samples":
                    columns = {f"{stage}/{key}": value for key, value in numbers_in(numbers).items()}
                    found.setdefault(sample, head).update(columns)
                elif rows == "stages":
                    found[name] = {**head, "stage": stage, "verb": numbers["verb"], **numbers_in(numbers)}
                elif numbers["verb"] == "erode":
                    for one in numbers["passes"]:
                        found[name, one["pass"]] = {**head, "stage": stage, **numbers_in(one)}
        return gather(found.values(), units)

    @spelled
    def resume(
        self, until="", time_limit=None, on_progress=None, threads=None, on_event=None, cache=None, rules=None, memory=None
    ):
        """Goes on with a run that was stopped, to the same bits; arguments as of Case.run. Stages that were requested with
        a rule of your own want the same one again."""
        resolved = self.folder / "case.resolved.toml"
        if resolved.exists():
            case = _core.CaseFile.load(resolved, "", [])
        else:  # stopped before it really began
            case = _core.CaseFile.load(*_core.run_request(self.folder))
        at_once = _at_once(case, memory, self.folder, cache, until, threads)
        self.outcome = conduct(case, self.folder, until, time_limit, on_progress or on_event, threads, cache, rules, at_once)
        return self

    def compare(self, other, tolerance=0):
        """What differs from another run, as in `suffuse compare --json`: differences, circumstances, ...

        tolerance: share up to which two numbers count as equal, as in "1 %"; below 1"""
        return _core.compare_runs(self.folder, pathlib.Path(getattr(other, "folder", other)), tolerance)

    def verify(self):
        """Whether the run is whole and as it was when it ended: damages, files, states, came_later."""
        return _core.verify_run(self.folder)

    def rebuild_report(self):
        """Writes summary.json, figures and report.html again, without computing."""
        return _core.rebuild_report(self.folder, page_folder())

    def case(self):
        """The case of this run, with every default spelled out."""
        return Case(self.folder / "case.resolved.toml")

    def _repr_html_(self):
        return show_run(self)

    def __repr__(self):
        return f"<suffuse.Run {str(self.folder)!r}: {len(self.stages)} stages done>"
