// SPDX-License-Identifier: MIT
#include "detent/query/closest_point/segment.hpp"

#include "query/raycast/helpers.hpp"

namespace detent::test {
namespace {

TEMPLATE_TEST_CASE("closest point, segment: the foot of the perpendicular or an end",
                   "[closest_point]", DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const Segment<S, N> segment{at<S, N>(1, 1), at<S, N>(9, 1)};
  CHECK(closest_point(segment, at<S, N>(3, 5)) == at<S, N>(3, 1));
  CHECK(closest_point(segment, at<S, N>(-3, 5)) == segment.start);
  CHECK(closest_point(segment, at<S, N>(12, -5)) == segment.end);
  CHECK(closest_point(segment, at<S, N>(9, 5)) == segment.end);
  CHECK(closest_point(segment, at<S, N>(4, 1)) == at<S, N>(4, 1));
  CHECK(closest_point(Segment<S, N>{segment.end, segment.end}, Vec<S, N>()) == segment.end);
}

TEMPLATE_TEST_CASE("closest point, segment: rounded once, ties to even", "[closest_point]",
                   DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto raw = in_steps<S, N>;
  // Onto y = x: (1, 0) gives (0.5, 0.5) and (3, 0) gives (1.5, 1.5).
  const Segment<S, N> diagonal{raw(-8, -8), raw(8, 8)};
  CHECK(closest_point(diagonal, raw(1, 0)) == raw(0, 0));
  CHECK(closest_point(diagonal, raw(3, 0)) == raw(2, 2));
  CHECK(closest_point(diagonal, raw(0, -3)) == raw(-2, -2));
  const Segment<S, N> all{filled<S, N>(S::lowest()), filled<S, N>(S::max())};
  // The midpoint of the domain's corners is half a unit below 0.
  CHECK(closest_point(all, Vec<S, N>()) == Vec<S, N>());
  CHECK(closest_point(all, all.end) == all.end);
}

}  // namespace
}  // namespace detent::test
