#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# usage: csharp.sh MATCH_IN_CPP LIBRARY
# The C# binding compiles without a warning in Mono, its tests pass, and the page's programs run.
set -euo pipefail
command -v mcs >/dev/null && command -v mono >/dev/null || { echo 'skipped: mono is not installed'; exit 77; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mcs -unsafe -optimize -warnaserror -nowarn:0649 -out:"$work/tests.exe" \
  bindings/csharp/*.cs bindings/csharp/examples/*.cs bindings/csharp/tests/*.cs
folder=$(dirname "$(realpath "$2")")
DETENT_MATCH=$("$1") LD_LIBRARY_PATH=$folder mono "$work/tests.exe"
number=0
for wanted in 'True 9' '10 10 2'; do
  number=$((number + 1))
  bash tests/docs/block.sh docs/bindings.md csharp $number >"$work/page.cs"
  mcs -unsafe -warnaserror -nowarn:0649 -out:"$work/page.exe" bindings/csharp/*.cs "$work/page.cs"
  said=$(LD_LIBRARY_PATH=$folder mono "$work/page.exe")
  [[ $said == "$wanted" ]] || { echo "program $number of the page prints $said"; exit 1; }
done
