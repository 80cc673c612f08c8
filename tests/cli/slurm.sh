#!/bin/sh
# Runs a command in a Slurm cluster that is this machine alone: slurm.sh FOLDER COMMAND... (as root). Controller, daemon
# and munge are of Debian; all they write is in FOLDER, and they are stopped in the end.
set -eu
folder=$1 host=$(hostname -s)
shift
PATH=$PATH:/usr/sbin:/sbin
mkdir -p "$folder/state" "$folder/spool"

stop() {
    for name in slurmctld slurmd munged; do
        [ ! -s "$folder/$name.pid" ] || kill "$(cat "$folder/$name.pid")" 2>/dev/null || :
    done
    for _ in $(seq 50); do # they write while they end
        left=0
        for name in slurmctld slurmd munged; do
            [ ! -s "$folder/$name.pid" ] || ! kill -0 "$(cat "$folder/$name.pid")" 2>/dev/null || left=1
        done
        [ $left -eq 1 ] || return 0
        sleep 0.1
    done
}
trap stop EXIT
trap 'exit 1' HUP INT TERM

dd if=/dev/urandom of="$folder/key" bs=1024 count=1 2>/dev/null
chmod 400 "$folder/key"
munged --force --key-file="$folder/key" --socket="$folder/munge" --pid-file="$folder/munged.pid" \
    --log-file="$folder/munged.log" --seed-file="$folder/seed" 2>/dev/null
port=$((20000 + $$ % 20000))
cat >"$folder/slurm.conf" <<END
ClusterName=test
SlurmctldHost=$host(127.0.0.1)
SlurmUser=root
SlurmctldPort=$port
SlurmdPort=$((port + 1))
AuthType=auth/munge
AuthInfo=socket=$folder/munge
CredType=cred/munge
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SchedulerParameters=bf_interval=1,sched_interval=1
NodeName=$host NodeAddr=127.0.0.1 CPUs=2
PartitionName=all Nodes=$host Default=YES MaxTime=INFINITE State=UP
END
export SLURM_CONF="$folder/slurm.conf"
slurmctld -c -f "$SLURM_CONF"
slurmd -f "$SLURM_CONF"
for _ in $(seq 100); do
    ! sinfo --noheader --format=%T 2>/dev/null | grep -q idle || break
    sleep 0.1
done
"$@"
