// SPDX-License-Identifier: MIT
#include "detent/number/divide.hpp"

#include <array>
#include <cstdint>
#include <type_traits>

#include "number/big_integer.hpp"
#include "support/catch.hpp"

using namespace detent;
using namespace detent::test;

namespace {

template <class I>
constexpr bool divides(int numerator, int denominator, int quotient, int remainder) {
  const auto [q, r] = divide_floor(I(numerator), I(denominator));
  return q == I(quotient) && r == I(remainder);
}

template <class I>
constexpr bool small_quotients_are_right() {
  return divides<I>(7, 2, 3, 1) && divides<I>(-7, 2, -4, 1) && divides<I>(-8, 2, -4, 0) &&
         divides<I>(0, 5, 0, 0) && divides<I>(-1, 1000, -1, 999) && divides<I>(1, 1000, 0, 1);
}
static_assert(small_quotients_are_right<std::int32_t>());
static_assert(small_quotients_are_right<std::int64_t>());
static_assert(small_quotients_are_right<Int128>());
static_assert(small_quotients_are_right<Wide<2>>());
static_assert(small_quotients_are_right<Wide<4>>());
static_assert(small_quotients_are_right<Wide<5>>());

// Base 2^32 digits for which long division first guesses one or two too high.
template <class I>
I random_digits(Random& random) {
  if constexpr (sizeof(I) <= 8) {
    return random_integer<I>(random);
  } else {
    constexpr std::array<std::uint32_t, 8> hard = {0,          1,          2,          0x7fffffff,
                                                   0x80000000, 0x80000001, 0xfffffffe, 0xffffffff};
    constexpr int words = static_cast<int>(sizeof(I) / 8);
    std::array<std::uint64_t, words> pattern{};
    for (auto& word : pattern) {
      word = (std::uint64_t{hard[random.below(8)]} << 32) | hard[random.below(8)];
    }
    const auto wide = Wide<words>::from_words(pattern);
    return integer_cast<I>(wide >> static_cast<int>(random.below(64 * words)));
  }
}

}  // namespace

TEMPLATE_TEST_CASE("divide: quotients are the exact ones rounded down", "[number]", std::int32_t,
                   std::int64_t, Int128, Wide<2>, Wide<3>, Wide<4>, Wide<5>) {
  using I = TestType;
  // If numerator and denominator differ much in length, only a few digits are computed.
  Random random(0xd17);
  INFO(random);
  int large = 0;
  for (int i = 0; i < 300'000; ++i) {
    I n = random.coin() ? random_integer<I>(random) : random_digits<I>(random);
    I d = random.coin() ? random_integer<I>(random) : random_digits<I>(random);
    if (sign_of(d) < 0) d = wrapping_subtract<I>(I(0), d);
    if (sign_of(d) <= 0) continue;  // zero, or the value without a negative
    if (random.one_in(3)) {         // a multiple or next to one: remainders of 0, 1 and d - 1
      n = integer_from<I>(wrapped(floor_of(big(n), big(d)) * big(d) + random.between(-1, 1),
                                  8 * static_cast<int>(sizeof(I))));
    }
    const auto [quotient, remainder] = divide_floor(n, d);
    const BigInteger expected = floor_of(big(n), big(d));
    if (big(quotient) != expected || big(remainder) != big(n) - expected * big(d)) {
      FAIL("n = " << big(n) << ", d = " << big(d));
    }
    large += bit_length(d) > value_bits<I> - 16 ? 1 : 0;
  }
  CHECK(large > 10'000);
}

TEST_CASE("short_quotient: agrees with the long division for quotients below 2^32") {
  Random random(20260602);
  INFO(random);
  for (int i = 0; i < 20000; ++i) {
    const auto bits = static_cast<int>(random.below(63));
    const std::int64_t low = random.wide(62), high = std::abs(random.wide(bits)) >> 31;
    const auto denominator = static_cast<Int128>(
        Wide<2>::from_words({static_cast<std::uint64_t>(low) >> random.below(60),
                             i % 2 == 0 ? static_cast<std::uint64_t>(high) : 0}));
    if (denominator == Int128(0)) continue;
    const auto quotient = static_cast<std::int64_t>(random.next() >> (32 + random.below(32)));
    const auto product = wrapping_multiply<Int128>(denominator, quotient);
    const auto last = wrapping_subtract<Int128>(wrapping_add<Int128>(product, denominator), 1);
    CHECK(short_quotient(product, denominator) == quotient);
    CHECK(short_quotient(last, denominator) == quotient);
    if (bit_length(denominator) <= 63) {
      CHECK(short_quotient(product, integer_cast<std::int64_t>(denominator)) == quotient);
    }
  }
}

TEMPLATE_TEST_CASE("short_quotient: agrees with the long division of wide integers", "[number]",
                   Int128, Wide<3>, Wide<4>, Wide<5>) {
  using I = TestType;
  Random random(20261127);
  INFO(random);
  for (int i = 0; i < 20000; ++i) {
    const auto digits = random_digits<I>(random);
    const I magnitude = is_negative(digits) ? wrapping_subtract<I>(I(-1), digits) : digits;
    const I denominator = shift_right_floor(magnitude, 33);
    if (denominator == I(0)) continue;
    const auto quotient = static_cast<std::int64_t>(random.next() >> (32 + random.below(32)));
    const auto first = wrapping_multiply<I>(denominator, quotient);
    const auto last = wrapping_subtract<I>(wrapping_add<I>(first, denominator), I(1));
    CHECK(short_quotient(first, denominator) == quotient);
    CHECK(short_quotient(last, denominator) == quotient);
  }
}
