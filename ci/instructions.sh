#!/usr/bin/env bash
# Counts the instructions of fixed runs of the solver (valgrind: the same in every repetition) and
# compares them with ci/instructions.csv, where they were counted by the same compiler.
# Usage: instructions.sh PROGRAM COMPILER [--update REASON]     PROGRAM porowave, COMPILER "GNU 12.2.0"
# Exit codes: 0 as before; 1 changed by more than 2 %, to either side; 2 wrong usage; 5 no valgrind;
#             77 the file has no counts by this compiler.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
file=$root/ci/instructions.csv
case $#:${1-}:${3-} in
  [01]:-h: | 1:--help:) sed -n '2,6s/^# //p' "${BASH_SOURCE[0]}"; exit 0 ;;
  2:*: | 4:*:--update) program=$1 compiler=$2 reason=${4-} ;;
  *) echo "instructions.sh: wrong usage, expected PROGRAM COMPILER [--update REASON]" >&2; exit 2 ;;
esac
[[ $# == 2 || ($reason != "" && $reason != *$'\n'*) ]] || {
  echo "instructions.sh: --update: expected a reason of one line" >&2; exit 2; }
[[ -x $program ]] || { echo "instructions.sh: $program: expected the program porowave" >&2; exit 2; }
command -v valgrind >/dev/null || { echo "instructions.sh: valgrind is missing" >&2; exit 5; }

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# scene NAME SOLVER SED...: the paper's case, changed; instructions within SOLVER::run().
scene() {
  local name=$1 solver=$2
  shift 2
  sed "$@" "$root/verification/studies/paper_case.toml" >"$scratch/$name.toml"
  valgrind --tool=callgrind --toggle-collect="porowave::solver::$solver::run()" \
    --callgrind-out-file=/dev/null "$program" solve "$scratch/$name.toml" >"$scratch/log" 2>&1 ||
    { cat "$scratch/log" >&2; exit 1; }
  awk -v scene="$name" -v compiler="$compiler" \
    '/Collected :/ { printf "%s,\"%s\",%d\n", scene, compiler, $4; found = 1 } END { exit !found }' "$scratch/log"
}

counted() {
  scene frozen ColumnSolver -e 's/^flip = 1.0/&/'
  scene points ColumnSolver -e 's/^flip = 1.0/&\npath = "points"/'
  # Nothing but what the wave has reached may count.
  scene long_column ColumnSolver -e 's/^length = 0.1/length = 2.0/' -e 's/^elements = 200/elements = 4000/' \
    -e 's/^flip = 1.0/&\npath = "points"/'
  scene shape ColumnSolver -e '/^kernel\|^support\|^basis/d' -e 's/"mls"/"shape"/' \
    -e 's/^flip = 1.0/&\npath = "points"/'
  scene staggered4 StaggeredSolver -e '/^kernel\|^support\|^basis/d' -e 's/^transfer.*/scheme = "staggered4"/'
}
counted >"$scratch/now.csv"

if [[ -n $reason ]]; then
  {
    grep '^#' "$file" 2>/dev/null || true
    echo "# $(date -u +%F): $reason"
    echo "scene,compiler,instructions"
    grep -v '^#\|^scene,' "$file" 2>/dev/null | grep -vF "\"$compiler\"" || true
    cat "$scratch/now.csv"
  } >"$scratch/new.csv"
  cp "$scratch/new.csv" "$file"
  cat "$scratch/now.csv"
  exit 0
fi

grep -qF "\"$compiler\"" "$file" || { echo "$file has no counts by $compiler"; exit 77; }
awk -F, 'NR == FNR { if (!/^#/) before[$1 "," $2] = $3; next }
  {
    key = $1 "," $2
    change = 100 * ($3 / before[key] - 1)
    bad = !(change <= 2 && change >= -2)
    failed += bad
    printf "%s: %d instructions, %+.2f %% %s\n", $1, $3, change, bad ? "CHANGED" : ""
  }
  END {
    if (failed) print "if that is meant: instructions.sh ... --update REASON"
    exit failed > 0
  }' "$file" "$scratch/now.csv"
