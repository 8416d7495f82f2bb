#!/bin/sh
# bench/peers/step_vs_yade.sh [OPTION...]: installs Debian's Yade (about 2 GiB), then measures one time step of ours against
# one of Yade's: same settled packing of 10,000 grains, same law, slow shear, two threads, seven pairs of windows in turn.
# Options go to yade/compare.py: --at-least RATIO, --pairs N, --packing FILE.csv.gz, --program FILE, ...
set -eu
root=$(cd "$(dirname "$(readlink -f "$0")")/../.." && pwd)
offline=no
# shellcheck source=tools/bootstrap.sh
. "$root/tools/bootstrap.sh"

lock
# shellcheck disable=SC2086
need_packages $build_packages || fail "some packages are missing"
need_packages yade python3 || fail "Yade is missing"
configure OFF
build_target suffuse
unlock

exec /usr/bin/python3 "$root/bench/peers/yade/compare.py" --program "$build/apps/suffuse" \
    --packing "$root/tests/reference/packing10k.csv.gz" --output "$root/build/peers/step_vs_yade.csv" "$@"
