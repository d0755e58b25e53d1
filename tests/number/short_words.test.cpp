// SPDX-License-Identifier: MIT
#include "detent/number/short_words.hpp"

#include <limits>

#include "number/big_integer.hpp"
#include "support/catch.hpp"

using namespace detent;
using namespace detent::test;

namespace {

// The path for 32-bit processors must also work in constant expressions.
static_assert(multiply_halves_portable(-1, 0xffffffffu) == 0xffffffff00000001u);
static_assert(divide_halves_portable(0xfffffffeffffffff, 0xffffffff).quotient == 0xffffffff);
static_assert(multiply_by_half<2>(Wide<2>(-1), -3) == Wide<2>(3));

BigInteger big(const WordProduct& product) {
  return test::big(Wide<2>::from_words({product.low, product.high}));
}

std::int64_t draw(Random& random) {
  return random.coin() ? random.edgy(62) : static_cast<std::int64_t>(random.next());
}
std::int32_t draw_half(Random& random) { return static_cast<std::int32_t>(random.edgy(31)); }

}  // namespace

TEST_CASE("short words: products of halves are exact, with and without signs", "[number]") {
  Random random(0x5407d0);
  INFO(random);
  for (int i = 0; i < 200'000; ++i) {
    const std::int32_t a = draw_half(random), b = draw_half(random);
    const auto c = static_cast<std::uint32_t>(a), d = static_cast<std::uint32_t>(b);
    const auto as_signed = [](std::uint64_t x) { return test::big(static_cast<std::int64_t>(x)); };
    const bool right = as_signed(multiply_halves_portable(a, b)) == BigInteger(a) * b &&
                       as_signed(multiply_halves_portable(a, d)) == BigInteger(a) * d &&
                       as_signed(multiply_halves_portable(c, b)) == BigInteger(c) * b &&
                       test::big(multiply_halves_portable(c, d)) == BigInteger(c) * d &&
                       multiply_halves(a, b) == multiply_halves_portable(a, b) &&
                       multiply_halves(a, d) == multiply_halves_portable(a, d) &&
                       multiply_halves(c, d) == multiply_halves_portable(c, d);
    if (!right) FAIL("a = " << a << ", b = " << b);
  }
}

TEST_CASE("short words: products of words are exact, or correct modulo 2^64", "[number]") {
  Random random(0x5407d1);
  INFO(random);
  for (int i = 0; i < 200'000; ++i) {
    const std::int64_t a = draw(random), b = draw(random);
    const std::int32_t half = draw_half(random);
    const auto quarter = static_cast<std::int16_t>(random.edgy(15));
    const auto low_is_right = [](std::uint64_t low, const BigInteger& product) {
      return test::big(static_cast<std::int64_t>(low)) == wrapped(product, 64);
    };
    const BigInteger x = a, y = b;
    const bool right = big(multiply_signed_halves(a, b)) == x * y &&
                       big(multiply_signed_halves(a, half)) == x * half &&
                       big(multiply_signed_halves(quarter, b)) == quarter * y &&
                       big(multiply_signed_halves(half, quarter)) == BigInteger(half) * quarter &&
                       low_is_right(multiply_low_halves(a, b), x * y) &&
                       low_is_right(multiply_low_halves(half, b), half * y) &&
                       low_is_right(multiply_low_halves(a, quarter), x * quarter) &&
                       low_is_right(multiply_low_halves(half, half), BigInteger(half) * half);
    if (!right) FAIL("a = " << a << ", b = " << b << ", " << half << ", " << quarter);
  }
}

TEST_CASE("short words: wide products assembled from halves are exact", "[number]") {
  Random random(0x5407d2);
  INFO(random);
  for (int i = 0; i < 100'000; ++i) {
    const auto a = random_wide<2>(random);
    const auto c = random_wide<4>(random);
    const std::int32_t half = draw_half(random);
    const BigInteger x = test::big(a), z = test::big(c);
    const bool right = test::big(multiply_by_halves<2>(a, a)) == wrapped(x * x, 128) &&
                       test::big(multiply_by_halves<4>(a, a)) == x * x &&
                       test::big(multiply_by_halves<5>(c, a)) == wrapped(z * x, 320) &&
                       test::big(multiply_by_halves<6>(a, c)) == x * z &&
                       test::big(multiply_by_halves<3>(c, c)) == wrapped(z * z, 192) &&
                       test::big(multiply_by_half<2>(a, half)) == wrapped(x * half, 128) &&
                       test::big(multiply_by_half<3>(a, half)) == x * half &&
                       test::big(multiply_by_half<2>(c, half)) == wrapped(z * half, 128);
    if (!right) FAIL("a = " << x << ", c = " << z << ", half = " << half);
  }
}

TEST_CASE("short words: a 32-bit quotient is computed by 32-bit divisions", "[number]") {
  Random random(0x5407d3);
  INFO(random);
  for (int i = 0; i < 300'000; ++i) {
    const auto wanted = static_cast<std::uint32_t>(random.edgy(32));
    const auto d = static_cast<std::uint32_t>(random.edgy(32)) | 0x80000000u;
    const std::uint64_t rest = random.coin() ? (random.coin() ? 0 : d - 1) : random.below(d);
    const std::uint64_t n = std::uint64_t{wanted} * d + rest;
    const auto portable = divide_halves_portable(n, d);
    const auto division = divide_halves(n, d);
    const bool right = portable.quotient == wanted && portable.remainder == rest &&
                       division.quotient == wanted && division.remainder == rest;
    if (!right) FAIL("n = " << n << ", d = " << d);
  }
}
