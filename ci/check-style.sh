#!/usr/bin/env bash
# Checks what a reader relies on: rules (length of files, which room includes which) and format.
# Usage: check-style.sh [rules|format]      both if not given
# Exit codes: 0 all as agreed; 1 something is not; 2 wrong usage; 5 clang-format-14 is missing.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

# Files that git does not know yet count as well: they are about to be committed.
mapfile -t sources < <(find solver reference verification reports ci \
                            -name '*.cpp' -o -name '*.hpp' -o -name '*.gp' -o -name '*.sh' | sort)
((${#sources[@]})) || { echo "check-style: found no source file" >&2; exit 1; }
status=0
broken() { echo "$1" >&2; status=1; }

# forbid REASON FOLDER INCLUDED [EXCEPT]: no file in FOLDER includes a path that matches INCLUDED.
forbid() {
  local found
  found=$(grep -rnE --include='*.[ch]pp' "^ *# *include *[\"<]($3)" "$2" | grep -vE "${4:-^$}" || true)
  [[ -z $found ]] || broken "$1:"$'\n'"$found"
}

rules() {
  local file lines room
  for file in "${sources[@]}"; do
    lines=$(wc -l <"$file")
    ((lines <= 400)) || broken "$file: $lines lines, more than 400: split it"
  done
  forbid "the solver includes only itself and the statement of the problem" \
         solver "reference/|verification/|reports/" '["<]reference/problem/'
  forbid "the reference must not know of solver, verification and reports" \
         reference "solver/|verification/|reports/"
  forbid "the statement of the problem must not know the reference" \
         reference/problem "reference/" '["<]reference/problem/'
  forbid "verification must not know of reports" verification "reports/"
  # Paths from the top keep the rules above complete, and work once installed.
  for room in solver reference verification reports; do
    forbid "includes are written from the top of the tree" \
           "$room" '' '# *include *(<|"(solver|reference|verification|reports)/)'
  done
}

format() {
  command -v clang-format-14 >/dev/null || {
    echo "check-style: clang-format-14 is missing, run ci/install-deps.sh --dev" >&2
    exit 5
  }
  local file
  for file in "${sources[@]}"; do
    [[ $file != *.[ch]pp ]] || clang-format-14 --dry-run -Werror "$file" 2>/dev/null ||
      broken "$file: clang-format-14 -i $file changes it"
  done
}

case $#:${1-} in
  0:) rules; format ;;
  1:rules) rules ;;
  1:format) format ;;
  1:-h | 1:--help) sed -n '2,4s/^# //p' "${BASH_SOURCE[0]}" ;;
  *) echo "check-style.sh: wrong usage, expected [rules|format]" >&2; exit 2 ;;
esac
exit $status
