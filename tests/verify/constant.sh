#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# usage: constant.sh COUNT COMPILER ARGUMENT...
# The compiler itself computes the golden results, COUNT parts of the corpus at a time, because all
# of it takes some compilers gigabytes.
set -euo pipefail

count=$1
shift
if ! command -v "$1" >/dev/null; then
  echo "skipped: $1 is not installed"
  exit 77
fi

mapfile -t parts < <(sed -n '/^struct Basics {/,/^};/p' src/verify/corpus.hpp |
  sed -n '/using Parts = List</,/;/p' | grep -oE '[A-Z][A-Za-z]+' | grep -vx -e Parts -e List)
[[ ${#parts[@]} -gt 20 ]] || { echo 'src/verify/corpus.hpp has no list of parts'; exit 1; }

# Precompiles the common headers where g++ looks for them.
flags=(-std=c++20 -Wall -Wextra -Wconversion -Wshadow -Werror -Iinclude -Isrc)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
echo '#include "verify/check.hpp"' >"$work/check.hpp"
if ((count == 1)); then
  "${@:1:$#-1}" "${flags[@]}" -x c++-header "$work/check.hpp" -o "$work/check.hpp.gch"
fi
for ((i = 0; i < ${#parts[@]}; i += count)); do
  some=$(IFS=,; echo "${parts[*]:i:count}")
  "$@" -DDETENT_VERIFY_PARTS="$some" -include "$work/check.hpp" "${flags[@]}" -fsyntax-only
done
echo "$1 gives the golden answers of ${#parts[@]} parts while it compiles"
