// SPDX-License-Identifier: MIT
#include "detent/query/contains/triangle.hpp"

#include "query/raycast/helpers.hpp"

namespace detent::test {
namespace {

TEMPLATE_TEST_CASE("contains, triangle: its face, edges and corners", "[contains]",
                   DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  for (const auto& t : both_orders(right_triangle<S, N>())) {
    CHECK(contains(t, at<S, N>(2, 2)));
    CHECK(contains(t, at<S, N>(4, 0)));
    CHECK(contains(t, at<S, N>(4, 4)));
    CHECK(contains(t, at<S, N>(0, 4)));
    CHECK(contains(t, t.a));
    CHECK(contains(t, t.b));
    CHECK(contains(t, t.c));
    CHECK_FALSE(contains(t, at<S, N>(4.5, 4)));
    CHECK_FALSE(contains(t, at<S, N>(-1, 4)));
    CHECK_FALSE(contains(t, at<S, N>(9, 0)));
    CHECK_FALSE(contains(t, at<S, N>(4, -1)));
    if (N == 3) CHECK_FALSE(contains(t, at<S, N>(2, 2, 0.5)));
  }
}

TEMPLATE_TEST_CASE("contains, triangle: a collapsed triangle is a segment or a point", "[contains]",
                   DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto a = at<S, N>(1, 1), b = at<S, N>(3, 2), c = at<S, N>(7, 4);
  for (const auto& t :
       {Triangle<S, N>{a, b, c}, Triangle<S, N>{b, c, a}, Triangle<S, N>{c, a, a}}) {
    CHECK(contains(t, at<S, N>(5, 3)));
    CHECK(contains(t, a));
    CHECK(contains(t, c));
    CHECK_FALSE(contains(t, at<S, N>(9, 5)));
    CHECK_FALSE(contains(t, at<S, N>(5, 3.5)));
  }
  CHECK(contains(Triangle<S, N>{a, a, a}, a));
  CHECK_FALSE(contains(Triangle<S, N>{a, a, a}, b));
}

TEMPLATE_TEST_CASE("contains, triangle: one raw unit decides, at the ends of the domain too",
                   "[contains]", DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto [low, side, high] = half_domain<S, N>();
  const Triangle<S, N> half{low, side, high};
  CHECK(contains(half, low));
  CHECK(contains(half, Vec<S, N>()));
  auto beside = Vec<S, N>();
  beside.x = moved(S(0), 1);
  CHECK(contains(half, beside));
  beside.x = moved(S(0), -1);
  CHECK_FALSE(contains(half, beside));
}

}  // namespace
}  // namespace detent::test
