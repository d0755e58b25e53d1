#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# usage: constant.sh COUNT COMPILER ARGUMENT...
# The compiler itself computes the golden results, of COUNT parts of the corpus at a time, since all
# of it takes some compilers gigabytes.
set -euo pipefail

count=$1
shift
if ! command -v "$1" >/dev/null; then
  echo "skipped: $1 is not installed"
  exit 77
fi

mapfile -t parts < <(sed -n '/^using Parts = List</,/;/p' src/verify/corpus.hpp |
  grep -oE '[A-Z][A-Za-z]+' | grep -vx -e Parts -e List)
[[ ${#parts[@]} -gt 20 ]] || { echo 'src/verify/corpus.hpp has no list of parts'; exit 1; }
for ((i = 0; i < ${#parts[@]}; i += count)); do
  some=$(IFS=,; echo "${parts[*]:i:count}")
  "$@" -DDETENT_VERIFY_PARTS="$some" -std=c++20 -Wall -Wextra -Wconversion -Wshadow -Werror \
    -Iinclude -Isrc -fsyntax-only
done
echo "$1 gives the golden answers of ${#parts[@]} parts while it compiles"
