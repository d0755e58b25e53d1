#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# usage: constant.sh COMPILER ARGUMENT...
# The compiler itself computes the golden results.
set -euo pipefail

if ! command -v "$1" >/dev/null; then
  echo "skipped: $1 is not installed"
  exit 77
fi
"$@" -std=c++20 -Wall -Wextra -Wconversion -Wshadow -Werror -Iinclude -Isrc -fsyntax-only
echo "$1 gives the golden answers while it compiles"
