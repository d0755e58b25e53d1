#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# No header of math, shape, query, scene, dynamics, draw or lockstep names a built-in number type,
# <cmath> or a limit. Only number/ rounds; cull/ has its own integers.
set -euo pipefail

words='float|double|int64_t|numeric_limits|std::sqrt|std::reduce|std::transform_reduce|epsilon'
layers=()
for layer in math shape query scene dynamics draw lockstep; do
  if [[ -d include/detent/$layer ]]; then layers+=("include/detent/$layer"); fi
done

# Comments may mention floats, so awk removes them and keeps the line numbers.
found=$(find "${layers[@]}" -name '*.hpp' -exec \
          awk '{ sub(/\/\/.*/, ""); print FILENAME ":" FNR ":" $0 }' {} + |
        grep -E "(\b($words)\b)|<cmath>|<math\.h>|<limits>" || true)
if [[ -n $found ]]; then
  echo "$found"
  echo "use the types and rounding functions of number/ instead"
  exit 1
fi
echo "no built-in number type right of number/"
