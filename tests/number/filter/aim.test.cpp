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

template <class Component>
void check_units(std::uint64_t seed) {
  using Long = Fixed<66, 0>;
  Random random(seed);
  int unsure = 0, wrong = 0;
  constexpr int count = 60'000;
  for (int k = 0; k < count; ++k) {
    std::array<Fixed<62, 58>, 3> v;
    std::array<Long, 3> exact;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto limit = std::int64_t{1} << 60;
      v[i] = Fixed<62, 58>::from_raw(i == 0 ? random.between(limit / 2, limit)
                                            : random.between(-limit, limit));
      // In eighths of a step: from -15 to 15.
      const auto away = static_cast<std::int64_t>(random.below(31)) - 15;
      exact[i] = Long::assume_raw(
          integer_cast<typename Long::raw_type>(Int128(-away) - shift_left(Int128(v[i].raw()), 3)));
    }
    const auto found = decide_opposite<Component>(v);
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
  if (Component::frac == 30) {  // three components, 2^-12 each
    CHECK(unsure > 15);
    CHECK(unsure < 90);
  } else {
    CHECK(unsure == 0);
  }
}

TEST_CASE("decide_opposite: where it is sure, it is right for every vector within its steps") {
  check_units<Fixed<31, 30>>(0xa1301);
  check_units<Fixed<15, 14>>(0xa1302);
}

TEST_CASE("decide_opposite: it is unsure about short vectors") {
  using T = Fixed<62, 58>;
  using Component = Fixed<31, 30>;
  const auto is_sure = [](std::int64_t x, std::int64_t y, std::int64_t z) {
    return decide_opposite<Component>(std::array{T::from_raw(x), T::from_raw(y), T::from_raw(z)})
        .is_sure;
  };
  CHECK_FALSE(is_sure(0, 0, 0));
  CHECK_FALSE(is_sure(1, 0, 0));
  CHECK_FALSE(is_sure(std::int64_t{1} << 55, 0, 0));
  CHECK(is_sure(std::int64_t{1} << 58, 0, 0));
}

}  // namespace
}  // namespace detent::test
