// SPDX-License-Identifier: MIT
#include "detent/query/kernel/thin_in_slabs.hpp"

#include "detent/query/cast/point.hpp"
#include "oracle/space.hpp"
#include "query/kernel/boxes_and_segments.hpp"
#include "support/catch.hpp"

namespace detent::test {
namespace {

/// Compares the filter with the exact point for a box and a segment, moved to any distance.
template <class A, class B, Scalar S, int N>
void compare(const A& shape, const B& target, const Direction<S, N>& direction, const S& distance,
             HitRate& sure) {
  const auto found = detail::decide_closest_point(shape, target, direction, distance);
  sure.count(found.is_sure);
  if (!found.is_sure) return;
  REQUIRE(found.value == detail::find_closest_point_of_target(shape, target, direction, distance));
}

/// As many directions as random vectors.
template <Scalar S, int N>
Direction<S, N> direction_from(const Vec<S, N>& v) {
  return direction_of<S>(v).value_or(Direction<S, N>::along(0));
}

TEMPLATE_TEST_CASE("thin in slabs: what it is sure of is exact", "[query]", DETENT_FILTER_SCALARS) {
  using S = TestType;
  for (const auto turning : {Turning::any, Turning::none, Turning::little, Turning::skew}) {
    for (const int bits : {3, 12, 22, S::bits - 2, S::bits}) {
      HitRate sure;
      draw_boxes_and_segments<S>(bits, 100, [&](BoxesAndSegments<S> draw) {
        const auto box = draw.box(turning);
        const auto flat = draw.aligned_box();
        const auto segment = draw.segment(box), other = draw.segment(flat);
        const auto direction = direction_from(draw.vector(std::int64_t{1} << bits));
        const S distance = draw.number(0, (std::int64_t{1} << bits) - 1);
        const Capsule<S, 3> round{segment.start, segment.end, draw.radius()};
        const Capsule<S, 3> ball{other.start, other.end, draw.radius()};
        compare(box, segment, direction, distance, sure);
        compare(box, round, direction, distance, sure);
        compare(round, box, direction, distance, sure);
        compare(flat, other, direction, distance, sure);
        compare(flat, ball, direction, distance, sure);
        compare(ball, flat, direction, distance, sure);
        compare(Sphere<S, 3>{flat.min, ball.radius}, ball, direction, distance, sure);
        compare(ball, Sphere<S, 3>{flat.min, draw.radius()}, direction, distance, sure);
      });
      INFO(bits << ": sure " << sure);
      CHECK(sure.percent() < 100);
      // Most of the others meet. Without bisection it would be sure of a fifth less.
      if (bits >= 12 && bits < S::bits) CHECK(sure.percent() >= 65);
    }
  }
}

/// Corners of the box and points of the segment close to ties: near-parallel edges, and ends level
/// with a face.
TEST_CASE("thin in slabs: near ties are left to the exact path or rounded correctly", "[query]") {
  using S = q16_16;
  HitRate sure;
  Random random(7);
  const auto step = [&](std::int64_t most) {
    return S::from_raw(static_cast<std::int32_t>(random.between(-most, most)));
  };
  for (int i = 0; i < 3000; ++i) {
    CAPTURE(i);
    const Obb<S, 3> box{{step(9), step(9), step(9)}, {S(1), S(1), S(1)}, {}};
    const Aabb<S, 3> flat{{S(-1), S(-1), S(-1)}, {S(1), S(1), S(1)}};
    const S low = random.coin() ? S(-1) : S(-3), high = random.coin() ? S(1) : S(3);
    const Segment<S, 3> segment{{nearest_to<S>(low + step(2)), nearest_to<S>(S(1) + step(2)),
                                 nearest_to<S>(S(2) + step(2))},
                                {nearest_to<S>(high + step(2)), nearest_to<S>(S(1) + step(2)),
                                 nearest_to<S>(S(2) + step(2))}};
    const auto direction = direction_from(Vec<S, 3>{step(2), step(2), S(-1)});
    const S distance = nearest_to<S>(S(1) + step(70000));
    if (distance < 0) continue;
    const Capsule<S, 3> round{segment.start, segment.end, S::from_raw(1 + (i & 0xffff))};
    compare(box, round, -direction, distance, sure);
    compare(round, box, direction, distance, sure);
    compare(flat, segment, -direction, distance, sure);
    compare(round, flat, direction, distance, sure);
  }
  INFO(sure);
  CHECK(sure.percent() >= 10);
  CHECK(sure.percent() < 100);
}

TEST_CASE("thin in slabs: what it is sure of is exact in 2D", "[query]") {
  using S = q16_16;
  for (const int bits : {3, 12, 22, 29}) {
    HitRate sure;
    Random random(static_cast<std::uint64_t>(bits));
    const std::int64_t reach = std::int64_t{1} << bits;
    const auto number = [&](std::int64_t low, std::int64_t high) {
      return S::from_raw(static_cast<std::int32_t>(random.between(low, high)));
    };
    const auto vector = [&] { return make_vec<2>([&](int) { return number(-reach, reach - 1); }); };
    for (int i = 0; i < 500; ++i) {
      CAPTURE(bits, i);
      const Obb<S, 2> box{vector(),
                          {number(0, reach / 2), number(0, reach / 2)},
                          Rotation<S, 2>::from_angle(Angle<S>::from_raw(
                              random.one_in(3) ? 0 : static_cast<std::uint32_t>(random.next())))};
      const Segment<S, 2> segment{vector(), vector()};
      const Capsule<S, 2> round{segment.start, segment.end, number(0, reach / 2)};
      const auto direction = direction_from(vector());
      const S distance = number(0, reach - 1);
      const auto a = vector(), b = vector();
      const Aabb<S, 2> flat{make_vec<2>([&](int k) { return (std::min)(a[k], b[k]); }),
                            make_vec<2>([&](int k) { return (std::max)(a[k], b[k]); })};
      compare(box, round, direction, distance, sure);
      compare(box, segment, direction, distance, sure);
      compare(round, box, direction, distance, sure);
      compare(flat, round, direction, distance, sure);
      compare(segment, flat, direction, distance, sure);
      compare(Sphere<S, 2>{a, round.radius}, round, direction, distance, sure);
      compare(Sphere<S, 2>{a, round.radius}, segment, direction, distance, sure);
      compare(round, Sphere<S, 2>{a, number(0, reach / 2)}, direction, distance, sure);
      compare(segment, Sphere<S, 2>{a, round.radius}, direction, distance, sure);
    }
    INFO(bits << ": sure " << sure);
    CHECK(sure.percent() < 100);
    if (bits >= 12) CHECK(sure.percent() >= 75);
  }
}

}  // namespace
}  // namespace detent::test
