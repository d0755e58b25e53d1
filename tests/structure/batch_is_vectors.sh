#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# usage: batch_is_vectors.sh COMPILER
# The compiler must vectorise the loop over a batch's columns with 16-bit integers, eight per
# register on the oldest x86-64 processor: 12 high-half multiplications in 3D.
set -euo pipefail

command -v "$1" >/dev/null || { echo "skipped: $1 is not installed"; exit 77; }
found=$("$1" -std=c++20 -O3 -DNDEBUG -Iinclude -S -o - tests/examples/batch.cpp |
        grep -cE '\bpmulhw\b.*%xmm' || true)
echo "$found multiplications of eight numbers"
[[ $found -ge 12 ]]
