#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Every test cited by path in a comment exists.
set -euo pipefail

missing=0
while IFS=: read -r file line test; do
  if [[ ! -e $test ]]; then
    echo "$file:$line: there is no $test"
    missing=1
  fi
done < <(grep -rnoE --include='*.hpp' --include='*.cpp' 'tests/[a-z0-9_/]+\.(test\.)?(cpp|sh)' include src fuzz tests)

if [[ $missing -eq 0 ]]; then echo 'every cited test exists'; fi
exit "$missing"
