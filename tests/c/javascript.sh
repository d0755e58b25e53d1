#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# usage: javascript.sh MATCH_IN_CPP
# The WebAssembly modules compile and stay below their size limit, the tests of the JavaScript
# binding pass in node, and the page's programs run. If installed, tsc compiles the types and
# Chromium plays the match.
set -euo pipefail
command -v node >/dev/null || { echo 'skipped: node is not installed'; exit 77; }
(($(node -p 'process.versions.node.split(".")[0]') >= 20)) ||
  { echo 'skipped: node is older than 20'; exit 77; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
bindings/js/build "$work"
DETENT_WASM=$work DETENT_MATCH=$("$1") node --test bindings/js/tests/
cp bindings/js/*.mjs "$work"
if command -v tsc >/dev/null; then  # Debian: node-typescript
  mkdir -p "$work/types/node_modules/detent"
  cp bindings/js/*.mts bindings/js/package.json "$work/types/node_modules/detent"
  cp bindings/js/tests/types.mts "$work/types"
  (cd "$work/types" && tsc --strict --noEmit --module nodenext --target es2022 --lib es2022,dom types.mts)
fi
if command -v chromium >/dev/null; then
  cp -r bindings/js/examples "$work"
  said=$(node tests/c/browser.mjs chromium "$work")
  [[ $said == "$("$1")" ]] || { echo "in a browser the match ends with $said"; exit 1; }
fi
falls=$(bash tests/c/falls.sh) number=0
for wanted in "$falls" 9; do
  number=$((number + 1))
  bash tests/docs/block.sh docs/bindings.md js $number | sed "s|'detent'|'./index.mjs'|" >"$work/page.mjs"
  said=$(node "$work/page.mjs")
  [[ $said == "$wanted" ]] || { echo "program $number of the page prints $said"; exit 1; }
done
