// SPDX-License-Identifier: MIT
#include "query/overlaps/hulls.hpp"

namespace detent::test {
namespace {

constexpr auto corners = diamond<q16_16, 3>();
static_assert(overlaps(ConvexHull{corners}, ConvexHull{corners}));
static_assert(overlaps(ConvexHull{corners}, Sphere{at<q16_16, 3>(8, 3), q16_16(5)}));
static_assert(!overlaps(ConvexHull{corners}, Sphere{at<q16_16, 3>(8, 3), q16_16(4)}));

TEMPLATE_TEST_CASE("overlaps, hull: every shape hits, misses and touches it", "[overlaps]",
                   DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto point = [](double x, double y) { return at<S, N>(x, y); };
  const auto solid = diamond<S, N>();
  const auto r = [](double radius) { return num<S>(radius); };

  CHECK(meets(Sphere<S, N>{point(8, 3), r(5)}, solid));
  CHECK_FALSE(meets(Sphere<S, N>{point(8, 3), r(4.5)}, solid));
  CHECK(meets(Sphere<S, N>{point(1, 1), r(0)}, solid));

  const auto diagonal = toward<S, N>(1, 0);
  CHECK(meets(Plane<S, N>{diagonal, r(4)}, solid));
  CHECK_FALSE(meets(Plane<S, N>{diagonal, r(4.5)}, solid));
  CHECK(meets(Plane<S, N>{diagonal, r(0)}, solid));

  CHECK(meets(Triangle<S, N>{point(2, 2), point(9, 2), point(2, 9)}, solid));
  CHECK_FALSE(meets(Triangle<S, N>{point(2, 2.5), point(9, 2), point(2, 9)}, solid));
  CHECK(meets(Triangle<S, N>{point(-9, -9), point(9, -9), point(0, 9)}, solid));

  CHECK(meets(Capsule<S, N>{point(8, 3), point(18, 3), r(5)}, solid));
  CHECK_FALSE(meets(Capsule<S, N>{point(8, 3), point(18, 3), r(4.5)}, solid));
  CHECK(meets(Capsule<S, N>{point(-9, 6), point(9, 6), r(2)}, solid));
  CHECK_FALSE(meets(Capsule<S, N>{point(-9, 6), point(9, 6), r(1.5)}, solid));
  CHECK(meets(Capsule<S, N>{point(-9, 0), point(9, 0), r(0)}, solid));

  CHECK(meets(Segment<S, N>{point(0, 4), point(4, 8)}, solid));
  CHECK(meets(Segment<S, N>{point(-9, 1), point(9, 1)}, solid));
  CHECK_FALSE(meets(Segment<S, N>{point(0, 4.5), point(4.5, 0)}, solid));

  auto other = solid;
  for (auto& corner : other) corner.x = nearest_to<S>(corner.x + num<S>(8));
  CHECK(meets(solid, other));
  for (auto& corner : other) corner.x = nearest_to<S>(corner.x + num<S>(0.5));
  CHECK_FALSE(meets(solid, other));
}

TEMPLATE_TEST_CASE("overlaps, hull: flat, a segment, a point or empty", "[overlaps]",
                   DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto sheet = flat<S, N>();
  auto upright = sheet;
  for (auto& corner : upright) std::swap(corner.x, corner[N - 1]);
  CHECK(meets(sheet, upright));
  for (auto& corner : upright) corner[N - 1] = nearest_to<S>(corner[N - 1] + num<S>(4));
  CHECK(meets(sheet, upright));
  for (auto& corner : upright) corner[N - 1] = nearest_to<S>(corner[N - 1] + num<S>(0.5));
  CHECK_FALSE(meets(sheet, upright));
  const Points<S, N, 1> place{at<S, N>(1)};
  const Points<S, N, 3> line{at<S, N>(-2), at<S, N>(3), at<S, N>(0)};
  CHECK(meets(place, sheet));
  CHECK(meets(place, line));
  CHECK(meets(line, sheet));
  CHECK(meets(place, place));
  CHECK_FALSE(meets(place, Points<S, N, 1>{at<S, N>(1, 1)}));

  const auto solid = diamond<S, N>();
  const ConvexHull<S, N> none;
  CHECK_FALSE(overlaps(none, none));
  CHECK_FALSE(overlaps(none, ConvexHull<S, N>{solid}));
  CHECK_FALSE(overlaps(ConvexHull<S, N>{solid}, none));
  CHECK_FALSE(overlaps(Sphere<S, N>{{}, num<S>(9)}, none));
  CHECK_FALSE(overlaps(Plane<S, N>{}, none));
  CHECK_FALSE(overlaps(Capsule<S, N>{{}, {}, num<S>(9)}, none));
  CHECK_FALSE(overlaps(Triangle<S, N>{}, none));
  CHECK_FALSE(intersects(Segment<S, N>{}, none));
  CHECK_FALSE(meets(Sphere<S, N>{{}, num<S>(-1)}, solid));
  CHECK_FALSE(meets(Capsule<S, N>{{}, {}, num<S>(-1)}, solid));
}

TEMPLATE_TEST_CASE("overlaps, hull: one raw unit decides, at the ends of the domain too",
                   "[overlaps]", DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto half = half_domain<S, N>();
  const auto on = Vec<S, N>(), beside = in_steps<S, N>(-1, 0);
  CHECK(meets(Sphere<S, N>{on, S(0)}, half));
  CHECK_FALSE(meets(Sphere<S, N>{beside, S(0)}, half));
  CHECK(meets(Sphere<S, N>{beside, moved(S(0), 1)}, half));
  CHECK(meets(Capsule<S, N>{on, on, S(0)}, half));
  CHECK_FALSE(meets(Capsule<S, N>{beside, beside, S(0)}, half));
  CHECK(meets(Triangle<S, N>{on, on, on}, half));
  CHECK_FALSE(meets(Triangle<S, N>{beside, beside, beside}, half));
  CHECK_FALSE(meets(Segment<S, N>{beside, beside}, half));
  CHECK(meets(half, Points<S, N, 1>{on}));
  CHECK_FALSE(meets(half, Points<S, N, 1>{beside}));
  CHECK(meets(Plane<S, N>{Direction<S, N>::along(N - 1), S::max()}, half));
  CHECK(meets(Plane<S, N>{Direction<S, N>::along(N - 1), S::lowest()}, half));
}

}  // namespace
}  // namespace detent::test
