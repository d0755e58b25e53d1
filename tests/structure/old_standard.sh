#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# usage: old_standard.sh COMPILER
# Under an older standard, a header gives one error that names the flag, in few lines.
set -euo pipefail

most_lines=17
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

for header in detent.hpp scene/scene.hpp query/raycast/sphere.hpp version.hpp; do
  echo "#include \"detent/$header\"" >"$work/old.cpp"
  if "$1" -std=c++17 -fsyntax-only -Iinclude "$work/old.cpp" 2>"$work/errors"; then
    echo "$header compiles as C++17"
    exit 1
  fi
  lines=$(wc -l <"$work/errors")
  sentences=$(grep -c 'error: .*detent needs C++20: compile with -std=c++20' "$work/errors" || true)
  if [[ $sentences -ne 1 || $lines -gt $most_lines ]]; then
    head -n 40 "$work/errors"
    echo "$header as C++17: $sentences sentences in $lines lines; wanted: 1 in at most $most_lines"
    exit 1
  fi
done

# A header that includes no other header of ours is parsed first, so it must contain the error.
silent=$(grep -rL '#include "detent/' include --include='*.hpp' | grep -v '/require_cxx20.hpp$' || true)
if [[ -n $silent ]]; then
  echo "these include nothing of ours, so they need detent/number/require_cxx20.hpp:"
  echo "$silent"
  exit 1
fi
echo "headers say that they need C++20"
