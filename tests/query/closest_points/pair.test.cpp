// SPDX-License-Identifier: MIT
#include "detent/query/closest_points/pair.hpp"

#include <array>
#include <utility>

#include "detent/query/distance/pair.hpp"
#include "detent/shape/frustum.hpp"
#include "query/raycast/helpers.hpp"

namespace detent::test {
namespace {

template <Scalar S, int N>
using Points = std::pair<Vec<S, N>, Vec<S, N>>;

TEMPLATE_TEST_CASE("closest points: of several pairs, the one with the least point",
                   "[closest_points]", DETENT_EVERYDAY_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const Aabb<S, N> low{at<S, N>(-3, -2, -1), at<S, N>(3, 2, 1)};
  const Aabb<S, N> high{at<S, N>(-2, 5, -4), at<S, N>(6, 7, 9)};
  CHECK(closest_points(low, high) == Points<S, N>{at<S, N>(-2, 2, -1), at<S, N>(-2, 5, -1)});
  CHECK(closest_points(high, low) == Points<S, N>{at<S, N>(-2, 5, -1), at<S, N>(-2, 2, -1)});
  const Obb<S, N> turned{at<S, N>(2, 6, 2), at<S, N>(4, 1, 6), {}};
  CHECK(closest_points(low, turned) == Points<S, N>{at<S, N>(-2, 2, -1), at<S, N>(-2, 5, -1)});
  // A capsule along the face of a box, in either direction.
  for (const bool flips : {false, true}) {
    const auto left = at<S, N>(-1, 5), right = at<S, N>(9, 5);
    const Capsule<S, N> capsule{flips ? right : left, flips ? left : right, num<S>(1)};
    const Points<S, N> expected{at<S, N>(-1, 2), at<S, N>(-1, 4)};
    CHECK(closest_points(low, capsule) == expected);
    CHECK(closest_points(Obb<S, N>{{}, at<S, N>(3, 2, 1), {}}, capsule) == expected);
  }
}

TEMPLATE_TEST_CASE("closest points: crossing faces are closest where their edges cross",
                   "[closest_points]", q16_16, q8_8, float) {
  using S = TestType;
  const Triangle<S, 3> below{at<S, 3>(-2, 0, 0), at<S, 3>(2, 0, -2), at<S, 3>(2, 0, 2)};
  const Triangle<S, 3> above{at<S, 3>(0, 3, -4), at<S, 3>(0, 3, 4), at<S, 3>(4, 3, 0)};
  const auto [p, q] = closest_points(below, above);
  if constexpr (is_fixed<S>) {
    CHECK(p == at<S, 3>(0, 0, -1));
    CHECK(q == at<S, 3>(0, 3, -1));
  }
  CHECK(q.y - p.y == num<S>(3));
}

TEMPLATE_TEST_CASE("closest points: one common point where shapes meet", "[closest_points]",
                   DETENT_EVERYDAY_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto meets_at = [](const auto& a, const auto& b, const Vec<S, N>& point) {
    CHECK(closest_points(a, b) == Points<S, N>{point, point});
  };
  const Aabb<S, N> box{at<S, N>(-2, -2, -2), at<S, N>(2, 2, 2)};
  const Segment<S, N> inside{at<S, N>(1, 1), at<S, N>(9, 1)};
  const Segment<S, N> across{at<S, N>(-9, 1), at<S, N>(9, 1)};
  meets_at(inside, box, at<S, N>(1, 1));
  meets_at(box, inside, at<S, N>(1, 1));
  meets_at(across, box, at<S, N>(-2, 1));
  meets_at(box, Aabb<S, N>{at<S, N>(1, 1, 1), at<S, N>(5, 5, 5)}, at<S, N>(2, 2, N == 3 ? 2 : 0));
  meets_at(Obb<S, N>{{}, at<S, N>(2, 2, 2), {}}, across, at<S, N>(-2, 1));
  // Balls: the point between the centers where the segment leaves the first ball, or the center.
  const Sphere<S, N> ball{at<S, N>(0), num<S>(3)};
  meets_at(ball, Sphere<S, N>{at<S, N>(4), num<S>(2)}, at<S, N>(3));
  meets_at(Sphere<S, N>{at<S, N>(4), num<S>(2)}, ball, at<S, N>(2));
  meets_at(ball, Sphere<S, N>{at<S, N>(2), num<S>(9)}, at<S, N>(2));
  meets_at(ball, ball, at<S, N>(0));
  const Plane<S, N> plane{toward<S, N>(0, 1), num<S>(2)};
  meets_at(plane, ball, at<S, N>(0, 2));
  meets_at(Segment<S, N>{at<S, N>(5, 0), at<S, N>(5, 8)}, plane, at<S, N>(5, 2));
}

TEMPLATE_TEST_CASE("closest points: of planes, the ones nearest to the origin", "[closest_points]",
                   DETENT_EVERYDAY_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const Plane<S, N> plane{toward<S, N>(0, 1), num<S>(3)};
  const Plane<S, N> parallel{toward<S, N>(0, -1), num<S>(1)}, upright{toward<S, N>(1), num<S>(-2)};
  CHECK(closest_points(plane, parallel) == Points<S, N>{at<S, N>(0, 3), at<S, N>(0, -1)});
  CHECK(closest_points(plane, upright) == Points<S, N>{at<S, N>(-2, 3), at<S, N>(-2, 3)});
}

TEMPLATE_TEST_CASE("closest points: both are the origin if a shape is empty", "[closest_points]",
                   DETENT_EVERYDAY_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const Sphere<S, N> none{at<S, N>(5), num<S>(-1)}, some{at<S, N>(3), num<S>(1)};
  CHECK(closest_points(none, some) == Points<S, N>());
  CHECK(closest_points(some, ConvexHull<S, N>{}) == Points<S, N>());
}

TEST_CASE("closest points: a point out of range is clamped") {
  using S = q8_8;
  const auto most = largest<S>, least = lowest<S>;
  // The plane x + y = -360 leaves the range at the lower corner.
  const Plane<S, 2> plane{*normalize(Vec{S(1), S(1)}), least};
  const Sphere<S, 2> ball{{least, most}, S(100)};
  const auto [p, q] = closest_points(plane, ball);
  CHECK(p.x == least);
  CHECK(q.x == least);
  CHECK(q.y == num<S>(127.99609375 - 70.7109375));
}

TEST_CASE("closest points: can be computed in constant expressions") {
  using S = q16_16;
  constexpr Sphere<S, 3> ball{{}, S(1)};
  constexpr Aabb<S, 3> box{{S(2), S(3), S(6)}, {S(9), S(9), S(9)}};
  constexpr auto points = closest_points(ball, box);
  static_assert(points.second == box.min);
  // The corner is 7 away.
  STATIC_REQUIRE(points.first == Vec{S::from_raw(18725), S::from_raw(28087), S::from_raw(56174)});
}

}  // namespace
}  // namespace detent::test
