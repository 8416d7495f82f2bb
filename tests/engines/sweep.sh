#!/bin/sh
# tests/engines/sweep.sh PROGRAM: the tasks of a sweep, run by GNU parallel and by Snakemake, end with the bits of a plain run and
# in one report, also after a task was stopped. Needs Debian's packages parallel and snakemake; ./test --long calls it.
set -eu
here=$(dirname "$(readlink -f "$0")")
program=$(readlink -f "$1")
# shellcheck source=tools/at_end.sh
. "$here/../../tools/at_end.sh"
folder=
trap 'end_attended; rm -rf "$folder"' EXIT
folder=$(mktemp -d)
cd "$folder"
cat >case.toml <<'EOT'
schema = 1
[soil.sand]
psd = { d = ["0.2 mm", "0.3 mm", "0.4 mm"], passing = ["0 %", "50 %", "100 %"] }
[study.s]
soil       = "sand"
particles  = 300
sweep      = { "stage.moved.steps" = [2_000, 4_000] }
replicates = 3
[[study.s.stage]]
name     = "cloud"
do       = "pack"
porosity = 0.62
[[study.s.stage]]
name        = "moved"
do          = "advance"
steps       = 2_000
strain_rate = ["1 1/s", "0 1/s", "0 1/s"]
EOT
hashes() { (cd "$1/studies" && find . -name stage.json -exec grep -H '"state_hash"' {} + | sort); }
same() {
    hashes "$1" >"$1.txt"
    [ "$(wc -l <whole.txt)" -eq 12 ] && diff whole.txt "$1.txt" && [ -e "$1/report.html" ] && "$program" verify "$1"
}
attended "$program" run case.toml -o whole --no-cache --quiet
hashes whole >whole.txt

run="a {folder} 'of' tasks" # names that Snakemake and shells could take for something else
"$program" sweep case.toml --emit parallel -o "$run" --no-cache --task-time 2s --quiet
[ "$(wc -l <"$run/tasks.txt")" -lt 6 ] || { echo "nothing was packed" >&2 && exit 1; }
attended parallel --will-cite -j 2 --arg-file "$run/tasks.txt" >said.txt 2>&1 || { cat said.txt >&2 && exit 1; }
"$program" sweep --collect "$run" --quiet
same "$run"
echo "GNU parallel $(parallel --version | sed -n '1s/.* //p'): 12 stages, the same bits, one report"
rm -r "$run"

# Tasks whose time is over at once leave no flag; Snakemake runs them again when they are written without a limit.
snake() { attended snakemake --snakefile "$run/sweep.smk" --cores 2 --keep-going >said.txt 2>&1; }
"$program" sweep case.toml --emit snakemake -o "$run" --no-cache --time-limit 1ns --quiet
! snake || { echo "Snakemake took tasks that are not done for done" >&2 && exit 1; }
"$program" sweep "$run" --emit snakemake --no-cache --quiet
snake || { cat said.txt "$run"/tasks/*.txt >&2 && exit 1; }
grep -q '6 of 6 samples done' "$run/tasks/gather.txt"
same "$run"
echo "Snakemake $(snakemake --version): 12 stages, the same bits, one report"
