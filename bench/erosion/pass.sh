#!/bin/sh
# bench/erosion/pass.sh [--rounds N] [-j N] [--program FILE]
# One whole erosion pass of the Fontainebleau example, 10,000 grains: relaxation, flow and forces, probe of 1000 steps with
# its ramp and its twin, extraction, new equilibrium at constant volume and under the stresses held. Prepares the sample
# anew in each round (default: 3) and prints the wall time of the pass alone, its steps, and the physics before and after.
set -eu
root=$(cd "$(dirname "$(readlink -f "$0")")/../.." && pwd)
rounds=3 threads=$(nproc) program=$root/build/release/apps/suffuse
while [ $# -gt 0 ]; do
    case $1 in
    --rounds) rounds=$2 && shift 2 ;;
    -j) threads=$2 && shift 2 ;;
    --program) program=$2 && shift 2 ;;
    *) sed -n '2,5s/^# //p' "$0" >&2 && exit 2 ;;
    esac
done
# shellcheck source=tools/at_end.sh
. "$root/tools/at_end.sh"
folder=
trap 'end_attended; rm -rf "$folder"' EXIT
folder=$(mktemp -d)

round=1
while [ "$round" -le "$rounds" ]; do
    code=0
    attended "$program" run "$root/examples/fontainebleau-2016/case.toml" -o "$folder/$round" --study erosion --until erosion \
        --set study.erosion.stage.erosion.passes=1 --set 'output.formats=[]' -j "$threads" --no-cache --quiet \
        >"$folder/log" 2>&1 || code=$?
    [ "$code" -eq 0 ] || [ "$code" -eq 4 ] || { cat "$folder/log" >&2 && exit "$code"; }
    round=$((round + 1))
done

/usr/bin/python3 - "$folder" "$rounds" "$threads" <<'PYTHON'
import json, sys
folder, rounds, threads = sys.argv[1], int(sys.argv[2]), sys.argv[3]
stage = lambda round, name: json.load(open(f"{folder}/{round}/studies/erosion/{name}/stage.json"))
seconds = sorted(stage(round, "erosion")["wall_seconds"] for round in range(1, rounds + 1))
one = stage(1, "erosion")["passes"][0]
probe = one["probe"]
print(f"{threads} threads, one pass: " + ", ".join(f"{s:.2f}" for s in seconds) + " s")
print(f"steps: relaxation {probe['relax_steps']}, probe and twin {2 * (probe['ramp'] + probe['watch'])}, "
      f"new equilibrium {one['steps']}; {one['removed']} of {probe['fines']} fines removed, {one['eroded_mass_percent']:.2f} % of the mass")
print("state    void ratio  coordination  mean stress [kPa]  unbalanced")
for name, state in (("before", stage(1, "initial")), ("after", stage(1, "erosion"))):
    print(f"{name:8} {state['void_ratio']:.5f}     {state['coordination']:.3f}         "
          f"{state['mean_stress'] / 1e3:.2f}             {state['unbalanced_force']:.1e}")
PYTHON
