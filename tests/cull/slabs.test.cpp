// SPDX-License-Identifier: MIT
#include "detent/cull/slabs.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

#include "detent/cull/bins.hpp"
#include "detent/cull/grid.hpp"
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

TEMPLATE_TEST_CASE("plane grid: a byte encloses a coordinate, rounded outward", "[slabs]", q16_16,
                   q24_8, q8_8) {
  using S = TestType;
  Random random(0x9121d);
  for (int i = 0; i < 20'000; ++i) {
    const auto a = raw<S>(random.edgy(S::bits)), b = raw<S>(random.edgy(S::bits));
    const auto least = std::min(a, b), greatest = std::max(a, b);
    const ByteGrid<S> grid(least, greatest);
    REQUIRE(grid.below(least) == 0);
    REQUIRE(grid.plane(grid.above(greatest)) >= greatest);
    const auto x = raw<S>(random.between(least.raw(), greatest.raw()));
    const auto below = grid.below(x), above = grid.above(x);
    REQUIRE(grid.plane(below) <= x);
    REQUIRE(grid.plane(above) >= x);
    REQUIRE(above - below <= 1);
    // As fine as a byte allows: at half the spacing, the planes would not reach.
    const auto size = std::int64_t{greatest.raw()} - least.raw();
    REQUIRE((grid.step() == 1 || 255 * (grid.step() / 2) < size));
  }
}

TEMPLATE_TEST_CASE("slabs: no part of the ray between the planes is lost", "[slabs]", q16_16,
                   q14_16, q24_8, q8_8) {
  using S = TestType;
  using Component = direction_component<S>;
  using Lanes = detail::ArrayLanes<std::int32_t>;
  constexpr std::int64_t one = std::int64_t{1} << Component::frac;
  constexpr std::int64_t low = S::lowest().raw(), high = S::max().raw();
  Random random(0x51ab);
  int tight = 0, turned = 0;
  for (int i = 0; i < 60'000; ++i) {
    // A point of the ray, and planes on either side of it.
    const auto length = [&] { return random.wide(S::bits) & high; };
    const auto origin = raw<S>(random.one_in(3) ? random.edgy(S::bits) : random.wide(S::bits - 1));
    const std::int64_t speed =
        random.one_in(3) ? random.between(-one, one) : random.wide(Component::frac - 1);
    const auto limit = raw<S>(length());
    const auto distance = raw<S>(random.between(0, limit.raw()));
    const Integer at = Integer(origin.raw()) * one + Integer(speed) * distance.raw();
    const auto below = static_cast<std::int64_t>(at >> Component::frac);
    const auto above = static_cast<std::int64_t>(-(-at >> Component::frac));
    if (below < low || above > high) continue;
    const auto x = raw<S>(std::max(low, random.one_in(2) ? below : below - length()));
    const auto y = raw<S>(std::min(high, random.one_in(2) ? above : above + length()));
    const auto least = raw<S>(std::max(low, x.raw() - length()));
    const auto greatest = raw<S>(std::min(high, y.raw() + length()));

    using Reach = typename Ticks<S>::Reach;
    const auto reach = std::max(Reach(abs(least - origin)), Reach(abs(greatest - origin)));
    const Ticks<S> ticks(reach, limit);
    if (distance > ticks.longest()) continue;
    const RaySlab<S> slab(origin, raw<Component>(speed), ticks);
    const ByteGrid<S> grid(least, greatest);
    const auto planes = slab.on_grid(grid);
    const auto times = [&](std::uint8_t plane) {
      std::array<std::uint8_t, 8> bytes{};
      std::array<std::int32_t, 8> enter{}, leave{};
      bytes[3] = plane;
      planes.template enter<Lanes>(bytes).store(enter);
      planes.template leave<Lanes>(bytes).store(leave);
      return std::pair(enter[3], leave[3]);
    };
    const bool back = speed < 0;
    const auto near = back ? grid.above(y) : grid.below(x);
    const auto far = back ? grid.below(x) : grid.above(y);
    const auto enter = times(near).first;
    REQUIRE(enter <= ticks.time(distance));
    REQUIRE(times(far).second >= ticks.time(distance));
    REQUIRE(slab.enter(back ? y : x) <= ticks.time(distance));
    REQUIRE(slab.leave(back ? x : y) >= ticks.time(distance));

    const Integer plane = grid.origin() + near * grid.step();
    const Integer fast = back ? -speed : speed;
    const Integer ahead = back ? origin.raw() - plane : plane - origin.raw();
    const auto in_ticks = [&](Integer raws) {  // along the ray
      return fast == 0 ? Integer(1) << 62 : (raws * 65536 * one / fast) >> (16 + ticks.exponent());
    };
    if (in_ticks(Integer(grid.step())) > (1 << 21) + 1) {
      // Nearly parallel: a plane more than four steps ahead of the origin is not reached.
      if (ahead > 4 * Integer(grid.step())) REQUIRE(enter > ticks.time(ticks.longest()));
      ++turned;
    } else if (fast >= one / 64) {
      // The excess is small: a raw unit on the axis, and the rounding of the steps.
      REQUIRE(in_ticks(ahead) - enter <= in_ticks(1) + 260);
      ++tight;
    }
  }
  CHECK(tight > 1'000);
  CHECK(turned > 1'000);
}

TEMPLATE_TEST_CASE("slabs: on a scene's grid, rays arrive in time and lose little", "[slabs]",
                   q16_16, q24_8, q8_8) {
  using S = TestType;
  using Grid = detail::Grid<S>;
  using Component = direction_component<S>;
  constexpr std::int64_t one = std::int64_t{1} << Component::frac;
  constexpr std::int64_t low = S::lowest().raw(), high = S::max().raw();
  constexpr std::int64_t size = std::int64_t{1} << Grid::shift;
  Random random(0x51ac);
  int exact = 0, parallel = 0, tight = 0;
  for (int i = 0; i < 60'000; ++i) {
    const auto origin = raw<S>(random.one_in(3) ? random.edgy(S::bits) : random.wide(S::bits - 1));
    const std::int64_t speed = random.one_in(8)   ? 0
                               : random.one_in(3) ? random.between(-one, one)
                                                  : random.wide(Component::frac - 1);
    const std::int64_t distance = random.wide(S::bits) & high;
    const Integer at = Integer(origin.raw()) * one + Integer(speed) * distance;
    const auto below = static_cast<std::int64_t>(at >> Component::frac);
    const auto above = static_cast<std::int64_t>(-(-at >> Component::frac));
    if (below <= low || above >= high) continue;
    // The narrowest slab of the grid around a point of the ray.
    const std::int64_t least = Grid::below(raw<S>(below)), greatest = Grid::above(raw<S>(above));
    const RaySlab<S> slab(Grid::step(origin), raw<Component>(speed), Ticks<S>());
    const bool back = speed < 0;
    REQUIRE(slab.is_backward() == back);
    const auto enter = slab.enter(back ? greatest : least);
    const auto leave = slab.leave(back ? least : greatest);
    REQUIRE(std::max<Integer>(enter, 0) * size <= distance);
    REQUIRE(Integer(leave) * size >= distance);
    exact += above == below && above % size == 0;
    parallel += speed == 0;
    // A slab five steps away is behind the ray, or not yet reached.
    const std::int64_t fast = back ? -speed : speed;
    if (fast < one / 64) continue;
    REQUIRE(Integer(slab.leave(back ? greatest + 5 : least - 5)) * size <= distance + size);
    REQUIRE(Integer(slab.enter(back ? least - 5 : greatest + 5)) * size > distance);
    ++tight;
  }
  CHECK(exact > 1'000);
  CHECK(parallel > 1'000);
  CHECK(tight > 1'000);
}

TEMPLATE_TEST_CASE("slabs: no part of a box's path between the planes is lost", "[slabs]", q16_16,
                   q14_16, q24_8, q8_8) {
  using S = TestType;
  using Component = direction_component<S>;
  constexpr std::int64_t one = std::int64_t{1} << Component::frac;
  constexpr std::int64_t high = S::max().raw();
  Random random(0x51ad);
  int tight = 0, touching = 0;
  for (int i = 0; i < 60'000; ++i) {
    // A box that has moved by `distance`, and a slab that it touches there. Boxes extend beyond the
    // scalar's range, planes do not.
    const std::int64_t size = random.wide(S::bits) & high;
    const std::int64_t left = random.wide(S::bits) - size, right = left + 2 * size;
    const std::int64_t speed =
        random.one_in(3) ? random.between(-one, one) : random.wide(Component::frac - 1);
    const auto limit = raw<S>(random.wide(S::bits) & high);
    const auto distance = raw<S>(random.between(0, limit.raw()));
    const Integer moved = Integer(speed) * distance.raw();
    const auto floor = static_cast<std::int64_t>(moved >> Component::frac);
    const auto ceiling = static_cast<std::int64_t>(-(-moved >> Component::frac));
    const bool back = speed < 0;
    const std::int64_t inner = random.one_in(2) ? 0 : random.wide(S::bits) & high;
    const std::int64_t width = random.one_in(2) ? 0 : random.wide(S::bits) & high;
    // It touches a plane with its front, or another with its back, or is deep in the slab.
    const bool by_front = random.coin();
    const std::int64_t least = by_front != back ? right + floor - inner : left + ceiling - width;
    const std::int64_t greatest = by_front != back ? right + floor + width : left + ceiling + inner;
    if (least < -high || greatest > high) continue;
    if (greatest < left + floor || least > right + ceiling) continue;
    ++touching;

    using Reach = typename Ticks<S>::Reach;
    const auto farthest =
        std::max({least - left, right - least, greatest - left, right - greatest});
    const Ticks<S> ticks(Reach::from_raw(farthest), limit);
    if (distance > ticks.longest()) continue;
    const RaySlab<S> slab(left, right, raw<Component>(speed), ticks);
    REQUIRE(slab.is_backward() == back);
    const auto enter = slab.enter(back ? greatest : least);
    const auto leave = slab.leave(back ? least : greatest);
    REQUIRE(enter <= ticks.time(distance));
    REQUIRE(leave >= ticks.time(distance));
    const std::int64_t fast = back ? -speed : speed;
    if (fast < one / 64) continue;
    // Two steps earlier, or margin and two steps later, it does not touch it.
    const auto in_ticks = [&](Integer raws) {
      return (raws * 65536 * one / fast) >> (16 + ticks.exponent());
    };
    const std::int64_t ahead = back ? left - greatest : least - right;
    const std::int64_t behind = back ? right - least : greatest - left;
    REQUIRE(in_ticks(ahead) - enter <= in_ticks(2) + 4);
    REQUIRE(leave - in_ticks(behind) <= in_ticks(ticks.margin() + 1) + 4);
    ++tight;
  }
  CHECK(touching > 10'000);
  CHECK(tight > 1'000);
}

TEMPLATE_TEST_CASE("slabs: eight planes at once lose no part of a path, and keep little more",
                   "[slabs]", q16_16, q24_8, q8_8) {
  using S = TestType;
  using Component = direction_component<S>;
  using Array = detail::ArrayLanes<std::int32_t>;
  using Compared = detail::ComparedLanes<std::int32_t>;
  using Planes = typename LaneSlab<S, Array>::Planes;
  constexpr std::int64_t one = std::int64_t{1} << Component::frac;
  constexpr int bits = S::bits - detail::Grid<S>::shift;
  constexpr std::int64_t beyond = detail::Grid<S>::beyond;
  Random random(0x51ae);
  int tight = 0, parallel = 0, everywhere = 0, culled = 0;
  for (int i = 0; i < 60'000; ++i) {
    std::int64_t low = random.wide(bits), high = low;
    if (random.one_in(3)) high = low + (random.wide(bits) & (beyond / 2 - 1));
    if (random.one_in(20)) high = beyond;
    if (random.one_in(20)) low = -beyond;
    const std::int64_t speed = random.one_in(8)   ? random.between(-2, 2)
                               : random.one_in(3) ? random.between(-one, one)
                                                  : random.wide(Component::frac - 1);
    const std::int64_t reach = std::clamp<std::int64_t>(
        random.wide(bits) & ((std::int64_t{1} << bits) - 1), 64, std::int64_t{1} << bits);
    const int exponent =
        std::max(static_cast<int>(std::bit_width(static_cast<std::uint64_t>(reach))) - 26, 0);
    const LaneSlab<S, Array> slab(low, high, raw<Component>(speed), reach, exponent);
    const LaneSlab<S, Compared> same(low, high, raw<Component>(speed), reach, exponent);
    const bool is_everywhere = low <= -beyond / 2 || high >= beyond / 2;
    const bool back = speed < 0 && !is_everywhere;
    REQUIRE(slab.is_backward() == back);
    REQUIRE(same.is_backward() == back);

    // Eight slabs that it touches, each at another distance, from up to a step from its start.
    std::array<std::int64_t, 8> distances{};
    Planes lower{}, upper{}, enter{}, leave{}, enter_same{}, leave_same{};
    for (std::size_t k = 0; k < 8; ++k) {
      distances[k] = random.one_in(4) ? reach : random.between(0, reach);
      const Integer moved = Integer(speed) * distances[k];
      const auto floor = static_cast<std::int64_t>(moved >> Component::frac);
      const auto ceiling = static_cast<std::int64_t>(-(-moved >> Component::frac));
      const auto inner = [&] { return random.one_in(2) ? 0 : random.wide(bits) & (beyond - 1); };
      const std::int64_t least = high + floor + 1 - inner(), most = low + ceiling - 1 + inner();
      lower[k] = static_cast<std::int32_t>(std::clamp(std::min(least, most), -beyond, beyond));
      upper[k] = static_cast<std::int32_t>(std::clamp(std::max(least, most), -beyond, beyond));
    }
    slab.enter(back ? upper : lower).store(enter);
    slab.leave(back ? lower : upper).store(leave);
    same.enter(back ? upper : lower).store(enter_same);
    same.leave(back ? lower : upper).store(leave_same);
    REQUIRE(enter_same == enter);
    REQUIRE(leave_same == leave);
    for (std::size_t k = 0; k < 8; ++k) {
      const auto unit = std::int64_t{1} << exponent;
      REQUIRE(std::int64_t{enter[k]} * unit <= distances[k]);
      REQUIRE(std::int64_t{leave[k]} * unit >= distances[k]);
    }
    everywhere += is_everywhere;
    parallel += speed == 0;
    if (is_everywhere) continue;

    // Slabs eleven steps behind it are left before it starts; those twelve steps beyond its path
    // are entered after its end.
    const auto way = static_cast<std::int64_t>((Integer(back ? -speed : speed) * reach) / one) + 1;
    const auto at = [&](std::int64_t x) {
      Planes planes{};
      planes.fill(static_cast<std::int32_t>(std::clamp(x, -beyond, beyond)));
      return planes;
    };
    slab.leave(at(back ? high + 30 : low - 30)).store(leave);
    slab.enter(at(back ? low - way - 30 : high + way + 30)).store(enter);
    REQUIRE((leave[0] < 0 || exponent > 0));
    REQUIRE((enter[0] > (reach >> exponent) || exponent > 0));
    culled += leave[0] < 0 && enter[0] > (reach >> exponent);
    // Times lose at most a few steps and ticks.
    const std::int64_t fast = back ? -speed : speed;
    if (fast < one / 64 || reach < 1024) continue;
    const auto ahead = random.between(0, way - 1);
    const Integer exact = (Integer(ahead) * one / fast) >> exponent;
    const Integer step = (Integer(one) / fast >> exponent) + 1;
    slab.enter(at(back ? low - ahead : high + ahead)).store(enter);
    slab.leave(at(back ? high - ahead : low + ahead)).store(leave);
    REQUIRE(exact - enter[0] <= 2 * step + 12);
    REQUIRE(leave[0] - exact <= 10 * step + 12);
    ++tight;
  }
  CHECK(tight > 1'000);
  CHECK(parallel > 1'000);
  CHECK(everywhere > 1'000);
  CHECK(culled > 10'000);
}

TEMPLATE_TEST_CASE("bins: sorted, and at least nine of sixteen", "[slabs]", q16_16, q8_8, float) {
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
      const auto middle = mean(least[k], std::max(a[k], b[k]));
      REQUIRE(middle <= std::max(a[k], b[k]));
      if constexpr (is_fixed<S>) REQUIRE(next_up(next_up(middle)) >= least[k]);
    }
  }
  const Bins<q16_16> wide(q16_16(0), q16_16(1));
  CHECK(wide(q16_16(1)) == 8);
  CHECK(QuantizedSize<q16_16>(q16_16::from_raw(16'384))(q16_16::from_raw(16'383)) == 8'191);
}

}  // namespace
}  // namespace detent::test
