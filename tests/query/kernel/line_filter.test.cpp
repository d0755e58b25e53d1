// SPDX-License-Identifier: MIT
#include "detent/query/kernel/line_filter.hpp"

#include "detent/query/raycast/triangle.hpp"
#include "support/catch.hpp"
#include "support/random_vec.hpp"

namespace detent::test {
namespace {

TEMPLATE_TEST_CASE("line filter: rejects exactly the triangles that the line misses", "", q16_16,
                   q14_16, q24_8, q8_8) {
  using S = TestType;
  Random random(0x9a55);
  const auto point = [&](int size) { return random_vec<S, 3>(random, -size, size); };
  int met = 0, missed = 0, seen_from_edge = 0;
  for (int i = 0; i < 20'000; ++i) {
    // Few raw units, so that corners and edges are often hit, but long enough to cross the
    // triangle.
    const int size = random.one_in(2) ? 6 : 5'000;
    const auto direction = random.one_in(8)
                               ? Direction<S, 3>::along(static_cast<int>(random.between(0, 2)))
                               : normalize(point(size));
    if (!direction) continue;
    Triangle<S, 3> triangle{point(size), point(size), point(size)};
    if (random.one_in(20)) triangle.c = triangle.b;
    const Ray<S, 3> ray{random.one_in(2) ? triangle.a : point(size), *direction, S::max()};
    const Ray<S, 3> back{ray.origin, -*direction, S::max()};
    const bool meets = raycast(ray, triangle) || raycast(back, triangle);
    const bool misses = detail::LineFilter<S>(ray).meets(triangle) == Filtered::no;
    INFO(i);
    if (misses) REQUIRE_FALSE(meets);
    const bool is_edge_on = detail::RayTriangle<S>(ray, triangle).det == 0;
    seen_from_edge += is_edge_on ? 1 : 0;
    if (is_edge_on || direction->vec().z == 0) continue;
    REQUIRE(misses != meets);
    ++(misses ? missed : met);
  }
  CHECK(met > 2'000);
  CHECK(missed > 2'000);
  CHECK(seen_from_edge > 200);
}

TEST_CASE("line filter: rejects nothing in float and double") {
  const auto misses = []<class S>(S) {
    const Ray<S, 3> ray{{S(0), S(0), S(0)}, Direction<S, 3>::along(2), S(9)};
    return detail::LineFilter<S>(ray).meets(
               {{S(5), S(5), S(1)}, {S(6), S(5), S(1)}, {S(5), S(6), S(1)}}) == Filtered::no;
  };
  CHECK_FALSE(misses(0.0F));
  CHECK_FALSE(misses(0.0));
  CHECK(misses(q16_16()));
}

}  // namespace
}  // namespace detent::test
