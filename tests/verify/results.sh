#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# usage: results.sh FILE, with the output of `detent verify --results`
# A results version gives every question the same result forever. results.txt records, as digests,
# which version gave which results for which questions. Lines are added and never changed, so a
# changed result needs a higher results_version and a line in the changelog.
set -euo pipefail

table=tests/verify/results.txt
bad=0 checked=

complain() {
  echo "$*"
  bad=1
}

while read -r version query questions answers; do
  known=$(awk -v v="$version" -v q="$query" -v a="$questions" \
    '$1 == v && $2 == q && $3 == a { print $4 }' "$table")
  if [[ -z $known ]]; then
    complain "$table lacks this line: $version $query $questions $answers"
  elif [[ $known != "$answers" ]]; then
    complain "$query: results_version $version answered $known so far, and now $answers;" \
      "raise results_version in include/detent/version.hpp (see docs/verify.md)"
  fi
  checked=1
done <"$1"
[[ $checked ]] || complain "$1 has no results"

version=$(sed -nE 's/.*results_version = ([0-9]+);.*/\1/p' include/detent/version.hpp)
newest=$(awk '!/^#/ { print $1 }' "$table" | sort -n | tail -n 1)
[[ $newest == "$version" ]] ||
  complain "$table ends with version $newest, but the library has version $version"
grep -qE "\*RES\*.*results_version $version\b" CHANGELOG.md ||
  complain "CHANGELOG.md has no line with *RES* and \"results_version $version\""

if git rev-parse --is-inside-work-tree >/dev/null 2>&1; then
  while read -r commit; do
    while read -r line; do
      complain "$table had this line in $commit: $line"
    done < <(git show "$commit:$table" 2>/dev/null | grep -v '^#' | grep -vxF -f "$table")
  done < <(git log --format=%h -- "$table")
fi

if [[ $bad -eq 0 ]]; then echo "version $version answers as it always did"; fi
exit "$bad"
