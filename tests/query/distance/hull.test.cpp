// SPDX-License-Identifier: MIT
#include "detent/query/distance/hull.hpp"

#include "query/hulls.hpp"

namespace detent::test {
namespace {

template <Scalar S, int N, std::size_t Count>
S apart(const Points<S, N, Count>& points, const Vec<S, N>& point) {
  return in_every_order(points, [&](const auto& hull) { return detent::distance(hull, point); });
}

TEMPLATE_TEST_CASE("distance, hull: to a face, an edge or a corner", "[distance]",
                   DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto solid = diamond<S, N>();
  CHECK(apart(solid, at<S, N>(8, 3)) == num<S>(5));
  CHECK(apart(solid, at<S, N>(0, 9)) == num<S>(5));
  CHECK(apart(solid, at<S, N>(1, -1)) == num<S>(0));
  CHECK(apart(solid, at<S, N>(2, 2)) == num<S>(0));
  CHECK(squared_distance(ConvexHull{solid}, at<S, N>(5, 5)) <= num<S>(18));
  CHECK_FALSE(squared_distance(ConvexHull{solid}, at<S, N>(5, 5)) <= num<S>(17.5));
  if (N == 3) {
    CHECK(squared_distance(ConvexHull{solid}, at<S, N>(4, 4, 2)) <= num<S>(12.25));
    CHECK_FALSE(squared_distance(ConvexHull{solid}, at<S, N>(4, 4, 2)) <= num<S>(11.5));
  }
  auto above = at<S, N>(1);
  above[N - 1] = num<S>(-3);
  CHECK(apart(flat<S, N>(), above) == num<S>(3));
  CHECK(apart(flat<S, N>(), at<S, N>(6)) == num<S>(2));
  CHECK(apart(Points<S, N, 2>{at<S, N>(1, 1), at<S, N>(9, 1)}, at<S, N>(5, 7)) == num<S>(6));
  CHECK(apart(Points<S, N, 1>{at<S, N>(1, 1)}, at<S, N>(4, 5)) == num<S>(5));
  CHECK(detent::distance(ConvexHull<S, N>{}, at<S, N>(4, 5)) == largest<S>);
}

TEMPLATE_TEST_CASE("distance, hull: clamped at the ends of the domain", "[distance]",
                   DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto low = filled<S, N>(S::lowest()), high = filled<S, N>(S::max());
  auto side = low, across = high;
  side.x = S::max();
  across.x = S::lowest();
  CHECK(apart(Points<S, N, 1>{low}, high) == S::max());
  CHECK(apart(Points<S, N, 3>{low, side, high}, high) == S(0));
  CHECK(apart(Points<S, N, 3>{low, side, high}, across) == S::max());
  across = Vec<S, N>();
  across.x = moved(S(0), -2);
  // 2 raw units off the diagonal along x; its slope leaves a distance of 1.41 or 1.63.
  CHECK(apart(Points<S, N, 2>{low, high}, across) == moved(S(0), 1));
}

}  // namespace
}  // namespace detent::test
