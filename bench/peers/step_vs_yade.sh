#!/bin/sh
# bench/peers/step_vs_yade.sh [OPTION...]: installs Debian's Yade (about 2 GiB), then measures one time step of ours against
# one of Yade's: same settled packing of 10,000 grains, same law, slow shear, two threads, seven pairs of windows in turn.
# Options go to step.py: --at-least RATIO, --pairs N, --packing FILE.csv.gz, --program FILE, ...
set -eu
root=$(cd "$(dirname "$(readlink -f "$0")")/../.." && pwd)
# shellcheck source=bench/peers/common.sh
. "$root/bench/peers/common.sh"
ready yade
compare step yade "$@"
