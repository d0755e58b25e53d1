#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# usage: query_matrix.sh COMPILER [--write] FILE
#
# Writes the tables of FILE between its two "query matrix" comments: for each query, the bits of the
# widest number that it computes with. The width comes from the code: a call in q16_16 and 3D is
# compiled without optimisation, the linker drops what the call does not reach, and the remaining
# symbols name every Fixed<Bits, ...> that a function takes or returns. Without --write, fails if
# FILE differs.
set -euo pipefail

compiler=$1
mode=check
if [[ $2 == --write ]]; then
  mode=write
  shift
fi
file=$2
for tool in ld nm; do
  command -v $tool >/dev/null || { echo "skipped: $tool is not installed"; exit 77; }
done

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

shapes=($(awk '/^using SceneShapes/, /;/' src/support/shapes.hpp | grep -oE '[A-Za-z]+<S, N>' |
  cut -d '<' -f 1) ConvexHull)
declare -A stem=()
for shape in "${shapes[@]}" Segment Ray Frustum; do stem[$shape]=${shape,,}; done
stem[ConvexHull]=hull

# A cell is a function with one or a few calls, in its group's source, so that shared code is
# compiled once. It is named after the header's path; if one header has several cells, also after
# the shape.
declare -A function_of=() group_of=()
cell() { # group header[+shape] parameters calls...
  local group=$1 name=$2 header=${2%+*} parameters=$3 call
  shift 3
  [[ -f include/detent/query/$header.hpp ]] || return 0
  function_of[$name]=cell_${#function_of[@]}
  group_of[$name]=$group
  [[ -f $work/$group.cpp ]] || {
    echo '#include "detent/number/fixed.hpp"'
    echo 'using S = detent::q16_16;'
  } >"$work/$group.cpp"
  {
    echo "#include \"detent/query/$header.hpp\""
    echo "extern \"C\" void ${function_of[$name]}($parameters) {"
    for call in "$@"; do echo "  static_cast<void>(detent::$call);"; done
    echo '}'
  } >>"$work/$group.cpp"
}

for shape in "${shapes[@]}" Segment Ray Frustum; do
  name=${stem[$shape]}
  type="$shape<S, 3>"
  [[ $shape != Frustum ]] || type='Frustum<S>'
  shape_and_point="const detent::$type& a, const detent::Vec<S, 3>& b"
  cell point "contains/$name" "$shape_and_point" 'contains(a, b)'
  cell point "closest_point/$name" "$shape_and_point" 'closest_point(a, b)'
  cell point "distance/$name" "$shape_and_point" 'distance(a, b)'
  cell line "raycast/$name" "const detent::Ray<S, 3>& a, const detent::$type& b" \
    'raycast(a, b)' 'raycast_hit(a, b)' 'raycast_interval(a, b)'
  cell line "intersects/$name" "const detent::Segment<S, 3>& a, const detent::$type& b" \
    'intersects(a, b)'
done
for shape in "${shapes[@]}"; do
  cell overlaps "overlaps/frustum+$shape" \
    "const detent::$shape<S, 3>& a, const detent::Frustum<S>& b" 'overlaps(a, b)'
done
# Queries of two shapes: one row per first shape, with the second shapes that need the widest
# numbers.
pair_queries=(distance closest_points contact cast)
for query in "${pair_queries[@]}"; do
  for a in "${shapes[@]}"; do
    [[ $query-$a != cast-Plane ]] || continue  # planes do not move
    calls=("$query(a, b)" "$query(a, c)")
    if [[ $query == cast ]]; then calls=('cast(a, d, S(1), b)' 'cast(a, d, S(1), c)'); fi
    cell "$query" "$query+$a" "const detent::$a<S, 3>& a, const detent::Obb<S, 3>& b,
      const detent::Capsule<S, 3>& c, [[maybe_unused]] const detent::Direction<S, 3>& d" \
      "${calls[@]}"
  done
done
for ((i = 0; i < ${#shapes[@]}; ++i)); do
  for ((j = i; j < ${#shapes[@]}; ++j)); do
    a=${shapes[i]} b=${shapes[j]}
    cell overlaps "overlaps/${stem[$a]}_${stem[$b]}" \
      "const detent::$a<S, 3>& a, const detent::$b<S, 3>& b" 'overlaps(a, b)'
  done
done

export compiler
# These parameters make g++ collect garbage rarely but stay below 900 MB; clang++ ignores them.
(cd "$work" && printf '%s\0' *.cpp) | xargs -0 -n 1 -P "$(nproc)" \
  bash -c '"$compiler" -std=c++20 -O0 -ffunction-sections -Iinclude \
    --param=ggc-min-heapsize=560000 --param=ggc-min-expand=10 -c "$0/$1" -o "$0/${1%.cpp}.o"' "$work"

bits() { # cell
  local function=${function_of[$1]-}
  if [[ ! $function ]]; then
    echo -
    return
  fi
  ld --gc-sections --entry="$function" --unresolved-symbols=ignore-all -o "$work/reached" \
    "$work/${group_of[$1]}.o"
  nm -C "$work/reached" | grep -oE 'Fixed<[0-9]+' | grep -oE '[0-9]+' | sort -n | tail -n 1
}

# Prints a row of the first or second table: a name, then numbers below the column names.
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
  echo
  columns=("${pair_queries[@]/#/\`}")
  columns=("${columns[@]/%/\`}")
  row 'two shapes' "${columns[@]}"
  rule
  for shape in "${shapes[@]}"; do
    cells=()
    for operation in "${pair_queries[@]}"; do cells+=("$(bits "$operation+$shape")"); done
    row "\`$shape\`" "${cells[@]}"
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
