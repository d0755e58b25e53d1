// SPDX-License-Identifier: MIT
#include "detent/query/kernel/stab_witness.hpp"

#include <algorithm>

#include "detent/math/direction.hpp"
#include "detent/math/rotation.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace detent::test {
namespace {

struct Count {
  HitRate hits, sure;
};

/// Compares the filter with the exact linear program.
template <class A, class B, Scalar S, int N>
void compare(const A& a, const B& b, const Direction<S, N>& direction, const S& limit,
             Count& count) {
  const auto& way = direction.vec();
  using Component = std::remove_cvref_t<decltype(way.x)>;
  const auto points = detail::differences(a, b);
  using Point = std::remove_cvref_t<decltype(points[0])>;
  using T = std::remove_cvref_t<decltype(Point().x)>;
  detail::Stab<T, N, std::remove_cvref_t<decltype(points)>, Direction<S, N>> stab(
      Point(), direction, points);
  const auto exact = detail::entry(stab, limit);
  const auto decided = detail::StabWitness<A, B, Component, S>(a, b, way).entry(limit);
  count.hits.count(exact.has_value());
  if (exact && exact->starts_inside) {
    REQUIRE_FALSE(decided.is_sure);
    return;
  }
  count.sure.count(decided.is_sure);
  if (!decided.is_sure) return;
  REQUIRE(decided.value.has_value() == exact.has_value());
  if (!exact) return;
  REQUIRE(decided.value->distance == exact->distance);
  REQUIRE(stab.is_face());
  REQUIRE(direction_of<S>(decided.value->normal) == direction_of<S>(stab.normal()));
}

/// How the axes of boxes lie: faces and edges are often parallel, or nearly so.
enum class Axes { any, parallel, nearly_parallel };

/// Bodies within `reach` steps, on a grid of `grid` steps.
template <Scalar S, int N = 3>
void compare_many(std::int64_t reach, std::int64_t grid, Axes axes, int asked, Count& count) {
  Random random(static_cast<std::uint64_t>(reach + grid + asked));
  const auto number = [&](std::int64_t low, std::int64_t high) {
    return S::from_raw(
        static_cast<typename S::raw_type>(random.between(low / grid, high / grid) * grid));
  };
  const auto point = [&] { return make_vec<N>([&](int) { return number(-reach, reach); }); };
  const auto box = [&] {
    const auto half = make_vec<N>([&](int) { return number(0, reach / 2); });
    const auto toward = [&] {
      if (axes == Axes::any) return point();
      return make_vec<N>([&](int) {
        const auto component = random.between(-1, 1) * (1 << 18);
        const auto off = axes == Axes::parallel ? 0 : random.between(-2, 2);
        return S::from_raw(static_cast<typename S::raw_type>(component + off));
      });
    };
    Rotation<S, N> rotation;
    if (const auto first = direction_of<S>(toward())) {
      if constexpr (N == 2) {
        const Vec<S, 2> second{toward().x, S(0)};
        const Vec across{narrow_negative(first->vec().y), first->vec().x};
        rotation = Rotation<S, 2>::from_axes({*first, random.one_in(4)
                                                          ? direction_of<S>(second).value_or(*first)
                                                          : *direction_of<S>(across)});
      } else if (const auto third = direction_of<S>(cross(first->vec(), toward()))) {
        const auto second = direction_of<S>(cross(third->vec(), first->vec()));
        rotation = Rotation<S, 3>::from_axes({*first, *second, *third});
      }
    }
    return Obb<S, N>{point(), half, rotation};
  };
  for (int i = 0; i < asked; ++i) {
    CAPTURE(reach, grid, axes, i);
    const auto first = box(), second = box();
    const auto to = nearest_to<S>(second.center - first.center);
    const auto direction = axes == Axes::parallel && random.one_in(4)
                               ? Direction<S, N>::along(i % N)
                               : direction_of<S>(random.one_in(4) ? point() : to);
    if (!direction) continue;
    const S limit = number(0, 8 * reach);
    const auto a = detail::edge_body(first), b = detail::edge_body(second);
    compare(a, b, *direction, limit, count);
    const detail::HullBody triangle(std::array{point(), point(), point()});
    compare(triangle, b, *direction, limit, count);
    compare(a, triangle, *direction, limit, count);
    const auto p = point(), q = point();
    Vec<S, N> low = p, high = p;
    for (int k = 0; k < N; ++k) {
      low[k] = (std::min)(p[k], q[k]);
      high[k] = (std::max)(p[k], q[k]);
    }
    compare(detail::AabbBody(low, high), b, *direction, limit, count);
    compare(detail::HullBody(std::array{p, q}), triangle, *direction, limit, count);
    std::array<Vec<S, N>, 33> points;
    for (auto& corner : points) corner = nearest_to<S>(point() + first.center);
    const auto hull = [&](std::size_t corners) {
      return detail::HullBody(ConvexHull<S, N>{std::span(points).first(corners)});
    };
    compare(hull(1 + static_cast<std::size_t>(i) % 32), b, *direction, limit, count);
    compare(hull(8), triangle, *direction, limit, count);
    compare(detail::HullBody(std::array{q}), hull(12), *direction, limit, count);
    Count many;
    compare(hull(33), b, *direction, limit, many);
    CHECK(many.sure.percent() == 0);
  }
}

struct Counts {
  Count local, lattice, tilted, extreme, tiny;
};

/// Asks `many`, `some` or `few` questions of each kind.
template <int N>
void compare_all(int many, int some, [[maybe_unused]] int few, Counts& counts) {
  compare_many<q16_16, N>(1 << 20, 1, Axes::any, many, counts.local);
#if DETENT_TEST_EVERY_SPACE
  compare_many<q14_16, N>(1 << 20, 1, Axes::any, few, counts.local);
  compare_many<q24_8, N>(1 << 20, 1, Axes::any, few, counts.local);
  compare_many<q24_8, N>(1 << 12, 1 << 9, Axes::parallel, few, counts.lattice);
  compare_many<q24_8, N>(std::int64_t{1} << 30, 1 << 28, Axes::parallel, few, counts.extreme);
#endif
  compare_many<q16_16, N>(1 << 20, 1 << 17, Axes::parallel, many, counts.lattice);
  compare_many<q16_16, N>(1 << 20, 1, Axes::nearly_parallel, many, counts.tilted);
  compare_many<q16_16, N>(std::int64_t{1} << 30, 1, Axes::any, some, counts.extreme);
  compare_many<q16_16, N>(32, 1, Axes::any, some, counts.tiny);
  INFO(counts.local.hits << ", " << counts.local.sure << "; " << counts.lattice.hits << ", "
                         << counts.lattice.sure << "; " << counts.tilted.hits << ", "
                         << counts.tilted.sure << "; " << counts.extreme.hits << ", "
                         << counts.extreme.sure << "; " << counts.tiny.hits << ", "
                         << counts.tiny.sure);
  CHECK(counts.local.hits.is_balanced());
  CHECK(counts.local.sure.percent() >= 70);
  CHECK(counts.lattice.sure.percent() >= 70);
  CHECK(counts.tiny.sure.percent() >= 70);
}

TEST_CASE("witnesses: an entry into a face that they are sure of is exact", "[query]") {
  Counts counts;
  compare_all<3>(300, 200, 100, counts);
  CHECK(counts.tilted.sure.percent() >= 50);
  CHECK(counts.extreme.sure.percent() >= 70);
}

TEST_CASE("witnesses: an entry into an edge that they are sure of is exact", "[query]") {
  Counts counts;
  compare_all<2>(1000, 500, 300, counts);
  CHECK(counts.tilted.sure.percent() >= 70);
  CHECK(counts.extreme.sure.percent() >= 50);
}

}  // namespace
}  // namespace detent::test
