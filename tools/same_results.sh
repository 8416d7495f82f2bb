#!/bin/sh
# tools/same_results.sh BEFORE AFTER [OPTION...]: whether two builds of the program give the same results, to the bit. Runs the
# quick presets of all examples, every verb and the Python module with both, side by side, and compares every file that they
# leave: numbers, keys, codes and hashes, but not times, versions and texts for people (tools/same_results/masks.py).
# BEFORE and AFTER: a build folder, a checkout with build/release, or a revision of git, which is checked out and built in
# build/same-results and stays there. --texts compares texts, too: for a change that should alter no word. --help has all options.
# Exit code 0: the same; 1: not; 2: wrong use. Three minutes on two cores, of builds that are there.
set -eu
root=$(cd "$(dirname "$(readlink -f "$0")")/.." && pwd)

# build_of GIVEN: a folder as it is; a revision is checked out and built.
build_of() {
    [ ! -d "$1" ] || { printf '%s\n' "$1" && return; }
    commit=$(git -C "$root" rev-parse --verify --quiet "$1^{commit}") ||
        { echo "tools/same_results.sh: $1 is neither a folder nor a revision" >&2 && exit 2; }
    tree=$root/build/same-results/$commit
    [ -d "$tree" ] || { git -C "$root" worktree prune && git -C "$root" worktree add --quiet --detach "$tree" "$commit"; } >&2
    [ -e "$tree/build/release/build.ninja" ] ||
        (cd "$tree" && cmake --preset release -DSUFFUSE_QUICK_BUILD=ON -DSUFFUSE_TESTS=OFF) >&2
    ninja -C "$tree/build/release" -j "${SUFFUSE_JOBS:-2}" suffuse suffuse_python_package >&2
    printf '%s\n' "$tree"
}

case ${1:-} in
-*) exec /usr/bin/python3 -B "$root/tools/same_results" "$@" ;;
esac
[ $# -ge 2 ] || { sed -n '2,8s/^# //p' "$0" >&2 && exit 2; }
before=$(build_of "$1")
after=$(build_of "$2")
shift 2
exec /usr/bin/python3 -B "$root/tools/same_results" "$before" "$after" "$@"
