#!/bin/sh
# tests/slurm/sweep.sh PROGRAM: a sweep as a job array of a real Slurm on this machine ends with the bits of a plain run, also
# after its tasks were stopped half-way. Needs root and Debian's packages slurm-wlm and munge; ./test --long calls it.
set -eu
here=$(dirname "$(readlink -f "$0")")
program=$(readlink -f "$1")
# shellcheck source=tests/slurm/one_machine.sh
. "$here/one_machine.sh"
# shellcheck source=tools/at_end.sh
. "$here/../../tools/at_end.sh"
folder=
trap 'end_attended; stop_slurm; rm -rf "$folder"' EXIT
folder=$(mktemp -d)

cat >"$folder/case.toml" <<'EOF'
schema = 1
[soil.sand]
psd = { d = ["0.2 mm", "0.3 mm", "0.4 mm"], passing = ["0 %", "50 %", "100 %"] }
[study.s]
soil       = "sand"
particles  = 300
sweep      = { "stage.state.pressure" = ["50 kPa", "100 kPa"] }
replicates = 2
[[study.s.stage]]
name     = "cloud"
do       = "pack"
porosity = 0.62
[[study.s.stage]]
name     = "state"
do       = "compact"
pressure = "100 kPa"
[[study.s.stage]]
name        = "moved"
do          = "advance"
steps       = 50_000
strain_rate = ["1 1/s", "0 1/s", "0 1/s"]
EOF
cd "$folder"

hashes() { (cd "$1/studies" && find . -name stage.json -exec grep -H '"state_hash"' {} + | sort); }

attended "$program" run case.toml -o whole --no-cache --quiet
"$program" sweep case.toml --emit slurm -o array --no-cache --quiet
start_slurm
job=$(sbatch --parsable array/sweep.sbatch)

# Stopped as Slurm stops what runs too long: SIGTERM to the batch script, which is the program.
waited=0
until [ -n "$(find array/studies -name moved 2>/dev/null)" ]; do
    sleep 0.5
    waited=$((waited + 1))
    [ "$waited" -lt 1200 ] || { cat array/tasks/* >&2 && exit 1; }
done
scancel --state=PENDING "$job" || :
for task in $(squeue --noheader --states=running --array --format=%i); do
    scancel --batch --signal=TERM "$task" || :
done
wait_for_jobs 600
code=0
"$program" sweep --collect array || code=$?
[ "$code" -eq 75 ] || { echo "collecting a stopped array ended with $code instead of 75" >&2 && cat array/tasks/* >&2 && exit 1; }

"$program" sweep array --emit slurm
sbatch array/sweep.sbatch
wait_for_jobs 1200
"$program" sweep --collect array || { cat array/tasks/* >&2 && exit 1; }
hashes whole >whole.txt
hashes array >array.txt
[ "$(wc -l <whole.txt)" -eq 12 ] && diff whole.txt array.txt
[ -e array/report.html ] && echo "a job array of Slurm $(sinfo --version | cut -d ' ' -f 2), stopped and gone on: 12 stages, the same bits"
