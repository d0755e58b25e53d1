// SPDX-License-Identifier: MIT
#include <algorithm>

#include "detent/query/contact/pair.hpp"
#include "detent/query/contact/segment_box.hpp"
#include "detent/query/distance/pair.hpp"
#include "detent/query/kernel/closest_in_frame.hpp"
#include "detent/query/kernel/segment_in_frame.hpp"
#include "oracle/space.hpp"
#include "query/kernel/boxes_and_segments.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace detent::test {
namespace {

struct Rates {
  HitRate meets, sure_points, sure_distances, sure_pushes;
};

template <Scalar S>
Obb<S, 2> draw_box(Random& random, std::int64_t reach, Turning turning) {
  const auto number = [&](std::int64_t low, std::int64_t high) {
    return random.number<S>(low, high);
  };
  const auto turn = [&](std::uint64_t most) {
    return Rotation<S, 2>::from_angle(
        Angle<S>::from_raw(static_cast<std::uint32_t>(random.below(most))));
  };
  constexpr std::uint64_t whole = std::uint64_t{1} << 32;
  const auto near = std::max<std::int64_t>(reach / 4, 1);
  Obb<S, 2> box{{number(-near, near), number(-near, near)},
                {random.one_in(8) ? S(0) : number(0, reach / 2), number(0, reach / 2)},
                {}};
  if (turning == Turning::any) box.rotation = turn(whole);
  if (turning == Turning::little) box.rotation = turn(1 << 12);
  if (turning == Turning::skew) {
    box.rotation = Rotation<S, 2>::from_axes({turn(whole).axis(0), turn(whole).axis(1)});
  }
  return box;
}

/// Compares what the filters are sure of with the exact path, in the plane.
template <Scalar S>
void compare_some(int bits, int asked, Turning turning, Rates& rates) {
  Random random(static_cast<std::uint64_t>(bits));
  INFO(random);
  const auto reach = std::int64_t{1} << bits;
  const auto number = [&](std::int64_t low, std::int64_t high) {
    return random.number<S>(low, high);
  };
  const auto point = [&] {
    return Vec<S, 2>{number(-reach, reach - 1), number(-reach, reach - 1)};
  };
  for (int i = 0; i < asked; ++i) {
    CAPTURE(bits, i);
    const auto box = draw_box<S>(random, reach, turning);
    Segment<S, 2> segment{point(), point()};
    if (random.one_in(8)) segment.start = box.center;
    if (random.one_in(8)) segment.end = segment.start;
    if (random.one_in(4)) segment.end.x = segment.start.x;
    const auto radius = random.one_in(3) ? S(0) : number(0, reach / 2);

    const detail::SegmentInFrame<S, 2> filter(box, segment);
    const auto distance = filter.distance_floor();
    const auto exact_distance =
        sqrt_floor<detail::Length<S>>(detail::squared_gap_in_frame(box, segment));
    rates.meets.count(exact_distance == 0);
    rates.sure_distances.count(distance.is_sure);
    if (distance.is_sure) REQUIRE(distance.value == exact_distance);
    const auto points = filter.closest_points(radius);
    rates.sure_points.count(points.is_sure);
    if (points.is_sure) {
      REQUIRE(points.value == detail::find_closest_points_in_frame(box, segment, radius));
    }
    const auto push = detail::find_segment_box_push(box, segment, radius);
    rates.sure_pushes.count(detail::SegmentBoxFilter<S, 2>(box, segment, radius).find().is_sure);
    for (const bool box_is_a : {true, false}) {
      REQUIRE(detail::contact_in_frame(box, segment, radius, box_is_a) ==
              detail::contact_of_push(box, segment, radius, box_is_a, push));
    }
  }
}

TEMPLATE_TEST_CASE("segment in frame: in the plane, too, what it is sure of is exact", "[query]",
                   DETENT_FILTER_SCALARS) {
  using S = TestType;
  static_assert(detail::has_segment_in_frame<Obb<S, 2>>);
  static_assert(!detail::has_segment_in_frame<Obb<q8_8, 2>>);
  for (const auto turning : {Turning::any, Turning::none, Turning::little, Turning::skew}) {
    for (const int bits : {3, 12, 22, S::bits - 3}) {
      Rates rates;
      compare_some<S>(bits, 500, turning, rates);
      INFO(bits << ": meets " << rates.meets << "; sure: points " << rates.sure_points
                << ", distances " << rates.sure_distances << ", pushes " << rates.sure_pushes);
      CHECK(rates.meets.percent() >= 10);
      CHECK(rates.meets.percent() <= 90);
      CHECK(rates.sure_points.percent() >= 60);
      CHECK(rates.sure_distances.percent() >= 90);
      CHECK(rates.sure_pushes.percent() >= 40);
    }
    Rates large;
    compare_some<S>(S::bits, 300, turning, large);
    if (S::bits > 30) CHECK(large.sure_distances.percent() < 100);
  }
}

}  // namespace
}  // namespace detent::test
