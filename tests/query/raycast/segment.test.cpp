// SPDX-License-Identifier: MIT
#include "detent/query/raycast/segment.hpp"

#include "query/raycast/helpers.hpp"

namespace detent::test {
namespace {

static_assert(raycast(Ray<q16_16, 2>{{}, toward<q16_16, 2>(1), q16_16(9)},
                      Segment<q16_16, 2>{at<q16_16, 2>(5, -1), at<q16_16, 2>(5, 1)}) == q16_16(5));

TEMPLATE_TEST_CASE("ray against segment: it hits, misses and touches as drawn", "[raycast]",
                   DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const Ray<S, N> ray{{}, toward<S, N>(1), num<S>(100)};
  const auto segment = [](double x0, double y0, double x1, double y1) {
    return Segment<S, N>{at<S, N>(x0, y0), at<S, N>(x1, y1)};
  };
  auto cut = ray;

  CHECK(distance(ray, segment(5, -2, 9, 2)) == num<S>(7));
  CHECK(raycast_hit(ray, segment(5, -2, 9, 2))->normal == toward<S, N>(-1));
  CHECK(misses(ray, segment(5, 1, 9, 2)));
  CHECK(misses(ray, segment(-5, -1, -5, 1)));
  cut.max_distance = num<S>(6.5);
  CHECK(misses(cut, segment(5, -2, 9, 2)));
  // Ends touch, including the ray's end and its start.
  CHECK(distance(ray, segment(5, 0, 9, 2)) == num<S>(5));
  CHECK(distance(ray, segment(5, -3, 9, 0)) == num<S>(9));
  cut.max_distance = num<S>(7);
  CHECK(distance(cut, segment(5, -2, 9, 2)) == num<S>(7));
  CHECK(distance(ray, segment(0, -2, 0, 2)) == num<S>(0));
  cut.max_distance = num<S>(-1);
  CHECK(misses(cut, segment(0, -2, 0, 2)));
  // Along the ray, and parallel next to it.
  CHECK(raycast_interval(ray, segment(9, 0, 5, 0)) == Interval<S>{num<S>(5), num<S>(9)});
  CHECK(raycast_interval(ray, segment(-5, 0, 5, 0)) == Interval<S>{num<S>(0), num<S>(5)});
  CHECK(misses(ray, segment(-9, 0, -5, 0)));
  CHECK(misses(ray, segment(5, 1, 9, 1)));
  // A single point.
  CHECK(distance(ray, segment(5, 0, 5, 0)) == num<S>(5));
  CHECK(misses(ray, segment(5, 1, 5, 1)));
}

TEMPLATE_TEST_CASE("ray against segment: one raw unit decides, at the ends of the domain too",
                   "[raycast]", DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto low = S::lowest(), high = S::max();
  const Ray<S, N> ray{{}, toward<S, N>(1)};
  auto start = at<S, N>(5), end = at<S, N>(5, 2);
  CHECK(distance(ray, Segment<S, N>{start, end}) == num<S>(5));
  start.y = moved(start.y, 1);
  CHECK(misses(ray, Segment<S, N>{start, end}));
  if constexpr (N == 3) {
    start = at<S, N>(5, -2);
    start.z = moved(start.z, 1);
    CHECK(misses(ray, Segment<S, N>{start, end}));
  }
  const Segment<S, N> diagonal{filled<S, N>(low), filled<S, N>(high)};
  CHECK(distance(ray, diagonal) == num<S>(0));
  auto left = filled<S, N>(moved(S(0), -1));
  left.x = low;
  CHECK(misses(Ray<S, N>{left, toward<S, N>(1), moved(high, -1)}, diagonal));
  CHECK(distance(Ray<S, N>{left, toward<S, N>(1)}, diagonal) == high);
}

}  // namespace
}  // namespace detent::test
