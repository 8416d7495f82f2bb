# shellcheck shell=sh disable=SC2034,SC2154
# Shared by ./run and ./test: fetch what is missing with the system's package manager, configure, build. The caller sets
# `root` (the checkout) and `offline`. Only standard error is written, so that a program's output stays clean.
# A second call finds its stamps, asks ninja once and is through in a tenth of a second.

build=$root/build/release
logs=$root/build/logs
build_packages="ccache g++ cmake ninja-build git libcgal-dev libgmp-dev libmpfr-dev libhdf5-dev libtomlplusplus-dev
    libcli11-dev libcpp-httplib-dev nlohmann-json3-dev libfmt-dev libfftw3-dev zlib1g-dev libssl-dev libeigen3-dev pybind11-dev python3-dev
    python3-numpy librsvg2-bin fonts-liberation"
# Shells, groff and poppler check what the program writes for them.
test_packages="libgtest-dev librapidcheck-dev clang clang-format clang-tidy chromium fonts-dejavu-core
    python3-pytest python3-venv python3-pandas python3-xarray zsh fish groff-base poppler-utils"
site_packages="python3-sphinx python3-myst-parser"
fuzz_packages="libclang-rt-14-dev"

mkdir -p "$logs"
# ccache, npm and Chromium want a home; a container may have none.
[ -n "${HOME:-}" ] || { HOME=$root/build/home && mkdir -p "$HOME" && export HOME; }

say() { printf 'suffuse: %s\n' "$*" >&2; }
fail() { say "$@"; exit 70; }
have() { command -v "$1" >/dev/null 2>&1; }

# One job a core, but no more than gigabytes of memory, of the machine or of the container: the largest file takes one.
count_jobs() {
    kilobytes=$(sed -n 's/^MemTotal: *\([0-9]*\) kB$/\1/p' /proc/meminfo 2>/dev/null)
    limit=$(cat /sys/fs/cgroup/memory.max 2>/dev/null || echo max)
    case $limit in *[!0-9]* | '') ;; *) [ $((limit / 1000)) -ge "${kilobytes:-0}" ] || kilobytes=$((limit / 1000)) ;; esac
    cores=$(nproc 2>/dev/null || echo 2)
    gigabytes=$((${kilobytes:-2000000} / 1000000))
    [ "$gigabytes" -ge 1 ] || gigabytes=1
    if [ "$cores" -lt "$gigabytes" ]; then echo "$cores"; else echo "$gigabytes"; fi
}
jobs=${SUFFUSE_JOBS:-$(count_jobs)}
# What presets build and test as well.
export CMAKE_BUILD_PARALLEL_LEVEL="$jobs" CTEST_PARALLEL_LEVEL="$jobs"

# watch TEXT LOG: while a command writes LOG, tell that it is under way and how far it is: in place on a terminal, else in a
# line every half minute. A command of less than a second is not shown.
watch() {
    watch_begin=$(date +%s) told=-30
    while sleep 1 >/dev/null 2>&1 && kill -0 $$ 2>/dev/null; do
        seconds=$(($(date +%s) - watch_begin))
        done_of=$(tail -n 1 "$2" 2>/dev/null | sed -n 's/^\[\([0-9]*\)\/\([0-9]*\)\] .*/, \1 of \2/p')
        if [ -t 2 ]; then
            printf '\r\033[Ksuffuse: %s ...%s, %d s' "$1" "$done_of" "$seconds" >&2
        elif [ $((seconds - told)) -ge 30 ]; then
            told=$seconds
            say "$1 ...$done_of, $seconds s"
        fi
    done
}

# step TEXT LOG COMMAND...: watched, one line with the seconds at its end; where the command fails, what its log says of it
# and its status. A step of less than two seconds that goes well says nothing.
step() {
    text=$1 log=$logs/$2 begin=$(date +%s) status=0
    shift 2
    : >"$log"
    watch "$text" "$log" &
    watcher=$!
    "$@" >"$log" 2>&1 </dev/null || status=$?
    kill "$watcher" 2>/dev/null || :
    wait "$watcher" 2>/dev/null || :
    [ ! -t 2 ] || printf '\r\033[K' >&2
    seconds=$(($(date +%s) - begin))
    if [ "$status" -ne 0 ]; then
        grep -v '^\[[0-9]*/[0-9]*\] [BL]' "$log" | tail -n 60 >&2
        say "$text: failed ($seconds s), all of it in $log"
    elif [ "$seconds" -ge 2 ]; then
        say "$text: $seconds s"
    fi
    return "$status"
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
            say "packages to fetch: $*"
            step "fetch $# packages" packages.log install_packages "$@" || return 1
        fi
    else
        say "no dpkg here; taken to be installed: $*"
    fi
    : >"$stamp"
}

# configure ON|OFF: with or without tests. Tests, once requested, stay configured, so that ./run and ./test share one tree.
configure() {
    [ -e "$build/build.ninja" ] && { [ "$1" = OFF ] || grep -q '^SUFFUSE_TESTS:BOOL=ON' "$build/CMakeCache.txt"; } && return
    (cd "$root" && step configure configure.log cmake --preset release -DSUFFUSE_QUICK_BUILD=ON -DSUFFUSE_TESTS="$1") || fail "cannot configure"
}

# build_target NAMES: silent when there is nothing to do.
build_target() {
    text=build
    [ -x "$build/apps/suffuse" ] || text="first build, $jobs at a time, some minutes"
    step "$text" build.log ninja -C "$build" -j "$jobs" "$@" || fail "the build failed"
}

# The report's page is optional: without it, reports are plain, and each call says so. It is rebuilt when a source of it
# is newer than its stamp; the stamp of a failure holds the line to say.
build_report_page() {
    [ -x "$root/page/build.sh" ] || return 0
    page_stamp=$root/build/report-page.stamp
    if [ -e "$page_stamp" ]; then
        newer=$(find "$root/page" -name node_modules -prune -o -type f -newer "$page_stamp" -print | head -n 1)
        [ -n "$newer" ] || { cat "$page_stamp" >&2 && return 0; }
    fi
    if ! { have npm && have node && [ "$(node -p 'parseInt(process.versions.node)')" -ge 18 ]; }; then
        need_packages nodejs npm || { say "no node (18 or newer) and npm: the report will be plain"; return 0; }
    fi
    [ "$offline" = no ] || { say "--offline leaves out the report's page, which npm builds: the report will be plain"; return 0; }
    if step "report page" report-page.log "$root/page/build.sh" "$root/build/report-page"; then
        : >"$page_stamp"
    else
        say "the report will be plain; to try again: rm $page_stamp" 2>"$page_stamp"
        cat "$page_stamp" >&2
    fi
}
