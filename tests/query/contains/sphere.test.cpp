// SPDX-License-Identifier: MIT
#include "detent/query/contains/sphere.hpp"

#include "query/raycast/helpers.hpp"

namespace detent::test {
namespace {

static_assert(contains(Sphere<q16_16, 3>{{}, q16_16(3)}, at<q16_16, 3>(2, 2, 1)));
static_assert(!contains(Sphere<q16_16, 3>{{}, q16_16(3)}, at<q16_16, 3>(2, 2, 1.5)));

TEMPLATE_TEST_CASE("contains, sphere: the ball is closed", "[contains]", DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const Sphere<S, N> sphere{at<S, N>(1, 2), num<S>(5)};
  CHECK(contains(sphere, sphere.center));
  CHECK(contains(sphere, at<S, N>(4, 6)));  // 3, 4, 5: on the surface
  CHECK(contains(sphere, at<S, N>(1, -3)));
  CHECK_FALSE(contains(sphere, at<S, N>(4, 6.5)));
  CHECK_FALSE(contains(sphere, at<S, N>(-5, 2)));
  const auto point = at<S, N>(3, 3);
  CHECK(contains(Sphere<S, N>{point, num<S>(0)}, point));
  CHECK_FALSE(contains(Sphere<S, N>{point, num<S>(0)}, at<S, N>(3, 3.5)));
  CHECK_FALSE(contains(Sphere<S, N>{point, num<S>(-1)}, point));
}

TEMPLATE_TEST_CASE("contains, sphere: one raw unit decides, at the ends of the domain too",
                   "[contains]", DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const Sphere<S, N> sphere{Vec<S, N>(), num<S>(5)};
  auto surface = at<S, N>(3, 4);
  CHECK(contains(sphere, surface));
  surface.y = moved(surface.y, 1);
  CHECK_FALSE(contains(sphere, surface));
  const auto low = filled<S, N>(S::lowest()), high = filled<S, N>(S::max());
  CHECK_FALSE(contains(Sphere<S, N>{low, S::max()}, high));
  CHECK(contains(Sphere<S, N>{low, S::max()}, low));
  auto corner = low;
  corner.x = moved(S::lowest(), S::max().raw());
  CHECK(contains(Sphere<S, N>{low, S::max()}, corner));
  corner.x = moved(corner.x, 1);
  CHECK_FALSE(contains(Sphere<S, N>{low, S::max()}, corner));
}

}  // namespace
}  // namespace detent::test
