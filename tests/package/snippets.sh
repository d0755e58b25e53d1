#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# usage: snippets.sh COMPILER [PAGE...]
# Compiles and runs every ```cpp block of the pages, by default README.md and docs/. A block without
# `main` is a fragment: its #include lines stay on top, and the rest becomes the body of a `main`
# that includes all of detent. A comment on the line before a block gives further compiler
# arguments, such as another source file: <!-- compile with: ARGUMENT... -->. tests/c/ covers blocks
# in other languages.
set -euo pipefail

compiler=$1
pages=("${@:2}")
if [[ ${#pages[@]} -eq 0 ]]; then pages=(README.md docs/*.md); fi

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# One file per block, named after its page and line; #line makes errors point to the page.
for page in "${pages[@]}"; do
  awk -v work="$work" -v page="$page" '
    BEGIN { stem = page; gsub(/\//, ".", stem) }
    /^```/ && !inside {
      inside = 1
      if ($0 !~ /^```(cpp|c|csharp|js|json|lua|python|rust|sh|yaml|text)?[[:space:]]*$/) {
        printf "%s:%d: a block of code starts with ```cpp, c, csharp, js, json, lua, python, rust, sh, yaml or text\n", page, FNR
        exit 1
      }
      if ($0 ~ /^```cpp/) {
        file = sprintf("%s/%s.%04d.cpp", work, stem, FNR)
        printf "#line %d \"%s\"\n", FNR + 1, page >file
        if (previous ~ /^<!-- compile with: .* -->$/) {
          print substr(previous, 20, length(previous) - 23) >(file ".arguments")
        }
      }
      next
    }
    /^```/ { if (file) close(file); file = ""; inside = 0; next }
    file { print >file }
    { previous = $0 }
  ' "$page"
done

wrap_fragment() {
  echo '#include <detent/detent.hpp>'
  grep '^#include' "$1" || true
  echo 'using namespace detent; using namespace detent::literals;'
  echo 'int main() {'
  sed 's|^#include|// &|' "$1"
  echo '}'
}

# Precompile the umbrella where the compiler looks first: most blocks begin with it.
compile=("$compiler" -std=c++20 -Wall -Wextra -Wno-unused)
mkdir -p "$work/precompiled/detent"
umbrella=$work/precompiled/detent/detent.hpp
echo "#include \"$PWD/include/detent/detent.hpp\"" >"$umbrella"
"${compile[@]}" -Iinclude -x c++-header "$umbrella" -o "$umbrella.gch"

shopt -s nullglob
snippets=("$work"/*.cpp)
for snippet in "${snippets[@]}"; do
  if ! grep -q '\bmain *(' "$snippet"; then
    wrap_fragment "$snippet" >"$snippet.wrapped"
    mv "$snippet.wrapped" "$snippet"
  fi
  name=$(basename "$snippet" .cpp)
  arguments=()
  if [[ -f $snippet.arguments ]]; then read -ra arguments <"$snippet.arguments"; fi
  "${compile[@]}" -I"$work/precompiled" -Iinclude "$snippet" "${arguments[@]}" -o "$work/$name"
  (cd "$work" && "./$name" >"$name.out") || { echo "$name: exit status $?"; exit 1; }
  echo "$name: compiles and runs"
done

if [[ ${#snippets[@]} -eq 0 ]]; then
  echo "no cpp blocks in ${pages[*]}"
  exit 1
fi
