#!/usr/bin/env bash
# Builds the fuzzers and lets each run for a time, from the studies and tables of the tree on. What
# they find stands in build/fuzz/findings; what they have learned is kept in build/fuzz/corpus.
# A finding is a crash, a report of a sanitizer, more than 10 s or 2 GiB for one input.
# Usage: run.sh MINUTES [toml|csv|store ...]
# Exit codes: 0 nothing found; 1 a finding; 2 wrong usage; 5 packages cannot be installed.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
build=$root/build/fuzz
case ${1-} in
  -h | --help) sed -n '2,6s/^# //p' "${BASH_SOURCE[0]}"; exit 0 ;;
  [1-9] | [1-9][0-9]) minutes=$1; shift ;;
  *) echo "fuzz/run.sh: wrong usage, expected MINUTES" >&2; exit 2 ;;
esac
(($# > 0)) || set -- toml csv store

bash "$root/ci/install-deps.sh" --dev
cmake -S "$root" --preset fuzz >/dev/null
for name in "$@"; do cmake --build "$build" --target "${name}_fuzz"; done
cmake --build "$build" --target store_seed

mkdir -p "$build"/corpus/{toml,csv,store} "$build/findings"
# The first byte says what the rest is read as.
first_byte() { printf '%b' "$1" | cat - "$2" >"$3"; }
for file in "$root"/verification/studies/*.toml; do
  for kind in 0 1 2; do first_byte "\\x0$kind" "$file" "$build/corpus/toml/$(basename "$file").$kind"; done
done
for file in "$root"/verification/studies/*.csv "$root"/verification/baselines/smoke.csv; do
  head -c 4000 "$file" >"$build/piece"
  for kind in 0 1 2 6; do first_byte "\\x0$kind" "$build/piece" "$build/corpus/csv/$(basename "$file").$kind"; done
done
"$build/ci/fuzz/store_seed" "$build/corpus/store/seed"

found=0
for name in "$@"; do
  echo "$name: $minutes minutes"
  dictionary=()
  [[ ! -f $root/ci/fuzz/$name.dict ]] || dictionary=("-dict=$root/ci/fuzz/$name.dict")
  "$build/ci/fuzz/${name}_fuzz" -max_total_time=$((60 * minutes)) -timeout=10 -rss_limit_mb=2048 \
    -print_final_stats=1 "${dictionary[@]}" -artifact_prefix="$build/findings/$name-" \
    "$build/corpus/$name" >"$build/$name.log" 2>&1 || found=1
  tail -n 12 "$build/$name.log"
done
exit $found
