// SPDX-License-Identifier: MIT
#include "detent/query/distance/capsule.hpp"

#include "query/raycast/helpers.hpp"

namespace detent::test {
namespace {

TEMPLATE_TEST_CASE("distance, capsule: to the surface, 0 inside, the greatest scalar to nothing",
                   "[distance]", DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const Capsule<S, N> capsule{at<S, N>(1, 1), at<S, N>(9, 1), num<S>(2)};
  CHECK(distance(capsule, at<S, N>(4, 11)) == num<S>(8));
  CHECK(distance(capsule, at<S, N>(12, 5)) == num<S>(3));
  CHECK(distance(capsule, at<S, N>(-2, -3)) == num<S>(3));
  CHECK(distance(capsule, at<S, N>(4, 2)) == num<S>(0));
  CHECK(distance(capsule, at<S, N>(4, 3)) == num<S>(0));
  CHECK(distance(Capsule<S, N>{capsule.a, capsule.b, num<S>(-1)}, capsule.a) == largest<S>);
}

TEMPLATE_TEST_CASE("distance, capsule: clamped at the ends of the domain", "[distance]",
                   DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto low = filled<S, N>(S::lowest()), high = filled<S, N>(S::max());
  CHECK(distance(Capsule<S, N>{low, low, S(0)}, high) == S::max());
  CHECK(distance(Capsule<S, N>{low, high, S(0)}, high) == S(0));
}

}  // namespace
}  // namespace detent::test
