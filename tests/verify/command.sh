#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# usage: command.sh DETENT RESULTS
# Runs `detent verify` as a user does and checks what it prints, writes and returns. Writes the lines
# of `detent verify --results` to RESULTS.
set -euo pipefail

detent=$1 results=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

fail() {
  echo "$*"
  exit 1
}

# Runs `detent verify ARGUMENT...`; sets out, err and the exit status.
run() {
  status=0
  "$detent" verify "$@" >"$work/out" 2>"$work/err" || status=$?
}

# One run answers the full corpus, which takes a minute unoptimised, for all three outputs. The table of
# a run without them goes through the same code as that of --small.
run --golden --results --table
[[ $status -eq 0 ]] || fail "exit $status: $(cat "$work/out" "$work/err")"
sed -n '/^query /,$p' "$work/out" >"$work/table"
sed '1,/^}  \/\/ namespace/d; /^query /,$d' "$work/out" >"$results"
cmp <(sed '/^}  \/\/ namespace/q' "$work/out") src/verify/golden.hpp || fail "src/verify/golden.hpp is not what --golden prints"
grep -qE '^all +[0-9]+  [0-9a-f]{16}  ok$' "$work/table" || fail "no total: $(cat "$work/table")"
! grep -q DIFFERENT "$work/table" || fail "exit 0 in spite of a difference"

run --small
[[ $status -eq 0 ]] || fail "--small: exit $status"
! cmp -s "$work/out" "$work/table" || fail "--small prints what the full corpus does"
cp "$work/out" "$work/small"

run --only raycast/sphere
[[ $status -eq 0 ]] || fail "--only: exit $status"
grep -E '^raycast/sphere ' "$work/out" >"$work/row"
grep -qxF "$(cat "$work/row")" "$work/table" || fail "--only changes a digest"
! grep -qE '^(all|raycast/aabb) ' "$work/out" || fail "--only prints other rows"

run --only raycast/ball
[[ $status -eq 2 && ! -s $work/out && $(wc -l <"$work/err") -eq 1 ]] || fail "a wrong name: $status"
grep -q 'raycast/sphere, .*to_chars' "$work/err" || fail "the error does not list the queries"

run --small --only raycast --json
[[ $(grep -c '"query": "raycast' "$work/out") -eq 24 ]] || fail "a prefix selects every row it begins"
grep -q '"ok": true' "$work/out" || fail "no verdict in the JSON"
! grep -q '"ok": false' "$work/out" || fail "a difference in the JSON"
cmp <(sed -nE 's/ *"digest": //p' "$work/out") <(sed -nE 's/ *"golden": //p' "$work/out") ||
  fail "the JSON has other golden digests than its verdict"

mkdir "$work/dumps"
for threads in 1 3; do
  run --small --dump "$work/dumps/$threads" --threads "$threads"
  cmp "$work/out" "$work/small" || fail "the number of threads shows"
done
cmp "$work/dumps/1" "$work/dumps/3" || fail "two dumps differ"
[[ $(head -c 8 "$work/dumps/1") == "detent 1" ]] || fail "the dump has another beginning"
[[ $(find "$work/dumps" -type f | wc -l) -eq 2 ]] || fail "a temporary file is left"
run --dump "$work/no/such/place"
[[ $status -eq 2 && $(wc -l <"$work/err") -eq 1 ]] || fail "an impossible dump: $status"

# The documents must show what the command prints.
while read -r line; do
  grep -qxF -- "$line" "$work/table" || fail "a document says: $line"
done < <(sed -nE 's/^ *([a-z_/]+ +[0-9]+  [0-9a-f]{16}  ok)$/\1/p' README.md docs/verify.md)

echo "$(grep '^all ' "$work/table")"
