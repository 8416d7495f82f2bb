#!/usr/bin/python3
"""One time step against a peer's, on one packing, with one law, on the same processors, measured in turn in one run.

The peer settles the packing once; each of our windows is one call of `suffuse bench step`, which settles the same packing
itself. Called by step_vs_*.sh; writes a row a window to --output, and prints ratios with quartiles next to the physics.
"""
import gzip
import json
import statistics
import sys

import harness
from harness import of, quartiles, row, say
from peer import make_peer

PHYSICS = ["grains", "contacts", "void_ratio", "coordination", "stress_1", "stress_2", "stress_3", "unbalanced_force_yade"]


def read_arguments():
    parser = harness.arguments(__doc__.splitlines()[0])
    parser.add_argument("--peer-steps", type=int, help="steps of a peer's window; by default its strain ends where ours does")
    parser.add_argument("--steps", type=int, default=5000, help="steps of one of our windows")
    parser.add_argument("--mode", choices=["reference", "fast"], default="reference", help="of our windows")
    return parser.parse_args()


def with_stresses(found):
    stress = found.get("stress", [])
    return {**found, **{f"stress_{a + 1}": s[a] if isinstance(s, list) else s for a, s in enumerate(stress)}}


def measure_ours(options, case, packing_csv):
    cell = ",".join(repr(edge) for edge in case["cell"])
    command = [options.program, "bench", "step", "--packing", packing_csv, "--cell", cell]
    command += ["--steps", options.steps, "--threads", options.threads, "--mode", options.mode, "--json"]
    printed, wall, processor = harness.run_alone(command)
    return {"code": "suffuse", "processors": processor / wall / options.threads, **with_stresses(json.loads(printed))}


def shown(value):
    return f"{value:.5g}" if isinstance(value, (int, float)) else "-"


def print_result(options, peer, windows):
    ours, theirs = of(windows, "suffuse"), of(windows, peer.name)
    processor_rate = lambda w: w["steps_per_second"] / (w["processors"] * options.threads)
    row("median (quartiles)", "suffuse", peer.title, "ratio, pair by pair")
    ratios = {}
    for title, rate in {
        "steps/s": lambda w: w["steps_per_second"],
        "contacts x steps/s": lambda w: w["steps_per_second"] * w["contacts"],
        "steps / s of processor time": processor_rate,
    }.items():
        ratios[title] = [rate(s) / rate(p) for s, p in zip(ours, theirs)]
        row(title, quartiles([rate(w) for w in ours]), quartiles([rate(w) for w in theirs]), quartiles(ratios[title]))
    clean = harness.print_machine(ours, theirs)
    if clean and len(clean) < len(ours):
        row("ratio of steps/s in those", "", "", quartiles([ratios["steps/s"][k] for k in clean]))
    print()
    row("state after the last window", "suffuse", peer.title, "relative difference")
    for name in PHYSICS:
        s, p = ours[-1].get(name), theirs[-1].get(name)
        row(name, shown(s), shown(p), f"{s / p - 1:+.2%}" if isinstance(s, (int, float)) and p else "-")
    print(f"\n{options.threads} threads (or ranks); windows of {options.steps} steps (ours) and {options.peer_steps} ({peer.title}), in turn; ours in mode {options.mode}")
    print("\n".join(peer.remarks))
    return statistics.median(ratios["steps/s"])


def main():
    options = read_arguments()
    case = harness.read_case(options.packing)
    peer = make_peer(options.peer, case, options.threads, options.output.with_suffix(""))
    options.peer_steps = options.peer_steps or (options.steps // options.pairs if peer.goes_on else options.steps)
    packing_csv = options.output.with_suffix("") / "packing.csv"
    packing_csv.write_bytes(gzip.open(options.packing).read())

    say(f"{peer.title} settles {len(case['grains'])} grains ...")
    settled = peer.settle()
    say(f"... {settled['steps']} steps, {settled['seconds']:.0f} s, quiet: {settled['quiet']}")
    theirs = lambda: {"code": peer.name, **with_stresses(peer.measure(options.peer_steps))}
    windows = harness.in_turn(options.pairs, [theirs, lambda: measure_ours(options, case, packing_csv)])
    peer.close()
    columns = ["pair", "code", "steps_per_second", "processors", "load_before", "load_after", *PHYSICS]
    harness.write_rows(options.output, columns, windows)
    sys.exit(1 if print_result(options, peer, windows) < options.at_least else 0)


if __name__ == "__main__":
    main()
