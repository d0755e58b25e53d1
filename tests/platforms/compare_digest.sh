#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# usage: compare_digest.sh GOLDEN COMPILER [FLAG...]
# Builds the digest program with these flags, runs it and compares what it prints with GOLDEN.
set -euo pipefail

golden=$1
shift
if ! command -v "$1" >/dev/null; then
  echo "skipped: $1 is not installed"
  exit 77
fi

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$@" -std=c++20 -Iinclude -Itests tests/platforms/digest.cpp -o "$work/digest"
"$work/digest" >"$work/printed"

if ! diff "$golden" "$work/printed"; then
  echo "'$*' disagrees with $golden: < golden, > printed"
  exit 1
fi
echo "'$*' prints the golden digest"
