// SPDX-License-Identifier: MIT
#include "detent/query/closest_point/sphere.hpp"

#include "query/raycast/helpers.hpp"

namespace detent::test {
namespace {

TEMPLATE_TEST_CASE(
    "closest point, sphere: on the surface toward the point, the point itself inside",
    "[closest_point]", DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const Sphere<S, N> sphere{at<S, N>(1, 2), num<S>(5)};
  CHECK(closest_point(sphere, at<S, N>(11, 2)) == at<S, N>(6, 2));
  CHECK(closest_point(sphere, at<S, N>(1, -20)) == at<S, N>(1, -3));
  CHECK(closest_point(sphere, at<S, N>(2, 2)) == at<S, N>(2, 2));
  CHECK(closest_point(sphere, sphere.center) == sphere.center);
  CHECK(closest_point(sphere, at<S, N>(4, 6)) == at<S, N>(4, 6));
  CHECK(closest_point(Sphere<S, N>{sphere.center, num<S>(0)}, at<S, N>(7, 8)) == sphere.center);
  CHECK(closest_point(Sphere<S, N>{sphere.center, num<S>(-1)}, at<S, N>(7, 8)) == at<S, N>(7, 8));
}

TEMPLATE_TEST_CASE("closest point, sphere: rounded once, ties to even", "[closest_point]",
                   DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  // (3, 4) / 5 of the radius on each axis: 25 steps give 15 and 20, 2.5 times as many steps do not.
  const auto raw = [](int x, int y) {
    Vec<S, N> v;
    v.x = moved(S(0), x);
    v.y = moved(S(0), y);
    return v;
  };
  const Sphere<S, N> sphere{Vec<S, N>(), moved(S(0), 25)};
  CHECK(closest_point(sphere, raw(300, 400)) == raw(15, 20));
  CHECK(closest_point(sphere, raw(-300, 400)) == raw(-15, 20));
  // 12.5 * (0.8, 0.6) = (10, 7.5) where the grid has no radius of 12.5; 25 * (0.28, 0.96) = (7,
  // 24).
  CHECK(closest_point(sphere, raw(7 * 16, -24 * 16)) == raw(7, -24));
  // 5 * (0.3, ...) never ties; a radius of 5 toward (24, 7): 4.8 and 1.4.
  CHECK(closest_point(Sphere<S, N>{raw(0, 0), moved(S(0), 5)}, raw(24, 7)) == raw(5, 1));
  // Halves: 5 / 2 along both axes of (4, 3) times 5 / 2 is (4 * 2.5 / 2.5 ...): radius 4 to (100,
  // 75) gives 3.2 and 2.4.
  CHECK(closest_point(Sphere<S, N>{raw(0, 0), moved(S(0), 4)}, raw(100, 75)) == raw(3, 2));
  const auto far = filled<S, N>(S::max());
  const Sphere<S, N> all{filled<S, N>(S::lowest()), S::max()};
  const auto closest = closest_point(all, far);
  for (int i = 0; i < N; ++i) CHECK(closest[i] == closest[0]);
  CHECK(closest[0] > all.center[0]);
  CHECK(closest[0] < far[0]);
}

}  // namespace
}  // namespace detent::test
