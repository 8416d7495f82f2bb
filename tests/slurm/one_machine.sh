# shellcheck shell=sh disable=SC2154
# A Slurm of its own on this machine, from Debian's packages: munged, slurmctld and slurmd with their files in $folder, which
# the caller makes, on ports that nobody else uses. Needs root, as slurmd does. `start_slurm` and `stop_slurm`. An array has
# fewer tasks than $max_array_size.

slurm_pids=

start_slurm() {
    mkdir -p "$folder/spool" "$folder/state"
    chmod 755 "$folder"
    dd if=/dev/urandom of="$folder/munge.key" bs=1024 count=1 2>/dev/null
    chmod 400 "$folder/munge.key"
    # --force: the folder is root's, which munge does not expect.
    munged --foreground --force --key-file="$folder/munge.key" --socket="$folder/munge.socket" \
        --pid-file="$folder/munged.pid" --log-file="$folder/munged.log" --seed-file="$folder/munged.seed" 2>/dev/null &
    slurm_pids=$!
    host=$(hostname -s)
    cat >"$folder/slurm.conf" <<EOF
ClusterName=one
SlurmctldHost=$host
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket=$folder/munge.socket,cred_expire=5
CredType=cred/munge
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/slurmd.log
SlurmctldPort=$((20000 + $$ % 10000))
SlurmdPort=$((30000 + $$ % 10000))
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
MpiDefault=none
SwitchType=switch/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
ReturnToService=2
SchedulerParameters=batch_sched_delay=0,sched_interval=1
MinJobAge=3600
MaxArraySize=${max_array_size:-1001}
NodeName=$host NodeAddr=127.0.0.1 CPUs=$(nproc) RealMemory=$(awk '/MemTotal/ { print int($2 / 1100) }' /proc/meminfo) State=UNKNOWN
PartitionName=all Nodes=$host Default=YES MaxTime=INFINITE State=UP
EOF
    SLURM_CONF=$folder/slurm.conf
    export SLURM_CONF
    waited=0
    until [ -S "$folder/munge.socket" ]; do
        sleep 0.2
        waited=$((waited + 1))
        [ "$waited" -lt 150 ] || { cat "$folder/munged.log" >&2 && return 1; }
    done
    slurmctld -D 2>/dev/null &
    slurm_pids="$slurm_pids $!"
    slurmd -D 2>/dev/null &
    slurm_pids="$slurm_pids $!"
    waited=0
    until sinfo --noheader --states=idle --format=%D 2>/dev/null | grep -q 1; do
        sleep 0.5
        waited=$((waited + 1))
        [ "$waited" -lt 120 ] || { tail "$folder/slurmctld.log" "$folder/slurmd.log" >&2 && return 1; }
    done
}

# Jobs end first: a daemon that goes would leave the programs that it has started.
stop_slurm() {
    [ -n "$slurm_pids" ] || return 0
    scancel --full --signal=KILL --partition=all 2>/dev/null || :
    scancel --partition=all 2>/dev/null || :
    wait_for_jobs 30 2>/dev/null || :
    # shellcheck disable=SC2086
    kill $slurm_pids 2>/dev/null || :
    wait
}

# wait_for_jobs SECONDS: until none is pending or running.
wait_for_jobs() {
    waited=0
    while [ -n "$(squeue --noheader)" ]; do
        sleep 1
        waited=$((waited + 1))
        [ "$waited" -lt "$1" ] || { squeue >&2 && return 1; }
    done
}
