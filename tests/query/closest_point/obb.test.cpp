// SPDX-License-Identifier: MIT
#include "detent/query/closest_point/obb.hpp"

#include "query/raycast/helpers.hpp"

namespace detent::test {
namespace {

TEMPLATE_TEST_CASE("closest point, obb: clamped in the box's frame", "[closest_point]",
                   DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  Obb<S, N> box{at<S, N>(1, 2), filled<S, N>(num<S>(3)), {}};
  CHECK(closest_point(box, at<S, N>(9, 3)) == at<S, N>(4, 3));
  CHECK(closest_point(box, at<S, N>(-9, -9)) == at<S, N>(-2, -1));
  CHECK(closest_point(box, at<S, N>(2, 3)) == at<S, N>(2, 3));
  box.half_extents = Vec<S, N>();
  CHECK(closest_point(box, at<S, N>(2, 3)) == box.center);
  box.half_extents.x = num<S>(-1);
  CHECK(closest_point(box, at<S, N>(2, 3)) == at<S, N>(2, 3));
}

TEMPLATE_TEST_CASE("closest point, obb: rotated by a right angle", "[closest_point]",
                   DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  auto half = filled<S, N>(num<S>(1));
  half.x = num<S>(5);  // along y of the world
  const Obb<S, N> box{at<S, N>(10, 10), half, heading<S, N>(0, 1)};
  CHECK(closest_point(box, at<S, N>(10, 30)) == at<S, N>(10, 15));
  CHECK(closest_point(box, at<S, N>(20, 12)) == at<S, N>(11, 12));
}

TEMPLATE_TEST_CASE("closest point, obb: the ends of the domain", "[closest_point]",
                   DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto low = filled<S, N>(S::lowest()), high = filled<S, N>(S::max());
  CHECK(closest_point(Obb<S, N>{low, {}, {}}, high) == low);
  CHECK(closest_point(Obb<S, N>{{}, high, {}}, low) == filled<S, N>(moved(S::lowest(), 1)));
}

}  // namespace
}  // namespace detent::test
