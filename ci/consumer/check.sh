#!/usr/bin/env bash
# Installs a finished build into BUILD_DIR/stage and builds and runs the project beside this script
# against what was installed. The example of the solver is the one that verification/README.md shows.
# Usage: check.sh BUILD_DIR [CMAKE_OPTION...]
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
build=$(cd "${1:?BUILD_DIR is missing}" && pwd)
shift

shown=$(awk '/^...cpp$/ { on = 1; next } /^...$/ { on = 0 } on' "$here/../../verification/README.md")
diff <(echo "$shown") "$here/column.cpp" || {
  echo "check.sh: verification/README.md shows another example than ci/consumer/column.cpp" >&2
  exit 1
}

# What an earlier version installed must not hide that this one forgot it.
rm -rf "$build/stage" "$build/consumer"
cmake --install "$build" --prefix "$build/stage" >/dev/null
cmake -S "$here" -B "$build/consumer" -DCMAKE_PREFIX_PATH="$build/stage" "$@"
cmake --build "$build/consumer"
"$build/consumer/consumer"
output=$("$build/consumer/column")
echo "$output"
# The number itself: half of the error, or twice of it, is another scheme.
[[ $output =~ ^relative\ L2\ error\ of\ effective\ stress:\ 0\.001[5-8][0-9]*$ ]] || {
  echo "check.sh: expected an error of 0.0015 to 0.0019" >&2
  exit 1
}
