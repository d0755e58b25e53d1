#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The headers that CMake installs (the arguments) are the headers that exist.
set -euo pipefail

if difference=$(diff <(printf '%s\n' "$@" | sed 's|^.*/include/|include/|' | sort) \
                     <(find include -name '*.hpp' | sort)); then
  echo "all $# headers are listed"
else
  echo "CMakeLists.txt (<) and include/ (>) name different headers:"
  grep '^[<>]' <<<"$difference"
  exit 1
fi
