#!/bin/sh
# tests/memcheck.sh PROGRAM: a run of every kind of stage, its report and its check under valgrind's memcheck. Whatever reads
# memory that was never written or is not its own, or forgets what it took, is an error: none is let pass. Needs valgrind (77
# where it is missing). Valgrind shows the program a processor without AVX-512.
set -eu
program=$(readlink -f "$1")
root=$(cd "$(dirname "$(readlink -f "$0")")/.." && pwd)
command -v valgrind >/dev/null || { echo "memcheck: valgrind is missing (Debian: valgrind)" >&2 && exit 77; }

# shellcheck source=tools/at_end.sh
. "$root/tools/at_end.sh"
folder=
trap 'end_attended; rm -rf "$folder"' EXIT
folder=$(mktemp -d)
sed '/^sweep /d' "$root/tests/crash/case.toml" >"$folder/case.toml" # one sample is enough

# check WORDS...: the program with these, and what memcheck says of it. Threads of the program live until its end, as does what
# libraries keep; only what nobody can reach any more is a leak.
check() {
    status=0
    attended valgrind --quiet --vgdb=no --error-exitcode=99 --leak-check=full --show-leak-kinds=definite --errors-for-leak-kinds=definite \
        --num-callers=30 "$program" "$@" >"$folder/out" 2>&1 || status=$?
    if [ $status -ne 0 ] || grep -q '^==[0-9]*== ' "$folder/out"; then
        cat "$folder/out"
        echo "memcheck: $*: ends with $status"
        exit 1
    fi
}

check run "$folder/case.toml" -o "$folder/run" --no-cache -j 2
check verify "$folder/run"
check resume "$folder/run" --no-cache
check report "$folder/run"
check export "$folder/run/studies/small/sheared" -o "$folder/grains.vtp"
check assess "$root/examples/fontainebleau-2016/data/fontainebleau.csv"
echo "memcheck: run, verify, resume, report, export and assess without an error"
