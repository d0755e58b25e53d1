#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# A header includes only its own layer and layers to its left, by the full path "detent/...". There
# are two exceptions: for programs that link detent::detent, query/raycast.hpp includes the list of
# compiled instantiations; and the library's version belongs to no layer.
set -euo pipefail

layers=(number math shape cull query scene dynamics draw lockstep)
bad=0

for i in "${!layers[@]}"; do
  [[ -d include/detent/${layers[i]} ]] || continue
  allowed=$(IFS='|'; echo "${layers[*]:0:i+1}")
  if grep -rnE '^ *# *include +"' "include/detent/${layers[i]}" |
      grep -vE "\"detent/($allowed)/|/query/raycast\.hpp:.*\"detent/instantiations\.hpp\"|\"detent/version\.hpp\""; then
    echo "${layers[i]}/ may include only: $allowed"
    bad=1
  fi
done

if [[ $bad -eq 0 ]]; then echo "every include points to its own layer or to the left"; fi
exit "$bad"
