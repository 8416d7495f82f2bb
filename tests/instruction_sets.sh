#!/bin/sh
# tests/instruction_sets.sh PROGRAM: a packing settled and sheared for 1,600 steps with AVX-512 and with AVX2, in both modes, must
# end in the same bits; a flow through it must have the same numbers. Valgrind runs the program as on a processor without AVX-512.
# Part of ./test --long; exit code 77 without AVX-512.
set -eu
program=$(readlink -f "$1")
root=$(cd "$(dirname "$(readlink -f "$0")")/.." && pwd)
grep -qw avx512f /proc/cpuinfo || { echo "instruction sets: left out, this processor has no AVX-512" && exit 77; }

# shellcheck source=tools/at_end.sh
. "$root/tools/at_end.sh"
folder=
trap 'end_attended; rm -rf "$folder"' EXIT
folder=$(mktemp -d)

cd "$root"
packing="--packing tests/reference/packing2000.csv.gz --cell 0.0022778842740888983,0.002276097964427531,0.0022783912598474043"

# state MODE [COMMAND...]: sets `hash`, of the state that the packing ends in.
state() {
    mode=$1
    shift
    # shellcheck disable=SC2086 # four words
    attended "$@" "$program" bench step $packing --threads 1 --steps 100 --mode "$mode" >"$folder/out"
    hash=$(sed -n 's/^state_hash *//p' "$folder/out")
}

# flow [COMMAND...]: sets `hash`, of all numbers of a flow but seconds and memory. What its forces lack to their sum is rounding: it
# depends on the last bits of them all.
flow() {
    # shellcheck disable=SC2086
    attended "$@" "$program" bench flow $packing --threads 1 --json >"$folder/out"
    hash=$(sed '/"seconds"/,/}/d; /peak_bytes/d' "$folder/out" | sha256sum | cut -c1-16)
}

for what in "state reference" "state fast" flow; do
    $what
    wide=$hash
    $what valgrind --quiet --vgdb=no --tool=none
    narrow=$hash
    echo "$what: AVX-512 $wide, AVX2 $narrow"
    [ -n "$wide" ] && [ "$wide" = "$narrow" ] || exit 1
done
