#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Only the headers listed in the README use the heap.
set -euo pipefail

allowed='include/detent/number/text.hpp include/detent/cull/list.hpp
         include/detent/scene/mesh/owned.hpp include/detent/scene/sync_test.hpp'
found=$(find include -name '*.hpp' -exec awk '{ sub(/\/\/.*/, ""); print FILENAME ": " $0 }' {} + |
        grep -E '<(vector|string|deque|list|map|set|unordered_[a-z]+|memory|functional)>|\bnew\b|\bmalloc\b' |
        cut -d : -f 1 | sort -u)
for header in $found; do
  case " ${allowed//$'\n'/ } " in
    *" $header "*) ;;
    *) echo "$header uses the heap, or a header of the library that does"; exit 1 ;;
  esac
done
echo 'only these use the heap:' $allowed
