// SPDX-License-Identifier: MIT
#include "detent/query/closest_point/plane.hpp"

#include "query/raycast/helpers.hpp"

namespace detent::test {
namespace {

TEMPLATE_TEST_CASE("closest point, plane: the foot of the perpendicular, from both sides",
                   "[closest_point]", DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const Plane<S, N> plane{toward<S, N>(0, 1), num<S>(5)};
  CHECK(closest_point(plane, at<S, N>(3, 9)) == at<S, N>(3, 5));
  CHECK(closest_point(plane, at<S, N>(3, -9)) == at<S, N>(3, 5));
  CHECK(closest_point(plane, at<S, N>(3, 5)) == at<S, N>(3, 5));
  const Plane<S, N> other{toward<S, N>(0, -1), num<S>(-5)};
  CHECK(closest_point(other, at<S, N>(3, -9)) == at<S, N>(3, 5));
}

TEMPLATE_TEST_CASE("closest point, plane: rounded once and clamped", "[closest_point]",
                   DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  // The foot does not depend on the length of the stored normal: exactly (0, 0) from (3, 4) * 10.
  const Plane<S, N> slope{three_four_fifths<S, N>(), S(0)};
  CHECK(closest_point(slope, at<S, N>(30, 40)) == Vec<S, N>());
  CHECK(closest_point(slope, at<S, N>(30 + 8, 40 - 6)) == at<S, N>(8, -6));
  // The foot is outside the world, so its coordinates are not representable.
  const Plane<S, N> diagonal{toward<S, N>(1, 1), S::max()};
  auto corner = Vec<S, N>();
  corner.x = S::lowest();
  corner.y = S::max();
  CHECK(closest_point(diagonal, corner).y == S::max());
}

}  // namespace
}  // namespace detent::test
