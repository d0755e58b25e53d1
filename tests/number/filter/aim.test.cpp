// SPDX-License-Identifier: MIT
#include "detent/number/filter/aim.hpp"

#include <algorithm>

#include "detent/number/unit.hpp"
#include "number/big_integer.hpp"
#include "support/catch.hpp"

namespace detent::test {
namespace {

template <int Bits>
void check_leading_bits(std::uint64_t seed) {
  using T = Fixed<Bits, 4>;
  using Raw = typename T::raw_type;
  Random random(seed);
  int wrong = 0;
  for (int k = 0; k < 2000; ++k) {
    const int length = static_cast<int>(random.below(Bits + 1));
    std::array<T, 3> v;
    BigInteger longest = 0;
    for (auto& c : v) {
      const Int128 raw = shift_left(Int128(random.edgy(62)), Bits - 62);
      c = T::from_raw(integer_cast<Raw>(shift_right_floor(raw, Bits - length)));
      longest = (std::max)(longest, BigInteger(abs(big_raw(c))));
    }
    if (longest == 0) continue;
    const auto found = leading_bits(v);
    const auto is_floor = [&](int up) {
      for (std::size_t i = 0; i < 3; ++i) {
        const BigInteger exact = big_raw(v[i]) << (std::max)(up, 0);
        const BigInteger down = BigInteger(1) << (std::max)(-up, 0);
        const BigInteger rest = exact - big_raw(found[i]) * down;
        if (rest < 0 || rest >= down) return false;
      }
      return true;
    };
    // 63 bits of the longest, if it is a negative power of two one more or one less.
    const int up = 62 - static_cast<int>(msb(longest));
    if (!is_floor(up) && !is_floor(up - 1) && !is_floor(up + 1)) ++wrong;
    BigInteger longest_found = 0;
    for (const auto& c : found)
      longest_found = (std::max)(longest_found, BigInteger(abs(big_raw(c))));
    if (longest_found < BigInteger(1) << 61) ++wrong;
  }
  CAPTURE(seed);
  CHECK(wrong == 0);
}

TEST_CASE("leading_bits: components are rounded down on one grid") {
  check_leading_bits<62>(0x1ead1);
  check_leading_bits<90>(0x1ead2);
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
      // In eighths of a step: from -7 to 15.
      const auto away = static_cast<std::int64_t>(random.below(23)) - 7;
      exact[i] = Long::assume_raw(
          integer_cast<typename Long::raw_type>(shift_left(Int128(v[i].raw()), 3) + Int128(away)));
    }
    const auto found = decide_unit<Component>(v);
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
  if (Component::frac == 30) {  // three components, 2^-13 each
    CHECK(unsure > 4);
    CHECK(unsure < 60);
  } else {
    CHECK(unsure == 0);
  }
}

TEST_CASE("decide_unit: where it is sure, it is right for every vector within its steps") {
  check_units<Fixed<31, 30>>(0xa1301);
  check_units<Fixed<15, 14>>(0xa1302);
}

TEST_CASE("decide_unit: it is unsure about short vectors") {
  using T = Fixed<62, 58>;
  using Component = Fixed<31, 30>;
  const auto is_sure = [](std::int64_t x, std::int64_t y, std::int64_t z) {
    return decide_unit<Component>(std::array{T::from_raw(x), T::from_raw(y), T::from_raw(z)})
        .is_sure;
  };
  CHECK_FALSE(is_sure(0, 0, 0));
  CHECK_FALSE(is_sure(1, 0, 0));
  CHECK_FALSE(is_sure(std::int64_t{1} << 56, 0, 0));
  CHECK(is_sure(std::int64_t{1} << 58, 0, 0));
}

}  // namespace
}  // namespace detent::test
