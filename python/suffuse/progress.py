"""What says on standard error how far long work is."""

import sys


def progress():
    """For Case.run(on_event=...): what says on standard error which stage is done."""
    return print_progress


def print_progress(progress, steps=None):
    """For on_progress, on standard error: of a run a line at the end of each stage, and of what failed; of a call that
    steps a world one line that counts."""
    if steps is not None:
        print(f"\r{progress}: {steps:,} steps ", end="", file=sys.stderr, flush=True)
        return
    if progress["failure"]:
        print(f'{progress["study"]}/{progress["stage"]} failed: {progress["failure"]}', file=sys.stderr)
    if progress["stage_finished"]:
        print(
            f'{progress["stage_number"]}/{progress["stages"]} {progress["study"]}/{progress["stage"]} '
            f'done in {progress["stage_seconds"]:.1f} s',
            file=sys.stderr,
        )
