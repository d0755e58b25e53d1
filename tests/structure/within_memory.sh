#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The build fails if, and only if, a compiler exceeds its memory limit.
set -euo pipefail

command -v python3 >/dev/null || { echo 'skipped: python3 is not installed'; exit 77; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
echo 'int main() {}' >"$work/main.cpp"
compile=("$1" -c "$work/main.cpp" -o "$work/main.o")

message=$(tests/support/within_memory 900 "${compile[@]}" 2>&1)
[[ -z $message ]] || { echo "unexpected message: $message"; exit 1; }
if message=$(tests/support/within_memory 5 "${compile[@]}" 2>&1); then
  echo "a limit of 5 MB did not stop the compiler: $message"
  exit 1
fi
[[ $message == *"main.o took "*" MB, more than 5 MB"* ]] || { echo "unclear: $message"; exit 1; }
mkdir "$work/joined"
message=$(tests/support/within_memory 5 "${compile[@]/main.o/joined/main.o}" 2>&1 || true)
[[ $message == *"more than 10 MB"* ]] || { echo "a joined source may take twice as much: $message"; exit 1; }
if tests/support/within_memory 900 false; then
  echo "a compiler's error status is lost"
  exit 1
fi
echo "$message"
