#!/bin/sh
# bench/run.sh [OPTION...]: builds the benchmarks and runs them, one thread each; prints a table and writes every number to
# build/bench-results.json. Options go to Google Benchmark: --benchmark_filter=step_.*, --benchmark_repetitions=9, ...
set -eu
root=$(cd "$(dirname "$(readlink -f "$0")")/.." && pwd)
# shellcheck source=bench/common.sh
. "$root/bench/common.sh"
# shellcheck source=tools/at_end.sh
. "$root/tools/at_end.sh"
trap end_attended EXIT
ready suffuse_bench

attended "$build/bench/suffuse_bench" --benchmark_out="$root/build/bench-results.json" --benchmark_out_format=json "$@" >&2
exec /usr/bin/python3 "$root/bench/table.py" "$root/build/bench-results.json"
