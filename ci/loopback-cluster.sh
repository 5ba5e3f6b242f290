# shellcheck shell=bash
# Slurm on this machine: a controller and nodes of one CPU each on loopback, ports of their own, all
# files in a folder that is gone at the end. To be sourced: it defines functions.

say() { echo "$(basename "$0" .sh): [$SECONDS s] $*"; }
skip() { say "left out: $*"; exit 77; }
fail() { say "FAILED: $*" >&2; tail -n 5 "$work"/*.log >&2; exit 1; }

# require_slurm INSTALL: root, Slurm, munge and sqlite3; with "yes" from Debian if they are missing.
require_slurm() {
  ((EUID == 0)) || skip "Slurm's daemons need root"
  if ! type slurmctld slurmd sbatch squeue scontrol munged sqlite3 >/dev/null 2>&1; then
    [[ $1 == yes ]] || skip "Slurm, munge or sqlite3 is missing; --install gets them from Debian"
    type apt-get >/dev/null 2>&1 || skip "no Slurm, and no apt to install it"
    # A package must not start a daemon of its own here: there is nothing configured for it.
    { apt-get -q update && DEBIAN_FRONTEND=noninteractive apt-get -q install -y --no-remove \
        --no-install-recommends slurmctld slurmd slurm-client munge sqlite3; } >/dev/null 2>&1 ||
      skip "apt-get could not install slurmctld slurmd slurm-client munge sqlite3"
    say "Slurm is installed"
  fi
}

# Processes of jobs on a node of this test (a name, or nothing for both): their environment tells.
# Before each the one that Slurm watches it by, or the node would only report a task that failed.
job_processes() {
  local process text parent
  for process in /proc/[0-9]*; do
    text=$({ tr '\0' '\n' <"$process/environ"; } 2>/dev/null) || continue
    grep -qx "SLURM_CONF=$SLURM_CONF" <<<"$text" || continue
    grep -qx "SLURMD_NODENAME=${1:-n[12]}" <<<"$text" || continue
    parent=$(awk '/^PPid:/ { print $2 }' "$process/status" 2>/dev/null) || continue
    if [[ $(cat "/proc/$parent/comm" 2>/dev/null) == slurmstepd ]]; then echo "$parent"; fi
    basename "$process"
  done
}
kill_all() { local pid; for pid in "$@"; do kill -9 "$pid" 2>/dev/null || true; done; }
stop_all() {
  local pids
  mapfile -t pids < <(job_processes "")
  kill_all "${daemon[@]}" "${pids[@]}"
  wait 2>/dev/null || true
  rm -rf "$work"
}

start_munge() {
  mkdir "$work/munge"
  dd if=/dev/urandom of="$work/munge/key" bs=64 count=1 status=none
  chmod 400 "$work/munge/key"
  chown -R munge:munge "$work/munge"
  setpriv --reuid=munge --regid=munge --clear-groups munged --foreground \
    --socket="$work/munge/socket" --key-file="$work/munge/key" --pid-file="$work/munge/pid" \
    --log-file="$work/munge/log" --seed-file="$work/munge/seed" >"$work/munged.log" 2>&1 &
  daemon[munge]=$!
}
start_controller() { slurmctld -D "$@" >>"$work/controller.log" 2>&1 & daemon[controller]=$!; }
start_node() { slurmd -D -N "$1" >>"$work/$1.log" 2>&1 & daemon[$1]=$!; }
# within SECONDS CONDITION...: asks again until it holds.
within() {
  local end=$((SECONDS + $1)); shift
  until "$@"; do ((SECONDS < end)) || return 1; sleep 0.3; done
}

node() {
  echo "NodeName=$1 NodeHostname=localhost NodeAddr=127.0.0.1 Port=$2 CPUs=1 Boards=1" \
       "SocketsPerBoard=1 CoresPerSocket=1 ThreadsPerCore=1 RealMemory=500 State=UNKNOWN"
}
# start_cluster: two nodes, n1 and n2. Sets `work`, a folder that is gone at the end, `daemon`, the
# processes by name, and SLURM_CONF.
start_cluster() {
  work=$(mktemp -d)
  chmod 755 "$work"
  export SLURM_CONF=$work/slurm.conf
  declare -gA daemon=()
  trap stop_all EXIT
  trap 'exit 1' INT TERM
  write_configuration
  start_munge
  within 10 test -S "$work/munge/socket" || fail "munge does not start"
  start_controller -c
  start_node n1
  start_node n2
  within 60 nodes_idle || fail "the nodes do not come up: $(sinfo -h 2>&1)"
  say "a controller and two nodes are up"
}
nodes_idle() { [[ $(sinfo -h -o '%D %t' 2>/dev/null) == "2 idle" ]]; }
write_configuration() {
  mkdir "$work/state"
  cat >"$SLURM_CONF" <<END
ClusterName=porowave
SlurmctldHost=localhost(127.0.0.1)
SlurmctldPort=16817
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket=$work/munge/socket
CredType=cred/munge
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool-%n
SlurmctldPidFile=$work/controller.pid
SlurmdPidFile=$work/%n.pid
CommunicationParameters=NoCtldInAddrAny,NoInAddrAny
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SchedulerParameters=sched_interval=5,bf_interval=5,sched_min_interval=100000,batch_sched_delay=0
MpiDefault=none
ReturnToService=2
JobRequeue=1
SlurmdTimeout=10
$(node n1 17001)
$(node n2 17002)
PartitionName=main Nodes=n1,n2 Default=YES MaxTime=INFINITE State=UP
END
}
