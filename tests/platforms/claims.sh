#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# usage: claims.sh [--write]
# Generates the text of README.md and docs/platforms.md between their "platforms" comments from
# tests/platforms/results, which a full run writes. Without --write, fails if a page differs.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

results=tests/platforms/results
verify_results=tests/verify/results.txt
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

value() { sed -n "s/^$1|//p" "$results"; }

# Prints the results as a block for the page: a summary for the README, more figures elsewhere.
block() {
  awk -F'|' -v page="$1" -v date="$(value date)" -v version="$(value results_version)" \
    -v seconds="$(value seconds)" -v floats="$(value float)" \
    -v golden="$(awk '!/^#/ { print $2 }' "$verify_results" | sort -u | wc -l)" '
    function list(text, item) { return text == "" ? item : text ", " item }
    $1 != "row" { next }
    {
      name = $3; result = $10; group = $2
      if (result == "equal") {
        ++equal
        big += $6 == "big"; short += $5 == 32; ours += $7 == "ours"; soft += $8 == "none"
        if ($13 > most) most = $13
        if (fewest == "" || $13 < fewest) fewest = $13
      } else if (result == "compiles") {
        ++compiled
      } else if (result ~ /^DIFFERENT/) {
        ++different
      } else {
        ++absent
      }
      if (result == "equal" || result == "compiles") {
        if (!(group in count)) groups[++known] = group
        ++count[group]
        names[group] = list(names[group], name)
      } else {
        failed = list(failed, name " (" result ")")
      }
    }
    END {
      printf "On %s **%d platforms gave the golden digests and %s differed**. ", date, equal,
             different ? different : "none"
      if (fewest == golden) ran = "all " golden
      else ran = (most == fewest ? most : fewest " to " most) " of the present " golden
      print "Each ran " ran " queries (results_version " version ")."
      if (failed != "") print "Not equal: " failed "."
      if (compiled) print compiled " more were not run: the compiler evaluated the check and gave the golden answers."
      print floats
      if (page != "README.md") {
        printf "\nOf the %d platforms, %d are big-endian, %d have 32-bit words, %d use our own 128-bit integer and %d have no\n", equal, big, short, ours, soft
        printf "floating-point unit. The run took %d seconds on one processor, compiling included.\n", seconds
      }
      print "\n| platforms | |\n|---|---|"
      for (i = 1; i <= known; ++i) print "| " groups[i] " | " count[groups[i]] ": " names[groups[i]] " |"
    }' "$results"
}

failures=0
for page in README.md docs/platforms.md; do
  block "$page" >"$work/block"
  awk -v block="$work/block" '
    /^<!-- end of the platforms -->/ { hidden = 0 }
    !hidden { print }
    /^<!-- platforms:/ { hidden = 1; while ((getline line <block) > 0) print line }
  ' "$page" >"$work/page"
  grep -q '^<!-- platforms:' "$page" || { echo "$page: no comment '<!-- platforms: ... -->'" >&2; exit 1; }
  if cmp -s "$work/page" "$page"; then continue; fi
  if [[ ${1-} == --write ]]; then
    cp "$work/page" "$page"
  else
    diff "$page" "$work/page" || true
    echo "$page: differs from $results; run tests/platforms/claims.sh --write"
    failures=1
  fi
done
exit "$failures"
