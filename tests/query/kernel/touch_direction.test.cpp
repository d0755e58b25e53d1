// SPDX-License-Identifier: MIT
#include "detent/query/kernel/touch_direction.hpp"

#include "detent/query/cast/motion.hpp"
#include "detent/query/cast/touch.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace detent::test {
namespace {

using S = q16_16;
using Radius = decltype(S() + S());

struct Count {
  HitRate hits, sure;
};

/// Compares the filter with Newton's method for a point that moves along `way` past another one, a
/// unit of time at a time, in a frame or in the world.
template <Number P, Number W, class ToWorld>
void compare(const Vec<P, 3>& between, const Vec<W, 3>& way, const Radius& radius,
             const S& distance, const ToWorld& to_world, Count& count) {
  const detail::HullBody a(std::array{Vec<P, 3>()}), b(std::array{between});
  using Body = std::remove_cvref_t<decltype(a)>;
  constexpr int most = bits_of<direction_component<S>> + 2;
  const auto place = between - way * distance;
  const auto next = S::from_raw(distance.raw() + 1);
  const auto reached = between - way * next;
  const bool is_hit = squared_length(place) > square(radius) &&
                      squared_length(reached) < square(radius) && dot(place, way) > 0;
  count.hits.count(is_hit);
  if (!is_hit) return;
  const auto found = detail::direction_at_touch<S>(place, way, radius, to_world);
  count.sure.count(found.is_sure);
  if (!found.is_sure) return;
  const detail::Approach<Body, Body, W, S, most> fine(a, b, way, radius,
                                                      detail::finer_by<most>(radius));
  const auto exact = fine.with_touch_of_points(
      between, fine.scaled(distance), fine.scaled(largest<S>),
      [&](const auto& v) { return direction_of<S>(detail::shortened<240>(to_world(v))).value(); });
  REQUIRE(found.value == exact);
}

/// Touches of balls whose radius has some bits; the motion and the normal have the cosine
/// 1 / `steepness` or, if it is small, about that.
void compare_many(int bits, std::int64_t steepness, int asked, Count& count) {
  Random random(static_cast<std::uint64_t>(bits) + static_cast<std::uint64_t>(steepness));
  using Place = Fixed<63, 46>;
  const auto unit = [&] {
    for (;;) {
      const auto v = make_vec<3>([&](int) {
        return S::from_raw(static_cast<std::int32_t>(random.between(-65536, 65536)));
      });
      if (const auto direction = direction_of<S>(v)) return *direction;
    }
  };
  for (int i = 0; i < asked; ++i) {
    CAPTURE(bits, steepness, i);
    const auto rotation = Rotation<S, 3>::from_euler(Angle<S>::from_degrees(S::from_raw(i << 8)),
                                                     Angle<S>(), Angle<S>());
    const auto direction = unit();
    const auto radius = Radius::from_raw(
        random.between(std::int64_t{1} << (bits - 1), (std::int64_t{1} << bits) - 1));
    const auto distance = S::from_raw(static_cast<std::int32_t>(random.between(0, 1 << 24)));
    const auto early = Fixed<31, 46>::from_raw(static_cast<std::int32_t>(random.below(1u << 30)));
    const auto compare_along = [&](const auto& way, const auto& to_world) {
      const auto across = direction_of<S>(cross(direction, unit().vec()));
      if (!across) return;
      const auto normal = direction_of<S>(direction.vec() + across->vec() * steepness);
      const auto between = make_vec<3>([&](int k) {
        return floor_to<Place>((*normal)[k] * radius + way[k] * early + way[k] * distance);
      });
      compare(between, way, radius, distance, to_world, count);
    };
    compare_along(direction.vec(), detail::SameFrame());
    const auto turned = make_vec<3>([&](int k) { return dot(rotation.axis(k), direction); });
    compare_along(turned, detail::FromFrame<S, 3>{rotation});
  }
}

TEST_CASE("touch direction: where the filter is sure, it is that of Newton's method", "[query]") {
  Count ordinary, steep, small;
  for (const int bits : {14, 17, 20, 24, 28}) compare_many(bits, 1, 1000, ordinary);
  for (const int bits : {20, 24, 28}) compare_many(bits, 1500, 10000, steep);
  for (const int bits : {1, 3, 7, 8, 10, 12}) compare_many(bits, 3, 1000, small);
  INFO(ordinary.hits << ", " << ordinary.sure << "; " << steep.hits << ", " << steep.sure << "; "
                     << small.hits << ", " << small.sure);
  CHECK(ordinary.hits.percent() >= 50);
  CHECK(ordinary.sure.percent() >= 95);
  CHECK(steep.sure.percent() >= 10);
  CHECK(steep.sure.percent() < 90);
  CHECK(small.sure.percent() < 90);
}

TEST_CASE("touch direction: frames whose axes are not perpendicular are left out", "[query]") {
  using Way = Fixed<61, 60>;
  const auto radius = Radius::from_raw(1 << 20);
  const Vec<Fixed<63, 46>, 3> place{radius, Radius(0), Radius(0)};
  const auto toward = [&](const Way& across) {
    return detail::direction_at_touch<S>(
        place + Vec<Fixed<31, 46>, 3>{Fixed<31, 46>::from_raw((1 << 28) + (1 << 16))},
        Vec<Way, 3>{Way(1), across, Way(0)}, radius, detail::SameFrame());
  };
  CHECK(toward(Way(0)).is_sure);
  CHECK_FALSE(toward(Way(1)).is_sure);
}

}  // namespace
}  // namespace detent::test
