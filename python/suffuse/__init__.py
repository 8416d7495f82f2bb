"""suffuse: internal erosion of soils, grain by grain, from a grading curve to a report.

    import suffuse

    case = suffuse.Case("examples/replay/case.toml")     # read and checked; raises CaseProblems with places
    print(case.plan())                                   # what it will cost
    run = case.run(on_progress=suffuse.print_progress)   # Ctrl-C saves; run.resume() goes on
    state = run["replay/settled"].world                  # grains and contacts as NumPy arrays

    print(suffuse.assess("dyke.csv", gradient=0.3))      # internal stability, by the grading alone

    world = suffuse.read_packing("packing.txt", cell=(4e-3, 4e-3, 4e-3))
    water = suffuse.seep(world, gradient=0.05, direction="x")

SI everywhere; a quantity may also be a text with its unit, as in "100 kPa". Compression is positive. The words are those
of the case file: suffuse.explain("contact.modulus").
"""

from suffuse import _core
from suffuse._core import (
    Balance,
    Bug,
    CaseError,
    CaseProblems,
    Constrictions,
    Contacts,
    Diagnostic,
    Error,
    Fluid,
    GeometryError,
    Grains,
    Interrupted,
    IoError,
    Key,
    Loading,
    Material,
    PoreNetwork,
    Probe,
    ResolvedFlow,
    Seepage,
    SolverError,
    StateError,
    UnitError,
    UsageError,
    World,
    __version__,
    commit,
    compiler,
    explain,
    quantity,
    schema,
    threads,
)
from suffuse.calibration import Calibration, calibrate
from suffuse.case import Plan, Table
from suffuse.executors import sweep
from suffuse.laboratory import read_test
from suffuse.packing import read, read_packing, write_packing
from suffuse.progress import print_progress, progress
from suffuse.records import Records
from suffuse.run import Case, Figure, Pass, Run, Stage
from suffuse.sample import constrictions, largest_overlap, make_cloud, resolve_flow, seep, set_threads
from suffuse.stability import Assessment, assess, atlas
from suffuse.views import View

__all__ = [name for name in dir() if not name.startswith("_") and name not in (
    "calibration", "case", "executors", "laboratory", "packing", "records", "run", "sample", "spelling", "stability", "views"
)]
