// SPDX-License-Identifier: MIT
#include "detent/query/closest_point/hull.hpp"

#include "query/hulls.hpp"

namespace detent::test {
namespace {

template <Scalar S, int N, std::size_t Count>
Vec<S, N> closest(const Points<S, N, Count>& points, const Vec<S, N>& point) {
  return in_every_order(points, [&](const auto& hull) { return closest_point(hull, point); });
}

TEMPLATE_TEST_CASE("closest point, hull: on a face, an edge or a corner, or the point itself",
                   "[closest_point]", DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto solid = diamond<S, N>();
  CHECK(closest(solid, at<S, N>(8, 3)) == at<S, N>(4, 0));
  CHECK(closest(solid, at<S, N>(3, 3)) == at<S, N>(2, 2));
  CHECK(closest(solid, at<S, N>(-5, 3)) == at<S, N>(-3, 1));
  CHECK(closest(solid, at<S, N>(1, 2)) == at<S, N>(1, 2));
  CHECK(closest(solid, at<S, N>(-2, 2)) == at<S, N>(-2, 2));
  if (N == 3) CHECK(closest(solid, at<S, N>(4, 4, 2)) == at<S, N>(2, 2, 0));
  if (N == 3) CHECK(closest(solid, at<S, N>(4, 3, 3)) == at<S, N>(2, 1, 1));
}

TEMPLATE_TEST_CASE("closest point, hull: flat, a segment, a point or empty", "[closest_point]",
                   DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  auto above = at<S, N>(1);
  above[N - 1] = num<S>(-3);
  CHECK(closest(flat<S, N>(), above) == at<S, N>(1));
  CHECK(closest(flat<S, N>(), at<S, N>(6)) == at<S, N>(4));
  const Points<S, N, 3> line{at<S, N>(1, 1), at<S, N>(9, 1), at<S, N>(3, 1)};
  CHECK(closest(line, at<S, N>(5, 7)) == at<S, N>(5, 1));
  CHECK(closest(line, at<S, N>(50, 7)) == at<S, N>(9, 1));
  CHECK(closest(Points<S, N, 1>{line[2]}, line[0]) == line[2]);
  CHECK(closest_point(ConvexHull<S, N>{}, line[0]) == line[0]);
}

TEMPLATE_TEST_CASE("closest point, hull: coordinates round to nearest, ties to even",
                   "[closest_point]", DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto raw = in_steps<S, N>;
  CHECK(closest(Points<S, N, 2>{raw(0, 0), raw(4, 4)}, raw(2, 1)) == raw(2, 2));
  CHECK(closest(Points<S, N, 2>{raw(0, 0), raw(4, 4)}, raw(3, 2)) == raw(2, 2));
  const auto low = filled<S, N>(S::lowest()), high = filled<S, N>(S::max());
  CHECK(closest(Points<S, N, 2>{low, high}, high) == high);
  CHECK(closest(Points<S, N, 1>{low}, high) == low);
}

}  // namespace
}  // namespace detent::test
