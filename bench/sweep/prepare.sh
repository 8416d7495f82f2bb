#!/bin/sh
# bench/sweep/prepare.sh [--particles N] [--loose PROTOCOL] [--dense PROTOCOL] [-j N] [--serial] [--program FILE]
# Prepares 26 samples (13 fines contents, loose and dense; bench/sweep/case.toml) side by side without the cache, and prints
# the wall time and each sample's void ratio, coordination and unbalanced force. --serial also prepares them one after the
# other on one thread, compares every bit, and prints the ratio of the two times.
set -eu
root=$(cd "$(dirname "$(readlink -f "$0")")/../.." && pwd)
particles=10000 loose=faithful dense=faithful threads=$(nproc) serial=no program=$root/build/release/apps/suffuse
while [ $# -gt 0 ]; do
    case $1 in
    --particles) particles=$2 && shift 2 ;;
    --loose) loose=$2 && shift 2 ;;
    --dense) dense=$2 && shift 2 ;;
    -j) threads=$2 && shift 2 ;;
    --serial) serial=yes && shift ;;
    --program) program=$2 && shift 2 ;;
    *) sed -n '2,5s/^# //p' "$0" >&2 && exit 2 ;;
    esac
done
# shellcheck source=tools/at_end.sh
. "$root/tools/at_end.sh"
folder=
trap 'end_attended; rm -rf "$folder"' EXIT
folder=$(mktemp -d)

# prepare NAME THREADS
prepare() {
    set -- "$1" "$2" --set "study.loose.particles=$particles" --set "study.dense.particles=$particles"
    set -- "$@" --set "study.loose.stage.state.protocol=$loose" --set "study.dense.stage.state.protocol=$dense"
    name=$1 on=$2
    shift 2
    code=0
    attended "$program" run "$root/bench/sweep/case.toml" -o "$folder/$name" -j "$on" --no-cache --quiet --json "$@" \
        >"$folder/$name.json" || code=$?
    [ "$code" -eq 0 ] || [ "$code" -eq 4 ] || { cat "$folder/$name.json" >&2 && exit "$code"; }
}

prepare beside "$threads"
[ "$serial" = no ] || prepare alone 1

/usr/bin/python3 - "$folder" "$serial" "$threads" <<'PYTHON'
import json, sys
folder, serial, threads = sys.argv[1:4]
read = lambda name: json.load(open(f"{folder}/{name}"))
stages = read("beside/summary.json")["stages"]
print("sample           grains  steps     e      Z      unbalanced  seconds")
for name, s in stages.items():
    if name.endswith("/state"):
        print(f"{name[:-6]:16} {s['grains']:6}  {s['steps']:6}  {s['void_ratio']:.4f}  {s['coordination']:.3f}  "
              f"{s['unbalanced_force']:.1e}   {s['wall_seconds']:.2f}")
wall = read("beside.json")["wall_seconds"]
print(f"side by side on {threads} threads: {wall:.1f} s")
if serial == "yes":
    alone = read("alone/summary.json")["stages"]
    assert all(alone[name]["state_hash"] == s["state_hash"] for name, s in stages.items()), "bits differ"
    slow = read("alone.json")["wall_seconds"]
    print(f"one after the other on one thread: {slow:.1f} s, {slow / wall:.2f} times as long; the bits are the same")
PYTHON
