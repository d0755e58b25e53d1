#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# usage: readme.sh README PREFIX
# The programs of a README do what it says, using the installation in PREFIX: the C++ program with
# the README's CMake lines, and the C program, if there is one, with its command.
set -euo pipefail
readme=$(realpath "$1") prefix=$(realpath "$2")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
block() { bash tests/docs/block.sh "$readme" "$1"; }
run() { "$@" >"$work/log" 2>&1 || { cat "$work/log"; exit 1; }; }
expect() {
  local said
  said=$("$1")
  [[ $said == 'a ball at 9' ]] || { echo "the program of $readme prints '$said'"; exit 1; }
}

block cpp >"$work/main.cpp"
block cmake >"$work/CMakeLists.txt"
run cmake -S "$work" -B "$work/build" -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_FIND_USE_PACKAGE_REGISTRY=OFF
run cmake --build "$work/build"
expect "$work/build/game"

if block c >"$work/main.c" 2>/dev/null && command -v pkg-config >/dev/null && command -v cc >/dev/null; then
  PKG_CONFIG_PATH=$(dirname "$(find "$prefix" -name detent.pc)")
  LD_LIBRARY_PATH=$(PKG_CONFIG_PATH=$PKG_CONFIG_PATH pkg-config --variable=libdir detent)
  export PKG_CONFIG_PATH LD_LIBRARY_PATH
  block sh >"$work/command"
  (cd "$work" && run bash -e command)
  expect "$work/game"
fi
echo "the programs of $(basename "$(dirname "$readme")")/README.md run"
