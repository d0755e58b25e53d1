#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# usage: query_matrix.sh COMPILER [--write] FILE
#
# Writes the tables of FILE between its two "query matrix" comments: for each query the bits of the
# widest number that it computes with. The width comes from the code itself: a call
# in q16_16 and 3D is compiled without optimisation, and the symbols of the object name every
# Fixed<Bits, ...> that a function takes or returns. Without --write, fails if FILE differs.
set -euo pipefail

compiler=$1
mode=check
if [[ $2 == --write ]]; then
  mode=write
  shift
fi
file=$2
command -v nm >/dev/null || { echo 'skipped: there is no nm'; exit 77; }

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

shapes=(Sphere Aabb Obb Plane Triangle Capsule ConvexHull)
declare -A stem=([Sphere]=sphere [Aabb]=aabb [Obb]=obb [Plane]=plane [Triangle]=triangle
                 [Capsule]=capsule [ConvexHull]=hull [Segment]=segment [Ray]=ray
                 [Frustum]=frustum)

# A cell is a program with one call, named by the header's path with dots; where one header has
# several cells, by the shape too.
cell() { # header[+shape] first-argument-type second-argument-type calls...
  local name=$1 header=${1%+*} first=$2 second=$3
  shift 3
  [[ -f include/detent/query/$header.hpp ]] || return 0
  {
    echo "#include \"detent/query/$header.hpp\""
    echo 'using S = detent::q16_16;'
    local call
    for call in "$@"; do
      echo "auto answer_$call(const detent::$first& a, const detent::$second& b) {"
      echo "  return detent::$call(a, b);"
      echo '}'
    done
  } >"$work/${name//\//.}.cpp"
}

for shape in "${shapes[@]}" Segment Ray Frustum; do
  name=${stem[$shape]}
  type="$shape<S, 3>"
  [[ $shape != Frustum ]] || type='Frustum<S>'
  cell "contains/$name" "$type" 'Vec<S, 3>' contains
  cell "closest_point/$name" "$type" 'Vec<S, 3>' closest_point
  cell "distance/$name" "$type" 'Vec<S, 3>' distance
  cell "raycast/$name" 'Ray<S, 3>' "$type" raycast raycast_hit raycast_interval
  cell "intersects/$name" 'Segment<S, 3>' "$type" intersects
done
for shape in "${shapes[@]}"; do
  cell "overlaps/frustum+$shape" "$shape<S, 3>" 'Frustum<S>' overlaps
done
for ((i = 0; i < ${#shapes[@]}; ++i)); do
  for ((j = i; j < ${#shapes[@]}; ++j)); do
    a=${shapes[i]} b=${shapes[j]}
    cell "overlaps/${stem[$a]}_${stem[$b]}" "$a<S, 3>" "$b<S, 3>" overlaps
  done
done

export compiler
(cd "$work" && printf '%s\0' ./*.cpp) | xargs -0 -n 1 -P "$(nproc)" \
  bash -c '"$compiler" -std=c++20 -O0 -Iinclude -c "$0/$1" -o "$0/${1%.cpp}.o"' "$work"

widest() {
  nm -C "$1" | grep -oE 'Fixed<[0-9]+' | grep -oE '[0-9]+' | sort -n | tail -n 1
}

bits() { # header
  local object=$work/${1//\//.}.o
  if [[ -f $object ]]; then widest "$object"; else echo -; fi
}

# A row of the first and the second table: a name, then numbers under the names of the columns.
row() { # name cells...
  local name=$1 width i
  shift
  printf '| %-12s |' "$name"
  for ((i = 1; i <= $#; ++i)); do
    width=${#columns[i - 1]}
    printf ' %*s |' "$width" "${!i}"
  done
  echo
}

rule() {
  local column line='|:-------------|'
  for column in "${columns[@]}"; do line+=$(printf '%*s' $((${#column} + 1)) '' | tr ' ' -):'|'; done
  echo "$line"
}

matrix() {
  local columns shape i j cells operation
  columns=('`contains`' '`closest_point`' '`distance`' '`raycast`' '`intersects`')
  row '' "${columns[@]}"
  rule
  for shape in "${shapes[@]}" Segment Ray Frustum; do
    cells=()
    for operation in "${columns[@]//\`/}"; do cells+=("$(bits "$operation/${stem[$shape]}")"); done
    row "\`$shape\`" "${cells[@]}"
  done
  echo
  columns=("${shapes[@]/#/\`}" '`Frustum')
  columns=("${columns[@]/%/\`}")
  row '`overlaps`' "${columns[@]}"
  rule
  for ((i = 0; i < ${#shapes[@]}; ++i)); do
    cells=()
    for ((j = 0; j < ${#shapes[@]}; ++j)); do
      if ((j < i)); then cells+=(''); else
        cells+=("$(bits "overlaps/${stem[${shapes[i]}]}_${stem[${shapes[j]}]}")")
      fi
    done
    cells+=("$(bits "overlaps/frustum+${shapes[i]}")")
    row "\`${shapes[i]}\`" "${cells[@]}"
  done
}

matrix >"$work/matrix"
awk -v matrix="$work/matrix" '
  /^<!-- query matrix/     { print; while ((getline line <matrix) > 0) print line; skip = 1 }
  /^<!-- end of the query/ { skip = 0 }
  !skip                    { print }
' "$file" >"$work/expected"
grep -q '^<!-- query matrix' "$file" || { echo "$file has no query matrix"; exit 1; }

if [[ $mode == write ]]; then
  cp "$work/expected" "$file"
elif ! diff -u "$file" "$work/expected"; then
  echo "$file: the query matrix is out of date; tests/structure/query_matrix.sh $compiler --write $file"
  exit 1
fi
