#!/usr/bin/env bash
# How a study scales on Slurm: makespans on one and two nodes on loopback, measured beside predicted,
# and what Slurm itself takes of a task. Makespan: from the submission until the queue is empty.
# Usage: cluster-scaling.sh [--install] [--repeat N] [PROGRAM]
#        cluster-scaling.sh --predict [PROGRAM]     needs no Slurm: 1 to 1,000 nodes, by simulation
# --repeat: measure so many times (1 if absent), nodes in turn. See verification/cluster/scaling.md.
# Exit codes: 0; 1 something failed; 2 wrong usage; 77 left out: Slurm is not to be had.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=loopback-cluster.sh
source "$(dirname "${BASH_SOURCE[0]}")/loopback-cluster.sh"
tree=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
predict=no
[[ ${1-} != --predict ]] || { predict=yes; shift; }
install=no
[[ ${1-} != --install ]] || { install=yes; shift; }
repeat=1
[[ ${1-} != --repeat ]] || { repeat=${2-}; shift 2; }
if (($# > 1)) || ! [[ $repeat =~ ^[1-9][0-9]*$ ]]; then
  echo "cluster-scaling: wrong usage, expected [--predict | [--install] [--repeat N]] [PROGRAM]" >&2
  exit 2
fi
program=$(realpath "${1:-$tree/build/release/reports/porowave}")
[[ -x $program ]] || { echo "cluster-scaling: $program: expected the program, built" >&2; exit 2; }

now() { date +%s.%N; }
since() { awk -v a="$1" -v b="$(now)" 'BEGIN { printf "%.2f", b - a }'; }
wait_for_queue() {
  local queue
  while queue=$(squeue -h -o '%i' 2>/dev/null) && [[ -n $queue ]]; do sleep 0.1; done
}
controller_ticks() { awk '{ print $14 + $15 }' "/proc/${daemon[controller]}/stat"; }

# What Slurm takes of tasks that do nothing, on one node and on two.
measure_overhead() {
  local nodes=$1 tasks=24 start ticks seconds
  printf '#!/bin/sh\n' >empty.sh
  start=$(now); ticks=$(controller_ticks)
  sbatch --parsable --array="1-$tasks%$nodes" --output=/dev/null empty.sh >/dev/null
  wait_for_queue
  seconds=$(since "$start"); ticks=$(($(controller_ticks) - ticks))
  awk -v s="$seconds" -v n="$nodes" -v t="$tasks" -v c="$ticks" -v hz="$(getconf CLK_TCK)" 'BEGIN {
    printf "empty tasks on %d nodes: %.2f s a task and node, %.1f ms of the controller'"'"'s CPU\n",
           n, s * n / t, 1000 * c / hz / t }'
}

# measure STUDY NODES: a line of the table.
measure() {
  local store=$1-$2-$RANDOM start seconds predicted cpu merging waited
  "$program" sweep "$1.toml" --store "$store" --slurm --nodes "$2" >submitted
  # Submission itself, with its trial, is no part of it.
  start=$(now)
  wait_for_queue
  seconds=$(since "$start")
  merging=$(awk -v a="$(stat -c %.3Y "$store".shards/*[0-9] | sort -g | tail -n 1)" \
                -v b="$(stat -c %.3Y "$store")" 'BEGIN { printf "%.1f", b - a }')
  # What others had of the cores: wall less CPU time of the tasks, which run a case at a time.
  waited=$(cat "$store".slurm/*/task-*.out | sed -nE -e 's/.*run now in ([0-9.]+) s.*/\1/p' \
      -e 's/^CPU time: solver ([0-9.]+) s, reference and errors ([0-9.]+) s.*/-\1\n-\2/p' |
    awk -v n="$2" '{ sum += $1 } END { printf "%.1f", sum / n }')
  predicted=$(sed -n 's/^predicted makespan.*CPUs: \([0-9.]*\) s.*/\1/p' submitted)
  cpu=$(sqlite3 "$store" 'SELECT sum(cpu_seconds) FROM cases')
  [[ $(sqlite3 "$store" 'SELECT count(*) FROM cases') == "$(wc -l <"$store.slurm/cases" |
    awk '{ print $1 - 1 }')" ]] || fail "the store of $1 lacks rows"
  awk -v study="$1" -v n="$2" -v m="$seconds" -v p="$predicted" -v c="$cpu" -v merge="$merging" -v w="$waited" \
      -v tasks="$(compgen -G "$store.shards/*[0-9]" | wc -l)" -v f="$(sed -n \
      's/^a case takes \([0-9.]*\) times.*/\1/p' submitted)" 'BEGIN {
    printf "| %s | %d | %d | %.1f | %.2f | %.1f | %.1f | %.1f | %+.0f %% | %.1f | %+.0f %% |\n", study, n, tasks, c, f,
           merge, p, m, 100 * (p / m - 1), w, 100 * (p / (m - w) - 1) }'
}

# prediction STUDY NODES [TASKS]: the makespan, its two parts, tasks and CPU seconds.
prediction() {
  "$program" sweep "$1" --store "$work/none" --slurm --dry-run --nodes "$2" ${3:+--tasks "$3"} |
    sed -nE -e 's/.*take ([0-9]+) s of CPU: ([0-9]+) tasks/\1 \2/p' \
            -e 's/^predicted makespan.*CPUs: ([0-9.]+) s; .* after ([0-9.]+) s.*takes ([0-9.]+) s/\1 \2 \3/p' |
    xargs
}
predict_all() {
  local file nodes tasks
  work=$(mktemp -d)
  trap 'rm -rf "$work"' EXIT
  sed 's/count = 16 }/count = 48 }/; s/\[25, 50, 100, 200, 400\]/[400, 800, 1600, 3200, 6400]/' \
    "$tree/verification/studies/paper.toml" >"$work/many-cases.toml"
  sed 's/count = 16 }/count = 8 }/; s/\[25, 50, 100, 200, 400\]/[3200, 6400, 12800, 25600, 51200]/' \
    "$tree/verification/studies/paper.toml" >"$work/long-cases.toml"
  echo '| study | nodes | tasks | CPU, s | tasks end, s | merging, s | makespan, s | of all nodes at work |'
  for file in many-cases long-cases; do
    for nodes in 1 2 10 100 1000; do
      row $file $nodes "$(prediction "$work/$file.toml" $nodes)"
    done
  done
  echo 'tasks a node, on ten nodes:'
  for file in many-cases long-cases; do
    for tasks in 10 40 160 1000; do
      row $file 10 "$(prediction "$work/$file.toml" 10 $tasks)"
    done
  done
}
row() {
  awk -v study="$1" -v n="$2" '{ printf "| %s | %d | %d | %d | %.1f | %.1f | %.1f | %.0f %% |\n", study, n,
    $2, $1, $4, $5, $3, 100 * $1 / n / $3 }' <<<"$3"
}

if [[ $predict == yes ]]; then predict_all; exit 0; fi
require_slurm "$install"
start_cluster
cd "$work"
measure_overhead 1
measure_overhead 2
studies=$tree/verification/studies
sed 's/count = 8 }/count = 120 }/' "$studies/pull_request.toml" >pull_request.toml
cp "$studies"/{nightly,paper}.toml .
echo '| study | nodes | tasks | CPU of the solver, s | speed | merging, s | predicted, s | measured, s | off by | waited for others, s | off by, without that |'
for ((k = 0; k < repeat; ++k)); do
  for study in pull_request paper nightly; do
    for nodes in 2 1; do measure "$study" "$nodes"; done
  done
done
say "done"
