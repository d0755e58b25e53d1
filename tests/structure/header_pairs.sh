#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# usage: header_pairs.sh COMPILER
# Headers compile in any order, detent.hpp includes all of them, and a surface and one of its
# queries compile from their two headers in either order.
set -euo pipefail

compile=("$1" -std=c++20 -fsyntax-only -Wall -Wextra -Werror -Iinclude)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# expect_to_compile WHAT, with the source on standard input
expect_to_compile() {
  cat >"$work/source.cpp"
  if ! "${compile[@]}" "$work/source.cpp" 2>"$work/errors"; then
    grep -m 5 'error' "$work/errors"
    echo "does not compile: $1"
    exit 1
  fi
}

all() { find include -name '*.hpp' -printf '#include "%P"\n' | sort "$@"; }
all | expect_to_compile 'all headers in the order of their names'
all -r | expect_to_compile 'all headers in the reverse order'

# The headers for programs that link the compiled library.
echo '#include <detent/detent.hpp>' >"$work/umbrella.cpp"
missing=$(comm -13 <("$1" -std=c++20 -Iinclude -M "$work/umbrella.cpp" |
                       grep -oE 'include/detent/[^ ]+' | sort -u) \
                   <(find include -name '*.hpp' | grep -v '/instantiations\.hpp$' | sort))
if [[ -n $missing ]]; then
  echo "detent.hpp does not include:" $missing
  exit 1
fi

# Headers with a type of surface, and the type; headers with queries, and their purpose.
surfaces=('mesh/mesh.hpp Mesh' 'mesh/placed.hpp PlacedMesh'
  'height_field/height_field.hpp HeightField')
queries=('mesh/raycast.hpp raycast_nearest(ray, surface)'
  'mesh/closest_point.hpp nearest_triangle(surface, point)'
  'mesh/contains.hpp contains(surface, point)'
  'mesh/overlaps.hpp intersects(segment, surface)'
  'mesh/pairs.hpp overlaps(surface, surface)')
count=0
for surface in "${surfaces[@]}"; do
  for query in "${queries[@]}"; do
    headers=("${surface%% *}" "${query%% *}")
    if ((count++ % 2)); then headers=("${query%% *}" "${surface%% *}"); fi
    expect_to_compile "${headers[*]}: ${query#* }" <<END
#include "detent/shape/segment.hpp"
#include "detent/scene/${headers[0]}"
#include "detent/scene/${headers[1]}"
using namespace detent;
auto answer(const ${surface#* }<q8_8>& surface, [[maybe_unused]] const Ray<q8_8, 3>& ray,
            [[maybe_unused]] const Vec<q8_8, 3>& point,
            [[maybe_unused]] const Segment<q8_8, 3>& segment) {
  return ${query#* };
}
END
  done
done

expect_to_compile 'scene/scene.hpp alone' <<'END'
#include "detent/scene/scene.hpp"
using namespace detent;
auto answer(const Scene<q8_8, 3, Sphere, Triangle>& scene, const Ray<q8_8, 3>& ray,
            const Vec<q8_8, 3>& point, const Obb<q8_8, 3>& box) {
  return scene.nearest(ray).has_value() + scene.nearest(point).has_value() + scene.any(box) +
         scene.overlaps().size();
}
END
# A header's overloads must not change what another layer's templates call.
for headers in 'dynamics/dynamics.hpp query/query.hpp' 'query/query.hpp dynamics/dynamics.hpp'; do
  expect_to_compile "$headers: worlds and queries" <<END
#include "detent/${headers% *}"
#include "detent/${headers#* }"
using namespace detent;
template <class A, class B>
auto ask(const A& a, const B& b) {
  return distance(a, b) == 0 && contact(a, b) && overlaps(a, b);
}
bool answer(World<q8_8, 3, Aabb, Obb, Capsule>& world, const Aabb<q8_8, 3>& a, const Obb<q8_8, 3>& b,
            const Capsule<q8_8, 3>& c) {
  world.step();
  return ask(a, b) && ask(b, c) && ask(c, a) && cast(c, Direction<q8_8, 3>::along(0), q8_8(1), a);
}
END
done
echo "headers compile in both orders, and $count pairs of surfaces and queries"
