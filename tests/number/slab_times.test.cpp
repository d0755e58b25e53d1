// SPDX-License-Identifier: MIT
#include "detent/number/slab_times.hpp"

#include <array>

#include "detent/number/bins.hpp"
#include "detent/number/next_up.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace detent::test {
namespace {

using Integer = __int128;

template <class S>
S raw(std::int64_t x) {
  return S::from_raw(static_cast<typename S::raw_type>(x));
}

TEMPLATE_TEST_CASE("plane grid: a byte encloses a coordinate, outward", "[slab_times]", q16_16,
                   q24_8, q8_8) {
  using S = TestType;
  Random random(0x9121d);
  for (int i = 0; i < 20'000; ++i) {
    const auto a = raw<S>(random.edgy(S::bits)), b = raw<S>(random.edgy(S::bits));
    const auto least = std::min(a, b), greatest = std::max(a, b);
    const PlaneGrid<S> grid(least, greatest);
    REQUIRE(grid.below(least) == 0);
    REQUIRE(grid.plane(grid.above(greatest)) >= greatest);
    const auto x = raw<S>(random.between(least.raw(), greatest.raw()));
    const auto below = grid.below(x), above = grid.above(x);
    REQUIRE(grid.plane(below) <= x);
    REQUIRE(grid.plane(above) >= x);
    REQUIRE(above - below <= 1);
    // As fine as a byte allows: half as far apart, the planes would not reach.
    const auto size = std::int64_t{greatest.raw()} - least.raw();
    REQUIRE((grid.step() == 1 || 255 * (grid.step() / 2) < size));
  }
}

TEMPLATE_TEST_CASE("slab times: no part of the ray between the planes is left out", "[slab_times]",
                   q16_16, q14_16, q24_8, q8_8) {
  using S = TestType;
  using Component = direction_component<S>;
  constexpr std::int64_t one = std::int64_t{1} << Component::frac;
  Random random(0x51ab);
  int tight = 0;
  for (int i = 0; i < 20'000; ++i) {
    const bool whole = random.one_in(3);
    const auto coordinate = [&] {
      return random.one_in(3) ? random.edgy(S::bits) : random.between(-1'000, 1'000);
    };
    const auto a = coordinate(), b = coordinate();
    const auto least = raw<S>(std::min(a, b)), greatest = raw<S>(std::max(a, b));
    const auto origin = raw<S>(coordinate());
    const std::int64_t speed = whole ? random.between(-one, one) : random.wide(Component::frac - 1);
    const auto direction = raw<Component>(speed);
    const auto longest = raw<S>(random.between(0, S::max().raw()));
    const SlabTimes<S> slab(origin, direction, least, greatest, longest);
    const PlaneGrid<S> grid(least, greatest);
    const auto x = raw<S>(random.between(least.raw(), greatest.raw()));
    const auto y = raw<S>(random.between(x.raw(), greatest.raw()));
    const auto low = grid.below(x), high = grid.above(y);
    const auto near = speed < 0 ? high : low, far = speed < 0 ? low : high;
    const typename SlabTimes<S>::OnGrid planes(slab, grid);
    const auto enter = planes.enter(near), leave = planes.leave(far);
    if (grid.origin() + near * grid.step() <= S::max().raw()) {
      REQUIRE(slab.enter(grid.plane(near)) == enter);
    }
    // Any distance t, in the units of `enter`, whose point is between x and y is within.
    for (int k = 0; k < 4; ++k) {
      const std::int64_t t = random.between(0, SlabTimes<S>::time(longest));
      const Integer at = Integer(origin.raw()) * 65536 * one + Integer(speed) * t;
      if (at < Integer(x.raw()) * 65536 * one || at > Integer(y.raw()) * 65536 * one) continue;
      REQUIRE(enter <= t);
      REQUIRE(leave >= t);
    }
    // And where the ray does move, not much more is: two parts in 2^14 of the distances.
    const Integer fast = speed < 0 ? -speed : speed;
    if (fast < one / 64) continue;
    const Integer reach = std::max(std::abs(std::int64_t{least.raw()} - origin.raw()),
                                   std::abs(std::int64_t{greatest.raw()} - origin.raw()));
    const Integer first = Integer(grid.origin() + near * grid.step()) - origin.raw();
    const Integer time = first * 65536 * one / speed;
    REQUIRE(time - enter <= reach * 65536 * 64 / 8192 + 2);
    ++tight;
  }
  CHECK(tight > 1'000);
}

TEMPLATE_TEST_CASE("bins: in order, and at least nine of sixteen", "[slab_times]", q16_16, q8_8,
                   float) {
  using S = TestType;
  Random random(0xb125);
  const auto number = [&] {
    if constexpr (is_fixed<S>) {
      return raw<S>(random.edgy(S::bits));
    } else {
      return static_cast<S>(random.between(-1'000'000, 1'000'000));
    }
  };
  for (int i = 0; i < 5'000; ++i) {
    const S a = number(), b = number(), x = number(), y = number();
    const S least = std::min({a, b, x, y}), greatest = std::max({a, b, x, y});
    const Bins<S> bins(least, greatest);
    REQUIRE(bins(least) == 0);
    REQUIRE(bins(greatest) < bin_count);
    REQUIRE(bins(std::min(x, y)) <= bins(std::max(x, y)));
    if (least < greatest) REQUIRE(bins(greatest) > 0);
  }
  for (int i = 0; i < 1'000; ++i) {
    std::array<S, 8> a{}, b{};
    for (auto& x : a) x = number();
    for (auto& x : b) x = number();
    auto least = a;
    lower(least, b);
    for (std::size_t k = 0; k < 8; ++k) {
      REQUIRE(least[k] == std::min(a[k], b[k]));
      REQUIRE(reversed(reversed(a[k])) == a[k]);
      REQUIRE((reversed(a[k]) < reversed(b[k])) == (b[k] < a[k]));
      const auto middle = rough_middle(least[k], std::max(a[k], b[k]));
      REQUIRE(middle <= std::max(a[k], b[k]));
      if constexpr (is_fixed<S>) REQUIRE(next_up(next_up(middle)) >= least[k]);
    }
  }
  const Bins<q16_16> wide(q16_16(0), q16_16(1));
  CHECK(wide(q16_16(1)) == 8);
  CHECK(Coarse<q16_16>(q16_16::from_raw(16'384))(q16_16::from_raw(16'383)) == 8'191);
}

}  // namespace
}  // namespace detent::test
