#!/bin/sh
# bench/peers/critical_state_yade.sh [SEED...]: installs Debian's Yade (about 2 GiB), then measures the critical state of
# dense and loose samples of 1,000 equal spheres of these seeds [1 to 8] under the conditions of
# validation/critical_state.py with friction 0.3, and prints the table. Four to five minutes of one core a sample; samples
# already in build/peers/critical_state_yade are not measured again.
set -eu
root=$(cd "$(dirname "$(readlink -f "$0")")/../.." && pwd)
# shellcheck source=bench/peers/common.sh
. "$root/bench/peers/common.sh"
need_packages yade || fail "the peer is missing: yade"
[ $# -gt 0 ] || set -- 1 2 3 4 5 6 7 8
samples=
for start in dense loose; do
    for seed in "$@"; do samples="$samples $start:$seed"; done
done
# shellcheck disable=SC2086
exec yade -n -x -j1 "$root/bench/peers/critical_state_yade.py" "$root/build/peers/critical_state_yade" $samples
