#!/bin/sh
# bench/record.sh [--build SECONDS]: measures the release build and adds a line a figure to bench/history.csv: ns a contact of a
# step, on one thread and on two, in both modes; seconds of a flow solution; medians of five. Takes a minute on a quiet machine;
# where other programs run, it says so and adds nothing. --build: also how long a build from nothing took (./test says it).
set -eu
root=$(cd "$(dirname "$(readlink -f "$0")")/.." && pwd)
offline=no
# shellcheck source=tools/bootstrap.sh
. "$root/tools/bootstrap.sh"

lock
# shellcheck disable=SC2086
need_packages $build_packages || fail "some packages are missing"
configure OFF
build_target suffuse
unlock
exec /usr/bin/python3 "$root/bench/record.py" "$build/apps/suffuse" "$@"
