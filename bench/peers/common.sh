# shellcheck shell=sh disable=SC2034,SC2154
# Shared by the comparisons with peers. The caller sets `root`; options that follow the script's own are Python's.
offline=no
# shellcheck source=tools/bootstrap.sh
. "$root/tools/bootstrap.sh"

# ready PACKAGES: our program is built and the peer installed.
ready() {
    lock
    # shellcheck disable=SC2086
    need_packages $build_packages || fail "some packages are missing"
    need_packages python3 "$@" || fail "the peer is missing: $*"
    configure OFF
    build_target suffuse
    unlock
}

# compare SCRIPT PEER OPTION...: the packing, the program and the place of the result are the same for all.
compare() {
    script=$1 peer=$2
    shift 2
    exec /usr/bin/python3 "$root/bench/peers/$script.py" --peer "$peer" --program "$build/apps/suffuse" \
        --packing "$root/tests/reference/packing10k.csv.gz" --output "$root/build/peers/${script}_vs_$peer.csv" "$@"
}
