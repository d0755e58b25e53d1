#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# usage: fixed_path.sh COMPILER [FLAG...]
# The fixed-point path compiles for a bare machine. From the linker it needs only integer helpers
# and the memory functions that compilers assume: no soft float, no heap, no throw. It is compiled
# without optimisation, so that code that never runs counts too.
set -euo pipefail

if ! command -v "$1" >/dev/null; then
  echo "skipped: $1 is not installed"
  exit 77
fi

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
for part in 1 2; do
  "$@" -std=c++20 -Wall -Wextra -Wconversion -Wshadow -Werror -O0 -ffreestanding -fno-exceptions \
    -fno-rtti -Iinclude -Isrc -DDETENT_PART=$part -c tests/structure/fixed_path.cpp -o "$work/$part.o"
done

symbols=$(nm --undefined-only --format=just-symbols "$work"/[12].o | sort -u)
unexpected=$(grep -vxE 'mem(cpy|move|set|cmp)|__(mul|u?div|u?mod|u?divmod|ashl|ashr|lshr|clz|ctz)(si|di|ti)[234]|_GLOBAL_OFFSET_TABLE_' <<<"$symbols" || true)
if [[ -n $unexpected ]]; then
  echo "the fixed-point path needs more than a bare machine has:"
  c++filt <<<"$unexpected"
  exit 1
fi
echo "needs from the linker: ${symbols:-nothing}"
