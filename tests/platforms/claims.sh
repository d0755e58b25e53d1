#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# usage: claims.sh [--write]
# Generates the text of README.md and docs/platforms.md between their "platforms" comments from
# tests/platforms/results, which `run --record` writes. Without --write, fails if a page differs.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

results=tests/platforms/results
verify_results=tests/verify/results.txt
version=$(sed -n 's/.*results_version = \([0-9]*\).*/\1/p' include/detent/version.hpp)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Prints the results as a block for the page: a summary for the README, more figures elsewhere.
#
# A row counts as many digests of the current version as its last whole run had queries, less those
# whose digests have changed since, plus those that it answered later (with --only) as they are now.
# The queries of a whole run are those of the first version that had as many, because new ones are
# also added to a version.
block() {
  awk -F'|' -v page="$1" -v version="$version" -v floats="$(sed -n 's/^float|//p' "$results")" '
    function list(text, item) { return text == "" ? item : text ", " item }
    # Keeps the least and the greatest of a figure in a group of rows.
    function note(group, figure, value) {
      if (!((group, figure) in least) || value < least[group, figure]) least[group, figure] = value
      if (!((group, figure) in most) || value > most[group, figure]) most[group, figure] = value
    }
    function range(group, figure) {
      if (least[group, figure] == most[group, figure]) return least[group, figure]
      return least[group, figure] " to " most[group, figure]
    }
    # Whether version v of a query has the current digest.
    function is_current(v, name) { return (v, name) in digest && digest[v, name] == digest[version, name] }
    # The version with whose queries a row was run as a whole.
    function asked_in(   v) {
      for (v = 1; v < $15; ++v) if (count_of[v] == $13) return v
      return $15
    }
    # How many queries of that version have changed since the row was run.
    function changed(asked,   count, name) {
      for (name in names_of) count += (asked, name) in digest && !is_current($15, name)
      return count + 0
    }
    # How many queries were answered later, in fields 16 and on, but count only since then.
    function later(asked,   count, i, k, n, name, is_known) {
      for (i = 16; i < NF; i += 3) {
        if ($(i + 1) > last) last = $(i + 1)
        n = split($i, name, " ")
        for (k = 1; k <= n; ++k) {
          is_known = (asked, name[k]) in digest && is_current($15, name[k])
          count += !is_known && is_current($(i + 2), name[k])
        }
      }
      return count + 0
    }
    FNR == NR {
      if (/^#/ || NF == 0) next
      split($0, field, " ")
      digest[field[1], field[2]] = field[4]
      ++count_of[field[1]]
      names_of[field[2]]
      next
    }
    FNR == 1 { golden = count_of[version] }
    $1 != "row" { next }
    {
      name = $3; result = $10; group = $2
      if (result == "equal") {
        ++equal
        big += $6 == "big"; short += $5 == 32; ours += $7 == "ours"; soft += $8 == "none"
        last = $14
        asked = asked_in()
        answered = $13 - changed(asked) + later(asked)
        state = answered == golden ? "current" : "earlier"
        ++rows[state]
        note(state, "date", $14); note(state, "date", last); note(state, "queries", answered)
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
      printf "**%d platforms gave the golden digests and %s differed**.", equal, different ? different : "none"
      printf " Results_version %d has %d digests:", version, golden
      if (rows["current"]) printf " %d platforms gave all (%s)", rows["current"], range("current", "date")
      if (rows["current"] && rows["earlier"]) printf ","
      if (rows["earlier"])
        printf " %d gave %s (%s), because the others are newer than their last run, or do not fit", rows["earlier"],
               range("earlier", "queries"), range("earlier", "date")
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
    }' "$verify_results" "$results"
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
