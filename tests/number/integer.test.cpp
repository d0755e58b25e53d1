// SPDX-License-Identifier: MIT
#include "detent/number/integer.hpp"

#include <concepts>
#include <cstdint>
#include <limits>

#include "number/big_integer.hpp"
#include "support/catch.hpp"

using namespace detent;
using namespace detent::test;

namespace {

static_assert(std::same_as<IntegerFor<1>, std::int16_t> &&
              std::same_as<IntegerFor<15>, std::int16_t>);
static_assert(std::same_as<IntegerFor<16>, std::int32_t> &&
              std::same_as<IntegerFor<31>, std::int32_t>);
static_assert(std::same_as<IntegerFor<32>, std::int64_t> &&
              std::same_as<IntegerFor<63>, std::int64_t>);
static_assert(std::same_as<IntegerFor<64>, Int128> && std::same_as<IntegerFor<127>, Int128>);
static_assert(std::same_as<IntegerFor<128>, Wide<4>> && std::same_as<IntegerFor<255>, Wide<4>>);
static_assert(std::same_as<IntegerFor<320>, Wide<7>> && std::same_as<IntegerFor<447>, Wide<7>>);
static_assert(std::same_as<IntegerFor<448>, Wide<10>> && std::same_as<IntegerFor<639>, Wide<10>>);
static_assert(std::same_as<IntegerFor<256>, Wide<5>> && std::same_as<IntegerFor<319>, Wide<5>>);
static_assert(value_bits<std::int16_t> == 15 && value_bits<Int128> == 127 &&
              value_bits<Wide<5>> == 319);
static_assert(bit_length(0) == 0 && bit_length(1) == 1 && bit_length(-1) == 1 &&
              bit_length(-8) == 4);
static_assert(bit_length(std::numeric_limits<std::int64_t>::min()) == 64);
static_assert(bit_length(Int128(1)) == 1 && bit_length(Wide<4>(1) << 200) == 201);
static_assert(shift_right_floor(-1, 500) == -1 && shift_right_floor(7, 500) == 0);
static_assert(low_bits_are_zero(0, 500) && !low_bits_are_zero(1 << 30, 500) &&
              low_bits_are_zero(5, 0));
static_assert(wrapping_add<std::int32_t>(std::numeric_limits<std::int32_t>::max(), 1) ==
              std::numeric_limits<std::int32_t>::min());

}  // namespace

TEMPLATE_TEST_CASE("integer: the helpers agree with big integers", "[number]", std::int16_t,
                   std::int32_t, std::int64_t, Int128, Wide<2>, Wide<4>, Wide<5>) {
  using I = TestType;
  constexpr int width = value_bits<I> + 1;
  Random random(0x127);
  INFO(random);
  for (int i = 0; i < 50'000; ++i) {
    const I x = random_integer<I>(random);
    const BigInteger value = big(x);
    const int count = static_cast<int>(random.below(width));
    const int any_count = static_cast<int>(random.below(600));
    const BigInteger magnitude = abs(value);
    const int length = value == 0 ? 0 : static_cast<int>(msb(magnitude)) + 1;
    const bool right =
        sign_of(x) == (value > 0) - (value < 0) && bit_length(x) == length &&
        big(shift_left(x, count)) == wrapped(value * power_of_two(count), width) &&
        big(shift_right_floor(x, any_count)) == floor_of(value, power_of_two(any_count)) &&
        low_bits_are_zero(x, any_count) == (value % power_of_two(any_count) == 0);
    if (!right) FAIL("x = " << value << ", counts " << count << ", " << any_count);
  }
}

TEMPLATE_TEST_CASE("integer: wrapping operations take operands of any width", "[number]",
                   std::int16_t, std::int32_t, std::int64_t, Int128, Wide<2>, Wide<4>, Wide<5>) {
  using To = TestType;
  constexpr int width = value_bits<To> + 1;
  Random random(0x128);
  INFO(random);
  const auto sweep = [&random]<class A, class B>(A, B) {
    for (int i = 0; i < 3'000; ++i) {
      const A a = random_integer<A>(random);
      const B b = random_integer<B>(random);
      const BigInteger x = big(a), y = big(b);
      const bool right = big(wrapping_add<To>(a, b)) == wrapped(x + y, width) &&
                         big(wrapping_subtract<To>(a, b)) == wrapped(x - y, width) &&
                         big(wrapping_multiply<To>(a, b)) == wrapped(x * y, width);
      if (!right) FAIL("a = " << x << ", b = " << y);
    }
  };
  const auto with_all = [&sweep]<class A>(A a) {
    sweep(a, std::int16_t());
    sweep(a, std::int32_t());
    sweep(a, std::int64_t());
    sweep(a, Int128());
    sweep(a, Wide<4>());
    sweep(a, Wide<5>());
  };
  with_all(std::int16_t());
  with_all(std::int32_t());
  with_all(std::int64_t());
  with_all(Int128());
  with_all(Wide<4>());
  with_all(Wide<5>());
}
