// SPDX-License-Identifier: MIT
#include "detent/query/contains/plane.hpp"

#include "query/raycast/helpers.hpp"

namespace detent::test {
namespace {

TEMPLATE_TEST_CASE("contains, plane: the points at its offset", "[contains]", DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const Plane<S, N> plane{toward<S, N>(0, 1), num<S>(5)};
  CHECK(contains(plane, at<S, N>(0, 5)));
  CHECK(contains(plane, at<S, N>(-90, 5, 7)));
  CHECK_FALSE(contains(plane, at<S, N>(0, -5)));
  CHECK_FALSE(contains(plane, at<S, N>(0, 5.5)));
  CHECK_FALSE(contains(plane, Vec<S, N>()));
}

TEMPLATE_TEST_CASE("contains, plane: one raw unit decides, at the ends of the domain too",
                   "[contains]", DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const Plane<S, N> plane{toward<S, N>(1), S::lowest()};
  auto point = filled<S, N>(S::max());
  CHECK_FALSE(contains(plane, point));
  point.x = S::lowest();
  CHECK(contains(plane, point));
  point.x = moved(point.x, 1);
  CHECK_FALSE(contains(plane, point));
  // Through the origin, perpendicular to (4, -3).
  const Plane<S, N> slope{three_four_fifths<S, N>(), S(0)};
  CHECK(contains(slope, at<S, N>(80, -60)));
  CHECK_FALSE(contains(slope, at<S, N>(80, -60 + 1.0 / (1 << S::frac))));
}

}  // namespace
}  // namespace detent::test
