#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# usage: compiles.sh COMPILER
# A compiler accepts all headers.
set -euo pipefail

if ! command -v "$1" >/dev/null; then
  echo "skipped: $1 is not installed"
  exit 77
fi
find include -name '*.hpp' -printf '#include "%P"\n' | sort | "$1" -std=c++20 -fsyntax-only -Iinclude -x c++ -
