// SPDX-License-Identifier: MIT
#include "detent/query/closest_point/capsule.hpp"
#include "detent/query/contains/capsule.hpp"

#include "query/raycast/helpers.hpp"

namespace detent::test {
namespace {

TEMPLATE_TEST_CASE(
    "closest point, capsule: on the surface towards the point, or an inside point itself",
    "[closest_point]", DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const Capsule<S, N> capsule{at<S, N>(1, 1), at<S, N>(9, 1), num<S>(5)};
  CHECK(closest_point(capsule, at<S, N>(4, 11)) == at<S, N>(4, 6));
  CHECK(closest_point(capsule, at<S, N>(20, 1)) == at<S, N>(14, 1));
  CHECK(closest_point(capsule, at<S, N>(-20, 1)) == at<S, N>(-4, 1));
  CHECK(closest_point(capsule, at<S, N>(3, 3)) == at<S, N>(3, 3));
  CHECK(closest_point(Capsule<S, N>{capsule.a, capsule.a, num<S>(5)}, at<S, N>(1, 20)) ==
        at<S, N>(1, 6));
  CHECK(closest_point(Capsule<S, N>{capsule.a, capsule.b, num<S>(0)}, at<S, N>(4, 11)) ==
        at<S, N>(4, 1));
  CHECK(closest_point(Capsule<S, N>{capsule.a, capsule.b, num<S>(-1)}, at<S, N>(4, 11)) ==
        at<S, N>(4, 11));
}

// In float the vector from the axis to a nearby point may round to 0, which has no direction.
static_assert([] {
  const Capsule<float, 2> needle{{69, 998}, {-334, -454}, 0};
  const Vec<float, 2> beside{-182.874985f, 90.5f};
  const auto away = closest_point(needle, beside) - beside;
  return !contains(needle, beside) && squared_length(away) < 1e-6f;
}());

TEMPLATE_TEST_CASE("closest point, capsule: the ends of the domain", "[closest_point]",
                   DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto low = filled<S, N>(S::lowest()), high = filled<S, N>(S::max());
  auto edge = low;
  edge.x = S::max();
  const auto closest = closest_point(Capsule<S, N>{low, edge, S::max()}, high);
  CHECK(closest.x == S::max());
  CHECK(closest.y > S::lowest());
  if (N == 2) CHECK(closest.y == moved(S::lowest(), S::max().raw()));
}

}  // namespace
}  // namespace detent::test
