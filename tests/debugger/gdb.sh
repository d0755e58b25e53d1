#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# usage: gdb.sh COMPILER
# With src/debugger/detent_gdb.py, gdb shows the values of values.cpp as decimals, with the
# compiler's 128-bit integers and with ours.
set -euo pipefail

if ! command -v gdb >/dev/null || ! gdb -nx -batch -ex 'python pass' >/dev/null 2>&1; then
  echo 'skipped: no gdb with Python is installed'
  exit 77
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export DEBUGINFOD_URLS=  # needs no foreign debug symbols
printers=src/debugger/detent_gdb.py source=tests/debugger/values.cpp

cat >"$work/expected" <<'END'
number = 3.25 (raw 212992)
least = -32768 (raw -2147483648)
step = -0.0000152587890625 (raw -1)
small = -1.5 (raw -384)
product = -0.00004577706567943096160888671875 (raw -196611)
of_128_bits = 49152 (raw 13835058055282163712)
of_200_bits = 576460752303423488 (raw 45671926166590716193865151022383844364247891968)
flat = (0.5, -2)
vector = (1, -0.25, 30000)
rounded = (1, 0.5, -2)
direction = (0, 1, 0)
rotation = axes (1, 0), (0, 1)
quat = (0, 0, 0, 1)
angle = -90 degrees (raw 3221225472)
half_turn = 180 degrees (raw 2147483648)
radians = 1.5 radians
object = 5:20
nothing = none
sphere = {center = (1, 2, 3), radius = 0.125 (raw 8192)}
box = {center = (1, 2), half_extents = (3, 4), rotation = axes (1, 0), (0, 1)}
END

# Read the program's file without running it, which needs no permission to trace processes.
shown() {
  local commands=(-ex "source $printers") name
  while read -r name _; do
    commands+=(-ex "printf \"$name = \"" -ex "output shown::$name" -ex 'printf "\n"')
  done <"$work/expected"
  gdb -nx -batch "${commands[@]}" "$1"
}
for portable in 0 1; do
  defined=()
  if [[ $portable -eq 1 ]]; then defined=(-DDETENT_PORTABLE_INT128=1); fi
  "$1" -std=c++20 -g -O0 "${defined[@]}" -Iinclude "$source" -o "$work/values$portable"
  shown "$work/values$portable" | diff "$work/expected" - || exit 1
done
raw=$(gdb -nx -batch -ex "source $printers" -ex 'print/r shown::number' "$work/values0")
[[ $raw == *'raw_ = 212992'* ]] || { echo "print/r says: $raw"; exit 1; }
echo "$(wc -l <"$work/expected") values are shown as decimals"

# Locals of a running program, in std::optional.
line=$(grep -n 'the debugger stops here' "$source" | cut -d : -f 1)
gdb -nx -batch -ex "source $printers" -ex "break values.cpp:$line" -ex run -ex 'print distance' \
  -ex 'print point' "$work/values0" >"$work/run" 2>&1 || true
if ! grep -q '^Breakpoint 1, main' "$work/run"; then
  echo 'optionals were not checked: gdb may not trace processes here'
  exit 0
fi
for value in '3.25 (raw 212992)' '(0.5, -2)'; do
  grep -qF "$value" "$work/run" || { cat "$work/run"; exit 1; }
done
echo 'optionals show their values'
