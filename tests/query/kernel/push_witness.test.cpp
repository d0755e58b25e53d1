// SPDX-License-Identifier: MIT
#include "detent/query/kernel/push_witness.hpp"

#include <algorithm>

#include "detent/math/direction.hpp"
#include "detent/math/rotation.hpp"
#include "detent/query/contact.hpp"
#include "detent/query/kernel/gjk.hpp"
#include "oracle/space.hpp"
#include "support/catch.hpp"
#include "support/random_vec.hpp"

namespace detent::test {
namespace {

struct Count {
  HitRate hits, sure;
};

/// Compares the witness with the exact searches, in numbers of type T.
template <Number T, class A, class B, class Bounds>
void compare_in(const A& a, const B& b, const Bounds& low, const Bounds& high, Count& count) {
  using Witness = detail::PushWitness<T, A, B>;
  Witness witness(a, b);
  const auto outcome = witness.find(low, high);
  detail::Gjk<T, A, B> search(a, b);
  const bool touches = search.touches();
  count.hits.count(touches);
  count.sure.count(outcome != Witness::Outcome::unsure);
  if (outcome == Witness::Outcome::unsure) return;
  REQUIRE(touches == (outcome == Witness::Outcome::found));
  if (!touches) return;
  const auto exact = detail::Expansion<T, A, B>(a, b, search.feature()).least_push();
  const auto& push = witness.push();
  REQUIRE(push.height > 0);
  using Component = Fixed<31, 30>;
  REQUIRE(unit_vector<Component>(to_array(push.normal)) ==
          unit_vector<Component>(to_array(exact.normal)));
  REQUIRE(detail::are_parallel(push.normal, exact.normal));
  for (int i = 0; i < 3; ++i) {
    REQUIRE(push.height * exact.normal[i] == exact.height * push.normal[i]);
  }
  // The corners level with the facet.
  const auto level = [&](const auto& corners, std::uint32_t mask) {
    const auto on = [&](std::size_t k) { return (mask >> k & 1) != 0; };
    std::size_t first = 0;
    while (!on(first)) ++first;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      REQUIRE(on(k) == (dot(push.normal, corners[k] - corners[first]) == 0));
    }
  };
  level(a.corners(), witness.level().a);
  level(b.corners(), witness.level().b);
}
template <class A, class B>
void compare(const A& a, const B& b, Count& count) {
  const auto low = a.low() - b.high(), high = a.high() - b.low();
  if (!detail::holds_origin(low, high)) return;
  static_cast<void>(detail::with_differences(low, high, [&]<Number T>(const T&) {
    compare_in<T>(a, b, low, high, count);
    return true;
  }));
}

/// How the axes of boxes lie: faces and edges are often parallel, or nearly so.
enum class Axes { any, parallel, nearly_parallel };

/// Bodies within `reach` steps, on a grid of `grid` steps.
template <Scalar S>
void compare_many(std::int64_t reach, std::int64_t grid, Axes axes, int asked, Count& count,
                  Count& many) {
  Random random(static_cast<std::uint64_t>(reach + grid + asked));
  const auto number = [&](std::int64_t low, std::int64_t high) {
    return S::from_raw(
        static_cast<typename S::raw_type>(random.between(low / grid, high / grid) * grid));
  };
  const auto point = [&] { return make_vec<3>([&](int) { return number(-reach, reach); }); };
  const auto box = [&] {
    const auto half = make_vec<3>([&](int) { return number(0, reach); });
    const auto toward = [&] {
      if (axes == Axes::any) return point();
      return make_vec<3>([&](int) {
        const auto component = random.between(-1, 1) * (1 << 12);
        const auto off = axes == Axes::parallel ? 0 : random.between(-1, 1);
        return S::from_raw(static_cast<typename S::raw_type>(component + off));
      });
    };
    Rotation<S, 3> rotation;
    if (const auto first = direction_of<S>(toward())) {
      if (const auto third = direction_of<S>(cross(first->vec(), toward()))) {
        const auto second = direction_of<S>(cross(third->vec(), first->vec()));
        rotation = Rotation<S, 3>::from_axes({*first, *second, *third});
      }
    }
    return Obb<S, 3>{point(), half, rotation};
  };
  for (int i = 0; i < asked; ++i) {
    CAPTURE(reach, grid, axes, i);
    const auto a = detail::edge_body(box()), b = detail::edge_body(box());
    std::array<Vec<S, 3>, 33> points;
    for (auto& corner : points) corner = point();
    std::array<Vec<S, 3>, 12> others;
    for (auto& corner : others) corner = point();
    const auto hull = [&](std::size_t corners) {
      return detail::HullBody(ConvexHull<S, 3>{std::span(points).first(corners)});
    };
    const auto middle = point();
    for (auto& corner : others) {
      corner = make_vec<3>([&](int k) {
        const auto moved = corner[k] + middle[k];
        return i % 4 == 0   ? corner[k]
               : i % 2 == 0 ? saturate_to<S>(moved)
                            : saturate_to<S>(moved + middle[k]);
      });
    }
    const detail::HullBody other(ConvexHull<S, 3>{others});
    compare(hull(4), other, count);
    compare(hull(12), other, count);
    compare(other, hull(1 + static_cast<std::size_t>(i) % 32), count);
    compare(hull(8), b, count);
    compare(a, hull(3), count);
    compare(detail::HullBody(std::array{points[0], points[1], points[2]}), other, count);
    Vec<S, 3> low = points[3], high = low;
    for (int k = 0; k < 3; ++k) {
      low[k] = (std::min)(low[k], points[4][k]);
      high[k] = (std::max)(high[k], points[4][k]);
    }
    compare(detail::AabbBody(low, high), other, count);
    compare(a, b, count);
    compare(hull(33), other, many);
  }
}

/// Points, segments and triangles that share corners: they touch and have no depth.
template <Scalar S>
void compare_flat(std::int64_t reach, int asked, Count& count) {
  Random random(static_cast<std::uint64_t>(reach + asked));
  for (int i = 0; i < asked; ++i) {
    std::array<Vec<S, 3>, 5> p;
    for (auto& corner : p) {
      corner = random_vec<S, 3>(random, -reach, reach);
    }
    CAPTURE(reach, i, p);
    const detail::HullBody triangle(std::array{p[0], p[1], p[2]});
    for (std::size_t k = 0; k < 3; ++k) {
      compare(triangle, detail::HullBody(std::array{p[k]}), count);
      compare(triangle, detail::HullBody(std::array{p[3], p[k]}), count);
      compare(triangle, detail::HullBody(std::array{p[k], p[3], p[4]}), count);
      compare(detail::HullBody(std::array{p[k], p[3]}), triangle, count);
      compare(detail::HullBody(std::array{p[k], p[3]}), detail::HullBody(std::array{p[k]}), count);
    }
  }
}

TEMPLATE_TEST_CASE("push witness: flat bodies that share a corner are not apart", "[kernel]",
                   DETENT_FIXED_SCALARS) {
  Count count;
  for (const std::int64_t reach : {4, 3000, 30'000}) compare_flat<TestType>(reach, 300, count);
  if constexpr (bits_of < TestType >> 16) compare_flat<TestType>(1 << 28, 300, count);
  CHECK(count.hits.percent() >= 80);
}

/// Boxes whose pushes along the three axes are nearly equal, or that nearly touch, as hulls and as
/// bodies. The differences are up to 3 `unit`s.
template <Scalar S>
void compare_near_ties(std::int64_t reach, std::int64_t unit, int asked, Count& count) {
  Random random(static_cast<std::uint64_t>(reach + unit + asked));
  for (int i = 0; i < asked; ++i) {
    CAPTURE(reach, unit, i);
    const auto depth = i % 3 == 0 ? 0 : random.between(0, reach);
    const auto raw = [](std::int64_t x) {
      return S::from_raw(static_cast<typename S::raw_type>(x));
    };
    Vec<S, 3> half, low, high;
    for (int k = 0; k < 3; ++k) {
      const auto a = random.between(reach / 2, reach), b = random.between(reach / 2, reach);
      const auto at = a + b - depth - random.between(-3, 3) * unit;
      const auto center = random.coin() ? at : -at;
      half[k] = raw(a);
      low[k] = raw(center - b);
      high[k] = raw(center + b);
    }
    const detail::AabbBody a(make_vec<3>([&](int k) { return narrow_negative(half[k]); }), half);
    const detail::AabbBody b(low, high);
    const auto corners_a = a.corners(), corners_b = b.corners();
    const detail::HullBody hull_a(ConvexHull<S, 3>{corners_a}), hull_b(ConvexHull<S, 3>{corners_b});
    compare(hull_a, hull_b, count);
    compare(a, hull_b, count);
    compare(hull_a, detail::edge_body(Obb<S, 3>{{}, half, {}}), count);
    auto tilted = corners_b;
    for (auto& corner : tilted) corner.x = raw(corner.x.raw() + random.between(-1, 1) * unit);
    compare(hull_a, detail::HullBody(ConvexHull<S, 3>{tilted}), count);
  }
}

/// Hulls that nearly touch, in any direction.
template <Scalar S>
void compare_near_touches(std::int64_t reach, int asked, Count& count) {
  Random random(static_cast<std::uint64_t>(reach + asked));
  const auto point = [&] { return random_vec<S, 3>(random, -reach, reach); };
  for (int i = 0; i < asked; ++i) {
    CAPTURE(reach, i);
    std::array<Vec<S, 3>, 10> a, b;
    for (auto& corner : a) corner = point();
    for (auto& corner : b) corner = point();
    const auto found = contact(ConvexHull<S, 3>{a}, ConvexHull<S, 3>{b});
    if (!found) continue;
    const auto apart = separation(*found);
    const auto back = make_vec<3>([&](int k) {
      const auto steps = random.between(0, i % 4 == 0 ? reach / 64 : 3);
      const auto raw = apart[k] > 0 ? steps : -steps;
      return S::from_raw(static_cast<typename S::raw_type>(raw));
    });
    for (auto& corner : b) {
      corner = make_vec<3>([&](int k) { return saturate_to<S>(corner[k] + apart[k] - back[k]); });
    }
    compare(detail::HullBody(ConvexHull<S, 3>{a}), detail::HullBody(ConvexHull<S, 3>{b}), count);
  }
}

template <Scalar S>
void compare_all(int asked) {
  Count ordinary, lattice, tilted, extreme, tiny, many;
  const auto limit = std::int64_t{1} << bits_of<S>;
  compare_many<S>(limit >> 12, 1, Axes::any, asked, ordinary, many);
  compare_many<S>(limit >> 11, limit >> 13, Axes::parallel, asked, lattice, many);
  compare_many<S>(limit >> 11, 1, Axes::nearly_parallel, asked, tilted, many);
  compare_many<S>(limit - limit / 16, 1, Axes::any, asked, extreme, many);
  compare_many<S>(8, 1, Axes::parallel, asked, tiny, many);
  for (const auto* count : {&ordinary, &lattice, &tilted, &extreme, &tiny}) {
    INFO(count->hits << ", " << count->sure);
    CHECK(count->hits.percent() >= 30);
    CHECK(count->hits.percent() <= 80);
    CHECK(count->sure.percent() >= 85);
  }
  CHECK(ordinary.sure.percent() >= 95);
  CHECK(many.sure.percent() == 0);
  Count ties, touches;
  for (const auto reach : {limit >> 3, limit >> 7}) {
    for (const auto share : {19, 16, 13, 10}) {
      compare_near_ties<S>(reach, (std::max)(reach >> share, std::int64_t{1}), asked, ties);
    }
    compare_near_touches<S>(reach, asked, touches);
  }
  INFO(ties.hits << ", " << ties.sure << "; " << touches.hits << ", " << touches.sure);
  CHECK(ties.sure.percent() >= 20);
  CHECK(ties.sure.percent() <= 80);
  CHECK(touches.hits.percent() >= 30);
  CHECK(touches.hits.percent() <= 90);
  CHECK(touches.sure.percent() >= 20);
}

TEST_CASE("witnesses: a least push that they are sure of is that of the expansion", "[query]") {
  compare_all<q16_16>(300);
#if DETENT_TEST_EVERY_SPACE
  compare_all<q14_16>(100);
  compare_all<q24_8>(100);
#endif
  compare_all<q8_8>(100);
}
TEST_CASE("witnesses: long comparison of least pushes", "[query][.demand]") {
  compare_all<q16_16>(3000);
#if DETENT_TEST_EVERY_SPACE
  compare_all<q14_16>(2000);
  compare_all<q24_8>(2000);
#endif
  compare_all<q8_8>(2000);
}

}  // namespace
}  // namespace detent::test
