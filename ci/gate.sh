#!/usr/bin/env bash
# Runs a study of verification/studies and judges it by its baseline; verdicts also go to
# build/release/STUDY.junit.xml, rows to build/release/STUDY.store (kept: the next call continues).
# Usage: gate.sh [STUDY]      smoke if not given; also pull_request, nightly
# Exit codes: 0 pass; 1 fail; 2 wrong usage; 3 inconclusive; 5 packages cannot be installed.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

study=${1-smoke}
case $#:$study in
  [01]:-h | 1:--help) sed -n '2,5s/^# //p' "${BASH_SOURCE[0]}"; exit 0 ;;
  [01]:[a-z]*) ;;
  *) echo "gate.sh: wrong usage, expected [STUDY]" >&2; exit 2 ;;
esac
file=$root/verification/studies/$study.toml
baseline=$root/verification/baselines/$study.csv
for needed in "$file" "$baseline"; do
  [[ -r $needed ]] || { echo "gate.sh: $needed is missing: expected a study with a baseline" >&2; exit 2; }
done

bash "$root/ci/install-deps.sh"
set_up ON porowave
porowave=$build/reports/porowave
"$porowave" sweep "$file" --store "$build/$study.store"
"$porowave" gate "$file" --store "$build/$study.store" --baseline "$baseline" \
  --junit "$build/$study.junit.xml"
