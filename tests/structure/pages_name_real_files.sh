#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# usage: pages_name_real_files.sh [PAGE...]
# Every path in backquotes and every link of the pages names something of this repository: by default
# of those at the top level and in docs/. In backquotes, words count that begin with a folder of the
# top level, with `detent/` as #include has it, or with a layer and end in `.hpp`. A `*`, or a
# name in capitals such as PROPERTY, stands for anything, and something must match.
set -euo pipefail
shopt -s extglob

pages=("$@")
if [[ ${#pages[@]} -eq 0 ]]; then pages=(./*.md docs/*.md); fi

# paths PAGE: its paths, a line each: `code` or `link`, and the path. Paragraphs become one line, so
# that code may be broken in two; blocks of code are left out.
paths() {
  awk '
    function search(paragraph,   code, span, count, words, i) {
      while (match(paragraph, /`[^`]+`/)) {
        span = substr(paragraph, RSTART + 1, RLENGTH - 2)
        paragraph = substr(paragraph, 1, RSTART - 1) "code" substr(paragraph, RSTART + RLENGTH)
        count = split(span, words, " ")
        for (i = 1; i <= count; ++i) print "code " words[i]
      }
      while (match(paragraph, /\]\([^ )]+\)/)) {
        print "link " substr(paragraph, RSTART + 2, RLENGTH - 3)
        paragraph = substr(paragraph, RSTART + RLENGTH)
      }
    }
    /^ *```/ { in_block = !in_block; next }
    in_block { next }
    /^[[:space:]]*$/ { search(text); text = ""; next }
    { text = text " " $0 }
    END { search(text) }
  ' "$1"
}

# place KIND PATH PAGE: where the path leads, as a pattern, or nothing where it is no path of ours.
place() {
  local path=${2%%#*}
  if [[ $1 == link ]]; then
    if [[ -z $path || $path =~ ^[a-z]+: ]]; then return; fi
    echo "$(dirname "$3")/$path"
    return
  fi
  path=${path%%:+([0-9])}
  case $path in
    detent/* | @(number|math|shape|cull|query|scene)/*.hpp) path=include/detent/${path#detent/} ;;
    @(include|src|tests|fuzz|docs|.github|.ci)/*) ;;
    *) return ;;
  esac
  local part pattern=
  IFS=/ read -ra parts <<<"$path"
  for part in "${parts[@]}"; do
    if [[ $part =~ ^[A-Z_]+($|\.) ]]; then part="*${part##+([A-Z_])}"; fi
    pattern+=$part/
  done
  if [[ $path != */ ]]; then pattern=${pattern%/}; fi
  echo "$pattern"
}

# check PAGE...: prints what leads nowhere, and counts in `checked` and `wrong`.
check() {
  local page kind path pattern
  checked=0 wrong=0
  for page in "$@"; do
    while read -r kind path; do
      pattern=$(place "$kind" "$path" "$page")
      if [[ -z $pattern ]]; then continue; fi
      checked=$((checked + 1))
      if ! compgen -G "$pattern" >/dev/null; then
        echo "$page names $path, which is not there"
        wrong=$((wrong + 1))
      fi
    done < <(paths "$page" | sort -u)
  done
}

# Of seven paths in a page four are wrong, and they must be found.
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cat >"$work/page.md" <<'END'
Right are `tests/structure/*.sh`, `fuzz/NAME.cpp` and `./dev fuzz
fuzz/corpus/PROPERTY`. Wrong are `include/detent/nowhere.hpp`, `tests/structure/*.nowhere`,
`number/nowhere.hpp` and [a link](nowhere.md).
END
check "$work/page.md" >"$work/said"
if [[ $checked -ne 7 || $wrong -ne 4 || $(grep -c nowhere "$work/said") -ne 4 ]]; then
  cat "$work/said"
  echo "of the 7 paths of a planted page $checked were found, and $wrong of 4 wrong ones"
  exit 1
fi

check "${pages[@]}"
if [[ $wrong -ne 0 ]]; then exit 1; fi
echo "$checked paths in ${#pages[@]} pages are there"
