"""What is run with each of two builds: jobs, each of some steps in a folder of its own.

`@examples` stands for a folder with the examples, `@source` for the checkout. Where an example has no preset that is
quick enough, samples are made smaller.
"""

import dataclasses
import pathlib

ONE_THREAD = ("-j", "1")
QUIET = (*ONE_THREAD, "-q", "--json")
REPLAY = "@examples/replay/case.toml"
PACKING, CELL = "@examples/replay/packing.csv", "1.4360856339985508e-3,1.4358137235332051e-3,1.436026846625529e-3"
FONTAINEBLEAU = "@examples/fontainebleau-2016/data/fontainebleau.csv"
DAMAGE = "@source/tools/same_results/damage.py"
SHEETS = pathlib.Path(__file__).parents[2] / "tests/sheets"  # of laboratories, each with its answer
FORMATS = {"csv": "csv", "yade": "txt", "xyz": "xyz", "lammps": "data", "dump": "dump", "vtp": "vtp"}


@dataclasses.dataclass(frozen=True)
class Step:
    name: str  # of the file that takes its output: NAME.json with --json, else NAME.txt
    words: tuple  # for the program; where the first ends with .py, for Python
    codes: tuple  # with one of these it ends


@dataclasses.dataclass(frozen=True)
class Job:
    name: str
    steps: tuple


def step(name, *words, codes=(0,)):
    return Step(name, words, codes)


def of_case(name, file, *changes, codes=(0,), then=()):
    """A case from its check to its report. It has a cache of its own, empty at first: its keys are results, too."""
    path = f"@examples/{file}"
    return Job(name, (
        step("check", "check", path, *changes, "--json"),
        step("plan", "plan", path, *changes, *ONE_THREAD, "--json"),
        step("run", "run", path, *changes, "--cache", "cache", "-o", "run", *QUIET, codes=codes),
        step("verify", "verify", "run", "--json"),
        *then,
    ))


def sized(study, particles, *further):
    return ("--set", f"study.{study}.particles={particles}", *(word for one in further for word in ("--set", one)))


PAPER = (step("compare-paper", "compare", "run", "--paper", "--json", codes=(0, 5)),)

EXAMPLES = (
    of_case("fontainebleau-2016", "fontainebleau-2016/case.toml", "--preset", "quick", then=PAPER),
    of_case("fontainebleau-fines-0.18", "fontainebleau-fines-0.18/case.toml", "--preset", "quick"),
    of_case("silty-sand-2016", "silty-sand-2016/as-it-falls.toml", "--preset", "quick",  # fewer fines contents: 80 % take minutes
            "--set", 'study.fines.sweep={fines_content=["0 %","10 %","25 %","40 %"]}',
            "--set", 'study.removal.sweep={fines_content=["10 %","30 %"]}', codes=(0, 4), then=PAPER),
    of_case("silty-sand-fc20", "silty-sand-fc20/case.toml", "--preset", "quick"),
    of_case("silty-sand-fc20-removal", "silty-sand-fc20/removal.toml", *sized("orders", 1500)),
    of_case("silty-sand-fc20-stability", "silty-sand-fc20/stability.toml",
            *sized("stability", 1500, "study.stability.replicates=1")),
    of_case("silty-sand-fc20-transport", "silty-sand-fc20/transport.toml", *sized("ways", 1500, "study.ways.replicates=1")),
    of_case("second-erosion", "second-erosion/case.toml", *sized(
        "second", 1000, "study.second.stage.watch-100000.watch=1500", "study.second.stage.ramp-10000.ramp=1500",
        "study.second.stage.watch-100000-displacement.watch=1500"), codes=(0, 4)),
    of_case("second-erosion-fines-limit", "second-erosion/fines-limit.toml", *sized("limit", 1000)),
    of_case("second-erosion-merged-voids", "second-erosion/merged-voids.toml", *sized("limit", 1000)),
    Job("silty-sand-2016-size-ratio-20", (  # hours; its check and its plan alone
        step("check", "check", "@examples/silty-sand-2016/size-ratio-20.toml", "--json"),
        step("plan", "plan", "@examples/silty-sand-2016/size-ratio-20.toml", *ONE_THREAD, "--json"),
    )),
    Job("silty-sand-wide", (
        step("check", "check", "@examples/silty-sand-wide/case.toml", "--json"),
        step("plan", "plan", "@examples/silty-sand-wide/case.toml", *ONE_THREAD, "--json"),
    )),
)

SWEEP = ("--set", 'study.replay.sweep={"stage.seep.gradient"=[0.05,0.1]}', "--no-cache")

VERBS = (
    Job("replay", (
        step("run-until", "run", REPLAY, "--until", "settled", "--no-cache", "-o", "run", *QUIET),
        step("resume", "resume", "run", *QUIET),
        step("resume-again", "resume", "run", *QUIET),
        step("report", "report", "run", "--json"),
        step("watch", "watch", "run", "--json"),
        step("run-two-threads", "run", REPLAY, "--no-cache", "-o", "other", "-j", "2", "-q", "--json",
             "--set", "contact.damping=0.3", "--set", 'output.formats=["vtp","xyz","csv"]'),
        step("compare", "compare", "run", "other", "--json", codes=(5,)),
        step("compare-tolerant", "compare", "run", "other", "--tolerance", "20%", "--json", codes=(0, 5)),
        step("figures", "figures", "run", "--format", "svg", "-o", "drawn", "--json", codes=(0, 74)),
        *(step(f"export-{name}", "export", "run/studies/replay/compressed", "-o", f"grains.{ending}", "--format", name, "--json")
          for name, ending in FORMATS.items()),
        *(step(f"import-{name}", "import", f"grains.{ending}", "--cell", CELL, "-o", f"again-{name}.csv", "--json")
          for name, ending in FORMATS.items()),
    )),
    Job("failing", (
        step("run", "run", REPLAY, "--set", "study.replay.stage.settled.max_steps=10", "--no-cache", "-o", "run", *QUIET,
             codes=(1,)),
        step("report", "report", "run", "--json", codes=(1,)),
        step("verify", "verify", "run", "--json", codes=(0, 5)),
    )),
    Job("sweep", (
        step("emit", "sweep", REPLAY, *SWEEP, "--emit", "slurm", "-o", "swept", "--json"),
        step("emit-parallel", "sweep", "swept", "--emit", "parallel", "--json"),
        *(step(f"task-{k}", "resume", "swept", "--sample", f"replay/gradient={value}", *QUIET)
          for k, value in enumerate(("0.05", "0.1"))),
        step("collect", "sweep", "--collect", "swept", "--json"),
    )),
    Job("own-soil", (
        step("new", "new", "own", "--psd", FONTAINEBLEAU, "-i", "12m/40m", "--json"),
        step("check", "check", "own/case.toml", "--json"),
        step("new-part", "new", "part", "--psd", FONTAINEBLEAU, "--sizes", "0.1mm,0.6mm", "--particles", "2000", "--json"),
        *(step(f"new-{name}", "new", name, "--from", name, "--json")
          for name in ("fontainebleau-2016", "replay", "silty-sand-fc20")),
    )),
    Job("assess", (
        step("assess-sand", "assess", FONTAINEBLEAU, "-i", "0.3", "-o", "page", "--json"),
        step("assess-silt", "assess", "@examples/silty-sand-2016/data/silt.csv", "--json"),
        step("assess-fines", "assess", FONTAINEBLEAU, "--fines", "0.2mm", "-i", "3m/10m", "--alpha", "0.5", "--porosity",
             "35%", "--relative-density", "0.5", "--coarse-fabric", "--json"),
        step("assess-case", "assess", "@examples/silty-sand-fc20/case.toml", "--json"),
    )),
    Job("sheets", tuple(
        step(f"assess-{sheet.parent.name}-{sheet.name}", "assess", f"@source/{sheet.relative_to(SHEETS.parents[1])}", "--json", codes=(0, 3))
        for sheet in sorted(SHEETS.glob("*/*"))
        if not sheet.name.endswith(".expected.json")
    )),
    Job("damaged", (
        step("run", "run", REPLAY, "--no-cache", "-o", "run", *QUIET),
        step("damage-state", DAMAGE, "run/studies/replay/settled/state.h5", "run/studies/replay/compressed/stage.json"),
        step("verify", "verify", "run", "--json", codes=(5,)),
        step("report", "report", "run", "--json", codes=(0, 3, 74)),
        step("resume", "resume", "run", *QUIET, codes=(0, 1, 3, 74)),
        step("resume-again", "resume", "run", *QUIET, codes=(0, 1, 3, 74)),
        step("verify-again", "verify", "run", "--json", codes=(0, 5)),
        step("damage-case", DAMAGE, "run/case.resolved.toml"),
        step("resume-case", "resume", "run", *QUIET, codes=(0, 3, 74)),
    )),
    Job("bench", (
        step("bench-step", "bench", "step", "--packing", PACKING, "--cell", CELL, "--steps", "200", *ONE_THREAD, "--json"),
        step("bench-fast", "bench", "step", "--packing", PACKING, "--cell", CELL, "--steps", "200", "--mode", "fast",
             "--replicate", "2", *ONE_THREAD, "--json"),
        step("bench-flow", "bench", "flow", "--packing", PACKING, "--cell", CELL, *ONE_THREAD, "--json"),
    )),
    Job("words", (
        step("schema", "schema", "--json"),
        *(step(f"explain-{word}", "explain", word, "--json")
          for word in ("contact.modulus", "erode", "E310", "figure-9", "E4", "kezdi", "conventions")),
        step("completions", "completions", "bash"),
    )),
    Job("refusals", (
        step("wrong-verb", "rnu", "--json", codes=(2,)),
        step("wrong-flag", "run", REPLAY, "--presett", "quick", "--json", codes=(2,)),
        step("no-file", "check", "nowhere.toml", "--json", codes=(74,)),
        step("no-run", "resume", ".", "--json", codes=(2, 74)),
        step("no-packing", "import", REPLAY, "--json", codes=(3, 74)),
        *(step(f"check-{k}", "check", "@examples/fontainebleau-2016/case.toml", "--set", change, "--json", codes=(0, 3))
          for k, change in enumerate((
              "contact.shear_ratio=-1", "contact.frction=1", "contact.modulus=356", 'contact.modulus="356 mm"',
              'soil.fontainebleau.psd="nowhere.csv"', "study.erosion.particles=20", 'study.erosion.soil="clay"',
              'study.erosion.stage.initial.pressure="900 MPa"', "study.erosion.stage.erosion.gradient=30",
              'soil.fontainebleau.fines={finer_than="1 um"}', 'contact.law="hertz-mindlin"', 'preset="tiny"'))),
    )),
    Job("python", (
        step("numbers", "@source/tools/same_results/python_numbers.py"),
        step("flow", "@examples/python/flow_on_a_yade_packing.py"),
        step("triaxial", "@examples/python/triaxial_by_hand.py"),
        step("read-a-run", "@examples/python/read_a_run.py"),
        step("erosion", "@examples/python/erosion_by_hand.py"),
        step("twenty-lines", "@examples/python/twenty_lines.py", "1000"),
    )),
)

REST = (  # what no example has
    of_case("rest", "../rest.toml"),
    of_case("rest-fast", "../rest.toml", "--set", 'mode="fast"'),
    of_case("rest-elastic", "../rest.toml", "--study", "loads", "--set", 'contact.law="hertz-mindlin"',
            "--set", 'contact.modulus="7 GPa"', "--set", "contact.poisson=0.2"),
)

JOBS = (*EXAMPLES, *REST, *VERBS)
