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

TEMPLATE_TEST_CASE("closest point, sphere: rounded once", "[closest_point]", DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto raw = [](int x, int y) {
    Vec<S, N> v;
    v.x = moved(S(0), x);
    v.y = moved(S(0), y);
    return v;
  };
  const Sphere<S, N> sphere{Vec<S, N>(), moved(S(0), 25)};
  CHECK(closest_point(sphere, raw(300, 400)) == raw(15, 20));
  CHECK(closest_point(sphere, raw(-300, 400)) == raw(-15, 20));
  CHECK(closest_point(sphere, raw(7 * 16, -24 * 16)) == raw(7, -24));
  // (4.8, 1.4) and (3.2, 2.4): no tie can occur, as a primitive Pythagorean triple ends in an odd
  // number.
  CHECK(closest_point(Sphere<S, N>{raw(0, 0), moved(S(0), 5)}, raw(24, 7)) == raw(5, 1));
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
