#!/bin/sh
# bench/peers/prepare_vs_yade.sh [OPTION...]: installs Debian's Yade (about 2 GiB), then measures our preparation of 10,000
# grains at 100 kPa (bench/peers/prepare.toml) against the 40,911 steps that the reference's packing took with Yade.
# Options go to prepare.py: --set KEY=VALUE, --pairs N, --at-least RATIO, --program FILE, ...
set -eu
root=$(cd "$(dirname "$(readlink -f "$0")")/../.." && pwd)
# shellcheck source=bench/peers/common.sh
. "$root/bench/peers/common.sh"
ready yade
compare prepare yade "$@"
