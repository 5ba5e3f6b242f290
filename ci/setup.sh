# shellcheck shell=bash
# Sourced by run.sh and test.sh: one configuration and one build directory for both, so that
# whichever comes second compiles nothing again.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$root/build/release
export CMAKE_BUILD_PARALLEL_LEVEL=${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)}
export CTEST_PARALLEL_LEVEL=${CTEST_PARALLEL_LEVEL:-$(nproc)}

# Shows the output of make on a terminal as the percentage done, in place.
percentage() {
  local line
  while IFS= read -r line; do
    [[ ! -t 1 || ! $line =~ ^\[\ *([0-9]+%)\] ]] || printf '%4s\b\b\b\b' "${BASH_REMATCH[1]}"
  done
}

# stage NAME COMMAND...: one line with the time taken; the output goes to a log, shown on failure.
stage() {
  local name=$1 log=$build/log/$1.log start=$SECONDS
  shift
  mkdir -p "${log%/*}"
  printf '%-10s' "$name"
  if "$@" 2>&1 | tee "$log" | percentage; then
    printf '%4d s\n' $((SECONDS - start))
  else
    printf 'failed\n'
    tail -n 60 "$log" >&2
    echo "$name failed; the whole output is in $log" >&2
    exit 1
  fi
}

# set_up WARNINGS_AS_ERRORS TARGET: configure and build.
set_up() {
  stage configure cmake -S "$root" --preset release -DCMAKE_CXX_COMPILER=g++ \
        -DPOROWAVE_TESTS=ON -DPOROWAVE_UNITY_BUILD=ON -DPOROWAVE_WARNINGS_AS_ERRORS="$1"
  stage build cmake --build "$build" --target "$2"
}
