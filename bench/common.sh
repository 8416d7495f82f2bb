# shellcheck shell=sh disable=SC2034,SC2154
# Shared by run.sh and instructions.sh, which set `root`: a build folder of their own, so that ./run and ./test stay as they are.
offline=${offline:-no}
# shellcheck source=tools/bootstrap.sh
. "$root/tools/bootstrap.sh"
build=$root/build/benchmarks

# ready TARGET PACKAGES
ready() {
    target=$1
    shift
    lock
    # shellcheck disable=SC2086
    need_packages $build_packages libbenchmark-dev python3 "$@" || fail "some packages are missing"
    [ -e "$build/build.ninja" ] ||
        step "configure benchmarks" configure-benchmarks.log cmake -S "$root" -B "$build" -G Ninja \
            -DCMAKE_BUILD_TYPE=Release -DSUFFUSE_TESTS=OFF -DSUFFUSE_PYTHON=OFF -DSUFFUSE_BENCHMARKS=ON || fail "cannot configure"
    build_target "$target"
    unlock
}
