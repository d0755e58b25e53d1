// SPDX-License-Identifier: MIT
#include "detent/query/kernel/box_touch.hpp"

#include <array>

#include "detent/query/cast/motion.hpp"
#include "detent/query/cast/touch.hpp"
#include "oracle/space.hpp"
#include "query/kernel/boxes_and_segments.hpp"
#include "support/catch.hpp"

namespace detent::test {
namespace {

struct Rates {
  HitRate hits, sure, faces, features;
};

/// Compares the filter with the exact search, from where their boxes meet. Moving points and moving
/// boxes.
template <class A, class B, class Way, class ToWorld, Scalar S>
void compare(const A& a, const B& b, const Way& way, const ToWorld& to_world, const S& radius,
             const S& limit, Rates& rates) {
  constexpr int N = A::dimension;
  const auto steps = make_vec<N>([&](int i) { return way[i]; });
  using W = std::remove_cvref_t<decltype(steps.x)>;
  const auto sum = radius + S(0);
  using R = std::remove_cvref_t<decltype(sum)>;
  const auto start = detail::boxes_within(a, b, steps, sum, limit);
  if (!start) return;
  const detail::Approach<A, B, W, S, 0> search(a, b, steps, sum, 0);
  detail::BoxTouch<A, B, W, S, R> filter(a, b, steps, sum);
  const auto decided = filter.first(*start, limit);
  if (search.lead_at(*start).clearance != detail::Clearance::apart) {
    REQUIRE_FALSE(decided.is_sure);
    return;
  }
  const auto exact = search.first(*start, limit);
  rates.hits.count(exact.has_value());
  rates.sure.count(decided.is_sure);
  if (!decided.is_sure) return;
  REQUIRE(decided.value == exact);
  if (!exact) return;
  constexpr int most = bits_of<direction_component<S>> + 2;
  const detail::Approach<A, B, W, S, most> fine(a, b, steps, sum, detail::finer_by<most>(sum));
  const auto outward = [&](const auto& v) {
    return direction_of<S>(to_world(detail::shortened<240>(v))).value();
  };
  const auto from = fine.scaled(*exact), to = fine.scaled(limit);
  const int axis = filter.only_axis();
  const auto feature = filter.feature();
  rates.faces.count(axis >= 0);
  rates.features.count(feature.has_value());
  if (axis >= 0) {
    Vec<Fixed<2, 0>, N> normal{};
    normal[axis] = Fixed<2, 0>(steps[axis] > 0 ? 1 : -1);
    REQUIRE(outward(normal) == fine.with_touch(from, to, outward));
  } else if (feature) {
    REQUIRE(fine.with_touch_on(*feature, from, to, outward) == fine.with_touch(from, to, outward));
  }
}

template <Scalar S>
Direction<S, 3> toward(const Vec<S, 3>& from, const Vec<S, 3>& to, const Vec<S, 3>& aside) {
  return direction_of<S>(to - from + aside).value_or(Direction<S, 3>::along(0));
}

TEMPLATE_TEST_CASE("box touch: what it is sure of is exact", "[query]", DETENT_FILTER_SCALARS) {
  using S = TestType;
  for (const auto turning : {Turning::any, Turning::none, Turning::little, Turning::skew}) {
    for (const int bits : {3, 12, 20, S::bits - 4}) {
      Rates rates;
      draw_boxes_and_segments<S>(bits, 120, [&](BoxesAndSegments<S> draw) {
        const auto box = draw.box(turning);
        const auto flat = draw.aligned_box();
        const auto point = nearest_to<S>(draw.vector(std::int64_t{1} << (bits + 1)) + box.center);
        const auto aside = nearest_to<S>(draw.vector((std::int64_t{1} << bits) / 2));
        const auto radius = draw.radius() + S::from_raw(1);
        const auto direction = toward(point, box.center, aside);
        const S limit = draw.number(0, (std::int64_t{1} << S::bits) - 1);
        const auto place = detail::body_in_frame(box, point);
        const auto slabs = detail::slab_body(box);
        const auto way = detail::way_in_frame(box, direction);
        const detail::FromFrame<S, 3> to_world{box.rotation};
        const auto some = nearest_to<S>(radius);
        compare(place, slabs, way, to_world, some, limit, rates);
        compare(slabs, place, -way, to_world, some, limit, rates);
        const auto body = detail::body_of(point);
        compare(body, detail::AabbBody(flat), direction, detail::SameFrame(), some, limit, rates);
        compare(detail::AabbBody(flat), body, -direction, detail::SameFrame(), some, limit, rates);
      });
      INFO(bits << ": hits " << rates.hits << ", sure " << rates.sure << ", faces " << rates.faces
                << ", features " << rates.features);
      CHECK(rates.hits.percent() >= 20);
      CHECK(rates.hits.percent() <= 95);
      CHECK(rates.sure.percent() < 100);
      if (bits >= 20) CHECK(rates.sure.percent() >= 80);
      if (bits >= 20) CHECK(rates.features.percent() >= 60);
      CHECK(rates.faces.percent() >= 5);
    }
  }
}

TEMPLATE_TEST_CASE("box touch: what it is sure of is exact in 2D", "[query]",
                   DETENT_FILTER_SCALARS) {
  using S = TestType;
  Random random(1);
  for (const int bits : {4, 14, S::bits - 4}) {
    Rates rates;
    const auto number = [&](std::int64_t reach) { return random.number<S>(-reach, reach); };
    const std::int64_t reach = std::int64_t{1} << bits;
    for (int i = 0; i < 500; ++i) {
      CAPTURE(bits, i);
      const auto vector = [&] { return make_vec<2>([&](int) { return number(reach); }); };
      const auto a = vector(), b = vector();
      const detail::AabbBody box(
          make_vec<2>([&](int k) { return nearest_to<S>(half((std::min)(a[k], b[k]))); }),
          make_vec<2>([&](int k) { return nearest_to<S>(half((std::max)(a[k], b[k]))); }));
      const auto point = vector();
      const auto direction =
          direction_of<S>(half(vector()) - point).value_or(Direction<S, 2>::along(0));
      const S radius = S::from_raw(static_cast<typename S::raw_type>(
          1 + random.below(static_cast<std::uint64_t>(reach / 2))));
      const auto body = detail::body_of(point);
      compare(body, box, direction, detail::SameFrame(), radius, largest<S>, rates);
      compare(box, body, -direction, detail::SameFrame(), radius, largest<S>, rates);
    }
    INFO(bits << ": hits " << rates.hits << ", sure " << rates.sure);
    CHECK(rates.hits.percent() >= 30);
    if (bits >= 14) CHECK(rates.sure.percent() >= 80);
  }
}

/// Squares that sum to a square: the point is at exactly the radius from a face, an edge or a corner,
/// but for a few of the filter's steps, at a time of the grid.
TEMPLATE_TEST_CASE("box touch: touches within its error are left to the exact search", "[query]",
                   DETENT_FILTER_SCALARS) {
  using S = TestType;
  constexpr std::array<std::array<std::int64_t, 4>, 3> lengths{
      {{3, 4, 0, 5}, {2, 3, 6, 7}, {1, 2, 2, 3}}};
  Random random(29);
  Rates near, apart;
  const auto number = [&](std::int64_t low, std::int64_t high) {
    return random.number<S>(low, high);
  };
  for (int i = 0; i < 300; ++i) {
    CAPTURE(i);
    const auto extent = [&](int) { return number(1 << 16, 1 << 17); };
    const Obb<S, 3> box{{}, make_vec<3>(extent), random_turn<S>(random, 32)};
    const auto slabs = detail::slab_body(box);
    const auto direction = direction_of<S>(make_vec<3>([&](int) {
                             return number(-99, 99);
                           })).value_or(Direction<S, 3>::along(0));
    const auto way = detail::way_in_frame(box, direction);
    const S time = number(1 << 10, 1 << 20);
    const auto& length = lengths[random.below(3)];
    const auto scale = random.between(1, 1 << 10);
    const bool is_near = random.coin();
    auto place = detail::in_frame(box, box.center);
    using Place = std::remove_cvref_t<decltype(place.x)>;
    for (int k = 0; k < 3; ++k) {
      // The excess of the place over the box is `length` against the motion.
      const S v = S::from_raw(
          static_cast<typename S::raw_type>(length[static_cast<std::size_t>(k)] * scale));
      const auto moved = way[k] * time;
      const auto few = random.between(0, is_near ? 2 : 1 << 12);
      const auto more = Fixed<16, Place::frac>::from_raw(static_cast<std::int16_t>(few));
      place[k] = v == 0       ? floor_to<Place>(-moved)
                 : way[k] > 0 ? floor_to<Place>(slabs.low()[k] - v - moved - more)
                              : floor_to<Place>(slabs.high()[k] + v - moved + more);
    }
    const S radius = S::from_raw(static_cast<typename S::raw_type>(length[3] * scale));
    compare(detail::HullBody(std::array{place}), slabs, way, detail::FromFrame<S, 3>{box.rotation},
            radius, largest<S>, is_near ? near : apart);
  }
  INFO("near: hits " << near.hits << ", sure " << near.sure << "; apart: sure " << apart.sure);
  CHECK(near.hits.percent() >= 90);
  CHECK(near.sure.percent() <= 60);
  CHECK(apart.sure.percent() >= 80);
}

}  // namespace
}  // namespace detent::test
