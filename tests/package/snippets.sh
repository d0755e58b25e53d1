#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# usage: snippets.sh COMPILER [PAGE...]
# Compiles and runs every ```cpp block of the pages, by default README.md and docs/. A block without
# `main` is a fragment: its #include lines go to the top of a program that includes all of detent,
# and the rest becomes the body of a function there. A comment on the line before a program gives
# further compiler arguments, such as another source file: <!-- compile with: ARGUMENT... -->.
# DETENT_FRAGMENT_COMPILER names another compiler for that program, which is the largest.
# tests/c/ covers blocks in other languages.
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

# Fragments become functions of one program, which calls each in turn.
is_fragment() { [[ ! -f $1.arguments ]] && ! grep -q '\bmain *(' "$1"; }
fragments_program() { # FILE...
  local file
  echo '#include <detent/detent.hpp>'
  grep -h '^#include' "$@" | sort -u
  echo 'using namespace detent; using namespace detent::literals;'
  for file in "$@"; do
    echo "int $(function_of "$file")() {"
    sed 's|^#include|// &|' "$file"
    echo 'return 0; }'
  done
  echo '#include <cstdio>'
  echo 'int main() {'
  for file in "$@"; do
    echo "if (const int status = $(function_of "$file")()) {"
    echo "  std::fprintf(stderr, \"$(basename "$file" .cpp): returns %d\\n\", status); return 1; }"
  done
  echo '}'
}
function_of() { basename "$1" .cpp | tr -c '[:alnum:]\n' _ | sed 's/^/block_/'; }

# Precompile the umbrella where g++ looks first: most blocks begin with it.
flags=(-std=c++20 -Wall -Wextra -Wno-unused)
mkdir -p "$work/precompiled/detent"
umbrella=$work/precompiled/detent/detent.hpp
echo "#include \"$PWD/include/detent/detent.hpp\"" >"$umbrella"
"$compiler" "${flags[@]}" -Iinclude -x c++-header "$umbrella" -o "$umbrella.gch"

run_program() { # NAME SOURCE [COMPILER ARGUMENT...]
  "$compiler" "${flags[@]}" -I"$work/precompiled" -Iinclude "${@:2}" -o "$work/$1"
  (cd "$work" && "./$1" >"$1.out") || { echo "$1: exit status $?"; exit 1; }
  echo "$1: compiles and runs"
}

shopt -s nullglob
snippets=("$work"/*.cpp) fragments=()
if [[ ${#snippets[@]} -eq 0 ]]; then
  echo "no cpp blocks in ${pages[*]}"
  exit 1
fi
for snippet in "${snippets[@]}"; do
  if is_fragment "$snippet"; then
    fragments+=("$snippet")
    continue
  fi
  arguments=()
  if [[ -f $snippet.arguments ]]; then read -ra arguments <"$snippet.arguments"; fi
  run_program "$(basename "$snippet" .cpp)" "$snippet" "${arguments[@]}"
done
if [[ ${#fragments[@]} -gt 0 ]]; then
  mkdir "$work/fragments"
  fragments_program "${fragments[@]}" >"$work/fragments/all.cpp"
  compiler=${DETENT_FRAGMENT_COMPILER:-$compiler}
  run_program "${#fragments[@]}-fragments" "$work/fragments/all.cpp"
fi
