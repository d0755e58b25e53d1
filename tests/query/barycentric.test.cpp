// SPDX-License-Identifier: MIT
#include "detent/query/barycentric.hpp"

#include "query/raycast/helpers.hpp"

namespace detent::test {
namespace {

TEMPLATE_TEST_CASE("barycentric: weights of corners, edges and the middle", "[barycentric]",
                   DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  using T = direction_component<S>;
  const Triangle<S, N> triangle{at<S, N>(1, 1), at<S, N>(9, 1), at<S, N>(1, 9)};
  const Triangle<S, N> clockwise{triangle.a, triangle.c, triangle.b};
  const auto weights = [](const Triangle<S, N>& t, const Vec<S, N>& p) {
    return nearest_to<T>(*barycentric(t, p));
  };
  const auto expected = [](double a, double b, double c) {
    return Vec<T, 3>{num<T>(a), num<T>(b), num<T>(c)};
  };
  CHECK(weights(triangle, triangle.b) == expected(0, 1, 0));
  CHECK(weights(triangle, at<S, N>(5, 5)) == expected(0, 0.5, 0.5));
  CHECK(weights(triangle, at<S, N>(5, 3)) == expected(0.25, 0.5, 0.25));
  CHECK(weights(clockwise, at<S, N>(5, 3)) == expected(0.25, 0.25, 0.5));
  CHECK(weights(triangle, at<S, N>(9, 5)) == expected(-0.5, 1, 0.5));
  if (N == 3) CHECK(weights(triangle, at<S, N>(5, 3, 7)) == expected(0.25, 0.5, 0.25));
}

TEMPLATE_TEST_CASE("barycentric: a collapsed triangle has no weights", "[barycentric]",
                   DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto a = at<S, N>(1, 1), b = at<S, N>(3, 2), c = at<S, N>(7, 4);
  CHECK_FALSE(barycentric(Triangle<S, N>{a, b, c}, b));
  CHECK_FALSE(barycentric(Triangle<S, N>{a, a, c}, b));
  CHECK_FALSE(barycentric(Triangle<S, N>{a, a, a}, a));
}

TEMPLATE_TEST_CASE("barycentric: weights out of range are clamped, not wrapped", "[barycentric]",
                   DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  using T = direction_component<S>;
  auto b = Vec<S, N>(), c = Vec<S, N>();
  b.x = moved(S(0), 1);
  c.y = moved(S(0), 1);
  const auto weights = barycentric(Triangle<S, N>{Vec<S, N>(), b, c}, filled<S, N>(S::max()));
  REQUIRE(weights);
  CHECK(weights->a < 0);
  CHECK(nearest_to<T>(*weights) == Vec<T, 3>{T::lowest(), T::max(), T::max()});
}

}  // namespace
}  // namespace detent::test
