#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# usage: tests/size/slower_rows.sh [--write]
#
# Checks that docs/size.md lists every query that takes more instructions in a fixed scalar than in
# software float on M0 or M3, according to docs/data/instructions.csv. With --write, prints the
# rows.
set -euo pipefail
export LC_ALL=C
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

rows() {
  awk -F, '
    /^(m0|m3),/ {
      split("q16_16 q14_16 q24_8 q8_8", scalar, " ")
      for (i = 1; i <= 4; ++i)
        if ($(i + 3) > $3)
          printf "| %s | Cortex-%s | %s | %d | %d | %.2f |\n", $2, toupper($1), scalar[i], $3, $(i + 3), $(i + 3) / $3
    }' docs/data/instructions.csv
}

if [[ ${1-} == --write ]]; then rows && exit; fi
shown=$(awk '/^### Where software float wins/ { on = 1; next } on && /^#/ { exit } on && /^\| [a-z_]+\// { print }' docs/size.md |
  awk -F'|' '{ printf "|%s|%s|%s|%s|%s|%s|\n", $2, $3, $4, $5, $6, $7 }')
if [[ $shown != "$(rows)" ]]; then
  echo 'docs/size.md does not name the rows in which software float wins; these are (tests/size/slower_rows.sh --write):'
  rows
  exit 1
fi
