#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Checks what `run` reports for unknown options and missing compilers, and the stack it finds in a
# program whose stack is known.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

failures=0
# run STATUS PATTERN ARGUMENT...
run() {
  local status=0 said
  said=$(./run "${@:3}" 2>&1) || status=$?
  if [[ $status -ne $1 || ! $said =~ $2 ]]; then
    echo "run ${*:3}: status $status, not $1, or it does not say '$2': $said"
    failures=$((failures + 1))
  fi
}

run 0 'usage: ./dev size TABLE' --help
run 2 'usage: ./dev size TABLE'
run 2 "^size: unknown table 'speed'" speed
run 2 "^size: unknown option '--loud'" flash --loud
run 2 "^size: unknown option '--loud'" compile --loud
run 2 "^size: --loud needs a value, or is unknown" instructions --loud
run 2 "^size: unknown option '--loud'" instructions --loud 7
run 2 "^size: --seed needs a number, not 'x'" instructions --seed x
run 2 "^size: no core 'm1'; there are: m0 m3 m4f" instructions --core m1
run 2 "^size: no group 'rays'; there are: raycasts spheres" instructions --group rays
run 2 "^size: --optimise needs 0 to 3 or s" instructions --optimise fast

# An empty folder contains no compilers.
nowhere=$(mktemp -d)
trap 'rm -rf "$nowhere"' EXIT
for tool in bash dirname env; do ln -s "$(command -v "$tool")" "$nowhere/"; done
PATH=$nowhere run 77 '^skipped: arm-none-eabi-g\+\+ is not installed' flash --check
PATH=$nowhere run 2 '^size: arm-none-eabi-g\+\+ is not installed' flash

# `ask` takes 8 bytes and calls a function of 16 bytes, which calls one of the runtime of 12 + 16.
cat >"$nowhere/graph.ci" <<'GRAPH'
graph: { title: "x.cpp"
node: { title: "ask" label: "bool ask()\nx.cpp:1:2\n8 bytes (static)" }
node: { title: "x.cpp:f" label: "void f()\nx.cpp:1:2\n16 bytes (static)" }
node: { title: "__lib" label: "__lib\n<built-in>" shape : ellipse }
edge: { sourcename: "ask" targetname: "x.cpp:f" label: "x.cpp:2:3" }
edge: { sourcename: "x.cpp:f" targetname: "__lib" }
}
GRAPH
cat >"$nowhere/listing" <<'LISTING'
00000000 <ask>:
   0:	push	{r4, r5, r6, r7, lr}
00000010 <__lib>:
  10:	push	{r4, r5, lr}
  12:	sub	sp, #16
  14:	bl	20 <__leaf>
00000020 <__leaf>:
  20:	bx	lr
LISTING
bytes=$(awk -f stack.awk "$nowhere/graph.ci" - <"$nowhere/listing")
if [[ $bytes != 52 ]]; then
  echo "stack.awk finds $bytes bytes, not 52"
  failures=$((failures + 1))
fi

[[ $failures -eq 0 ]]
