# A Slurm of two nodes on this machine, n1 and n2, of one core each. To be sourced:
#   start_slurm FOLDER   false, with the reason on standard output, where that cannot be
#   stop_slurm
# Nodes are FOLDER/n1.pid and FOLDER/n2.pid; slurmd -N n2 starts one again.

start_slurm() {
  slurm_folder=$1
  [ "$(id -u)" = 0 ] || { echo "Slurm's daemons need root" && return 1; }
  local program
  for program in slurmctld slurmd sbatch munged; do
    command -v $program > /dev/null ||
      { echo "$program is missing: apt-get install slurm-wlm munge" && return 1; }
  done
  export SLURM_CONF=$slurm_folder/slurm.conf
  mkdir -p "$slurm_folder"/{state,logs,spool/n1,spool/n2} /run/munge
  chown munge:munge /run/munge
  if ! munge -n > /dev/null 2>&1; then
    su -s /bin/sh munge -c munged || { echo "munged does not start here" && return 1; }
    started_munge=yes
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
StateSaveLocation=$slurm_folder/state
SlurmdSpoolDir=$slurm_folder/spool/%n
SlurmctldPidFile=$slurm_folder/controller.pid
SlurmdPidFile=$slurm_folder/%n.pid
SlurmctldLogFile=$slurm_folder/logs/controller
SlurmdLogFile=$slurm_folder/logs/%n
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
  local _
  for _ in $(seq 60); do
    [ "$(sinfo --noheader --format '%T %D')" != "idle 2" ] || return 0
    sleep 1
  done
  echo "Slurm does not start here: $(sinfo)"
  return 1
}

stop_slurm() {
  local file
  for file in "$slurm_folder"/*.pid; do
    [ ! -f "$file" ] || kill "$(cat "$file")" 2> /dev/null || true
  done
  pkill -f "$slurm_folder" 2> /dev/null || true
  [ -z "${started_munge:-}" ] || pkill -x munged || true
  sleep 1
}
