#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# usage: c99.sh MATCH_IN_CPP LIBRARY
# A C99 program compiles without a warning, links the shared library and plays the same match as the
# C++ program. The library exports exactly the functions of detent.h.
set -euo pipefail
compiler=$(command -v gcc || command -v cc) || { echo 'skipped: no C compiler is installed'; exit 77; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
folder=$(dirname "$2")

compile() {
  "$compiler" -std=c99 -pedantic -Wall -Wextra -Wconversion -Wshadow -Werror -Iinclude "$1" \
    -L"$folder" -ldetent -Wl,-rpath,"$folder" -o "$2"
}
# Structures also have their sizes where words are shorter and aligned differently.
if echo | "$compiler" -m32 -x c -E - >/dev/null 2>&1; then
  "$compiler" -std=c99 -m32 -ffreestanding -fsyntax-only -x c include/detent.h
fi
compile tests/c/match.c "$work/match"
in_c=$("$work/match")
in_cpp=$("$1")
if [[ $in_c != "$in_cpp" ]]; then
  echo "the match ends with $in_c in C, with $in_cpp in C++"
  exit 1
fi

falls=$(bash tests/c/falls.sh)
for number in 1 2; do
  bash tests/docs/block.sh docs/bindings.md c $number >"$work/page.c"
  compile "$work/page.c" "$work/page"
  said=$("$work/page")
  [[ $said == 'object 0 at 9.000000' || ($number == 2 && $said == "$falls") ]] ||
    { echo "program $number of the page prints $said"; exit 1; }
done

nm -D --defined-only "$2" | sed 's/.* //' | sort >"$work/visible"
sed -n 's/^DETENT_API .*[ *]\(detent_[a-z0-9_]*\)(.*/\1/p' include/detent.h | sort >"$work/declared"
diff "$work/declared" "$work/visible" || { echo 'the library exports other functions'; exit 1; }
echo "the match ends with $in_c; $(wc -l <"$work/visible") functions are visible"
