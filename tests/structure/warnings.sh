#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# usage: warnings.sh COMPILER... [-O...]
# A user's source compiles without warnings under the flags of a strict project. With several
# compilers or levels, tries them all and prints a table:
#
#   tests/structure/warnings.sh g++-11 g++-12 clang++-13 clang++-14 clang++-19 -O0 -O1 -O2 -O3
set -euo pipefail

compilers=() levels=()
for argument in "$@"; do
  case $argument in
    -O*) levels+=("$argument") ;;
    *) compilers+=("$argument") ;;
  esac
done
if [[ ${#levels[@]} -eq 0 ]]; then levels=(-O2); fi

errors=$(mktemp)
trap 'rm -f "$errors"' EXIT
tried=0 bad=0
for compiler in "${compilers[@]}"; do
  if ! command -v "$compiler" >/dev/null; then
    echo "skipped: $compiler is not installed"
    continue
  fi
  for level in "${levels[@]}"; do
    tried=$((tried + 1))
    # clang's warnings come from its front end, so they do not depend on the level.
    if [[ $compiler == clang* ]]; then only=-fsyntax-only; else only=-c; fi
    if "$compiler" -std=c++20 "$level" "$only" -Wall -Wextra -Wconversion -Wsign-conversion -Wshadow -Werror \
      -Iinclude tests/structure/warnings.cpp -o /dev/null 2>"$errors"; then
      echo "$compiler $level: no warning"
    else
      bad=1
      echo "$compiler $level: $(grep -c 'error:' "$errors") warnings"
      grep 'error:' "$errors" | sort -u | head -n 10
    fi
  done
done
if [[ $tried -eq 0 ]]; then exit 77; fi
exit "$bad"
