// SPDX-License-Identifier: MIT
#include "detent/number/wide.hpp"

#include <array>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "number/big_integer.hpp"
#include "support/catch.hpp"

using namespace detent;
using namespace detent::test;

namespace {

template <int Words>
struct Extremes {
  static constexpr Wide<Words> max = Wide<Words>::from_words([] {
    std::array<std::uint64_t, Words> words;
    words.fill(~std::uint64_t{0});
    words.back() >>= 1;
    return words;
  }());
  static constexpr Wide<Words> min = Wide<Words>(1) << (64 * Words - 1);
};

// Every operator must work in a constant expression.
template <int Words>
constexpr bool identities_hold() {
  using W = Wide<Words>;
  constexpr W max = Extremes<Words>::max, min = Extremes<Words>::min, one = 1, minus_one = -1;
  return max + one == min && min - one == max && -min == min && min < max && minus_one < one &&
         W() == W(0) && minus_one * minus_one == one && min * minus_one == min &&
         max * max == one && min * min == W(0) && (min >> (64 * Words - 1)) == minus_one &&
         (max >> (64 * Words - 2)) == one && (one << (64 * Words - 1)) == min &&
         minus_one.is_negative() && !max.is_negative() && (max <=> max) == 0;
}
static_assert(identities_hold<2>() && identities_hold<3>() && identities_hold<4>() &&
              identities_hold<5>());

static_assert(std::is_trivially_copyable_v<Wide<4>> && sizeof(Wide<5>) == 40);
static_assert(std::is_convertible_v<int, Wide<2>> && !std::is_convertible_v<Wide<2>, int>);
static_assert(!std::is_convertible_v<Wide<4>, Wide<2>>);
static_assert(Wide<2>(std::uint64_t{0} - 1) > Wide<2>(0), "unsigned integers are zero-extended");
static_assert(Wide<4>(std::int8_t{-1}) == Wide<4>(-1) && Wide<4>(Wide<2>(-5)) == Wide<4>(-5));
static_assert(static_cast<std::int32_t>(Wide<2>(-7)) == -7);
static_assert(static_cast<std::uint8_t>(Wide<4>(0x1234)) == 0x34);
static_assert(Wide<2>(Wide<5>(1) << 128) == Wide<2>(0), "a narrower copy keeps the low words");

constexpr bool products_are_equal(std::uint64_t a, std::uint64_t b) {
  const WordProduct native = multiply_words(a, b), portable = multiply_words_portable(a, b);
  return native.low == portable.low && native.high == portable.high;
}
constexpr std::uint64_t all_ones = ~std::uint64_t{0};
static_assert(products_are_equal(all_ones, all_ones) && products_are_equal(all_ones, 0));
static_assert(multiply_words_portable(all_ones, all_ones).high == all_ones - 1);

}  // namespace

TEMPLATE_TEST_CASE_SIG("Wide: arithmetic is that of the integers modulo 2^width", "[number]",
                       ((int Words), Words), 2, 3, 4, 5) {
  constexpr int width = 64 * Words;
  Random random(0x51de0000 + Words);
  INFO(random);
  for (int i = 0; i < 250'000; ++i) {
    const Wide<Words> a = random_wide<Words>(random), b = random_wide<Words>(random);
    const BigInteger x = big(a), y = big(b);
    const bool right = big(a + b) == wrapped(x + y, width) && big(a - b) == wrapped(x - y, width) &&
                       big(-a) == wrapped(-x, width) && big(a * b) == wrapped(x * y, width) &&
                       (a == b) == (x == y) && (a != b) == (x != y) && (a < b) == (x < y) &&
                       (a <= b) == (x <= y) && (a > b) == (x > y) && (a >= b) == (x >= y) &&
                       a == Wide<Words>(a) && (a <=> a) == 0 && a.is_negative() == (x < 0);
    if (!right) FAIL("a = " << x << ", b = " << y);
  }
}

TEMPLATE_TEST_CASE_SIG("Wide: shifts multiply and divide by every power of two", "[number]",
                       ((int Words), Words), 2, 3, 4, 5) {
  constexpr int width = 64 * Words;
  Random random(0x51de1000 + Words);
  INFO(random);
  for (int i = 0; i < 300; ++i) {
    const Wide<Words> a = random_wide<Words>(random);
    const BigInteger x = big(a);
    for (int count = 0; count < width; ++count) {
      const bool right = big(a << count) == wrapped(x * power_of_two(count), width) &&
                         big(a >> count) == floor_of(x, power_of_two(count));
      if (!right) FAIL("a = " << x << ", count = " << count);
    }
  }
}

TEST_CASE("Wide: a product of different widths is exact in the sum of the widths", "[number]") {
  Random random(0x51de2);
  INFO(random);
  for (int i = 0; i < 100'000; ++i) {
    const auto a = random_wide<2>(random);
    const auto b = random_wide<3>(random);
    const auto c = random_wide<4>(random);
    const bool right =
        big(multiply<4>(a, a)) == big(a) * big(a) && big(multiply<5>(a, b)) == big(a) * big(b) &&
        big(multiply<5>(b, a)) == big(a) * big(b) && big(multiply<6>(a, c)) == big(a) * big(c) &&
        big(multiply<8>(c, c)) == big(c) * big(c) &&
        big(multiply<2>(c, b)) == wrapped(big(c) * big(b), 128) &&
        big(multiply<3>(c, a)) == wrapped(big(c) * big(a), 192) &&
        big(multiply<5>(c, c)) == wrapped(big(c) * big(c), 320);
    if (!right) FAIL("a = " << big(a) << ", b = " << big(b) << ", c = " << big(c));
  }
}

TEST_CASE("Wide: conversions extend the sign and keep the low bits", "[number]") {
  Random random(0x51de3);
  INFO(random);
  for (int i = 0; i < 100'000; ++i) {
    const auto a = random_wide<2>(random);
    const auto c = random_wide<5>(random);
    const auto word = static_cast<std::int64_t>(random.next());
    const bool right =
        big(Wide<4>(a)) == big(a) && big(Wide<5>(a)) == big(a) &&
        big(Wide<2>(c)) == wrapped(big(c), 128) && big(Wide<4>(c)) == wrapped(big(c), 256) &&
        big(static_cast<std::int64_t>(c)) == wrapped(big(c), 64) &&
        big(static_cast<std::int32_t>(c)) == wrapped(big(c), 32) &&
        big(static_cast<std::int16_t>(c)) == wrapped(big(c), 16) &&
        static_cast<std::uint32_t>(c) == static_cast<std::uint32_t>(c.word(0)) &&
        big(Wide<2>(word)) == word && big(Wide<5>(word)) == word &&
        big(Wide<5>(static_cast<std::uint64_t>(word))) == static_cast<std::uint64_t>(word);
    if (!right) FAIL("a = " << big(a) << ", c = " << big(c) << ", word = " << word);
  }
}

TEST_CASE("Wide: the portable word product is exact", "[number]") {
  Random random(0x51de4);
  INFO(random);
  for (int i = 0; i < 1'000'000; ++i) {
    const auto a = random_integer<std::uint64_t>(random), b = random_integer<std::uint64_t>(random);
    const WordProduct product = multiply_words_portable(a, b);
    if ((BigInteger(product.high) << 64) + product.low != BigInteger(a) * b) {
      FAIL("a = " << a << ", b = " << b);
    }
    if (!products_are_equal(a, b)) FAIL("native: a = " << a << ", b = " << b);
  }
}

#ifdef __SIZEOF_INT128__
TEST_CASE("Wide: two words behave like the compiler's 128-bit integer", "[number]") {
  __extension__ using Native = __int128;
  __extension__ using Unsigned = unsigned __int128;
  const auto native = [](const Wide<2>& x) {
    return static_cast<Native>((static_cast<Unsigned>(x.word(1)) << 64) | x.word(0));
  };
  const auto wrap = [](Unsigned x) { return static_cast<Native>(x); };
  Random random(0x51de5);
  INFO(random);
  for (int i = 0; i < 1'000'000; ++i) {
    const auto a = random_wide<2>(random), b = random_wide<2>(random);
    const Native x = native(a), y = native(b);
    const auto u = static_cast<Unsigned>(x), v = static_cast<Unsigned>(y);
    const int count = static_cast<int>(random.below(128));
    const bool equal = native(a + b) == wrap(u + v) && native(a - b) == wrap(u - v) &&
                       native(-a) == wrap(-u) && native(a * b) == wrap(u * v) &&
                       (a == b) == (x == y) && (a < b) == (x < y) && (a >= b) == (x >= y) &&
                       native(a << count) == wrap(u << count) && native(a >> count) == x >> count;
    if (!equal) FAIL("a = " << big(a) << ", b = " << big(b) << ", count = " << count);
  }
}
#endif
