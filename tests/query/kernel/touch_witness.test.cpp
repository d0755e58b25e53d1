// SPDX-License-Identifier: MIT
#include "detent/query/kernel/touch_witness.hpp"

#include "detent/math/direction.hpp"
#include "detent/query/cast/motion.hpp"
#include "detent/query/kernel/approach.hpp"
#include "detent/query/kernel/convex_body.hpp"
#include "detent/query/kernel/length.hpp"
#include "detent/query/kernel/touch_direction.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace detent::test {
namespace {

using detail::Clearance;

struct Count {
  HitRate hits, sure, same_feature, sure_distances, sure_directions, sure_across, sure_overlaps;
};

/// Whether a body's corners are on the grid of S.
template <class Body, class S>
constexpr bool is_scalar_body =
    std::is_same_v<std::remove_cvref_t<decltype(std::declval<Body>().some().x)>, S>;

/// Compares the exact search with one that starts at some feature of corner differences.
template <class A, class B, Number V, int N>
void compare_starts(const A& a, const B& b, const Vec<V, N>& v) {
  const auto from = a.some() - b.some();
  using Corner = std::remove_cvref_t<decltype(from.x)>;
  constexpr int bits = bits_of<Corner>;
  const auto ahead = a.template extreme<bits>(v, b.some(), true) - b.some();
  const auto behind = a.some() - b.template extreme<bits>(v, a.some(), true);
  const auto none = detail::squared_distance_of_none<Corner, N>();
  const auto exact = detail::squared_distance_between(a, b);
  detail::Simplex<Corner, N> start;
  for (const auto& corner : {from, ahead, behind}) {
    if (start.count == N) break;
    start.add(corner);
    const auto found = detail::with_gjk(a, b, [&](auto search) {
      search.start_at(start);
      return search.squared_distance(none);
    });
    REQUIRE(!(found < exact));
    REQUIRE(!(exact < found));
  }
}

/// Compares the filter with the exact search, starting where the bodies are apart.
template <class A, class B, Scalar S, int N>
void compare(const A& a, const B& b, const Direction<S, N>& direction, const S& radius,
             const S& limit, Count& count) {
  const auto& way = direction.vec();
  using Component = std::remove_cvref_t<decltype(way.x)>;
  using Sum = std::remove_cvref_t<decltype(radius + radius)>;
  const Sum sum = radius + S(0);
  const detail::Approach<A, B, Component, S, 0> search(a, b, way, sum, 0);
  detail::TouchWitness<A, B, Component, S, Sum> witness(a, b, way, sum);
  const auto decided = witness.first(S(0), limit);
  using Length = detail::Length<S>;
  const auto distance = detail::still_witness(a, b).template distance_floor<Length>();
  if (distance.is_sure) {
    REQUIRE(distance.value == sqrt_floor<Length>(detail::squared_distance_between(a, b)));
  }
  compare_starts(a, b, way);
  const bool do_overlap = detail::bodies_overlap(a, b);
  const auto overlap = detail::still_witness(a, b).overlap();
  (do_overlap ? count.sure_overlaps : count.sure_distances)
      .count(do_overlap ? overlap == Filtered::yes : distance.is_sure);
  REQUIRE(overlap != (do_overlap ? Filtered::no : Filtered::yes));
  if (search.lead_at(S(0)).clearance != Clearance::apart) {
    CHECK_FALSE(decided.is_sure);
    return;
  }
  const auto exact = search.first(S(0), limit);
  count.hits.count(exact.has_value());
  count.sure.count(decided.is_sure);
  if (!decided.is_sure) return;
  REQUIRE(decided.value == exact);
  if (!exact) return;
  const auto feature = witness.feature_from(*exact);
  count.same_feature.count(feature.has_value());
  if (!feature) return;
  constexpr int most = bits_of<Component> + 2;
  const detail::Approach<A, B, Component, S, most> fine(a, b, way, sum,
                                                        detail::finer_by<most>(sum));
  const auto normal = [](const auto& v) { return direction_of<S>(detail::shortened<240>(v)); };
  const auto from = fine.scaled(*exact), to = fine.scaled(limit);
  const auto found = fine.with_touch(from, to, normal);
  REQUIRE(fine.with_touch_on(*feature, from, to, normal) == found);
  if constexpr (filter_pays<S>) {
    const auto quick = detail::direction_on<S>(*feature, way, *exact, sum, detail::SameFrame());
    count.sure_directions.count(quick.is_sure);
    if (quick.is_sure) REQUIRE(quick.value == found);
  }
  if constexpr (N == 3 && filter_pays<S> && is_scalar_body<A, S> && is_scalar_body<B, S>) {
    if (feature->count == 2) {
      const auto& end = feature->corners[0];
      const auto across =
          detail::direction_across<S>(end - way * *exact, feature->corners[1] - end, way, sum);
      count.sure_across.count(across.is_sure);
      if (across.is_sure) REQUIRE(across.value == found);
    }
  }
  if (!feature->is_facet()) return;
  const auto facet = normal(detail::facet_normal(feature->simplex()));
  REQUIRE((facet == found || -*facet == *found));
}

/// Shapes within `reach` steps, on a grid of `grid` steps.
template <Scalar S, int N>
void compare_many(std::int64_t reach, std::int64_t grid, int asked, Count& count) {
  Random random(static_cast<std::uint64_t>(reach + grid));
  const auto number = [&](std::int64_t low, std::int64_t high) {
    return S::from_raw(
        static_cast<typename S::raw_type>(random.between(low / grid, high / grid) * grid));
  };
  const auto point = [&] { return make_vec<N>([&](int) { return number(-reach, reach); }); };
  for (int i = 0; i < asked; ++i) {
    CAPTURE(reach, grid, i);
    const std::array core{point(), point()};
    const std::array target{point(), point(), point()};
    const auto to = nearest_to<S>(target[0] - core[0]);
    const auto direction = random.one_in(4) ? Direction<S, N>::along(i % N)
                                            : direction_of<S>(random.coin() ? to : point());
    if (!direction) continue;
    const S radius = number(1, reach / 2);
    if (!(radius > 0)) continue;
    const S limit = number(0, 8 * reach);
    const detail::HullBody a(core);
    const detail::HullBody b(target);
    compare(a, b, *direction, radius, limit, count);
    const detail::HullBody start(std::array{core[0]});
    compare(start, b, *direction, radius, limit, count);
    auto low = target[0], high = target[0];
    for (int k = 0; k < N; ++k) high[k] = (std::max)(high[k], target[1][k]);
    compare(start, detail::AabbBody(low, high), *direction, radius, limit, count);
  }
}

TEST_CASE("witnesses: a touch or distance that they are sure of is exact", "[query]") {
  Count local, coarse, narrow, planar;
  compare_many<q16_16, 3>(1 << 18, 1, 1500, local);
  compare_many<q16_16, 3>(1 << 29, 1, 300, local);
  compare_many<q16_16, 2>(1 << 18, 1, 500, planar);
  compare_many<q16_16, 2>(1 << 26, 1, 500, planar);
#if DETENT_TEST_EVERY_SPACE
  compare_many<q24_8, 3>(1 << 22, 1, 200, local);
  compare_many<q14_16, 3>(1 << 24, 1, 200, local);
#endif
  compare_many<q16_16, 3>(1 << 24, 1, 400, local);
  compare_many<q16_16, 3>(1 << 18, 1 << 16, 1500, coarse);
  compare_many<q16_16, 3>(16, 1, 500, coarse);
  compare_many<q8_8, 3>(1 << 11, 1, 500, narrow);
  compare_many<q8_8, 2>(1 << 11, 1, 200, narrow);
  compare_many<q8_8, 3>(1 << 13, 1 << 10, 200, narrow);
  INFO(local.hits << ", " << local.sure << ", " << local.same_feature << ", "
                  << local.sure_directions << ", " << local.sure_across << "; " << coarse.hits
                  << ", " << coarse.sure << ", " << coarse.same_feature << "; " << narrow.hits
                  << ", " << narrow.sure);
  CHECK(local.hits.is_balanced());
  CHECK(local.sure.percent() >= 95);
  CHECK(local.same_feature.percent() >= 90);
  CHECK(local.sure_directions.percent() >= 20);
  CHECK(local.sure_across.percent() >= 90);
  CHECK(planar.sure.percent() >= 95);
  CHECK(planar.same_feature.percent() >= 90);
  CHECK(planar.sure_distances.percent() >= 97);
  CHECK(coarse.sure.percent() >= 50);
  CHECK(narrow.sure.percent() >= 80);
  CHECK(local.sure_distances.percent() >= 97);
  CHECK(local.sure_overlaps.percent() >= 50);
}

}  // namespace
}  // namespace detent::test
