#!/bin/sh
# tests/instruction_sets.sh PROGRAM: a packing settled and sheared for 1,600 steps with AVX-512 and with AVX2, in both modes, must
# end in the same bits. Valgrind runs the program as on a processor without AVX-512. Part of ./test --long; exit code 77 without AVX-512.
set -eu
program=$1
root=$(cd "$(dirname "$(readlink -f "$0")")/.." && pwd)
grep -qw avx512f /proc/cpuinfo || { echo "instruction sets: left out, this processor has no AVX-512" && exit 77; }

# shellcheck source=tools/at_end.sh
. "$root/tools/at_end.sh"
folder=
trap 'end_attended; rm -rf "$folder"' EXIT
folder=$(mktemp -d)

# state MODE [COMMAND...]: sets `hash`, of the state that the packing ends in.
state() {
    mode=$1
    shift
    attended "$@" "$program" bench step --packing "$root/tests/reference/packing2000.csv.gz" \
        --cell 0.0022778842740888983,0.002276097964427531,0.0022783912598474043 --threads 1 --steps 100 --mode "$mode" >"$folder/out"
    hash=$(sed -n 's/^state_hash *//p' "$folder/out")
}

for mode in reference fast; do
    state "$mode"
    wide=$hash
    state "$mode" valgrind --quiet --vgdb=no --tool=none
    narrow=$hash
    echo "$mode: AVX-512 $wide, AVX2 $narrow"
    [ -n "$wide" ] && [ "$wide" = "$narrow" ] || exit 1
done
