#!/usr/bin/python3
"""tests/engines/dask_sweep.py: a sweep by workers of dask.distributed has the bits of one without an executor. Needs Debian's
python3-distributed, and the module on PYTHONPATH; ./test --long engines calls it."""

import pathlib
import sys
import tempfile

import distributed

import suffuse

sys.path.insert(0, str(pathlib.Path(__file__).parents[2] / "python/tests"))
from test_sweep import CASE, hashes  # noqa: E402


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "case.toml").write_text(CASE)
        whole = hashes(suffuse.sweep(folder / "case.toml", folder / "whole"))
        with distributed.LocalCluster(
            n_workers=2, threads_per_worker=1, dashboard_address=None, local_directory=name
        ) as cluster, distributed.Client(cluster) as client:
            run = suffuse.sweep(folder / "case.toml", folder / "dask", executor=client.get_executor())
        assert len(whole) == 8 and hashes(run) == whole and run.outcome == "done" and run.report.exists()
        print(f"dask.distributed {distributed.__version__}: {len(whole)} stages, the same bits, one report")


if __name__ == "__main__":
    main()
