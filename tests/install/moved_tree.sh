#!/bin/sh
# tests/install/moved_tree.sh BUILD PYTHON: installs a build, moves the tree elsewhere, and uses it there: a project in C++
# finds and links it, a script imports it, the program runs a case. All three have the same permeability of one packing, and
# the program and the script find the report's page where there is one.
set -eu
build=$1 python=$2
here=$(dirname "$(readlink -f "$0")")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
fail() { echo "$*" >&2 && exit 1; }

cmake --install "$build" --prefix "$folder/first" >"$folder/log" 2>&1 || { cat "$folder/log" >&2 && fail "cannot install"; }
tree=$folder/moved/elsewhere
mkdir "$folder/moved" && mv "$folder/first" "$tree"
if grep -rlI "$folder" "$tree"; then fail "these files hold the place where they were installed"; fi

cmake -S "$here/consumer" -B "$folder/consumer" -G Ninja -DCMAKE_PREFIX_PATH="$tree" >"$folder/log" 2>&1 &&
    cmake --build "$folder/consumer" >>"$folder/log" 2>&1 || { cat "$folder/log" >&2 && fail "a project cannot use it"; }
packing=$tree/share/doc/suffuse/examples/replay/packing.csv
compiled=$("$folder/consumer/seep" "$packing" 1.436e-3)

PYTHONPATH=$tree/lib/python3/dist-packages PYTHONDONTWRITEBYTECODE=1 "$python" - "$packing" >"$folder/script" <<'END'
import sys

import suffuse
from suffuse.run import page_folder

water = suffuse.seep(suffuse.read_packing(sys.argv[1], cell=(1.436e-3,) * 3), gradient=0.05)
print(f"suffuse {suffuse.__version__}: {water.permeability:.4e} m2")
print(page_folder())
END
[ "$compiled" = "$(head -n 1 "$folder/script")" ] || fail "C++ has $compiled, Python $(head -n 1 "$folder/script")"

program=$tree/bin/suffuse
(cd "$folder" && "$program" new copy --from replay && "$program" run copy/case.toml --no-cache -o run) >"$folder/log" 2>&1 ||
    { cat "$folder/log" >&2 && fail "the program cannot run a case of its own"; }
page=$tree/share/suffuse/report-page
if [ -d "$page" ]; then
    [ "$(tail -n 1 "$folder/script")" = "$page" ] || fail "the script finds the page at $(tail -n 1 "$folder/script")"
    grep -qF "$(cat "$page/page.js.sha256")" "$folder/run/report.html" || fail "the report has not the page's script"
    "$python" -B "$here/../studio/test_studio.py" "$program" Soils.test_the_criteria_are_those_of_assess >"$folder/log" 2>&1 ||
        { cat "$folder/log" >&2 && fail "the studio does not answer"; }
fi
"$program" completions bash | cmp -s - "$tree/share/bash-completion/completions/suffuse" || fail "the completions are not the program's"
"$program" man | cmp -s - "$tree/share/man/man1/suffuse.1" || fail "the manual page is not the program's"
