#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# usage: pages_name_real_files.sh [PAGE...]
# Every path in backquotes and every link of the pages names something in this repository. The pages
# are by default those at the top level and in docs/. A word in backquotes is a path if it begins
# with a top-level folder, with `detent/` as in #include, or with a layer and ends in `.hpp`. A `*`,
# or a name in capitals such as PROPERTY, is a wildcard, which must match something.
set -euo pipefail
shopt -s extglob

pages=("$@")
if [[ ${#pages[@]} -eq 0 ]]; then pages=(./*.md docs/*.md); fi

# paths PAGE: prints its paths, one per line: `code` or `link`, and the path. Paragraphs are joined
# to one line, because code may be broken in two. Code blocks are left out.
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

# place KIND PATH PAGE: prints where the path leads, as a pattern, or nothing if it is not our path.
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

# check PAGE...: prints broken paths, and counts in `checked` and `wrong`.
check() {
  local page kind path pattern
  checked=0 wrong=0
  for page in "$@"; do
    while read -r kind path; do
      pattern=$(place "$kind" "$path" "$page")
      if [[ -z $pattern ]]; then continue; fi
      checked=$((checked + 1))
      if ! compgen -G "$pattern" >/dev/null; then
        echo "$page names $path, which does not exist"
        wrong=$((wrong + 1))
      fi
    done < <(paths "$page" | sort -u)
  done
}

# Self-test: four of a page's seven paths are wrong and must be found.
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
  echo "self-test: found $checked of 7 paths and $wrong of 4 broken ones"
  exit 1
fi

check "${pages[@]}"
if [[ $wrong -ne 0 ]]; then exit 1; fi
echo "$checked paths in ${#pages[@]} pages exist"
