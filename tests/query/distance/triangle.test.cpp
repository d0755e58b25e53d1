// SPDX-License-Identifier: MIT
#include "detent/query/distance/triangle.hpp"

#include "query/raycast/helpers.hpp"

namespace detent::test {
namespace {

TEMPLATE_TEST_CASE("distance, triangle: to the face, an edge or a corner", "[distance]",
                   DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const Triangle<S, N> triangle{at<S, N>(0, 0), at<S, N>(8, 0), at<S, N>(0, 8)};
  CHECK(distance(triangle, at<S, N>(-3, -4)) == num<S>(5));
  CHECK(distance(triangle, at<S, N>(3, -2)) == num<S>(2));
  CHECK(distance(triangle, at<S, N>(2, 3)) == num<S>(0));
  CHECK(distance(triangle, at<S, N>(8, 0)) == num<S>(0));
  CHECK(squared_distance(triangle, at<S, N>(3, -2)) <= num<S>(4));
  CHECK_FALSE(squared_distance(triangle, at<S, N>(3, -2)) <= num<S>(3.5));
  if (N == 3) {
    CHECK(distance(triangle, at<S, N>(2, 3, 7)) == num<S>(7));
    CHECK(distance(triangle, at<S, N>(3, -3, 4)) == num<S>(5));
  }
  const auto a = at<S, N>(1, 1), b = at<S, N>(3, 1), c = at<S, N>(9, 1);
  CHECK(distance(Triangle<S, N>{b, a, c}, at<S, N>(5, 7)) == num<S>(6));
  CHECK(distance(Triangle<S, N>{a, a, a}, at<S, N>(4, 5)) == num<S>(5));
}

TEMPLATE_TEST_CASE("distance, triangle: clamped at the ends of the domain", "[distance]",
                   DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto low = filled<S, N>(S::lowest()), high = filled<S, N>(S::max());
  CHECK(distance(Triangle<S, N>{low, low, low}, high) == S::max());
  auto side = low;
  side.x = S::max();
  CHECK(distance(Triangle<S, N>{low, side, high}, high) == S(0));
  auto across = high;
  across.x = S::lowest();
  CHECK(distance(Triangle<S, N>{low, side, high}, across) == S::max());
}

}  // namespace
}  // namespace detent::test
