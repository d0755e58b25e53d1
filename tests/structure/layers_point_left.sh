#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# A header includes only its own layer and layers to its left, by the full path "detent/...".
set -euo pipefail

layers=(number math shape cull query scene)
bad=0

for i in "${!layers[@]}"; do
  [[ -d include/detent/${layers[i]} ]] || continue
  allowed=$(IFS='|'; echo "${layers[*]:0:i+1}")
  if grep -rnE '^ *# *include +"' "include/detent/${layers[i]}" |
      grep -vE "\"detent/($allowed)/"; then
    echo "${layers[i]}/ may include only: $allowed"
    bad=1
  fi
done

if [[ $bad -eq 0 ]]; then echo "every include points to its own layer or to the left"; fi
exit "$bad"
