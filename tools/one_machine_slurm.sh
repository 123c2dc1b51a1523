#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# one_machine_slurm.sh start|stop FOLDER: a Slurm of this machine alone, for tests, with keys, sockets and
# ports of its own. Needs root, which a container gives, and the packages slurm-wlm and munge. SLURM_CONF of
# sbatch and squeue is FOLDER/slurm.conf. Exit status 77, with a line that says why, where it cannot run.
set -euo pipefail
action=${1-} folder=${2-}
[[ ($action == start || $action == stop) && -n $folder ]] || { sed -n '3,5p' "$0"; exit 2; }
skip() { printf 'skipped: %s\n' "$*" >&2; exit 77; }
PATH=$PATH:/usr/sbin

# A daemon that this folder started, by the number that it wrote.
stop_one() {
  local number
  number=$(cat "$folder/$1.pid" 2> /dev/null) || return 0
  kill "$number" 2> /dev/null || return 0
  for _ in $(seq 50); do kill -0 "$number" 2> /dev/null || return 0; sleep 0.1; done
  kill -9 "$number" 2> /dev/null || true
}
if [[ $action == stop ]]; then
  for daemon in slurmd slurmctld munged; do stop_one "$daemon"; done
  exit 0
fi

[[ $(id -u) == 0 ]] || skip "a Slurm of this machine alone needs root"
for program in munged slurmctld slurmd sbatch scontrol; do
  command -v "$program" > /dev/null || skip "$program is not there: apt-get install slurm-wlm munge"
done
free_port() {
  local port
  for _ in $(seq 100); do
    port=$((20000 + RANDOM % 20000))
    (exec 3<> "/dev/tcp/127.0.0.1/$port") 2> /dev/null || { echo "$port"; return; }
  done
  skip "no port is free"
}

mkdir -p "$folder"/{state,spool}
folder=$(cd "$folder" && pwd)
chmod 755 "$folder"
head -c 1024 /dev/urandom > "$folder/munge.key"
chmod 600 "$folder/munge.key"
munged --force --key-file="$folder/munge.key" --socket="$folder/munge.socket" \
  --pid-file="$folder/munged.pid" --log-file="$folder/munged.log" --seed-file="$folder/munge.seed" \
  2> "$folder/munged.err" ||
  skip "munged does not start: $(tail -1 "$folder/munged.err")"

cat > "$folder/slurm.conf" << END
ClusterName=one
SlurmctldHost=localhost(127.0.0.1)
SlurmctldPort=$(free_port)
SlurmdPort=$(free_port)
AuthType=auth/munge
CredType=cred/munge
AuthInfo=socket=$folder/munge.socket,cred_expire=5
SlurmUser=root
SlurmdUser=root
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SwitchType=switch/none
MpiDefault=none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=sched_interval=1,batch_sched_delay=0
ReturnToService=2
KillWait=2
MinJobAge=60
JobRequeue=1
NodeName=localhost NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN
PartitionName=all Nodes=localhost Default=YES MaxTime=INFINITE State=UP
END
export SLURM_CONF=$folder/slurm.conf
slurmctld 2> "$folder/slurmctld.err" || skip "slurmctld does not start: $(tail -1 "$folder/slurmctld.err")"
sleep 1
slurmd -N localhost 2> "$folder/slurmd.err" || skip "slurmd does not start: $(tail -1 "$folder/slurmd.err")"
for _ in $(seq 60); do
  [[ $(sinfo -h -o %t 2> /dev/null) == idle ]] && exit 0
  sleep 0.5
done
"$0" stop "$folder"
skip "the node does not come up: $(tail -1 "$folder/slurmd.log")"
