// SPDX-License-Identifier: MIT
#include "detent/query/contains/segment.hpp"

#include "query/raycast/helpers.hpp"

namespace detent::test {
namespace {

TEMPLATE_TEST_CASE("contains, segment: its points, including the ends", "[contains]",
                   DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const Segment<S, N> segment{at<S, N>(1, 1), at<S, N>(7, 4)};
  CHECK(contains(segment, segment.start));
  CHECK(contains(segment, segment.end));
  CHECK(contains(segment, at<S, N>(3, 2)));
  CHECK_FALSE(contains(segment, at<S, N>(9, 5)));
  CHECK_FALSE(contains(segment, at<S, N>(-1, 0)));
  CHECK_FALSE(contains(segment, at<S, N>(3, 2.5)));
  const Segment<S, N> point{segment.start, segment.start};
  CHECK(contains(point, segment.start));
  CHECK_FALSE(contains(point, at<S, N>(1, 2)));
  const Segment<S, N> upright{at<S, N>(2, 1), at<S, N>(2, 5)};
  CHECK(contains(upright, at<S, N>(2, 3)));
  CHECK_FALSE(contains(upright, at<S, N>(2, 5.5)));
}

TEMPLATE_TEST_CASE("contains, segment: one raw unit decides, at the ends of the domain too",
                   "[contains]", DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto low = filled<S, N>(S::lowest()), high = filled<S, N>(S::max());
  const Segment<S, N> diagonal{low, high};
  CHECK(contains(diagonal, Vec<S, N>()));
  auto beside = Vec<S, N>();
  beside[N - 1] = moved(S(0), 1);
  CHECK_FALSE(contains(diagonal, beside));
}

}  // namespace
}  // namespace detent::test
