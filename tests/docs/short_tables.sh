#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# usage: short_tables.sh [PAGE...]
# No table of a page has more than 25 rows; longer ones are data, in docs/data/. The pages are by
# default those at the top level and in docs/.
set -euo pipefail

# long PAGE...: prints `page:line: rows` of every table that is too long.
long() {
  awk '
    function finish() {
      if (rows > 27) printf "%s:%d: a table of %d rows\n", page, start, rows - 2  # head and rule
      rows = 0
    }
    FNR == 1 { finish() }
    /^ *\|/ { if (rows++ == 0) { page = FILENAME; start = FNR } next }
    { finish() }
    END { finish() }
  ' "$@"
}

# Self-test: of a table of 25 rows and one of 26, only the second must be found.
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
for rows in 25 26; do
  for ((i = -2; i < rows; ++i)); do echo '| a | b |'; done
  echo
done >"$work/page.md"
if [[ $(long "$work/page.md") != "$work/page.md:29: a table of 26 rows" ]]; then
  long "$work/page.md"
  echo 'the planted table of 26 rows, and only that, must be found'
  exit 1
fi

pages=("$@")
if [[ ${#pages[@]} -eq 0 ]]; then pages=(./*.md docs/*.md); fi
found=$(long "${pages[@]}")
if [[ $found ]]; then
  echo "$found"
  exit 1
fi
echo "no table in ${#pages[@]} pages has more than 25 rows"
