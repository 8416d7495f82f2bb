# shellcheck shell=sh disable=SC2034,SC2154
# Shared by ./run and ./test: fetch what is missing with the system's package manager, configure, build. The caller sets
# `root` (the checkout) and `offline`. Only standard error is written, so that a program's output stays clean.
# A second call finds its stamps, asks ninja once and is through in a tenth of a second.

build=$root/build/release
logs=$root/build/logs
jobs=${SUFFUSE_JOBS:-2}
build_packages="g++ cmake ninja-build libcgal-dev libgmp-dev libmpfr-dev libhdf5-dev libtomlplusplus-dev
    libcli11-dev nlohmann-json3-dev libfmt-dev libfftw3-dev zlib1g-dev libssl-dev pybind11-dev python3-dev python3-numpy"
test_packages="libeigen3-dev libgtest-dev librapidcheck-dev libbenchmark-dev voro++-dev clang-format chromium fonts-dejavu-core python3-pytest"
fuzz_packages="clang libclang-rt-14-dev"

mkdir -p "$logs"
# ccache, npm and Chromium want a home; a container may have none.
[ -n "${HOME:-}" ] || { HOME=$root/build/home && mkdir -p "$HOME" && export HOME; }

say() { printf 'suffuse: %s\n' "$*" >&2; }
fail() { say "$@"; exit 70; }
have() { command -v "$1" >/dev/null 2>&1; }

# step TEXT LOG COMMAND...: one line with the seconds; where the command fails, the end of its log and its status.
step() {
    text=$1 log=$logs/$2 begin=$(date +%s)
    shift 2
    [ ! -t 2 ] || printf 'suffuse: %s ...\r' "$text" >&2
    "$@" >"$log" 2>&1 </dev/null || {
        status=$?
        tail -n 40 "$log" >&2
        say "$text: failed ($(($(date +%s) - begin)) s), all of it in $log"
        return "$status"
    }
    say "$text: $(($(date +%s) - begin)) s"
}

# Two first calls at once (array jobs of a cluster) must not build over each other.
lock() { if have flock; then exec 9>"$root/build/.lock" && flock 9; fi; }
unlock() { if have flock; then exec 9>&-; fi; }

as_root() {
    if [ "$(id -u)" -eq 0 ]; then "$@"; else sudo "$@"; fi
}

install_packages() {
    as_root apt-get update &&
        as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends "$@"
}

# need_packages NAMES: true when all are there, now or after installing them. A stamp remembers what was found.
need_packages() {
    stamp=$root/build/packages-$(printf '%s' "$*" | cksum | cut -d ' ' -f 1).stamp
    [ -e "$stamp" ] && return 0
    if have dpkg-query; then
        missing=
        for package in "$@"; do
            case $(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null) in
            installed*) ;;
            *) missing="$missing $package" ;;
            esac
        done
        # shellcheck disable=SC2086
        set -- $missing
        if [ $# -gt 0 ]; then
            line="apt-get update && apt-get install -y --no-install-recommends $*"
            [ "$offline" = no ] || { say "missing, and --offline forbids to fetch: $*"; return 1; }
            have apt-get || { say "no apt-get here; please install by other means: $*"; return 1; }
            [ "$(id -u)" -eq 0 ] || have sudo || { say "neither root nor sudo; as root, run:  $line"; return 1; }
            step "fetch $# packages ($*)" packages.log install_packages "$@" || return 1
        fi
    else
        say "no dpkg here; taken to be installed: $*"
    fi
    : >"$stamp"
}

# configure ON|OFF: with or without tests. Tests, once asked for, stay configured, so that ./run and ./test share one tree.
configure() {
    [ -e "$build/build.ninja" ] && { [ "$1" = OFF ] || grep -q '^SUFFUSE_TESTS:BOOL=ON' "$build/CMakeCache.txt"; } && return
    (cd "$root" && step configure configure.log cmake --preset release -DSUFFUSE_UNITY=ON -DSUFFUSE_TESTS="$1") || fail "cannot configure"
}

# build_target NAMES: progress on a terminal for the first, long build; silence when there is nothing to do.
build_target() {
    begin=$(date +%s)
    if [ -t 2 ] && [ ! -x "$build/apps/suffuse" ]; then
        say "building with $jobs jobs; the first time takes some minutes"
        ninja -C "$build" -j "$jobs" "$@" >&2 </dev/null || fail "the build failed"
    else
        ninja -C "$build" -j "$jobs" "$@" >"$logs/build.log" 2>&1 </dev/null ||
            { grep -v '^\[[0-9]*/[0-9]*\] [BL]' "$logs/build.log" | tail -n 60 >&2; fail "the build failed: $logs/build.log"; }
    fi
    seconds=$(($(date +%s) - begin))
    [ "$seconds" -lt 2 ] || say "build: $seconds s"
}

# The report's page is optional: without it, reports are plain, and each call says so. It is rebuilt when a source of it
# is newer than its stamp; the stamp of a failure holds the line to say.
build_report_page() {
    [ -x "$root/report/build.sh" ] || return 0
    page_stamp=$root/build/report-page.stamp
    if [ -e "$page_stamp" ]; then
        newer=$(find "$root/report" -name node_modules -prune -o -type f -newer "$page_stamp" -print | head -n 1)
        [ -n "$newer" ] || { cat "$page_stamp" >&2 && return 0; }
    fi
    if ! { have npm && have node && [ "$(node -p 'parseInt(process.versions.node)')" -ge 18 ]; }; then
        need_packages nodejs npm || { say "no node (18 or newer) and npm: the report will be plain"; return 0; }
    fi
    [ "$offline" = no ] || { say "--offline leaves out the report's page, which npm builds: the report will be plain"; return 0; }
    if step "report page" report-page.log "$root/report/build.sh" "$root/build/report-page"; then
        : >"$page_stamp"
    else
        say "the report will be plain; to try again: rm $page_stamp" 2>"$page_stamp"
        cat "$page_stamp" >&2
    fi
}
