#!/usr/bin/python3
"""Our preparation of 10,000 grains at 100 kPa against the steps that Yade took for the reference's packing.

Yade's preparation took 40,911 steps (tests/reference/packing10k.json); running them again takes ten minutes, so their time is
that number times Yade's time for a step of the settled sample, measured in turn with ours in one run. Ours is the whole
program: cloud, compaction, settling, and the run's folder. Called by prepare_vs_yade.sh.
"""
import json
import pathlib
import shutil
import statistics
import sys

import harness
from harness import of, quartiles, row, say
from peer import make_peer

CASE = pathlib.Path(__file__).resolve().parent / "prepare.toml"
PHYSICS = ["grains", "steps", "void_ratio", "coordination", "rattlers", "stress_1", "stress_2", "stress_3", "unbalanced_force_yade"]


def read_arguments():
    parser = harness.arguments(__doc__.splitlines()[0])
    parser.set_defaults(pairs=3)
    parser.add_argument("--peer-steps", type=int, default=500, help="steps of one of the peer's windows")
    parser.add_argument("--set", action="append", default=[], metavar="KEY=VALUE", help="changes prepare.toml, as suffuse run does")
    return parser.parse_args()


def measure_ours(options):
    folder = options.output.with_suffix("") / "run"
    shutil.rmtree(folder, ignore_errors=True)
    command = [options.program, "run", CASE, "--threads", options.threads, "--output", folder, "--quiet", "--no-cache"]
    command += [word for change in options.set for word in ("--set", change)]
    _, wall, processor = harness.run_alone(command)
    stage = json.loads((folder / "studies" / "preparation" / "sample" / "stage.json").read_text())
    stage.update({f"stress_{a + 1}": stage["stress"][a][a] for a in range(3)})
    rates = {"steps_per_second": stage["steps"] / wall, "processors": processor / wall / options.threads}
    return {"code": "suffuse", "seconds": wall, **rates, **stage}


def reference(packing):
    """The state that the reference's preparation came to."""
    about = json.loads(pathlib.Path(packing.replace(".csv.gz", ".json")).read_text())
    porosity = about["porosity"]
    return {
        "grains": about["contacts"]["N"],
        "steps": about["iter"],
        "void_ratio": porosity / (1 - porosity),
        "coordination": about["contacts"]["Z"],
        "rattlers": about["contacts"]["rattlers_lt2"],
        **{f"stress_{a + 1}": -about["stress_Pa"][a][a] for a in range(3)},
        "unbalanced_force_yade": about["unbalanced"],
    }


def print_result(options, peer, windows, made):
    ours, theirs = of(windows, "suffuse"), of(windows, peer.name)
    theirs_seconds = [made["steps"] / w["steps_per_second"] for w in theirs]
    ratios = [t / w["seconds"] for t, w in zip(theirs_seconds, ours)]
    row("median (quartiles)", "suffuse", peer.title, "ratio, pair by pair")
    row("preparation [s]", quartiles([w["seconds"] for w in ours]), quartiles(theirs_seconds), quartiles(ratios))
    harness.print_machine(ours, theirs)
    print()
    row("state reached", f"suffuse, {ours[-1].get('protocol', 'faithful')}", f"{peer.title}, the reference's", "relative difference")
    for name in PHYSICS:
        s, p = ours[-1][name], made[name]
        row(name, f"{s:.5g}", f"{p:.5g}", f"{s / p - 1:+.2%}")
    print(f"\n{options.threads} threads; {peer.title}: {made['steps']} steps at the time of a step of the settled sample")
    return statistics.median(ratios)


def main():
    options = read_arguments()
    case = harness.read_case(options.packing)
    peer = make_peer(options.peer, case, options.threads, options.output.with_suffix(""))
    say(f"{peer.title} settles {len(case['grains'])} grains ...")
    peer.settle()
    theirs = lambda: {"code": peer.name, **peer.measure(options.peer_steps)}
    windows = harness.in_turn(options.pairs, [theirs, lambda: measure_ours(options)])
    peer.close()
    columns = ["pair", "code", "seconds", "steps_per_second", "processors", "load_before", "load_after", *PHYSICS]
    harness.write_rows(options.output, columns, windows)
    sys.exit(1 if print_result(options, peer, windows, reference(options.packing)) < options.at_least else 0)


if __name__ == "__main__":
    main()
