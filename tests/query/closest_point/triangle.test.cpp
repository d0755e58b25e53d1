// SPDX-License-Identifier: MIT
#include "detent/query/closest_point/triangle.hpp"

#include "query/raycast/helpers.hpp"

namespace detent::test {
namespace {

TEMPLATE_TEST_CASE("closest point, triangle: every region of a triangle", "[closest_point]",
                   DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  for (const auto& t : both_orders(right_triangle<S, N>())) {
    CHECK(closest_point(t, at<S, N>(-1, -1)) == at<S, N>(0, 0));
    CHECK(closest_point(t, at<S, N>(12, -1)) == at<S, N>(8, 0));
    CHECK(closest_point(t, at<S, N>(-1, 12)) == at<S, N>(0, 8));
    CHECK(closest_point(t, at<S, N>(3, -2)) == at<S, N>(3, 0));
    CHECK(closest_point(t, at<S, N>(-2, 3)) == at<S, N>(0, 3));
    CHECK(closest_point(t, at<S, N>(6, 6)) == at<S, N>(4, 4));
    CHECK(closest_point(t, at<S, N>(2, 3)) == at<S, N>(2, 3));
    if (N == 3) {
      CHECK(closest_point(t, at<S, N>(2, 3, 7)) == at<S, N>(2, 3));
      CHECK(closest_point(t, at<S, N>(6, 6, -7)) == at<S, N>(4, 4));
    }
  }
}

TEMPLATE_TEST_CASE("closest point, triangle: a collapsed triangle is a segment or a point",
                   "[closest_point]", DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto a = at<S, N>(1, 1), b = at<S, N>(3, 1), c = at<S, N>(9, 1);
  for (const auto& t :
       {Triangle<S, N>{a, b, c}, Triangle<S, N>{b, c, a}, Triangle<S, N>{c, a, a}}) {
    CHECK(closest_point(t, at<S, N>(5, 7)) == at<S, N>(5, 1));
    CHECK(closest_point(t, at<S, N>(-5, 7)) == a);
    CHECK(closest_point(t, at<S, N>(50, 7)) == c);
  }
  CHECK(closest_point(Triangle<S, N>{b, b, b}, c) == b);
}

TEMPLATE_TEST_CASE("closest point, triangle: the nearest corner, not the point itself",
                   "[closest_point]", DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  // A float library returned (5, 0, 0) itself.
  const Triangle<S, N> triangle{at<S, N>(0, 1), at<S, N>(0, 0), at<S, N>(1, 0)};
  CHECK(closest_point(triangle, at<S, N>(5, 0)) == at<S, N>(1, 0));
}

TEMPLATE_TEST_CASE("closest point, triangle: an obtuse corner", "[closest_point]",
                   DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  // Beyond b along ab, the closest point is still on bc.
  const Triangle<S, N> triangle{at<S, N>(0, 0), at<S, N>(4, 0), at<S, N>(20, 16)};
  CHECK(closest_point(triangle, at<S, N>(12, 0)) == at<S, N>(8, 4));
  CHECK(closest_point(triangle, at<S, N>(5, -2)) == at<S, N>(4, 0));
}

}  // namespace
}  // namespace detent::test
