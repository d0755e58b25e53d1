// SPDX-License-Identifier: MIT
#include "detent/query/distance/segment.hpp"

#include "query/raycast/helpers.hpp"

namespace detent::test {
namespace {

TEMPLATE_TEST_CASE("distance, segment: to the line between the ends, or to an end", "[distance]",
                   DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const Segment<S, N> segment{at<S, N>(1, 1), at<S, N>(9, 1)};
  CHECK(distance(segment, at<S, N>(3, 5)) == num<S>(4));
  CHECK(distance(segment, at<S, N>(-2, 5)) == num<S>(5));
  CHECK(distance(segment, at<S, N>(12, -3)) == num<S>(5));
  CHECK(distance(segment, at<S, N>(4, 1)) == num<S>(0));
  CHECK(distance(Segment<S, N>{segment.end, segment.end}, at<S, N>(12, 5)) == num<S>(5));
  CHECK(squared_distance(segment, at<S, N>(3, 5)) <= num<S>(16));
  CHECK_FALSE(squared_distance(segment, at<S, N>(3, 5)) <= num<S>(15.5));
}

TEMPLATE_TEST_CASE("distance, segment: rounded down and clamped", "[distance]",
                   DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto low = filled<S, N>(S::lowest()), high = filled<S, N>(S::max());
  CHECK(distance(Segment<S, N>{low, low}, high) == S::max());
  CHECK(distance(Segment<S, N>{low, high}, high) == S(0));
  // One raw unit off the diagonal is a distance below one; two are a distance above one.
  auto beside = high;
  beside.x = moved(beside.x, -1);
  CHECK(distance(Segment<S, N>{low, high}, beside) == S(0));
  beside.x = moved(beside.x, -1);
  CHECK(distance(Segment<S, N>{low, high}, beside) == moved(S(0), 1));
}

}  // namespace
}  // namespace detent::test
