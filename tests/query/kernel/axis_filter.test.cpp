// SPDX-License-Identifier: MIT
#include "detent/query/kernel/axis_filter.hpp"

#include "detent/math/rotation.hpp"
#include "detent/query/kernel/axis_push.hpp"
#include "detent/shape/bounding_box.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace detent::test {
namespace {

/// A body that hides that it is a box, so that all axes are tried.
template <class Body>
struct Plain : Body {
  explicit constexpr Plain(const Body& body) noexcept : Body(body) {}
  void span(int) const = delete;
};

struct Count {
  HitRate hits;
  int sides = 0, pairs = 0;
};

template <class A, class B>
void compare(const A& a, const B& b, Count& count) {
  static_assert(detail::IsBoxBody<A> && !detail::IsBoxBody<Plain<A>>);
  using T = std::remove_cvref_t<decltype((a.some() - b.some()).x)>;
  const auto filtered = detail::AxisPush<T, A, B>(a, b).least();
  const Plain<A> plain_a(a);
  const auto all = detail::AxisPush<T, Plain<A>, B>(plain_a, b).least();
  REQUIRE(filtered.has_value());
  count.hits.count(all->height > 0);
  REQUIRE((filtered->height > 0) == (all->height > 0));
  if (!(all->height > 0)) return;
  REQUIRE_FALSE(is_less(*filtered, *all));
  REQUIRE_FALSE(is_less(*all, *filtered));
  const auto lengths = squared_length(cross(filtered->normal, all->normal));
  REQUIRE((lengths == 0 && dot(filtered->normal, all->normal) > 0));

  detail::AxisFilter<A, B> filter(a, b);
  for (int i = 0; i < 3; ++i) filter.add(a.span(i));
  ++count.pairs;
  for (std::size_t i = 0; i < 3; ++i) {
    filter.for_each_side(i, [&](int) { ++count.sides; });
  }
}

/// Boxes within `reach` steps; `is_tight` makes many of them touch, be equal, flat or parallel.
template <Scalar S>
void compare_many(std::int64_t reach, bool is_tight, int asked, Count& count) {
  Random random(static_cast<std::uint64_t>(reach));
  const auto number = [&](std::int64_t low, std::int64_t high) {
    return S::from_raw(static_cast<typename S::raw_type>(random.between(low, high)));
  };
  const auto vector = [&](std::int64_t low, std::int64_t high) {
    return make_vec<3>([&](int) { return number(low, high); });
  };
  const auto rotation = [&] {
    const auto axis = direction_of<S>(vector(-reach, reach));
    if (!axis || random.one_in(5)) return Rotation<S, 3>();
    return Rotation<S, 3>::from_axis_angle(*axis, Angle<S>::from_degrees(number(0, reach)));
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
      if (random.one_in(4)) b.center[k] = saturate_to<S>(a.center[k] + number(-2, 2));
    }
    compare(detail::edge_body(a), detail::edge_body(b), count);
    const detail::AabbBody box(bounding_box(a)), other(bounding_box(b));
    if (i % 2 == 0) compare(box, detail::edge_body(b), count);
    if (i % 4 == 0) compare(box, other, count);
  }
}

TEST_CASE("axis filter of boxes: the remaining axes include the least push", "[query]") {
  Count spread, tight;
  compare_many<q16_16>(1 << 18, false, 1000, spread);
  compare_many<q16_16>(1 << 29, false, 500, spread);
  compare_many<q8_8>(1 << 13, false, 500, spread);
  compare_many<q16_16>(1 << 18, true, 500, tight);
  compare_many<q16_16>(64, true, 500, tight);
  compare_many<q16_16>(1 << 29, true, 300, tight);
  INFO(spread.hits << ", " << tight.hits);
  CHECK(spread.hits.is_balanced());
  CHECK(tight.hits.percent() >= 30);
  CHECK(spread.sides * 4 <= spread.pairs * 5);  // of six
}

}  // namespace
}  // namespace detent::test
