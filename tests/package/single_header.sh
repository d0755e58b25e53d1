#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# usage: single_header.sh COMPILER
# The single header made by src/amalgamate contains every header once and compiles without a
# warning. Examples from every layer compile with it alone and one of them runs; the program in its
# leading comment runs; two sources that include it link.
set -euo pipefail
command -v python3 >/dev/null || { echo 'skipped: python3 is not installed'; exit 77; }
compiler=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
src/amalgamate "$work/detent.hpp" >/dev/null

sed -n 's|^// ---- ||p' "$work/detent.hpp" | sort >"$work/has"
(cd include && find detent -name '*.hpp' | sort) >"$work/should_have"
diff "$work/should_have" "$work/has" ||
  { echo 'the single header (>) and include/ (<) have different headers'; exit 1; }

# The header is compiled once. It is found next to the examples, before the one in include/.
compile=("$compiler" -std=c++20 -Wall -Wextra -Wconversion -Wshadow -Werror)
echo '#include "detent.hpp"' >"$work/alone.cpp"
"${compile[@]}" -fsyntax-only "$work/alone.cpp"
"${compile[@]}" -Wno-error -x c++-header "$work/detent.hpp" -o "$work/detent.hpp.gch" 2>/dev/null
examples=(batch bodies camera cloth draw events lockstep raycast)
for name in "${examples[@]}"; do
  { echo '#include "detent.hpp"'; sed 's|^#include <detent/.*||' "tests/examples/$name.cpp"; } >"$work/$name.cpp"
  "${compile[@]}" -fsyntax-only "$work/$name.cpp"
done
"${compile[@]}" "$work/raycast.cpp" -o "$work/raycast"
"$work/raycast" >/dev/null || { echo 'the example fails with the single header'; exit 1; }

sed '/^#pragma once$/q' "$work/detent.hpp" | sed -n 's|^//     ||p; s|^//$||p' >"$work/top.cpp"
"${compile[@]}" "$work/top.cpp" -o "$work/top"
[[ $("$work/top") == 'a ball at 9' ]] || { echo 'the program at its top fails'; exit 1; }

printf '#include "detent.hpp"\ndetent::q16_16 one() { return detent::q16_16::from_raw(65536); }\n' \
  >"$work/one.cpp"
printf '#include "detent.hpp"\ndetent::q16_16 one();\nint main() { return one().raw() - 65536; }\n' \
  >"$work/other.cpp"
"${compile[@]}" "$work/one.cpp" "$work/other.cpp" -o "$work/both"
"$work/both" || { echo 'two sources disagree'; exit 1; }
echo "${#examples[@]} examples compile with the single header of $(wc -l <"$work/has") headers"
