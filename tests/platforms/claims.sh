#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# usage: claims.sh [--write]
# Generates the text of README.md and docs/platforms.md between their "platforms" comments from
# tests/platforms/results, which `run --record` writes. Without --write, fails if a page differs.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

results=tests/platforms/results
verify_results=tests/verify/results.txt
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Prints the results as a block for the page: a summary for the README, more figures elsewhere.
block() {
  awk -F'|' -v page="$1" -v floats="$(sed -n 's/^float|//p' "$results")" \
    -v golden="$(awk '!/^#/ { print $2 }' "$verify_results" | sort -u | wc -l)" '
    function list(text, item) { return text == "" ? item : text ", " item }
    $1 != "row" { next }
    {
      name = $3; result = $10; group = $2
      if (result == "equal") {
        ++equal
        big += $6 == "big"; short += $5 == 32; ours += $7 == "ours"; soft += $8 == "none"
        run = $14 "|" $13 "|" $15
        if (!(run in rows)) runs[++times] = run
        ++rows[run]
        seconds += $11
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
      printf "**%d platforms gave the golden digests and %s differed**: ", equal,
             different ? different : "none"
      # Latest first.
      for (i = 2; i <= times; ++i) {
        for (k = i; k > 1 && runs[k] > runs[k - 1]; --k) {
          run = runs[k]; runs[k] = runs[k - 1]; runs[k - 1] = run
        }
      }
      for (i = 1; i <= times; ++i) {
        split(runs[i], run_of, "|")
        asked = run_of[2] == golden ? "all " golden : run_of[2] " of the present " golden
        printf "%s%d on %s, each with %s queries (results_version %s)", (i > 1 ? "; " : ""),
               rows[runs[i]], run_of[1], asked, run_of[3]
      }
      print "."
      if (failed != "") print "Not equal: " failed "."
      if (compiled) print compiled " more were not run: the compiler evaluated the check and gave the golden answers."
      print floats
      if (page != "README.md") {
        printf "\nOf the %d platforms, %d are big-endian, %d have 32-bit words, %d use our own 128-bit integer and %d have no\n", equal, big, short, ours, soft
        printf "floating-point unit. Compiling and running them took %d seconds of one processor.\n", seconds
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
