#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# usage: refusal.sh SOURCE PATTERN COMPILER [FLAG...]
# The source must not compile; the compiler must say PATTERN, a grep -E expression, in one of its
# first 16 lines, and GCC must not take more than 25 lines to say it. (clang goes on to list every
# operator of that name, and why it is none.)
set -euo pipefail

source=$1 pattern=$2
shift 2
if output=$("$@" -std=c++20 -Iinclude -c "$source" -o /dev/null 2>&1); then
  echo "$source compiles"
  exit 1
fi
echo "$output"
lines=$(wc -l <<<"$output")
if ! head -n 16 <<<"$output" | grep -qE "$pattern"; then
  echo "$source: the first 16 lines do not say: $pattern"
  exit 1
fi
if [[ $("$1" --version) != *clang* && $lines -gt 25 ]]; then
  echo "$source: $lines lines, more than 25"
  exit 1
fi
