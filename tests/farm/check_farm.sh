#!/usr/bin/env bash
# A real Slurm of two nodes on this machine renders a sequence, while a node and a task are killed;
# frames are those of one process, byte for byte. Exit code 77: skipped, and why.
#   check_farm.sh BRUME SCENE
set -euo pipefail

skip() {
  echo "skipped: $1"
  exit 77
}
[ "$(id -u)" = 0 ] || skip "Slurm's daemons need root"
for program in slurmctld slurmd sbatch munged; do
  command -v $program > /dev/null || skip "$program is missing: apt-get install slurm-wlm munge"
done

brume=$1 scene=$2
folder=$(mktemp -d)
export SLURM_CONF=$folder/slurm.conf
started=

stop() {
  for file in "$folder"/*.pid; do
    [ ! -f "$file" ] || kill "$(cat "$file")" 2> /dev/null || true
  done
  pkill -f "$folder" 2> /dev/null || true
  [ -z "$started" ] || pkill -x munged || true
  sleep 1
  rm -rf "$folder"
}
trap stop EXIT

mkdir -p "$folder"/{state,logs,spool/n1,spool/n2,farm,one} /run/munge
chown munge:munge /run/munge
if ! munge -n > /dev/null 2>&1; then
  su -s /bin/sh munge -c munged || skip "munged does not start here"
  started=yes
fi
# A node that does not answer for five seconds is down, and its tasks go back into the queue.
cat > "$SLURM_CONF" << CONF
ClusterName=brume
SlurmctldHost=$(hostname -s)(127.0.0.1)
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
ProctrackType=proctrack/pgid
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool/%n
SlurmctldPidFile=$folder/controller.pid
SlurmdPidFile=$folder/%n.pid
SlurmctldLogFile=$folder/logs/controller
SlurmdLogFile=$folder/logs/%n
SlurmctldPort=16817
SlurmdTimeout=5
ReturnToService=2
MpiDefault=none
NodeName=n[1-2] NodeHostname=$(hostname -s) NodeAddr=127.0.0.1 Port=[17001-17002] CPUs=1 RealMemory=1000 State=UNKNOWN
PartitionName=all Nodes=n[1-2] Default=YES MaxTime=INFINITE State=UP
CONF
slurmctld
slurmd -N n1
slurmd -N n2
for _ in $(seq 60); do
  [ "$(sinfo --noheader --format '%T %D')" != "idle 2" ] || break
  sleep 1
done
[ "$(sinfo --noheader --format '%T %D')" = "idle 2" ] || skip "Slurm does not start here: $(sinfo)"

options=(--frames 0-39 --fps 10 --size 480x360 --airlight sliced --scattering single --backend cpu)
"$brume" render "$scene" "${options[@]}" -o "$folder/one/f_%04d.exr" > /dev/null
"$brume" submit slurm "$scene" "${options[@]}" -o "$folder/farm/f_%04d.exr" --chunk 5 --watch \
  > "$folder/result" 2> "$folder/errors" &
submission=$!

# Until there are so many frames, or it has ended.
wait_for() {
  while kill -0 $submission 2> /dev/null &&
    [ "$(find "$folder/farm" -name 'f_*.exr' | wc -l)" -lt "$1" ]; do
    sleep 0.2
  done
}
wait_for 3
# The same again is refused while it runs.
if "$brume" submit slurm "$scene" "${options[@]}" -o "$folder/farm/f_%04d.exr" 2> "$folder/again"; then
  echo "two jobs make the same files" && exit 1
fi
grep -q 'is not finished' "$folder/again" || { cat "$folder/again" "$folder/errors" && exit 1; }
kill_task() {
  for _ in $(seq 100); do
    if pkill -KILL -n -f "$brume render.*$folder/farm"; then return; fi
    sleep 0.05
  done
  echo "no task runs" && exit 1
}
# A task dies, and then a node with what runs on it.
kill_task
wait_for 10
kill -KILL "$(cat "$folder/n2.pid")"
kill_task
sleep 8
slurmd -N n2

wait $submission || { cat "$folder/errors" "$folder/result" && exit 1; }
cat "$folder/errors" "$folder/result"
grep -q 'were lost with their tasks' "$folder/errors"
grep -q '"done":40,"failed":\[\],"lost":\[\]' "$folder/result"
for frame in "$folder"/one/*.exr; do cmp "$frame" "$folder/farm/$(basename "$frame")"; done
# All is there: nothing is submitted.
"$brume" submit slurm "$scene" "${options[@]}" -o "$folder/farm/f_%04d.exr" --watch |
  grep -q '"jobs":\[\],"done":40'
