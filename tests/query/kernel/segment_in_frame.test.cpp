// SPDX-License-Identifier: MIT
#include "detent/query/kernel/segment_in_frame.hpp"

#include "detent/query/distance/pair.hpp"
#include "detent/query/kernel/closest_in_frame.hpp"
#include "oracle/space.hpp"
#include "query/kernel/boxes_and_segments.hpp"
#include "support/catch.hpp"

namespace detent::test {
namespace {

struct Rates {
  HitRate meets, between, sure_points, sure_distances;
};

/// Compares what the filter is sure of with the exact path. `same` is the box in its own frame.
template <class Box, Scalar S>
void compare(const Box& box, const Obb<S, 3>* same, const Segment<S, 3>& segment, const S& radius,
             Rates& rates) {
  using Length = detail::Length<S>;
  const detail::SegmentInFrame<S> filter(box, segment);
  const auto distance = filter.distance_floor();
  const auto exact_distance = sqrt_floor<Length>([&] {
    if constexpr (detail::is_kind<Box, Obb>) {
      return detail::squared_gap_in_frame(box, segment);
    } else {
      return detail::squared_distance_between(detail::body_of(box), detail::body_of(segment));
    }
  }());
  rates.meets.count(exact_distance == 0);
  rates.between.count(filter.closest_at() == detail::ClosestAt::between);
  rates.sure_distances.count(distance.is_sure);
  if (distance.is_sure) REQUIRE(distance.value == exact_distance);
  if (same == nullptr) return;
  const auto points = filter.closest_points(radius);
  rates.sure_points.count(points.is_sure);
  if (points.is_sure) {
    REQUIRE(points.value == detail::find_closest_points_in_frame(*same, segment, radius));
  }
}

template <Scalar S>
void compare_some(int bits, int asked, Turning turning, Rates& rates) {
  draw_boxes_and_segments<S>(bits, asked, [&](BoxesAndSegments<S> draw) {
    const auto box = draw.box(turning);
    const auto segment = draw.segment(box);
    compare(box, &box, segment, draw.radius(), rates);
    const auto aligned = draw.aligned_box();
    compare(aligned, static_cast<const Obb<S, 3>*>(nullptr), draw.segment(aligned), S(0), rates);
  });
}

TEMPLATE_TEST_CASE("segment in frame: what it is sure of is exact", "[query]",
                   DETENT_FILTER_SCALARS) {
  using S = TestType;
  for (const auto turning : {Turning::any, Turning::none, Turning::little, Turning::skew}) {
    for (const int bits : {3, 12, 22, S::bits - 3}) {
      Rates rates;
      compare_some<S>(bits, 800, turning, rates);
      INFO(bits << ": meets " << rates.meets << ", between " << rates.between << "; sure: points "
                << rates.sure_points << ", distances " << rates.sure_distances);
      CHECK(rates.meets.percent() >= 10);
      CHECK(rates.between.percent() >= 30);
      CHECK(rates.sure_points.percent() >= 70);
      CHECK(rates.sure_distances.percent() >= 90);
    }
    Rates large;
    compare_some<S>(S::bits, 800, turning, large);
    CHECK(large.sure_distances.percent() < 100);
  }
}

TEST_CASE("segment in frame: the distance of capsules and boxes uses it", "[query]") {
  using S = q16_16;
  static_assert(detail::has_segment_in_frame<Obb<S, 3>> &&
                detail::has_segment_in_frame<Aabb<S, 3>>);
  static_assert(!detail::has_segment_in_frame<Obb<q8_8, 3>>);
  const Obb<S, 3> box{{}, {S(1), S(1), S(1)}, {}};
  const Capsule<S, 3> above{{S(-5), S(4), S(0)}, {S(5), S(4), S(0)}, S(1)};
  CHECK(distance(box, above) == 2);  // parallel to a face: left to the exact path
  const Capsule<S, 3> across{{S(3), S(0), S(0)}, {S(0), S(3), S(0)}, S(0)};
  CHECK(distance(box, across) == S::from_raw(46340));
}

}  // namespace
}  // namespace detent::test
