#!/bin/sh
# page/test.sh PAGE_DIR [TEST_PROGRAM]: opens reports and the studio in a real browser. PAGE_DIR is where page/build.sh works;
# TEST_PROGRAM (default: the release build's suffuse_report_test) writes the sample runs; screenshots and samples go to
# PAGE_DIR/samples. Needs Chromium. Exit code 77 where what is needed for it cannot be had here.
# SUFFUSE_PICTURES=docs/images makes the pictures of docs/tutorials/in-the-browser.md anew.
set -eu
[ $# -ge 1 ] && [ $# -le 2 ] || { sed -n '2,5s/^# //p' "$0" >&2; exit 2; }
here=$(dirname "$(readlink -f "$0")")
program=${2:-$here/../build/release/suffuse_report_test}
complain() { printf 'report test: %s\n' "$*" >&2; }
fail() { complain "$@" && exit 1; }
lack() { complain "$@" && exit 77; }

"$here/build.sh" --dev "$1" || { status=$? && complain "without its page there is nothing to open" && exit "$status"; }
page=$(readlink -f "$1")
browser=${SUFFUSE_CHROMIUM:-$(command -v chromium || command -v chromium-browser || true)}
[ -n "$browser" ] || lack "no Chromium found; install the package chromium, or name it in SUFFUSE_CHROMIUM"
[ -x "$program" ] || fail "$program is missing; build the tests first"

samples=$page/samples
rm -rf "$samples"
SUFFUSE_SAMPLE_FOLDER=$samples SUFFUSE_SAMPLE_PAGE=$page "$program" --gtest_filter='SampleRun.*' >"$page/samples.log" ||
    { cat "$page/samples.log" >&2 && fail "the sample runs could not be written"; }
suffuse=$(dirname "$(readlink -f "$program")")/apps/suffuse
[ -x "$suffuse" ] || fail "$suffuse is missing; build it first"
SUFFUSE_SAMPLES=$samples SUFFUSE_PAGE=$page SUFFUSE_CHROMIUM=$browser SUFFUSE_PROGRAM=$suffuse node --test "$here"/tests/*.test.mjs
