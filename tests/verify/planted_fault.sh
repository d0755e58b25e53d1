#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# usage: planted_fault.sh LIBRARY ORACLE CROSSING COMPILER [FLAG...]
# A copy of the library sometimes returns one wrong bit in a ray query and in a point query. `detent
# verify` must name the queries, scalars, dimensions and questions. LIBRARY has the rest of the
# command, ORACLE and CROSSING its judge.
set -euo pipefail

libraries=("${@:1:3}")
shift 3
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

# In one of 64 intervals, flip the last bit of the exit.
plant include/detent/query/raycast/sphere.hpp \
  's/return Interval<S>\{\*enter, (.*)\};/const S exit = \1; return Interval<S>{*enter, S::from_raw(static_cast<typename S::raw_type>(exit.raw() % 64 == 21 ? exit.raw() ^ 1 : exit.raw()))};/'
# Flip the last bit in one of 64 first coordinates of inside points.
plant include/detent/query/closest_point/sphere.hpp \
  's/^(  if \(radius < 0 \|\| squared <= square\(radius\)\)) return point;/\1 {\n    Vec<S, N> wrong = point;\n    if (point[0].raw() % 64 == 21) wrong[0] = S::from_raw(static_cast<typename S::raw_type>(point[0].raw() ^ 1));\n    return wrong;\n  }/'
# The other shapes would only take time.
plant src/verify/corpus.hpp \
  's/^using Parts = .*;/using Parts = List<SolidRays, RoundPoints>;/'
plant src/verify/corpus.hpp 's/("SolidRays", AimedRays<SphereKind>), .*>;/\1>;/'
plant src/verify/corpus.hpp 's/("RoundPoints", Points<SphereKind>), .*>;/\1>;/'

# Keeps the golden values of the first group and of the eighth: 3 and 4 queries in 8 cells each.
awk '
  /^inline constexpr std::array/ {
    rows = /questions/ ? 1 : 3; others = /questions/ ? 1 : 4; before = /questions/ ? 7 : 21
    item = 0; inside = 1
    sub(/[0-9]+>/, 8 * (rows + others) ">")
    print
    next
  }
  !inside { print; next }
  {
    last = sub(/};/, "")
    for (i = 1; i <= NF; ++i) {
      row = (item - item % 8) / 8
      ++item
      if (row < rows || (row >= before && row < before + others)) print $i
    }
    if (last) { print "};"; inside = 0 }
  }' src/verify/golden.hpp >"$work/src/verify/golden.hpp"

for part in SolidRays RoundPoints; do
  sed "s/@part@/$part/; s/@declarations@//" src/verify/part.cpp.in >"$work/$part.cpp"
done
"$@" -std=c++20 -O1 -I"$work/include" -I"$work/src" -Isrc/cli -Itests -Itests/verify \
  tests/verify/planted_fault.cpp src/cli/verify.cpp "$work"/src/verify/{judge,sheets}.cpp \
  "$work"/{SolidRays,RoundPoints}.cpp "${libraries[@]}" -pthread -o "$work/faulty"

status=0
"$work/faulty" >"$work/printed" || status=$?
[[ $status -eq 1 ]] || fail "exit $status, not 1"
for query in raycast/sphere raycast_hit/sphere contains/sphere on/sphere distance/sphere; do
  grep -qE "^$query .* ok$" "$work/printed" || fail "$query is sound and blamed"
done
for query in raycast_interval/sphere closest_point/sphere; do
  grep -qE "^$query .* DIFFERENT$" "$work/printed" || fail "the fault of $query is not seen"
  sed -n "\#^$query differs for#,/^[^ ]* differs for/p" "$work/printed" >"$work/report"
  grep -qE "^$query differs for q16_16 2D, .*q8_8 3D$" "$work/report" ||
    fail "the cells of $query are not named"
  grep -qE '^  first wrong answer: q16_16 2D, question [0-9]+$' "$work/report" ||
    fail "the question of $query is not named"
done

# shows QUERY NAME LETTERS: the question has a vector named NAME, and the numbers after LETTERS,
# expected and actual, are one unit apart.
shows() {
  sed -n "\#^$1 differs for#,/got /p" "$work/printed" >"$work/report"
  grep -qE "^    $2 +\{-?[0-9]+, -?[0-9]+\} \(-?[0-9.]+, -?[0-9.]+\)$" "$work/report" ||
    fail "the question of $1 is not shown"
  paste -sd ' ' <(sed -nE "s/^    (expected|got) .*$3(-?[0-9]+)[ ,].*/\2/p" "$work/report") |
    awk 'NF != 2 || ($1 - $2) ^ 2 != 1 { exit 1 }' || fail "the wrong bit of $1 is not shown"
}
shows raycast_interval/sphere 'ray origin' ' to '
shows closest_point/sphere point '\{'
sed -n '/differs for/,$p' "$work/printed"
