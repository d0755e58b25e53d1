#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The umbrella compiles with the smallest standard libraries: libc++ 14 for WebAssembly, and
# newlib's without an operating system.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
echo '#include <detent/detent.hpp>' >"$work/umbrella.cpp"

tried=
# compiles NAME COMPILER [FLAG...]
compiles() {
  local name=$1
  shift
  if ! echo '#include <optional>' |
    "$1" -std=c++20 -fsyntax-only "${@:2}" -x c++ - 2>/dev/null; then return; fi
  "$1" -std=c++20 -fsyntax-only -Iinclude "${@:2}" "$work/umbrella.cpp"
  tried+=" $name"
}
compiles libc++ clang++-14 --target=wasm32-wasi -fno-exceptions
compiles newlib arm-none-eabi-g++ -mcpu=cortex-m0 -ffreestanding

[[ -n $tried ]] || { echo 'skipped: there is neither library'; exit 77; }
echo "the umbrella compiles with:$tried"
