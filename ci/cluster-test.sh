#!/usr/bin/env bash
# A study through Slurm on this machine: a controller and two nodes on loopback, a task, a node and
# the controller killed at work; the merged store must have the rows of a local run, each once.
# Usage: cluster-test.sh [--install] [PROGRAM]     build/release/reports/porowave if absent
# With --install Slurm, munge and sqlite3 are installed from Debian if they are missing.
# Exit codes: 0 all rows as they must be; 1 not so; 2 wrong usage; 77 left out: Slurm is not to be had.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=loopback-cluster.sh
source "$(dirname "${BASH_SOURCE[0]}")/loopback-cluster.sh"
tree=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
install=no
[[ ${1-} != --install ]] || { install=yes; shift; }
(($# <= 1)) || { echo "cluster-test: wrong usage, expected [--install] [PROGRAM]" >&2; exit 2; }
program=$(realpath "${1:-$tree/build/release/reports/porowave}")
[[ -x $program ]] || { echo "cluster-test: $program: expected the program, built" >&2; exit 2; }

require_slurm "$install"
start_cluster
cd "$work"
sed 's/count = 8 }/count = 240 }/' "$tree/verification/studies/smoke.toml" >study.toml
grep -q 'count = 240' study.toml || fail "the smoke study has no 8 seeds to make more of"
"$program" sweep study.toml --store alone >alone.log || fail "the local run"
say "local run: $(head -n 1 alone.log)"

submit() { "$program" sweep study.toml --store whole --slurm --nodes 2 --tasks 6 || fail "submission"; }
tasks_running() { squeue -h -r -t R -o '%i %N' | grep -E ' n[12]$' || true; }
rows_in() { sqlite3 "$1" 'SELECT count(*) FROM cases' 2>/dev/null || echo 0; }
at_work() {
  [[ $(tasks_running | wc -l) == 2 ]] && compgen -G 'whole.shards/*' >/dev/null &&
    local shard && for shard in whole.shards/*-[0-9]; do (($(rows_in "$shard") > 0)) || return 1; done
}
# A task that lost its node waits for two minutes unless it is told not to. One that a restarted
# controller launched a second time may be held and its node drained: an operator lets both go on.
queue_empty() {
  local id
  for id in $(squeue -h -r -t PD -o '%i %r' | awk '$2 == "BeginTime" { print $1 }'); do
    scontrol update JobId="$id" StartTime=now 2>/dev/null || true
  done
  for id in $(squeue -h -r -t PD -o '%i %r' | awk '/held/ { print $1 }'); do
    say "task $id was held, released"
    scontrol release "$id" 2>/dev/null || true
  done
  for id in $(sinfo -h -N -o '%N %t' | awk '$2 ~ /^dr/ { print $1 }'); do
    say "node $id was drained, resumed"
    scontrol update NodeName="$id" State=RESUME 2>/dev/null || true
  done
  local queue
  queue=$(squeue -h -r -o '%i' 2>/dev/null) && [[ -z $queue ]]
}

submit
within 60 at_work || fail "no two tasks at work: $(squeue -r 2>&1)"
victim=$(tasks_running | awk '$2 == "n1" { print $1; exit }')
scancel --full --signal=KILL "$victim"
say "killed task $victim"
within 30 at_work || fail "no two tasks at work after the kill"
mapfile -t lost < <(job_processes n2)
((${#lost[@]})) || fail "no process on node n2"
kill_all "${daemon[n2]}" "${lost[@]}"
say "killed node n2: its daemon and ${#lost[@]} processes"
"$program" status study.toml --store whole | tee status.log
grep -q ' 0 missing' status.log && fail "all was done before anything was killed"
# Its state is on disk some seconds after a change; what came later a killed controller forgets.
sleep 6
kill_all "${daemon[controller]}"
sleep 1
start_controller
say "killed and restarted the controller"
start_node n2
within 120 queue_empty || fail "the queue does not empty: $(squeue -r 2>&1)"
"$program" status study.toml --store whole

# Hands in what is left: cases whose task was forgotten, or the merging if that was. Jobs of a
# controller that forgot of the kill may still go on by themselves.
everything_merged() { (($(rows_in whole) == 2880)); }
for ((round = 1; round <= 3; ++round)); do
  submit
  within 90 queue_empty || fail "the queue does not empty: $(squeue -r 2>&1)"
  everything_merged && break
done
"$program" status study.toml --store whole | tee status.log
grep -q '^2880 cases: 2880 done, 0 broke down, 0 refused, 0 failed, 0 missing' status.log ||
  fail "not all cases are done"
everything_merged || fail "the store has $(rows_in whole) of 2880 rows after 3 submissions"

# Everything that must not depend on when and where: the columns before cpu_seconds.
dump() {
  local columns
  columns=$(sqlite3 "$1" "SELECT group_concat(name, ', ') FROM pragma_table_info('cases') WHERE cid <
    (SELECT cid FROM pragma_table_info('cases') WHERE name = 'cpu_seconds')")
  sqlite3 "$1" "SELECT $columns FROM cases ORDER BY id"
}
dump alone >alone.rows
dump whole >whole.rows
[[ $(wc -l <alone.rows) -ge 2880 ]] || fail "the local run has too few rows"
cmp alone.rows whole.rows || fail "rows differ from those of the local run"
[[ $(sqlite3 whole 'SELECT count(*), count(DISTINCT id) FROM cases') == "2880|2880" ]] ||
  fail "rows are lost or twice"
say "2880 rows, each once, as those of the local run"
