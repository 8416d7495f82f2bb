#!/usr/bin/python3
"""Prints Google Benchmark's JSON as a table: a row a benchmark, ns an item. Repetitions are reduced to their minimum."""
import json
import sys


def main():
    with open(sys.argv[1]) as file:
        found = json.load(file)
    rows = {}
    for run in found["benchmarks"]:
        if run.get("run_type") != "aggregate":
            best = rows.setdefault(run["run_name"], run)
            rows[run["run_name"]] = min(best, run, key=lambda r: r["cpu_time"])
    context = found["context"]
    print(f"{context['date']}  {context['num_cpus']} processors at {context['mhz_per_cpu']} MHz, load {context['load_avg'][0]:.1f}")
    to_ms = {"ns": 1e-6, "us": 1e-3, "ms": 1, "s": 1e3}
    for name, run in rows.items():
        counters = [f"{key} {value:.4g}" for key, value in run.items() if key.startswith("ns_per") or key.endswith("_per_grain")]
        print(f"{name:28}{run['cpu_time'] * to_ms[run['time_unit']]:>12.4g} ms   {', '.join(sorted(set(counters)))}")


if __name__ == "__main__":
    main()
