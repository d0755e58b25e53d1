#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# usage: tests/cull/simd128.sh CATCH_FOLDER
# Runs the tests of long lanes, and of what is computed with them, in node, compiled for WebAssembly with
# simd128. CATCH_FOLDER has catch2/catch.hpp of Catch2 2. Without clang 14 for wasm32-wasi or node it
# fails with 77.
set -euo pipefail
tests=$(realpath "$(dirname "${BASH_SOURCE[0]}")/..")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

[[ -f $1/catch2/catch.hpp ]] || { echo 'skipped: there is no Catch2 2'; exit 77; }
command -v node >/dev/null || { echo 'skipped: there is no node'; exit 77; }
# A folder of its own, because that of the system has headers for another machine.
mkdir "$work/include"
cp -r "$1/catch2" "$work/include/"
compile=(clang++-14 -std=c++20 --target=wasm32-wasi -msimd128 -fno-exceptions -fno-rtti -Wall -Wextra -Werror
  -I"$tests/../include" -I"$tests/../src" -I"$tests" -isystem "$work/include" -DDETENT_TEST_ALL=0
  -DCATCH_CONFIG_DISABLE_EXCEPTIONS -DCATCH_CONFIG_NO_POSIX_SIGNALS
  -D_WASI_EMULATED_SIGNAL -D_WASI_EMULATED_PROCESS_CLOCKS -D_WASI_EMULATED_GETPID)
echo '#include <vector>' >"$work/probe.cpp"
"${compile[@]}" -c "$work/probe.cpp" -o "$work/probe.o" 2>/dev/null && command -v wasm-ld-14 >/dev/null ||
  { echo 'skipped: there is no clang 14 for wasm32-wasi'; exit 77; }

objects=()
for name in support/main.cpp cull/long_lanes.test.cpp dynamics/contact_group.test.cpp dynamics/four.test.cpp \
    dynamics/four_contacts.test.cpp dynamics/four_flight.test.cpp dynamics/joint/four_joints.test.cpp; do
  objects+=("$work/$(basename "$name" .cpp).o")
  level=-O1
  if [[ $name == support/main.cpp ]]; then level=-O0; fi  # Catch2 takes longer to compile than to run
  ${CMAKE_CXX_COMPILER_LAUNCHER:-} "${compile[@]}" "$level" -c "$tests/$name" -o "${objects[-1]}"
done
clang++-14 --target=wasm32-wasi "${objects[@]}" -Wl,-z,stack-size=1048576 -lwasi-emulated-signal \
  -lwasi-emulated-process-clocks -lwasi-emulated-getpid -o "$work/lanes.wasm"
# Lanes as arrays are the same code as on any machine, where other tests run it.
node --no-warnings "$tests/platforms/wasi.mjs" "$work/lanes.wasm" '~*ArrayLongLanes*'
