#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# usage: wrong_calls.sh COMPILER
# Each line of wrong_calls.cpp that ends in a comment must cause an error of a few lines that
# contains the comment, and no other line may cause an error.
set -euo pipefail

most_lines=12
source=tests/structure/refused/wrong_calls.cpp
if ! command -v "$1" >/dev/null; then
  echo "skipped: $1 is not installed"
  exit 77
fi
limit=-fmax-errors=0
if "$1" --version | grep -q clang; then limit=-ferror-limit=0; fi

errors=$(mktemp)
trap 'rm -f "$errors"' EXIT
if "$1" -std=c++20 -fsyntax-only "$limit" -w -Iinclude "$source" 2>"$errors"; then
  echo "$source compiles"
  exit 1
fi

# The first input is the source, the second the compiler's output, where an error begins with its
# position.
awk -v file="$source" -v most="$most_lines" '
  FNR == NR {
    if (match($0, /;  +\/\/ /)) { wanted[FNR] = substr($0, RSTART + RLENGTH); ++count }
    next
  }
  index($0, file ":") == 1 && / error: / {
    split($0, part, ":")
    line = part[2]
    if (!(line in wanted)) { print "not expected: " $0; bad = 1 }
  }
  { ++lines }
  line in wanted && index($0, "\"" wanted[line] "\"") { said[line] = 1 }
  line in wanted && / error: / && index($0, ": " wanted[line]) { said[line] = 1 }
  END {
    for (line in wanted) {
      if (!(line in said)) { print "line " line " does not say: " wanted[line]; bad = 1 }
    }
    if (count == 0 || lines > most * count) {
      print lines " lines for " count " wrong calls; wanted: at most " most " for each"
      bad = 1
    }
    if (!bad) print count " wrong calls are refused, in " lines " lines"
    exit bad
  }' "$source" "$errors"
