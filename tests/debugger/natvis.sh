#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# usage: natvis.sh COMPILER
# src/debugger/detent.natvis is well-formed XML, and every type and member that it names exists. How
# Visual Studio displays it is not tested.
set -euo pipefail

if ! command -v gdb >/dev/null; then
  echo 'skipped: gdb, whose Python reads the file, is not installed'
  exit 77
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
gdb -nx -batch -x tests/debugger/natvis.py >"$work/natvis.cpp" 2>"$work/errors"
if [[ -s $work/errors ]]; then
  cat "$work/errors"
  exit 1
fi
# Microsoft's compilers have no 128-bit integers.
"$1" -std=c++20 -fsyntax-only -fno-access-control -w -DDETENT_PORTABLE_INT128=1 -Iinclude \
  "$work/natvis.cpp"
echo "$(grep -c '^struct' "$work/natvis.cpp") expressions of detent.natvis have a meaning"
