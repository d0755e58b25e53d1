// SPDX-License-Identifier: MIT
#include "detent/query/closest_point/ray.hpp"

#include "query/raycast/helpers.hpp"

namespace detent::test {
namespace {

TEMPLATE_TEST_CASE("closest point, ray: the foot of the perpendicular, the origin or the end",
                   "[closest_point]", DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  Ray<S, N> ray{at<S, N>(1, 1), toward<S, N>(1), num<S>(8)};
  CHECK(closest_point(ray, at<S, N>(3, 5)) == at<S, N>(3, 1));
  CHECK(closest_point(ray, at<S, N>(-3, 5)) == ray.origin);
  CHECK(closest_point(ray, at<S, N>(12, -5)) == at<S, N>(9, 1));
  CHECK(closest_point(ray, at<S, N>(9, 5)) == at<S, N>(9, 1));
  ray.max_distance = num<S>(0);
  CHECK(closest_point(ray, at<S, N>(3, 5)) == ray.origin);
  ray.max_distance = num<S>(-1);
  CHECK(closest_point(ray, at<S, N>(3, 5)) == at<S, N>(3, 5));
}

TEMPLATE_TEST_CASE("closest point, ray: rounded once and clamped", "[closest_point]",
                   DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const Ray<S, N> ray{Vec<S, N>(), three_four_fifths<S, N>(), S::max()};
  CHECK(closest_point(ray, at<S, N>(30 - 8, 40 + 6)) == at<S, N>(30, 40));
  // The end is outside the world.
  const Ray<S, N> out{filled<S, N>(S::max()), toward<S, N>(1), S::max()};
  CHECK(closest_point(out, filled<S, N>(S::max())) == filled<S, N>(S::max()));
}

}  // namespace
}  // namespace detent::test
