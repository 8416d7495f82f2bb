"""Sweeps by an executor: the samples of a case, run by processes of this machine or by the workers of a cluster."""

import concurrent.futures
import pathlib

from suffuse import _core
from suffuse.case import CaseFile
from suffuse.run import Case, Run
from suffuse.spelling import spelled
from suffuse.views import page_folder


def run_sample(folder, sample, threads, cache):
    """Runs one sample of the run in `folder`, as `suffuse resume FOLDER --sample NAME` does: what an executor calls.
    Returns its outcome; a sample that fails is kept as failed in the folder."""
    case = _core.CaseFile.load(pathlib.Path(folder) / "case.resolved.toml", "", [])
    _core.set_threads(threads)
    return _core.conduct(
        case, pathlib.Path(folder), "", None, page_folder(), None, cache, {}, 1, sample
    )[0]


@spelled
def sweep(case, folder=None, executor=None, threads=1, cache=None):
    """Runs all samples of a case by an executor, and makes one report of them; returns the Run. Results have the bits of
    Case.run.

    case: a Case, or the path of a case file
    folder: runs/NAME-0001 and so on unless given; a folder that holds this run already is gone on with. All workers must
        have access to it
    executor: any concurrent.futures.Executor, as ProcessPoolExecutor(4), or that of dask.distributed: client.get_executor().
        Without one, Case.run runs the samples side by side in this process
    threads: of each sample; without an executor, of the whole run
    cache: a folder in which finished stages are stored for reuse; by default none

    A call is one sample. Samples that `refine` adds follow when the others have ended. An executor that fails, or Ctrl-C,
    ends the sweep; the same call, or suffuse.Run(folder).resume(), goes on with what is not finished.
    """
    case = case if isinstance(case, CaseFile) else Case(case)
    if executor is None:
        return case.run(folder, threads=threads, cache=cache)
    place = pathlib.Path(_core.new_run_folder(case._core, None if folder is None else pathlib.Path(folder))).absolute()
    _core.open_run(case._core, place)
    before = _core.threads()
    tried = set()
    try:
        while names := [name for name in _core.unfinished_samples(place) if name not in tried]:
            tried.update(names)
            _run_all(executor, [(str(place), name, threads, str(cache or "")) for name in names])
    finally:
        _core.set_threads(before)  # an executor of threads has changed those of this process
    return Run(place, _core.gather(place, page_folder()))


def _run_all(executor, calls):
    """Calls run_sample by the executor; raises what one of the calls raises, and begins no other then."""
    futures = [executor.submit(run_sample, *call) for call in calls]
    try:
        for future in concurrent.futures.as_completed(futures):
            future.result()
    except BaseException:
        for future in futures:
            future.cancel()
        raise
