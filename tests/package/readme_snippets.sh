#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# usage: readme_snippets.sh COMPILER [README]
# Compiles and runs every ```cpp block of the README. A block without `main` is a fragment: its
# #include lines stay on top, and the rest becomes the body of a `main` that knows all of detent.
set -euo pipefail

compiler=$1
readme=${2:-README.md}
if [[ ! -f $readme ]]; then
  echo "skipped: there is no $readme"
  exit 77
fi

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# One file for each block, named by the line where it starts; #line makes errors point to the README.
awk -v work="$work" -v readme="$readme" '
  /^```cpp[[:space:]]*$/ { file = sprintf("%s/line_%04d.cpp", work, FNR)
                           printf "#line %d \"%s\"\n", FNR + 1, readme >file; next }
  /^```/                 { if (file) close(file); file = ""; next }
  file                   { print >file }
' "$readme"

wrap_fragment() {
  echo '#include <detent/detent.hpp>'
  grep '^#include' "$1" || true
  echo 'using namespace detent; using namespace detent::literals;'
  echo 'int main() {'
  sed 's|^#include|// &|' "$1"
  echo '}'
}

shopt -s nullglob
snippets=("$work"/line_*.cpp)
for snippet in "${snippets[@]}"; do
  if ! grep -q '\bmain *(' "$snippet"; then
    wrap_fragment "$snippet" >"$snippet.wrapped"
    mv "$snippet.wrapped" "$snippet"
  fi
  name=$(basename "$snippet" .cpp)
  "$compiler" -std=c++20 -Wall -Wextra -Wno-unused -Iinclude "$snippet" -o "$work/$name"
  (cd "$work" && "./$name") || { echo "$readme, $name: exit status $?"; exit 1; }
  echo "$readme, $name: compiles and runs"
done

if [[ ${#snippets[@]} -eq 0 ]]; then
  echo "skipped: $readme has no cpp blocks"
  exit 77
fi
