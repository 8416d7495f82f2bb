#!/bin/sh
# tools/paper_figures.sh PROGRAM ROOT [--preset NAME] [-o DIR] [--plan]: Figures 1 to 14 of the paper in one folder, DIR (paper):
# 1 to 6 from examples/silty-sand-2016/case.toml, 7 to 14 from examples/fontainebleau-2016/case.toml, and index.html, which
# shows them in the paper's order. It first says what the runs cost; with --plan no more than that. A second call goes on
# where the first one stopped. ./run --paper calls it.
set -eu
[ $# -ge 2 ] || { sed -n '2,6s/^# //p' "$0" >&2; exit 2; }
program=$1 root=$2 folder=paper preset= plan=no
shift 2
while [ $# -gt 0 ]; do
    case $1 in
    --preset) [ $# -ge 2 ] || { echo "run: --preset wants a name, such as quick" >&2; exit 2; } && preset=$2 && shift 2 ;;
    -o) [ $# -ge 2 ] || { echo "run: -o wants a folder" >&2; exit 2; } && folder=$2 && shift 2 ;;
    --plan) plan=yes && shift ;;
    -h | --help) echo "run --paper [--preset NAME] [-o DIR] [--plan]: Figures 1 to 14 of the paper in one folder; --plan: the price" && exit 0 ;;
    *) echo "run --paper: $1 is not known; --preset NAME, -o DIR and --plan are" >&2 && exit 2 ;;
    esac
done
mixtures=$root/examples/silty-sand-2016/case.toml
erosion=$root/examples/fontainebleau-2016/case.toml
set -- ${preset:+--preset "$preset"}
echo "== what Figures 1 to 6 cost" >&2
"$program" plan "$mixtures" "$@" >&2
echo "== what Figures 7 to 14 cost" >&2
"$program" plan "$erosion" "$@" >&2
[ "$plan" = no ] || exit 0
mkdir -p "$folder"

# A run that ends with flaws has its figures; one that stopped or failed has not.
run_of() { # CASE FOLDER WORDS...
    run_case=$1 run_folder=$2 status=0
    shift 2
    "$program" run "$run_case" -o "$run_folder" "$@" >&2 || status=$?
    [ "$status" -eq 0 ] || [ "$status" -eq 4 ] || exit "$status"
}
run_of "$mixtures" "$folder/mixtures" "$@"
run_of "$erosion" "$folder/erosion" "$@"

"$program" figures "$folder/mixtures" --figure 1,2,3,4,5,6 -o "$folder" >/dev/null
"$program" figures "$folder/erosion" --figure 7,8,9,10,11,12,13,14 -o "$folder" >/dev/null

{
    printf '<!doctype html>\n<html lang="en"><meta charset="utf-8"><title>Figures 1 to 14</title>\n'
    printf '<style>body{font:16px/1.5 sans-serif;max-width:60rem;margin:2rem auto;padding:0 1rem}img{max-width:100%%}</style>\n'
    printf '<h1>Figures 1 to 14, in the order of the paper</h1>\n'
    for number in 01 02 03 04 05 06 07 08 09 10 11 12 13 14; do
        run=erosion
        [ "$number" -gt 6 ] || run=mixtures
        printf '<figure><img src="fig%s.svg" alt="Figure %s"><figcaption>Figure %d. <a href="%s/report.html">Report</a>, ' \
            "$number" "$number" "$((1$number - 100))" "$run"
        printf '<a href="%s/figures/fig%s.csv">numbers</a></figcaption></figure>\n' "$run" "$number"
    done
} >"$folder/index.html"
echo "$folder/index.html"
