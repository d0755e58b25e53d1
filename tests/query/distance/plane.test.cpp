// SPDX-License-Identifier: MIT
#include "detent/query/distance/plane.hpp"

#include "query/raycast/helpers.hpp"

namespace detent::test {
namespace {

TEMPLATE_TEST_CASE("distance, plane: from both sides", "[distance]", DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const Plane<S, N> plane{toward<S, N>(0, 1), num<S>(5)};
  CHECK(distance(plane, at<S, N>(3, 9)) == num<S>(4));
  CHECK(distance(plane, at<S, N>(3, -9)) == num<S>(14));
  CHECK(distance(plane, at<S, N>(3, 5)) == num<S>(0));
  CHECK(squared_distance(plane, at<S, N>(3, 9)) <= num<S>(16));
  CHECK_FALSE(squared_distance(plane, at<S, N>(3, 9)) <= num<S>(15.5));
}

TEMPLATE_TEST_CASE("distance, plane: exact for the stored normal, and clamped", "[distance]",
                   DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const Plane<S, N> slope{three_four_fifths<S, N>(), S(0)};
  CHECK(distance(slope, at<S, N>(30, 40)) == S(50));
  CHECK(distance(slope, at<S, N>(-30, -40)) == S(50));
  const Plane<S, N> low{toward<S, N>(1), S::lowest()};
  CHECK(distance(low, filled<S, N>(S::max())) == S::max());
}

}  // namespace
}  // namespace detent::test
