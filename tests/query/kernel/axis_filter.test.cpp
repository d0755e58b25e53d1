// SPDX-License-Identifier: MIT
#include "detent/query/kernel/axis_filter.hpp"

#include "detent/math/rotation.hpp"
#include "detent/query/kernel/axis_push.hpp"
#include "detent/shape/bounding_box.hpp"
#include "support/catch.hpp"
#include "support/random_vec.hpp"

namespace detent::test {
namespace {

struct Count {
  HitRate hits;
  int axes = 0, overlapping = 0, apart = 0, proved_apart = 0;
};

/// The exact pushes along all axes against the filter: it leaves the least, and never says that boxes
/// with a common point are apart.
template <Scalar S, class A, class B>
void compare(const A& a, const B& b, Count& count) {
  const auto body_a = detail::body_of(a);
  const auto body_b = detail::body_of(b);
  using T = std::remove_cvref_t<decltype((body_a.some() - body_b.some()).x)>;
  using BodyA = std::remove_cvref_t<decltype(body_a)>;
  using BodyB = std::remove_cvref_t<decltype(body_b)>;
  const detail::AxisPush<T, BodyA, BodyB> pushes(body_a, body_b);
  const auto all = pushes.least();
  const detail::AxisFilter<S> filter(a, b);
  REQUIRE(all.has_value());
  count.hits.count(all->height > 0);
  if (filter.are_apart()) REQUIRE_FALSE(all->height > 0);
  if (all->height < 0) {
    ++count.apart;
    count.proved_apart += filter.are_apart() ? 1 : 0;
  }
  const auto filtered = pushes.least(filter);
  REQUIRE(filtered.has_value());
  REQUIRE((filtered->height > 0) == (all->height > 0));
  if (!(all->height > 0)) return;
  REQUIRE_FALSE(detail::is_less(*filtered, *all));
  REQUIRE_FALSE(detail::is_less(*all, *filtered));
  const auto lengths = squared_length(cross(filtered->normal, all->normal));
  REQUIRE((lengths == 0 && dot(filtered->normal, all->normal) > 0));
  ++count.overlapping;
  for (std::size_t i = 0; i < 15; ++i) count.axes += filter.can_be_least(i) ? 1 : 0;
}

/// Boxes within `reach` steps; `is_tight` makes many of them touch, be equal, flat or parallel.
template <Scalar S>
void compare_many(std::int64_t reach, bool is_tight, int asked, Count& count) {
  Random random(static_cast<std::uint64_t>(reach));
  const auto vector = [&](std::int64_t low, std::int64_t high) {
    return random_vec<S, 3>(random, low, high);
  };
  const auto rotation = [&] {
    const auto axis = direction_of<S>(vector(-reach, reach));
    if (!axis || random.one_in(5)) return Rotation<S, 3>();
    return Rotation<S, 3>::from_axis_angle(*axis,
                                           Angle<S>::from_degrees(random.number<S>(0, reach)));
  };
  for (int i = 0; i < asked; ++i) {
    CAPTURE(reach, is_tight, i);
    Obb<S, 3> a{vector(-reach, reach), vector(0, reach), rotation()};
    Obb<S, 3> b{vector(-reach, reach), vector(0, reach), rotation()};
    if (is_tight) {
      const int k = i % 3;
      if (random.coin()) b.rotation = a.rotation;
      if (random.coin()) b.center = a.center;
      if (random.one_in(4)) b.half_extents = a.half_extents;
      if (random.one_in(4)) a.half_extents[k] = S(0);
      if (random.one_in(4)) b.center[k] = saturate_to<S>(a.center[k] + random.number<S>(-2, 2));
    }
    compare<S>(a, b, count);
    if (i % 2 == 0) compare<S>(bounding_box(a), b, count);
    if (i % 4 == 0) compare<S>(a, bounding_box(b), count);
  }
}

TEST_CASE("axis filter of boxes: the remaining axes include the least push", "[query]") {
  Count spread, tight;
  compare_many<q16_16>(1 << 18, false, 1000, spread);
  compare_many<q16_16>(1 << 29, false, 500, spread);
  compare_many<q24_8>(1 << 30, false, 500, spread);
  compare_many<q16_16>(1 << 18, true, 500, tight);
  compare_many<q16_16>(64, true, 500, tight);
  compare_many<q16_16>(1 << 29, true, 300, tight);
  INFO(spread.hits << ", " << tight.hits);
  CHECK(spread.hits.is_balanced());
  CHECK(tight.hits.percent() >= 30);
  // Of 15 axes; boxes without a rotation have six pairs of edges that are nearly or quite parallel.
  INFO(spread.axes << " of " << spread.overlapping);
  CHECK(spread.axes < 3 * spread.overlapping);
  CHECK(100 * spread.proved_apart >= 99 * spread.apart);
}

}  // namespace
}  // namespace detent::test
