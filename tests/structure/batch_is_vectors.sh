#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# usage: batch_is_vectors.sh COMPILER
# The loop over the columns of a batch is compiled to vectors of 16-bit integers, eight per register
# on the oldest x86-64 processor: 12 high-half multiplications in 3D.
set -euo pipefail

command -v "$1" >/dev/null || { echo "skipped: no $1"; exit 77; }
found=$("$1" -std=c++20 -O3 -DNDEBUG -Iinclude -S -o - tests/examples/batch.cpp |
        grep -cE '\bpmulhw\b.*%xmm' || true)
echo "$found multiplications of eight numbers"
[[ $found -ge 12 ]]
