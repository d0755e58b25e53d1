// SPDX-License-Identifier: MIT
#include "detent/query/distance/pair.hpp"

#include <array>

#include "detent/shape/frustum.hpp"
#include "query/distance/kinds.hpp"

namespace detent::test {
namespace {

TEMPLATE_TEST_CASE("distance of two shapes: planes are apart only if parallel", "[distance]",
                   DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const Plane<S, N> plane{toward<S, N>(0, 1), num<S>(3)};
  CHECK(distance(plane, Plane<S, N>{toward<S, N>(0, 1), num<S>(-2)}) == num<S>(5));
  CHECK(distance(plane, Plane<S, N>{toward<S, N>(0, -1), num<S>(-3)}) == S(0));
  CHECK(distance(plane, Plane<S, N>{toward<S, N>(0, -1), num<S>(1)}) == num<S>(4));
  CHECK(distance(plane, Plane<S, N>{toward<S, N>(1, 8), num<S>(-2)}) == S(0));
}

TEMPLATE_TEST_CASE("distance of two shapes: to an empty one it is the greatest scalar",
                   "[distance]", DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const Sphere<S, N> none{Vec<S, N>(), num<S>(-1)};
  const Aabb<S, N> inverted{at<S, N>(1), at<S, N>(-1)};
  visit_shapes<S, N>(0, [&](const auto& shape) {
    CHECK(distance(shape, none) == largest<S>);
    CHECK(distance(inverted, shape) == largest<S>);
    CHECK(distance(shape, ConvexHull<S, N>()) == largest<S>);
  });
}

TEMPLATE_TEST_CASE("distance of two shapes: a frustum is the hull of its corners", "[distance]",
                   q16_16, q8_8, float) {
  using S = TestType;
  const Frustum<S> frustum(frustum_corners<S>());
  visit_shapes<S, 3>(6, [&](const auto& shape) {
    CHECK(distance(frustum, shape) == distance(frustum.hull(), shape));
    CHECK(distance(shape, frustum) == distance(frustum, shape));
    CHECK(distance(frustum, shape) > S(0));
  });
  CHECK(distance(frustum, frustum) == S(0));
}

TEMPLATE_TEST_CASE("distance of two shapes: clamped at the ends of the domain", "[distance]",
                   DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto low = filled<S, N>(S::lowest()), high = filled<S, N>(S::max());
  CHECK(distance(Segment<S, N>{low, low}, Segment<S, N>{high, high}) == S::max());
  // The centers are farther apart than a scalar can represent; the surfaces are not.
  Vec<S, N> left = Vec<S, N>(), right = Vec<S, N>();
  left[0] = S::lowest();
  right[0] = S::max();
  const Sphere<S, N> a{left, S::max()}, b{right, num<S>(1)};
  CHECK(distance(a, b) == nearest_to<S>(-S::lowest() - num<S>(1)));
}

TEMPLATE_TEST_CASE("distance of two shapes: boxes are slabs to round shapes and edges to others",
                   "[distance]", DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  // All axes are equal: the slabs contain a whole plane, the edges span a segment.
  const auto x = toward<S, N>(1);
  const auto flat = [&] {
    if constexpr (N == 2) {
      return Rotation<S, N>::from_axes({x, x});
    } else {
      return Rotation<S, N>::from_axes({x, x, x});
    }
  }();
  const Obb<S, N> box{Vec<S, N>(), filled<S, N>(num<S>(1)), flat};
  CHECK(distance(box, Sphere<S, N>{at<S, N>(0, 9), num<S>(1)}) == S(0));
  CHECK(distance(box, Segment<S, N>{at<S, N>(0, 9), at<S, N>(0, 12)}) == S(0));
  const Triangle<S, N> triangle{at<S, N>(0, 9), at<S, N>(0, 12), at<S, N>(1, 12)};
  CHECK(distance(box, triangle) == num<S>(9));
}

}  // namespace
}  // namespace detent::test
