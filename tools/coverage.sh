#!/bin/sh
# tools/coverage.sh MODULE...   which lines of these modules their own unit tests run (gcovr; Debian: gcovr)
set -eu
root=$(dirname "$(dirname "$(readlink -f "$0")")")
build=$root/build/coverage
if [ $# -eq 0 ]; then
    sed -n '2s/^# //p' "$0" >&2
    exit 2
fi
command -v gcovr >/dev/null || { echo "gcovr is missing (Debian: gcovr)" >&2 && exit 77; }
cd "$root"
cmake --preset coverage >/dev/null
find "$build" -name '*.gcda' -delete # counts of an earlier run would be added to
for module in "$@"; do
    cmake --build "$build" --target "suffuse_${module}_test"
    "$build/suffuse_${module}_test" --gtest_brief=1
    gcovr --root "$root" --filter "suffuse/$module/" --exclude '.*\.(test|bench)\.cpp' --sort-uncovered "$build"
done
