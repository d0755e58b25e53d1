#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# A new shape changes no more files than ARCHITECTURE.md says. The bullets of its section "A shape"
# name the files that change for a typical shape, and then those that not every shape needs. All
# other code gets its shapes from src/support/shapes.hpp, from their fields or from their cores.
set -euo pipefail

shape=Capsule
own=${shape,,}       # files with this in their paths are the shape's own
oracle=Pill          # the oracle's name for it
most_hand_written=23 # tests that name every shape of scenes

bad=0
fault() {
  echo "$*"
  bad=1
}

# bullets PART: the files in the bullets before (1) or after (2) the paragraph that separates them.
bullets() {
  awk -v wanted="$1" '
    /^### /            { inside = $0 == "### A shape"; part = 1 }
    /^Not every shape/ { part = 2 }
    /^(\*|[^ ])/       { bullet = /^\*/ }
    inside && bullet && part == wanted
  ' ARCHITECTURE.md | tr '\n' ' ' | grep -oE '`[^`* ]+`' | tr -d '`' |
    sed -E 's@^(cull|draw|dynamics|query|scene|shape)/@include/detent/&@' | sort -u |
    while read -r path; do
      if [[ -f $path && $path != *$own* ]]; then echo "$path"; fi
    done
}
changing=$(bullets 1)
others=$(bullets 2)

# The section's count, and whether each file belongs in it.
counted=$(wc -l <<<"$changing")
written=$(tr '\n' ' ' <ARCHITECTURE.md | grep -oE '[0-9]+ files change' | cut -d ' ' -f 1)
if [[ $counted -ne $written ]]; then
  fault "ARCHITECTURE.md says that $written files change for a new shape, but names $counted"
fi
for file in $changing; do
  [[ $file != src/verify/golden.hpp ]] || continue  # digests of rows by their numbers
  grep -qiE "$own|$oracle" "$file" || fault "$file does not name $shape: ARCHITECTURE.md need not list it"
done

# Code outside of comments that names the shape or includes one of its headers.
for file in $(find include src fuzz -name '*.hpp' -o -name '*.cpp' | grep -v "$own" | sort); do
  grep -qE "\b$shape\b|$own[a-z_]*\.hpp" <(sed 's@//.*@@' "$file") || continue
  grep -qx "$file" <<<"$changing"$'\n'"$others" ||
    fault "$file names $shape: get it from src/support/shapes.hpp or its core, or list the file" \
      'in ARCHITECTURE.md, "A shape"'
done

# Tests with a list of shapes of their own.
scene_shapes=$(awk '/^using SceneShapes/, /;/' src/support/shapes.hpp | grep -oE '[A-Za-z]+<' | tr -d '<')
hand_written=$(grep -rlw --include='*.?pp' "$shape" tests | grep -v "$own" | sort)
for name in $(grep -vx 'ShapeList' <<<"$scene_shapes"); do
  hand_written=$(xargs grep -lw "$name" <<<"$hand_written")
done
count=$(wc -l <<<"$hand_written")
if [[ $count -gt $most_hand_written ]]; then
  echo "$hand_written"
  fault "$count tests name every shape, more than $most_hand_written: use src/support/shapes.hpp"
fi

if [[ $bad -eq 0 ]]; then
  echo "a new shape changes $counted files besides its own; $count tests name every shape"
fi
exit "$bad"
