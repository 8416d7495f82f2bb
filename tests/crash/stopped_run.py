"""A run that is stopped in the middle of a stage, on a machine of any speed."""

import os
import pathlib
import subprocess
import sys
import tempfile
import time


def stop_in_stage(stage, command, environment=None, **more):
    """Its exit code, stopped by SIGTERM in the middle of a stage, where it waits at its gate (apps/test_gate.hpp)."""
    with tempfile.TemporaryDirectory() as folder:
        fifo = pathlib.Path(folder) / "gate"
        os.mkfifo(fifo)
        variables = {**os.environ, **(environment or {}), "SUFFUSE_TEST_GATE": f"{stage}={fifo}"}
        run = subprocess.Popen([*map(str, command), "-q"], env=variables, **more)
        gate = None
        while gate is None:
            try:
                gate = os.open(fifo, os.O_WRONLY | os.O_NONBLOCK)  # as soon as the run reads there
            except OSError:
                if run.poll() is not None:
                    sys.exit(f"the run ended with {run.returncode} before it came to its gate")
                time.sleep(0.01)
        run.terminate()
        os.close(gate)
        return run.wait(timeout=300)
