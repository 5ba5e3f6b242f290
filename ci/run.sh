#!/usr/bin/env bash
# From a fresh clone to figures: installs packages, builds the program and runs its demo.
# Usage: run.sh [--output DIR]      DIR is porowave-demo at the top of the tree if not given
# Exit codes: 1 the build failed; 2 wrong usage; 5 packages cannot be installed; else the demo's.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

output=$root/porowave-demo
case $#:${1-} in
  0:) ;;
  2:--output) output=$2 ;;
  1:-h | 1:--help) sed -n '2,4s/^# //p' "${BASH_SOURCE[0]}"; exit 0 ;;
  *) echo "run.sh: wrong usage, expected [--output DIR]" >&2; exit 2 ;;
esac

bash "$root/ci/install-deps.sh"

# Warnings are errors as in test.sh, because another flag would compile everything again; but what
# a compiler of another age warns of must not keep anyone from the figures.
strict=OFF
[[ $(g++ -dumpversion) != 12* ]] || strict=ON
set_up "$strict" porowave

start=$SECONDS
"$build/reports/porowave" demo --output "$output"
printf 'demo      %4d s\n' $((SECONDS - start))
