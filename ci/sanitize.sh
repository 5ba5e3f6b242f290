#!/usr/bin/env bash
# Builds everything with sanitizers and runs the tests; a finding makes the test that met it fail.
# Usage: sanitize.sh address|threads [CTEST ARGUMENTS...]
#   address   AddressSanitizer, LeakSanitizer and UndefinedBehaviorSanitizer (g++)
#   threads   ThreadSanitizer (clang, whose OpenMP tells it of its barriers)
# Left out are tests of cost, package and style, to which a sanitizer adds nothing.
# Exit codes: 0 all passed; 1 the build or a test failed; 2 wrong usage; 5 packages cannot be installed.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
case ${1-} in
  -h | --help) sed -n '2,7s/^# //p' "${BASH_SOURCE[0]}"; exit 0 ;;
  address) preset=dev ;;
  threads) preset=threads ;;
  *) echo "sanitize.sh: wrong usage, expected address or threads" >&2; exit 2 ;;
esac
shift

bash "$root/ci/install-deps.sh" --dev
cd "$root"
cmake --preset "$preset" -DPOROWAVE_UNITY_BUILD=ON >/dev/null
cmake --build --preset "$preset" --parallel "${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)}" || exit 1
export UBSAN_OPTIONS=print_stacktrace=1 TSAN_OPTIONS="halt_on_error=1 second_deadlock_stack=1 ignore_noninstrumented_modules=1"
export ARCHER_OPTIONS="verbose=0"
ctest --preset "$preset" --no-tests=error --timeout 1500 -LE 'cost|package|style' \
  -j "${CTEST_PARALLEL_LEVEL:-$(nproc)}" "$@" || exit 1
