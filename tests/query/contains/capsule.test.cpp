// SPDX-License-Identifier: MIT
#include "detent/query/contains/capsule.hpp"

#include "detent/query/on.hpp"
#include "query/raycast/helpers.hpp"

namespace detent::test {
namespace {

TEMPLATE_TEST_CASE("contains, capsule: the points within the radius of its axis", "[contains]",
                   DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const Capsule<S, N> capsule{at<S, N>(1, 1), at<S, N>(9, 1), num<S>(5)};
  CHECK(contains(capsule, at<S, N>(4, 1)));
  CHECK(contains(capsule, at<S, N>(4, 6)));
  CHECK(contains(capsule, at<S, N>(12, 5)));
  CHECK(contains(capsule, at<S, N>(-2, -3)));
  CHECK_FALSE(contains(capsule, at<S, N>(4, 6.5)));
  CHECK_FALSE(contains(capsule, at<S, N>(12.5, 5)));
  CHECK_FALSE(contains(capsule, at<S, N>(-2, 5.5)));
  const Capsule<S, N> sphere{capsule.a, capsule.a, num<S>(5)};
  CHECK(contains(sphere, at<S, N>(4, 5)));
  CHECK_FALSE(contains(sphere, at<S, N>(4, 5.5)));
  CHECK(contains(Capsule<S, N>{capsule.a, capsule.b, num<S>(0)}, at<S, N>(4, 1)));
  CHECK_FALSE(contains(Capsule<S, N>{capsule.a, capsule.b, num<S>(0)}, at<S, N>(4, 1.5)));
  CHECK_FALSE(contains(Capsule<S, N>{capsule.a, capsule.b, num<S>(-1)}, capsule.a));
}

TEMPLATE_TEST_CASE("on, capsule: the tolerance includes its limit", "[on]", DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const Capsule<S, N> capsule{at<S, N>(1, 1), at<S, N>(9, 1), num<S>(2)};
  CHECK(on(capsule, at<S, N>(4, 6), num<S>(3)));
  CHECK_FALSE(on(capsule, at<S, N>(4, 6), num<S>(2.5)));
  CHECK_FALSE(on(Capsule<S, N>{capsule.a, capsule.b, num<S>(-1)}, capsule.a, largest<S>));
}

TEMPLATE_TEST_CASE("contains, capsule: one raw unit decides, at the ends of the domain too",
                   "[contains]", DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto low = filled<S, N>(S::lowest()), high = filled<S, N>(S::max());
  CHECK(contains(Capsule<S, N>{low, high, S(0)}, high));
  auto edge = low;
  edge.x = S::max();
  const Capsule<S, N> beam{low, edge, S::max()};
  auto point = Vec<S, N>();
  point[N - 1] = moved(S::lowest(), S::max().raw());
  if (N == 2) CHECK(contains(beam, point));
  point[N - 1] = moved(point[N - 1], 1);
  CHECK_FALSE(contains(beam, point));
}

}  // namespace
}  // namespace detent::test
