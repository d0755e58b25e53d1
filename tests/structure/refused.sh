#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# usage: refused.sh MOST_LINES NAME PATTERN COMPILER [FLAG...]
# refused/NAME.cpp must not compile: one of the compiler's first 25 lines must match PATTERN, a grep
# -E expression, and there must be at most MOST_LINES.
set -euo pipefail

most_lines=$1 source=tests/structure/refused/$2.cpp pattern=$3
shift 3
if ! command -v "$1" >/dev/null; then
  echo "skipped: $1 is not installed"
  exit 77
fi
# GCC reports some errors only when it optimises, so the code is compiled, not just parsed.
if output=$("$@" -std=c++20 -Iinclude -c "$source" -o /dev/null 2>&1); then
  echo "$source compiles"
  exit 1
fi
lines=$(wc -l <<<"$output")
if ! head -n 25 <<<"$output" | grep -E "$pattern" || [[ $lines -gt $most_lines ]]; then
  head -n 60 <<<"$output"
  echo "$source: $lines lines; wanted: at most $most_lines, and among the first 25: $pattern"
  exit 1
fi
echo "$source is refused in $lines lines"
