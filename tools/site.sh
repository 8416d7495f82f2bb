#!/bin/sh
# tools/site.sh [OUT]: the documentation as pages with a search that needs no network: OUT/index.html, build/site by default.
# Pages are made from the Markdown of this checkout and from what the Python module says of itself. A link to nothing and a
# page that nothing leads to are errors. --offline before OUT refuses to fetch packages.
set -eu
root=$(dirname "$(dirname "$(readlink -f "$0")")")
offline=no
case ${1:-} in
--offline) offline=yes && shift ;;
-h | --help) sed -n '2,4s/^# //p' "$0" && exit 0 ;;
-*) sed -n '2,4s/^# //p' "$0" >&2 && exit 2 ;;
esac
# shellcheck source=tools/bootstrap.sh
. "$root/tools/bootstrap.sh"
out=${1:-$root/build/site}
source=$root/build/site-source

lock
# shellcheck disable=SC2086
need_packages $build_packages $site_packages || fail "some packages are missing"
configure OFF
build_target suffuse_python_package
unlock

# Other files lie there, too, or nothing could point to them.
rm -rf "$source" && mkdir -p "$source"
(cd "$root" && git ls-files -z -co --exclude-standard -- '*.md' ':!tools' 'docs/*' 'validation/*.svg' 'examples/*.svg' CITATION.cff tests/reference/planned_runs.csv |
    tar -c --null -T - | tar -x -C "$source")
cp "$root"/tools/site/* "$source"
PYTHONPATH=$build/python PYTHONDONTWRITEBYTECODE=1 /usr/bin/python3 "$source/python_reference.py" >"$source/python.md" ||
    fail "the Python module does not say what it can"
step "pages" site.log /usr/bin/python3 -m sphinx -b html -W --keep-going -q -d "$root/build/site-doctrees" "$source" "$out" ||
    fail "the pages have errors"
say "documentation: $out/index.html"
