#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The rules in docs/tutorial.md equal tests/examples/tag/rules.hpp, which its later steps include.
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
sed -n '/^\/\/ rules\.hpp:/,/^```$/{/^```$/d;p}' docs/tutorial.md >"$work/page"
tail -n +2 tests/examples/tag/rules.hpp >"$work/file"
diff "$work/file" "$work/page" || { echo 'docs/tutorial.md (>) has other rules than the file (<)'; exit 1; }
steps=$(grep -c '^## [0-9]' docs/tutorial.md)
[[ $steps -eq 10 ]] || { echo "the tutorial has $steps steps"; exit 1; }
echo "the rules have $(wc -l <"$work/page") lines, in the page and in the file"
