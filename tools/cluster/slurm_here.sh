#!/usr/bin/env bash
# Starts a Slurm of one node on this machine, to try slurm.sh: tools/cluster/slurm_here.sh start|stop|restart-controller FOLDER. All of it
# lives in FOLDER, whose file `env` sets what the commands of Slurm need. Only root can start it.
set -euo pipefail
what=${1:?} folder=$(realpath -m "${2:?}")

controller() {
    slurmctld -f "$folder/slurm.conf" >>"$folder/log/slurmctld" 2>&1
    for _ in $(seq 100); do
        ! sinfo -h >/dev/null 2>&1 || return 0
        sleep 0.2
    done
    echo "slurm_here: the controller does not answer: see $folder/log/slurmctld" >&2
    return 1
}

end() {
    local pid
    pid=$(cat "$1" 2>/dev/null) || return 0
    kill "-${2:-TERM}" "$pid" 2>/dev/null || return 0
    for _ in $(seq 100); do
        kill -0 "$pid" 2>/dev/null || return 0
        sleep 0.1
    done
    kill -KILL "$pid" 2>/dev/null || true
}

start() {
    local tool host
    for tool in slurmctld slurmd munged sbatch; do
        command -v $tool >/dev/null || { echo "slurm_here: $tool is missing: apt-get install slurm-wlm munge" >&2; exit 1; }
    done
    [ "$(id -u)" = 0 ] || { echo "slurm_here: only root can start it" >&2; exit 1; }
    mkdir -p "$folder"/{log,state,spool,munge}
    chmod 700 "$folder/munge"
    dd if=/dev/urandom of="$folder/munge/key" bs=1024 count=1 status=none
    chmod 400 "$folder/munge/key"
    host=$(hostname -s)
    cat >"$folder/slurm.conf" <<CONF
ClusterName=here
SlurmctldHost=$host(127.0.0.1)
SlurmUser=root
SlurmctldPort=$((20000 + RANDOM % 10000))
SlurmdPort=$((30000 + RANDOM % 10000))
AuthType=auth/munge
AuthInfo=socket=$folder/munge/socket
CredType=cred/munge
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SchedulerType=sched/backfill
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
MpiDefault=none
ReturnToService=2
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
SlurmctldLogFile=$folder/log/slurmctld
SlurmdLogFile=$folder/log/slurmd
SlurmctldParameters=idle_on_node_suspend
SchedulerParameters=sched_interval=1,requeue_delay=0
JobRequeue=1
NodeName=$host NodeAddr=127.0.0.1 CPUs=$(nproc) RealMemory=1000 State=UNKNOWN
PartitionName=all Nodes=$host Default=YES MaxTime=INFINITE State=UP
CONF
    echo "export SLURM_CONF='$folder/slurm.conf'" >"$folder/env"
    export SLURM_CONF=$folder/slurm.conf
    munged --force --key-file="$folder/munge/key" --socket="$folder/munge/socket" --pid-file="$folder/munge/pid" \
        --log-file="$folder/log/munged" --seed-file="$folder/munge/seed" >"$folder/log/munged.start" 2>&1
    controller
    slurmd -f "$folder/slurm.conf" >>"$folder/log/slurmd" 2>&1
    for _ in $(seq 100); do
        [ "$(sinfo -h -o %t 2>/dev/null)" != idle ] || return 0
        sleep 0.2
    done
    echo "slurm_here: the node is not ready: $(sinfo -h 2>&1)" >&2
    return 1
}

case $what in
start) start ;;
stop)
    export SLURM_CONF=$folder/slurm.conf
    end "$folder/slurmd.pid"
    end "$folder/slurmctld.pid"
    end "$folder/munge/pid"
    ;;
# As when its machine dies: killed, and started anew.
restart-controller)
    export SLURM_CONF=$folder/slurm.conf
    end "$folder/slurmctld.pid" KILL
    controller
    ;;
*) echo "usage: tools/cluster/slurm_here.sh start|stop|restart-controller FOLDER" >&2 && exit 2 ;;
esac
