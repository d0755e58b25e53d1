// SPDX-License-Identifier: MIT
#include "detent/query/kernel/touch_feature.hpp"

#include "detent/math/direction.hpp"
#include "detent/query/cast/point.hpp"
#include "support/catch.hpp"
#include "support/random_vec.hpp"

namespace detent::test {
namespace {

struct Count {
  HitRate hits, sure, sure_beyond;
};

/// Compares the filter with the exact inequalities and the exact search for the closest point.
template <std::size_t CountA, std::size_t CountB, Scalar S>
void compare(const std::array<Vec<S, 3>, CountA>& corners_a,
             const std::array<Vec<S, 3>, CountB>& corners_b, const Direction<S, 3>& direction,
             const S& radius, const S& limit, Count& count) {
  const detail::HullBody a(corners_a);
  const detail::HullBody b(corners_b);
  using A = std::remove_cvref_t<decltype(a)>;
  using B = std::remove_cvref_t<decltype(b)>;
  const auto& way = direction.vec();
  using Component = std::remove_cvref_t<decltype(way.x)>;
  using Sum = std::remove_cvref_t<decltype(radius + radius)>;
  detail::TouchWitness<A, B, Component, S, Sum> witness(a, b, way, radius + S(0));
  const auto touch = witness.first(S(0), limit);
  if (!touch.is_sure) return;
  count.hits.count(touch.value.has_value());
  if (!touch.value) return;
  const auto feature = witness.found();
  const detail::TouchFeature<A, B, Component, S> words(a, b, way, *touch.value, feature);
  count.sure.count(words.is_unique());
  if (!words.is_unique()) return;
  REQUIRE(witness.feature_from(*touch.value).has_value());
  const auto moved = detail::moved_body(a, way * *touch.value);
  REQUIRE(words.point() == detail::closest_point_of_body<S>(moved, b, S(0)));
  const auto beyond = words.point_beyond(radius);
  count.sure_beyond.count(beyond.has_value());
  if (beyond) REQUIRE(*beyond == detail::closest_point_of_body<S>(moved, b, radius));
}

/// Shapes within `reach` steps, on a grid of `grid` steps; `flat` ones in one plane.
template <Scalar S>
void compare_many(std::int64_t reach, std::int64_t grid, bool flat, int asked, Count& count) {
  Random random(static_cast<std::uint64_t>(reach + grid + asked));
  const auto number = [&](std::int64_t low, std::int64_t high) {
    return S::from_raw(
        static_cast<typename S::raw_type>(random.between(low / grid, high / grid) * grid));
  };
  const auto point = [&] {
    return make_vec<3>([&](int i) { return flat && i == 2 ? S(0) : number(-reach, reach); });
  };
  for (int i = 0; i < asked; ++i) {
    CAPTURE(reach, grid, flat, i);
    const auto p = point(), q = point(), r = point();
    const auto u = point(), v = point(), w = point();
    const auto to = nearest_to<S>(u - p);
    const auto direction = random.one_in(4) ? Direction<S, 3>::along(i % 3)
                                            : direction_of<S>(random.coin() ? to : point());
    if (!direction) continue;
    const S radius = number(1, reach / 2), limit = number(0, 8 * reach);
    if (!(radius > 0)) continue;
    compare(std::array{p}, std::array{u}, *direction, radius, limit, count);
    compare(std::array{p}, std::array{u, v}, *direction, radius, limit, count);
    compare(std::array{p}, std::array{u, v, w}, *direction, radius, limit, count);
    compare(std::array{p, q}, std::array{u}, *direction, radius, limit, count);
    compare(std::array{p, q}, std::array{u, v}, *direction, radius, limit, count);
    compare(std::array{p, q}, std::array{u, v, w}, *direction, radius, limit, count);
    compare(std::array{p, q, r}, std::array{u}, *direction, radius, limit, count);
    compare(std::array{p, q, r}, std::array{u, v}, *direction, radius, limit, count);
    compare(std::array{p, q, r}, std::array{u, v, w}, *direction, radius, limit, count);
    // Nearly parallel edges, and equal corners.
    const auto step = random_vec<S, 3>(random, -1, 1);
    const auto beside = nearest_to<S>(u + (q - p) + step);
    compare(std::array{p, q}, std::array{u, beside}, *direction, radius, limit, count);
    compare(std::array{p, q}, std::array{u, beside, v}, *direction, radius, limit, count);
    compare(std::array{p, p}, std::array{u, v, v}, *direction, radius, limit, count);
  }
}

TEST_CASE("features: closest features that are sure of being unique are", "[query]") {
  Count local, lattice, flat, extreme, tiny, narrow;
  compare_many<q16_16>(1 << 22, 1, false, 300, local);
#if DETENT_TEST_EVERY_SPACE
  compare_many<q14_16>(1 << 20, 1, false, 100, local);
  compare_many<q24_8>(1 << 20, 1, false, 100, local);
  compare_many<q24_8>(std::int64_t{1} << 29, 1 << 27, false, 100, extreme);
#endif
  compare_many<q16_16>(1 << 20, 1 << 17, false, 300, lattice);
  compare_many<q16_16>(1 << 20, 1 << 14, true, 300, flat);
  compare_many<q16_16>(std::int64_t{1} << 29, 1, false, 200, extreme);
  compare_many<q16_16>(64, 1, false, 300, tiny);
  compare_many<q8_8>(1 << 11, 1, false, 200, narrow);
  compare_many<q8_8>(1 << 13, 1 << 10, false, 100, narrow);
  compare_many<q16_16>(1 << 12, 1, false, 300, tiny);
  INFO(local.hits << ", " << local.sure << ", " << local.sure_beyond << "; " << lattice.hits << ", "
                  << lattice.sure << "; " << flat.hits << ", " << flat.sure << "; " << extreme.hits
                  << ", " << extreme.sure << "; " << tiny.hits << ", " << tiny.sure);
  CHECK(local.hits.is_balanced());
  CHECK(local.sure.percent() >= 70);
  CHECK(local.sure_beyond.percent() >= 60);
  CHECK(lattice.sure.percent() >= 60);
  CHECK(flat.sure.percent() >= 60);
  CHECK(extreme.sure.percent() >= 60);
  CHECK(narrow.sure.percent() >= 5);
}

}  // namespace
}  // namespace detent::test
