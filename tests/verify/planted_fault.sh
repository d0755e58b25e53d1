#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# usage: planted_fault.sh LIBRARY COMPILER [FLAG...]
# A copy of the library in which one query gives one wrong bit now and then: `detent verify` must
# name the query, the scalar, the dimension and the question. LIBRARY holds the rest of the tool.
set -euo pipefail

library=$1
shift
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/src"
cp -r include "$work/"
cp -r src/verify "$work/src/"

fail() {
  echo "$*"
  [[ ! -e $work/printed ]] || cat "$work/printed"
  exit 1
}

plant() {
  cp "$work/$1" "$work/before"
  sed -i -E "$2" "$work/$1"
  ! cmp -s "$work/before" "$work/$1" || fail "nothing to replace in $1: $2"
}

# In one of 64 intervals the last bit of the exit is wrong.
plant include/detent/query/raycast/sphere.hpp \
  's/return Interval<S>\{\*enter, (.*)\};/const S exit = \1; return Interval<S>{*enter, S::from_raw(static_cast<typename S::raw_type>(exit.raw() % 64 == 21 ? exit.raw() ^ 1 : exit.raw()))};/'
# The other shapes would only cost time.
plant src/verify/corpus.hpp 's/^using Parts = List<SolidRays,.*/using Parts = List<SolidRays>;/'
sed -i '/^using Parts/,/^$/{/^using Parts/!{/^$/!d}}' "$work/src/verify/corpus.hpp"
plant src/verify/corpus.hpp 's/List<Spheres, .*>;/List<Spheres>;/'

"$@" -std=c++20 -O1 -I"$work/include" -I"$work/src" -Isrc/cli -Itests -Itests/verify \
  tests/verify/planted_fault.cpp src/cli/verify.cpp "$work/src/verify/sheets.cpp" \
  "$work/src/verify/parts/solid_rays.cpp" "$library" -pthread -o "$work/faulty"

status=0
"$work/faulty" >"$work/printed" || status=$?
[[ $status -eq 1 ]] || fail "exit $status, not 1"
grep -qE '^raycast/sphere .* ok$' "$work/printed" || fail "a sound query is blamed"
grep -qE '^raycast_interval/sphere .* DIFFERENT$' "$work/printed" || fail "the fault is not seen"
grep -qE '^raycast_interval/sphere differs for q16_16 2D, .*q8_8 3D$' "$work/printed" ||
  fail "the cells are not named"
grep -qE '^  first wrong answer: q16_16 2D, question [0-9]+$' "$work/printed" ||
  fail "the question is not named"
grep -qE '^    ray origin +\{-?[0-9]+, -?[0-9]+\} \(-?[0-9.]+, -?[0-9.]+\)$' "$work/printed" ||
  fail "the question is not shown"
paste -sd ' ' <(sed -nE 's/^    (expected|got) .* to (-?[0-9]+) .*/\2/p' "$work/printed") |
  awk 'NF != 2 || ($1 - $2) ^ 2 != 1 { exit 1 }' || fail "the wrong bit is not shown"
sed -n '/differs for/,$p' "$work/printed"
