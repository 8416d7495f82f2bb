#!/bin/sh
# bench/instructions.sh [--write]: counts the instructions of a contact step, a grain step and an iteration of the flow solver
# with callgrind and compares them with bench/instructions.json, within 1 %; --write makes that file. Part of ./test --long.
set -eu
root=$(cd "$(dirname "$(readlink -f "$0")")/.." && pwd)
# shellcheck source=bench/common.sh
. "$root/bench/common.sh"
# shellcheck source=tools/at_end.sh
. "$root/tools/at_end.sh"
trap end_attended EXIT
attended_by=TERM
ready suffuse_count valgrind

status=0
attended /usr/bin/python3 "$root/bench/instructions.py" "$build" "$@" || status=$?
[ "$status" -eq 77 ] || exit "$status" # 77: skipped, and it said why
