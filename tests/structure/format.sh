#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Every C++ source is formatted with clang-format 14. Other versions format some details
# differently.
set -euo pipefail

for formatter in clang-format-14 clang-format; do
  if [[ $("$formatter" --version 2>/dev/null || true) == *"version 14."* ]]; then
    if find . -path ./build -prune -o \( -name '*.hpp' -o -name '*.cpp' \) -print0 |
        xargs -0 "$formatter" --dry-run -Werror --ferror-limit=1; then
      echo "every source is formatted"
      exit 0
    fi
    echo "run ./dev format to fix this"
    exit 1
  fi
done

echo "skipped: clang-format 14 is not installed (on Debian and Ubuntu: apt install clang-format-14)"
exit 77
