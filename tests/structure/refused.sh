#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# usage: refused.sh COMPILER NAME PATTERN
# refused/NAME.cpp must not compile: a line says what the pattern wants, and there are few lines.
set -euo pipefail

most_lines=25
if ! command -v "$1" >/dev/null; then
  echo "skipped: $1 is not installed"
  exit 77
fi
errors=$(mktemp)
trap 'rm -f "$errors"' EXIT
if "$1" -std=c++20 -fsyntax-only -Iinclude "tests/structure/refused/$2.cpp" 2>"$errors"; then
  echo "$2.cpp compiles"
  exit 1
fi
lines=$(wc -l <"$errors")
if ! grep -E "(error|note): .*($3)" "$errors" || [[ $lines -gt $most_lines ]]; then
  head -n 60 "$errors"
  echo "$2.cpp: $lines lines; wanted: at most $most_lines, with: $3"
  exit 1
fi
echo "$2.cpp is refused in $lines lines"
