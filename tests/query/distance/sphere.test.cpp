// SPDX-License-Identifier: MIT
#include "detent/query/distance/sphere.hpp"

#include "query/raycast/helpers.hpp"

namespace detent::test {
namespace {

TEMPLATE_TEST_CASE("distance, sphere: to the surface, 0 inside, the greatest scalar to nothing",
                   "[distance]", DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const Sphere<S, N> sphere{at<S, N>(1, 2), num<S>(5)};
  CHECK(distance(sphere, at<S, N>(11, 2)) == num<S>(5));
  CHECK(distance(sphere, at<S, N>(7, 10)) == num<S>(5));
  CHECK(distance(sphere, at<S, N>(4, 6)) == num<S>(0));
  CHECK(distance(sphere, at<S, N>(2, 2)) == num<S>(0));
  CHECK(distance(Sphere<S, N>{sphere.center, num<S>(0)}, at<S, N>(4, 6)) == num<S>(5));
  CHECK(distance(Sphere<S, N>{sphere.center, num<S>(-1)}, sphere.center) == largest<S>);
}

TEMPLATE_TEST_CASE("distance, sphere: rounded down and clamped", "[distance]",
                   DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const Sphere<S, N> unit{Vec<S, N>(), num<S>(1)};
  // sqrt(2) - 1 = 0.41421356...
  CHECK(distance(unit, at<S, N>(1, 1)) ==
        num<S>(static_cast<int>(0.41421356 * (1 << S::frac)) / static_cast<double>(1 << S::frac)));
  const Sphere<S, N> far{filled<S, N>(S::lowest()), num<S>(0)};
  CHECK(distance(far, filled<S, N>(S::max())) == S::max());
}

}  // namespace
}  // namespace detent::test
