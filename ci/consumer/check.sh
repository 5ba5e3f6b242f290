#!/usr/bin/env bash
# Installs a finished build into BUILD_DIR/stage and builds and runs the project beside this script
# against what was installed.
# Usage: check.sh BUILD_DIR [CMAKE_OPTION...]
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
build=$(cd "${1:?BUILD_DIR is missing}" && pwd)
shift

# What an earlier version installed must not hide that this one forgot it.
rm -rf "$build/stage" "$build/consumer"
cmake --install "$build" --prefix "$build/stage" >/dev/null
cmake -S "$here" -B "$build/consumer" -DCMAKE_PREFIX_PATH="$build/stage" "$@"
cmake --build "$build/consumer"
"$build/consumer/consumer"
