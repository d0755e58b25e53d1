// SPDX-License-Identifier: MIT
#include "detent/query/closest_point/aabb.hpp"

#include "query/raycast/helpers.hpp"

namespace detent::test {
namespace {

static_assert(closest_point(Aabb<q16_16, 3>{{}, at<q16_16, 3>(1, 1, 1)}, at<q16_16, 3>(2, 0.5)) ==
              at<q16_16, 3>(1, 0.5));

TEMPLATE_TEST_CASE("closest point, aabb: clamped to the box", "[closest_point]",
                   DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const Aabb<S, N> box{filled<S, N>(num<S>(-2)), filled<S, N>(num<S>(3))};
  CHECK(closest_point(box, at<S, N>(7, 1)) == at<S, N>(3, 1));
  CHECK(closest_point(box, at<S, N>(-7, 9)) == at<S, N>(-2, 3));
  CHECK(closest_point(box, at<S, N>(1, 1)) == at<S, N>(1, 1));
  CHECK(closest_point(Aabb<S, N>{box.max, box.max}, Vec<S, N>()) == box.max);
  CHECK(closest_point(Aabb<S, N>{box.max, box.min}, at<S, N>(9, 1)) == at<S, N>(9, 1));
}

TEMPLATE_TEST_CASE("closest point, aabb: an inside point is its own, however long the box",
                   "[closest_point]", DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  // A float library that clamped y by the wrong extent returned (0, 5, 0).
  const Aabb<S, N> box{at<S, N>(-1, -5, -1), at<S, N>(1, 5, 1)};
  CHECK(closest_point(box, at<S, N>(0, 3)) == at<S, N>(0, 3));
}

TEMPLATE_TEST_CASE("closest point, aabb: the ends of the domain", "[closest_point]",
                   DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto low = filled<S, N>(S::lowest()), high = filled<S, N>(S::max());
  CHECK(closest_point(Aabb<S, N>{low, low}, high) == low);
  CHECK(closest_point(Aabb<S, N>{low, high}, high) == high);
}

}  // namespace
}  // namespace detent::test
