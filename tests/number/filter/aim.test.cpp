// SPDX-License-Identifier: MIT
#include "detent/number/filter/aim.hpp"

#include <algorithm>

#include "detent/number/unit.hpp"
#include "number/big_integer.hpp"
#include "support/catch.hpp"

namespace detent::test {
namespace {

TEST_CASE("floor_product: products are rounded down") {
  using Weight = Fixed<62, 60>;
  using Sum = Fixed<62, 58>;
  Random random(0xf1008);
  int wrong = 0;
  for (int k = 0; k < 20'000; ++k) {
    const auto a = Weight::from_raw(random.edgy(62));
    const auto b = Fixed<31, 30>::from_raw(static_cast<std::int32_t>(random.wide(30)));
    wrong += floor_product<Sum>(a, b) == floor_to<Sum>(a * b) ? 0 : 1;
    const auto c = Fixed<46, 44>::from_raw(random.edgy(46));
    const auto d = Fixed<15, 14>::from_raw(static_cast<std::int16_t>(random.wide(14)));
    wrong += floor_product<Sum>(c, d) == floor_to<Sum>(c * d) ? 0 : 1;
  }
  INFO(random);
  CHECK(wrong == 0);
}

TEST_CASE("in_units: the numbers are multiples of one power of two, and the unit is below 1") {
  using T = Fixed<62, 28>;
  using Unit = Fixed<30, 0>;
  Random random(0x141);
  int wrong = 0, sure = 0;
  constexpr int count = 20'000;
  for (int k = 0; k < count; ++k) {
    const auto unit = Unit::from_raw(static_cast<std::int32_t>(random.edgy(30)));
    const std::int64_t limit = std::int64_t{unit.raw()} << 30;
    const auto number = [&] {
      return T::from_raw(random.one_in(8) ? limit - 2 + random.wide(2) : random.edgy(60));
    };
    const auto x = number(), y = number();
    const auto found = in_units(x, y, unit);
    const bool fits = unit.raw() > 0 && std::abs(x.raw()) <= limit && std::abs(y.raw()) <= limit;
    if (found.is_sure != fits) ++wrong;
    if (!found.is_sure) continue;
    ++sure;
    const auto &right = found.value[0], &up = found.value[1], &one = found.value[2];
    if (one.raw() < std::int64_t{1} << 59 || one.raw() >= std::int64_t{1} << 60) ++wrong;
    const auto is_same = [&](const auto& number_found, const T& x_given) {
      return big_raw(number_found) * unit.raw() * (1 << 28) == big_raw(x_given) * big_raw(one);
    };
    if (!is_same(right, x) || !is_same(up, y)) ++wrong;
  }
  INFO(random);
  CHECK(wrong == 0);
  CHECK(sure > count / 10);
}

/// Compares `decide` with the exact unit vectors opposite to vectors that differ from drawn ones by
/// less than `Reach` 64ths of a step of 2^-58. Returns how many of them it is unsure about.
template <class Component, std::int64_t Reach, class Draw, class Decide>
int count_unsure(std::uint64_t seed, int count, const Draw& draw, const Decide& decide) {
  using Long = Fixed<72, 0>;
  Random random(seed);
  int unsure = 0, wrong = 0;
  for (int k = 0; k < count; ++k) {
    std::array<Fixed<63, 58>, 3> v;
    std::array<Long, 3> exact;
    for (std::size_t i = 0; i < 3; ++i) {
      v[i] = Fixed<63, 58>::from_raw(draw(random, i));
      const std::int64_t away = random.between(1 - Reach, Reach - 1);
      exact[i] = Long::assume_raw(
          integer_cast<typename Long::raw_type>(Int128(-away) - shift_left(Int128(v[i].raw()), 6)));
    }
    const auto found = decide(v);
    if (!found.is_sure) {
      ++unsure;
      continue;
    }
    const auto expected = unit_vector<Component>(exact);
    for (std::size_t i = 0; i < 3; ++i) {
      if (found.value[i].raw() != (*expected)[i].raw()) ++wrong;
    }
  }
  CAPTURE(seed);
  CHECK(wrong == 0);
  return unsure;
}

/// Vectors of at least 2^Bits steps.
template <class Component, int Bits>
int count_unsure_units(std::uint64_t seed) {
  const auto draw = [](Random& random, std::size_t i) {
    const auto least = std::int64_t{1} << Bits;
    return random.between(i == 0 ? least : -2 * least, 2 * least);
  };
  return count_unsure<Component, 128>(seed, 60'000, draw,
                                      [](const auto& v) { return decide_opposite<Component>(v); });
}

template <class Component, std::int64_t Error, bool MayBeHalf>
int count_unsure_short_units(std::uint64_t seed) {
  const auto draw = [](Random& random, std::size_t i) {
    const auto one = std::int64_t{1} << (MayBeHalf && random.coin() ? 57 : 58);
    return i == 0 ? random.between(one, one * 5 / 4) : random.between(-one, one);
  };
  // 2^17 and 2 steps.
  constexpr std::int64_t reach = Error == 1 << 15 ? std::int64_t{64} << 17 : 128;
  return count_unsure<Component, reach>(seed, 60'000, draw, [](const auto& v) {
    return decide_opposite_of_short<Component, Error, MayBeHalf>(v);
  });
}

TEST_CASE("decide_opposite: where it is sure, it is right for every vector within its steps") {
  for (const int unsure : {count_unsure_units<Fixed<31, 30>, 57>(0xa1301),
                           count_unsure_units<Fixed<31, 30>, 60>(0xa1306)}) {
    CHECK(unsure > 15);  // three components, 2^-12 each
    CHECK(unsure < 90);
  }
  CHECK(count_unsure_units<Fixed<15, 14>, 58>(0xa1302) == 0);
}

TEST_CASE(
    "decide_opposite_of_short: where it is sure, it is right for every vector within its steps") {
  const int unsure = count_unsure_short_units<Fixed<31, 30>, (1 << 15), false>(0xa1303);
  CHECK(unsure > 120);  // three components, 2^-9 each
  CHECK(unsure < 720);
  CHECK(count_unsure_short_units<Fixed<15, 14>, (1 << 15), false>(0xa1304) < 6);
  const int few = count_unsure_short_units<Fixed<31, 30>, (1 << 12), true>(0xa1305);
  CHECK(few > 15);  // 2^-12 each
  CHECK(few < 90);
}

TEST_CASE("decide_opposite: it is unsure about short vectors") {
  using T = Fixed<63, 58>;
  using Component = Fixed<31, 30>;
  const auto is_sure = [](std::int64_t x, std::int64_t y, std::int64_t z) {
    return decide_opposite<Component>(std::array{T::from_raw(x), T::from_raw(y), T::from_raw(z)})
        .is_sure;
  };
  CHECK_FALSE(is_sure(0, 0, 0));
  CHECK_FALSE(is_sure(1, 0, 0));
  CHECK_FALSE(is_sure(std::int64_t{1} << 56, 0, 0));
  CHECK(is_sure(std::int64_t{1} << 57, 0, 0));
}

TEST_CASE("decide_opposite_of_short: it is unsure unless the vector is about 1 to 2 long") {
  using T = Fixed<63, 58>;
  using Component = Fixed<31, 30>;
  const auto v = [](std::int64_t x) { return std::array{T(), T::from_raw(x), T()}; };
  const auto is_sure = [&](std::int64_t x) {
    return decide_opposite_of_short<Component, (1 << 15), false>(v(x)).is_sure;
  };
  const auto is_sure_of_halves = [&](std::int64_t x) {
    return decide_opposite_of_short<Component, (1 << 12), true>(v(x)).is_sure;
  };
  constexpr auto one = std::int64_t{1} << 58;
  for (const auto x : {one, -one, one - (one >> 29), 2 * one - 1}) {
    CHECK(is_sure(x));
    CHECK(is_sure_of_halves(x));
    CHECK(is_sure_of_halves(x / 2));
  }
  CHECK_FALSE(is_sure(one / 2));
  for (const auto x : {std::int64_t{0}, std::int64_t{1}, one / 2 - one / 128, 2 * one, 17 * one}) {
    CHECK_FALSE(is_sure(x));
    CHECK_FALSE(is_sure_of_halves(x));
  }
  CHECK_FALSE(is_sure(one - one / 64));
  CHECK(is_sure_of_halves(one - one / 64));
}

}  // namespace
}  // namespace detent::test
