#!/usr/bin/env bash
# Builds everything with warnings as errors and runs every test; JUnit goes to build/release/junit.xml.
# Usage: test.sh
# Exit codes: 0 all passed; 1 the build or a test failed; 2 wrong usage; 5 packages cannot be installed.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

case ${1-} in
  "") ;;
  -h | --help) sed -n '2,4s/^# //p' "${BASH_SOURCE[0]}"; exit 0 ;;
  *) echo "test.sh: takes no arguments" >&2; exit 2 ;;
esac

bash "$root/ci/install-deps.sh"
set_up ON all
# The last lines are ctest's own summary. A suite that has lost its tests fails.
cd "$root"
ctest --preset release --no-tests=error --output-junit "$build/junit.xml" || exit 1
