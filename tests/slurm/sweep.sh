#!/bin/sh
# tests/slurm/sweep.sh PROGRAM: a sweep of more samples than an array of Slurm may have ends with the bits of a plain run, and
# in one report. Before, its tasks met a time limit, were cancelled, put back by hand, and stopped as before the end of their
# time. Needs root and Debian's packages slurm-wlm and munge; ./test --long calls it.
set -eu
here=$(dirname "$(readlink -f "$0")")
program=$(readlink -f "$1")
# shellcheck source=tests/slurm/one_machine.sh
. "$here/one_machine.sh"
# shellcheck source=tools/at_end.sh
. "$here/../../tools/at_end.sh"
folder=
holder=none # of the gate
trap 'end_attended; kill "$holder" 2>/dev/null || :; stop_slurm; rm -rf "$folder"' EXIT
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
export max_array_size=4 # arrays of three tasks
start_slurm

fails() { echo "$*" >&2 && tail -n 30 array/tasks/* >&2 && exit 1; }
# until_true WHAT COMMAND...
until_true() {
    what=$1 waited=0
    shift
    until "$@"; do
        sleep 0.5
        waited=$((waited + 1))
        [ "$waited" -lt 1200 ] || fails "never seen: $what"
    done
}
submitted() { # prints the jobs that have tasks
    sh array/submit.sh >submitted.txt || return 1
    sed -n 's/.*: job //p' submitted.txt
}

# A time limit that is over at once: the tasks go back into the queue, again and again, and none has failed.
"$program" sweep case.toml --emit slurm -o array --no-cache --task-time 1s --time-limit 1ms --partition all --quiet
grep -q '^#SBATCH --array=1-3$' array/sweep.sbatch && grep -q '^#SBATCH --array=1-1$' array/sweep-2.sbatch
jobs=$(submitted)
again() { [ "$(cat array/tasks/1.txt array/tasks/2-1.txt 2>/dev/null | grep -c 'put back into the queue')" -ge 4 ]; }
until_true "two tasks that went on" again
if squeue --noheader --states=all --array --format=%T | grep -E 'FAILED|TIMEOUT'; then fails "a time limit was a failure"; fi
# shellcheck disable=SC2086
scancel $jobs
wait_for_jobs 600
grep -q '0 of 4 samples done' array/tasks/gather.txt || fails "nothing was gathered after the tasks had been cancelled"

# The rest without a limit. A gate holds a sample in its last stage: put back by hand there, then announced the end of its time.
"$program" sweep array --emit slurm --no-cache --task-time 1s --quiet
mkfifo gate
SUFFUSE_TEST_GATE="s/pressure=50kPa/rep=1/moved=$folder/gate" submitted >jobs.txt
job=$(head -n 1 jobs.txt)
hold() { # until the sample waits at the gate
    sleep 10000 >gate &
    holder=$!
    until_true "a sample at the gate" grep -q sleep "/proc/$holder/comm"
}
let_go() { # the next one waits at a new gate
    rm gate && mkfifo gate
    kill "$holder"
}
heard() { [ "$(grep -c 'the state is saved first' array/tasks/1.txt)" -ge "$1" ]; }
before=$(grep -c 'the state is saved first' array/tasks/1.txt || :)
hold
scontrol requeue "${job}_1"
until_true "the signal of a requeue" heard $((before + 1))
let_go
hold
scancel --batch --signal=USR1 "${job}_1"
until_true "the signal before the end" heard $((before + 2))
let_go
hold
let_go
wait_for_jobs 1200
restarts=$(scontrol show job "${job}_1" | sed -n 's/.*Restarts=\([0-9]*\).*/\1/p')
[ "$restarts" -eq 2 ] || fails "the task was put back $restarts times instead of twice"
grep -q '4 of 4 samples done' array/tasks/gather.txt || fails "not all was gathered"
hashes whole >whole.txt
hashes array >array.txt
[ "$(wc -l <whole.txt)" -eq 12 ] && diff whole.txt array.txt
"$program" verify array
[ -e array/report.html ] && echo "two arrays of Slurm $(sinfo --version | cut -d ' ' -f 2), with tasks put back: 12 stages, the same bits, one report"
