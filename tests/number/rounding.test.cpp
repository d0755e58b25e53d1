// SPDX-License-Identifier: MIT
#include "detent/number/rounding.hpp"

#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <utility>

#include "detent/number/literals.hpp"
#include "detent/number/text.hpp"
#include "number/big_integer.hpp"
#include "support/catch.hpp"

using namespace detent;
using namespace detent::literals;
using namespace detent::test;

namespace {

using Whole = Fixed<31, 0>;

// Down, also for negative numbers.
static_assert(floor_to<Whole>(1.75_q16_16) == 1 && floor_to<Whole>(-1.25_q16_16) == -2);
static_assert(floor_to<q8_8>(q16_16::from_raw(-1)) == q8_8::from_raw(-1));
static_assert(floor_to<q16_16>(1.5_q8_8) == 1.5_q16_16, "a finer grid changes nothing");
// Up, also for negative numbers.
static_assert(ceil_to<Whole>(1.25_q16_16) == 2 && ceil_to<Whole>(-1.75_q16_16) == -1);
static_assert(ceil_to<Whole>(3_q16_16) == 3 && ceil_to<q16_16>(-1.5_q8_8) == q16_16(-1.5_q8_8));
static_assert(ceil_to<q8_8>(-q8_8::lowest()) == q8_8::max());
static_assert(ceil_to<q8_8>(-q16_16::max()) == q8_8::lowest());
static_assert(ceil_to<q16_16>(q16_16::lowest() - 1_q16_16) == q16_16::lowest());
// Halved onto a finer grid.
static_assert(half(3_q8_8) == 1.5_q8_8 &&
              half(q8_8::from_raw(-1)) + half(q8_8::from_raw(-1)) == q8_8::from_raw(-1));
// To nearest, ties to even.
static_assert(nearest_to<Whole>(1.5_q16_16) == 2 && nearest_to<Whole>(2.5_q16_16) == 2);
static_assert(nearest_to<Whole>(-1.5_q16_16) == -2 && nearest_to<Whole>(-2.5_q16_16) == -2);
static_assert(nearest_to<Whole>(-0.5_q16_16) == 0 && nearest_to<Whole>(0.50001_q16_16) == 1);
static_assert(nearest_to<Fixed<5, -8>>(384_q16_16) == 512 &&
              nearest_to<Fixed<5, -8>>(128_q16_16) == 0);
static_assert(nearest_to<q16_16>(2_q16_16 * 0.25_q16_16) == 0.5_q16_16);
// Ends of the range.
static_assert(floor_to<q8_8>(q16_16::max()) == q8_8::max());
static_assert(nearest_to<q8_8>(-q16_16::max()) == q8_8::lowest());
static_assert(saturate_to<q16_16>(q16_16::lowest() - q16_16(1)) == q16_16::lowest());
static_assert(saturate_to<q16_16>(q16_16::lowest() * q16_16(-1)) == q16_16::max());
static_assert(nearest_to<q8_8>(127.998_q16_16) == q8_8::max(),
              "what rounds past the end stops there");
// A proof instead of rounding.
static_assert(std::same_as<decltype(narrow<31>(q16_16() + q16_16())), q16_16>);
static_assert(narrow<31>(q16_16(2) + q16_16(3)) == 5 && narrow<29>(-q14_16::lowest()) == 8192);
static_assert(std::same_as<decltype(narrow_product<40>(q16_16(), q16_16())), Fixed<40, 32>>);
static_assert(std::same_as<decltype(narrow_sum<32>(q16_16(), Fixed<20, 18>())), Fixed<32, 18>>);
static_assert(narrow_product<40>(q16_16(3), 0.5_q16_16) == 1.5_q16_16);
static_assert(narrow_difference<31>(q16_16(3), q16_16(4)) == -1 &&
              narrow_sum<31>(1_q8_8, 2_q16_16) == 3);
// Quotients.
static_assert(quotient_floor<Whole>(7_q16_16, 2_q16_16) == 3);
static_assert(quotient_floor<Whole>(-7_q16_16, 2_q16_16) == -4);
static_assert(quotient_floor<Whole>(7_q16_16, -2_q16_16) == -4);
static_assert(quotient_floor<Whole>(-7_q16_16, -2_q16_16) == 3);
static_assert(quotient_nearest<Whole>(7_q16_16, 2_q16_16) == 4);
static_assert(quotient_nearest<Whole>(5_q16_16, -2_q16_16) == -2);
static_assert(quotient_floor<q16_16>(1_q16_16, 3_q16_16).raw() == 21845);
static_assert(quotient_floor<q16_16>(1_q16_16, 0_q16_16) == q16_16::max(), "d = 0: the side of n");
static_assert(quotient_floor<q16_16>(-1_q16_16, 0_q16_16) == q16_16::lowest());
static_assert(quotient_floor<q16_16>(0_q16_16, 0_q16_16) == 0);
static_assert(quotient_nearest<q8_8>(-1_q16_16, 0_q16_16) == q8_8::lowest());
static_assert(quotient_floor<q16_16>(q16_16::lowest(), q16_16::from_raw(-1)) == q16_16::max());
static_assert(quotient_floor<q16_16>(q16_16::lowest(), -1_q16_16) == q16_16::max());
// Roots.
static_assert(sqrt_floor<q16_16>(2_q16_16).raw() == 92681 && sqrt_floor<q16_16>(9_q16_16) == 3);
static_assert(sqrt_floor<q16_16>(-1_q16_16) == 0 && sqrt_floor<q16_16>(0_q16_16) == 0);
static_assert(sqrt_floor<q8_8>(q16_16::max() * q16_16::max()) == q8_8::max());
static_assert(sqrt_ceil<q16_16>(2_q16_16).raw() == 92682 && sqrt_ceil<q16_16>(9_q16_16) == 3);
static_assert(sqrt_ceil<q16_16>(-1_q16_16) == 0 && sqrt_ceil<q16_16>(0_q16_16) == 0);
static_assert(sqrt_ceil<Whole>(q16_16::from_raw(1)) == 1);
static_assert(sqrt_ceil<q8_8>(q16_16::max() * q16_16::max()) == q8_8::max());

template <class A, class B>
struct Two {
  using First = A;
  using Second = B;
};

template <class N, class D, class T>
struct Three {
  using Numerator = N;
  using Denominator = D;
  using Result = T;
};

/// x * 2^exponent as a fraction of integers.
struct Ratio {
  Ratio(const BigInteger& n, const BigInteger& d, int exponent)
      : numerator(exponent > 0 ? BigInteger(n << exponent) : n),
        denominator(exponent < 0 ? BigInteger(d << -exponent) : d) {}

  [[nodiscard]] BigInteger floor() const { return floor_of(numerator, denominator); }
  [[nodiscard]] BigInteger nearest() const {
    const BigInteger below = floor();
    BigInteger twice = 2 * (numerator - below * denominator), size = denominator;
    if (size < 0) {
      twice = -twice;
      size = -size;
    }
    const bool up = twice > size || (twice == size && below % 2 != 0);
    return up ? BigInteger(below + 1) : below;
  }

  BigInteger numerator;
  BigInteger denominator;
};

// A number of A at or next to a multiple of half a step of T, if possible.
template <class A, class T>
A random_beside(Random& random) {
  if (random.coin()) return random_fixed<A>(random);
  const BigInteger half_steps = 2 * big_raw(random_fixed<T>(random)) + random.between(0, 1);
  return fixed_from<A>(Ratio(half_steps, 1, A::frac - T::frac - 1).floor() + random.between(-1, 1));
}

}  // namespace

TEMPLATE_TEST_CASE("rounding: down, up, to nearest, clamping at the ends", "[number]",
                   (Two<q16_16, Whole>), (Two<q16_16, q8_8>), (Two<q8_8, q16_16>),
                   (Two<q16_16, q24_8>), (Two<q24_8, q16_16>), (Two<q16_16, q14_16>),
                   (Two<Fixed<32, 16>, q16_16>), (Two<Fixed<62, 32>, q16_16>),
                   (Two<Fixed<46, 46>, Fixed<31, 30>>), (Two<Fixed<30, 30>, Fixed<5, -3>>),
                   (Two<Fixed<15, 60>, q16_16>), (Two<Fixed<63, 63>, Fixed<31, 31>>),
                   (Two<Fixed<63, 52>, Fixed<33, 22>>), (Two<Fixed<63, 20>, Fixed<63, 19>>),
                   (Two<Fixed<64, 48>, Fixed<63, 47>>), (Two<Fixed<94, 46>, q16_16>),
                   (Two<Fixed<126, 92>, Fixed<31, 30>>), (Two<Fixed<127, 64>, Fixed<127, 63>>),
                   (Two<Fixed<128, 0>, Fixed<31, -90>>), (Two<Fixed<200, 90>, Fixed<100, 20>>),
                   (Two<Fixed<255, 255>, Fixed<127, 127>>), (Two<Fixed<300, 100>, q16_16>)) {
  using A = typename TestType::First;
  using T = typename TestType::Second;
  Random random(0x20dd);
  INFO(random);
  int inside = 0;
  for (int i = 0; i < 60'000; ++i) {
    const A x = random_beside<A, T>(random);
    const Ratio exact(big_raw(x), 1, T::frac - A::frac);
    const BigInteger floor = exact.floor(), nearest = exact.nearest();
    const BigInteger ceil = -Ratio(-big_raw(x), 1, T::frac - A::frac).floor();
    const bool right = big_raw(floor_to<T>(x)) == clamped<T>(floor) &&
                       big_raw(ceil_to<T>(x)) == clamped<T>(ceil) &&
                       big_raw(nearest_to<T>(x)) == clamped<T>(nearest) &&
                       big_raw(saturate_to<T>(x)) == clamped<T>(nearest);
    if (!right) FAIL("raw " << big_raw(x));
    inside += nearest == clamped<T>(nearest) ? 1 : 0;
  }
  CHECK(inside > 5'000);
}

template <class I>
BigInteger held(const BigInteger& n) {
  const BigInteger low(std::numeric_limits<I>::min()), high(std::numeric_limits<I>::max());
  return n < low ? low : high < n ? high : n;
}

TEMPLATE_TEST_CASE("rounding: to built-in integers, clamping at their ends", "[number]", q16_16,
                   (Fixed<62, 32>), (Fixed<94, 16>), (Fixed<20, -40>)) {
  Random random(0x20e1);
  INFO(random);
  const auto sweep = [&random]<class I>(I) {
    int inside = 0;
    for (int i = 0; i < 4'000; ++i) {
      const auto x = random_beside<TestType, detail::WholeFor<I>>(random);
      const Ratio exact(big_raw(x), 1, -TestType::frac);
      const BigInteger floor = exact.floor(), nearest = exact.nearest();
      const BigInteger ceil = -Ratio(-big_raw(x), 1, -TestType::frac).floor();
      const bool right = floor_to<I>(x) == held<I>(floor) && ceil_to<I>(x) == held<I>(ceil) &&
                         nearest_to<I>(x) == held<I>(nearest) &&
                         saturate_to<I>(x) == held<I>(nearest);
      if (!right) FAIL("raw " << big_raw(x));
      inside += nearest == held<I>(nearest) ? 1 : 0;
    }
    CHECK(inside > 200);
  };
  sweep(std::int8_t{});
  sweep(std::uint16_t{});
  sweep(int{});
  sweep(std::int64_t{});
  sweep(std::uint64_t{});
}

// The result of <cmath> for the double, which is exact; clamped to the integer's range.
TEMPLATE_TEST_CASE("rounding: float and double to built-in integers", "[number]", float, double) {
  static_assert(floor_to<int>(TestType(-1.5)) == -2 && ceil_to<int>(TestType(-1.5)) == -1);
  static_assert(nearest_to<int>(TestType(2.5)) == 2 && nearest_to<int>(TestType(3.5)) == 4);
  static_assert(floor_to<unsigned>(TestType(-0.5)) == 0);
  CHECK(nearest_to<int>(std::numeric_limits<TestType>::quiet_NaN()) == 0);
  CHECK(floor_to<std::int64_t>(std::numeric_limits<TestType>::infinity()) ==
        std::numeric_limits<std::int64_t>::max());
  Random random(0x20e2);
  INFO(random);
  const auto sweep = [&random]<class I>(I) {
    const auto stop = [](double y) {
      if (y >= std::ldexp(1.0, std::numeric_limits<I>::digits))
        return std::numeric_limits<I>::max();
      return y < static_cast<double>(std::numeric_limits<I>::min()) ? std::numeric_limits<I>::min()
                                                                    : static_cast<I>(y);
    };
    for (int i = 0; i < 20'000; ++i) {
      const auto x = static_cast<TestType>(
          std::ldexp(static_cast<double>(random.between(-1'000'000, 1'000'000)),
                     static_cast<int>(random.between(-21, 48))));
      const auto y = static_cast<double>(x);
      const bool right =
          floor_to<I>(x) == stop(std::floor(y)) && ceil_to<I>(x) == stop(std::ceil(y)) &&
          nearest_to<I>(x) == stop(std::nearbyint(y)) && saturate_to<I>(x) == nearest_to<I>(x);
      if (!right) FAIL(y);
    }
  };
  sweep(std::int8_t{});
  sweep(std::uint8_t{});
  sweep(int{});
  sweep(std::int64_t{});
  sweep(std::uint64_t{});
}

static_assert(quotient_nearest<q16_16>(1, 3) == quotient_nearest<q16_16>(1_q16_16, 3_q16_16) &&
              quotient_floor<q16_16>(-7_q16_16, 2) == -3.5_q16_16 &&
              quotient_floor<q16_16>(1, 2_q16_16) == 0.5_q16_16 &&
              quotient_nearest<q16_16>(-1, 0) == q16_16::lowest());
static_assert(quotient_floor<int>(-7_q16_16, 2_q16_16) == -4 &&
              quotient_nearest<std::uint8_t>(999_q16_16, 2_q16_16) == 255);

TEMPLATE_TEST_CASE("rounding: narrow keeps a number that fits", "[number]",
                   (Two<Fixed<32, 16>, q16_16>), (Two<Fixed<62, 32>, Fixed<40, 32>>),
                   (Two<Fixed<64, 32>, Fixed<62, 32>>), (Two<Fixed<128, 60>, Fixed<63, 60>>),
                   (Two<Fixed<130, 60>, Fixed<126, 60>>), (Two<Fixed<257, 0>, Fixed<255, 0>>),
                   (Two<Fixed<300, 8>, Fixed<14, 8>>)) {
  using A = typename TestType::First;
  using T = typename TestType::Second;
  Random random(0x20de);
  INFO(random);
  for (int i = 0; i < 20'000; ++i) {
    const T kept = random_fixed<T>(random);
    const A x = kept;
    if (big_raw(narrow<T::bits>(x)) != big_raw(kept)) FAIL("raw " << big_raw(kept));
  }
}

TEMPLATE_TEST_CASE("rounding: narrow sums, differences and products are exact when they fit",
                   "[number]", (Two<q8_8, q8_8>), (Two<q16_16, q16_16>),
                   (Two<q16_16, Fixed<31, 30>>), (Two<Fixed<32, 16>, Fixed<62, 32>>),
                   (Two<Fixed<63, 32>, Fixed<63, 60>>), (Two<Fixed<127, 60>, Fixed<66, 32>>),
                   (Two<Fixed<126, 60>, Fixed<126, 32>>), (Two<Fixed<150, 0>, Fixed<120, 46>>)) {
  using A = typename TestType::First;
  using B = typename TestType::Second;
  constexpr int frac = std::max(A::frac, B::frac);
  Random random(0x20df);
  INFO(random);
  const auto sweep = [&random]<int Bits>(std::integral_constant<int, Bits>) {
    const auto fits = [](const BigInteger& raw) {
      const BigInteger end = power_of_two(Bits);
      return raw >= -end && raw <= (detail::fills_container(Bits) ? BigInteger(end - 1) : end);
    };
    int fitting = 0;
    for (int i = 0; i < 10'000; ++i) {
      const A a = random_fixed<A>(random);
      const B b = random_fixed<B>(random);
      const BigInteger x = big_raw(a), y = big_raw(b);
      const BigInteger u = x << (frac - A::frac), v = y << (frac - B::frac);
      bool right = true;
      if (fits(x * y)) {
        right = big_raw(narrow_product<Bits>(a, b)) == x * y;
        ++fitting;
      }
      if (fits(u + v)) right = right && big_raw(narrow_sum<Bits>(a, b)) == u + v;
      if (fits(u - v)) right = right && big_raw(narrow_difference<Bits>(a, b)) == u - v;
      if (!right) FAIL(Bits << " bits: raw a = " << x << ", raw b = " << y);
    }
    CHECK(fitting > 500);
  };
  sweep(std::integral_constant<int, 15>());
  sweep(std::integral_constant<int, 29>());
  sweep(std::integral_constant<int, 63>());
  sweep(std::integral_constant<int, 64>());
  sweep(std::integral_constant<int, 127>());
  sweep(std::integral_constant<int, 140>());
}

TEMPLATE_TEST_CASE("rounding: headroom is the number of bits scale_up can add", "[number]", q8_8,
                   q16_16, (Fixed<62, 32>), (Fixed<64, 32>), (Fixed<126, 60>), (Fixed<200, 8>)) {
  Random random(0x20e0);
  INFO(random);
  for (int i = 0; i < 20'000; ++i) {
    const auto x = abs(random_fixed<TestType>(random));
    if (x == 0 || x > TestType::max()) continue;
    const int room = headroom(x);
    REQUIRE(room >= 0);
    REQUIRE(big_raw(x) << room < power_of_two(x.bits));
    REQUIRE(big_raw(x) << (room + 1) >= power_of_two(x.bits));
    for (const int count : {0, room / 2, room}) {
      REQUIRE(big_raw(scale_up<x.bits>(x, count)) == big_raw(x) << count);
    }
  }
}

TEMPLATE_TEST_CASE(
    "rounding: quotients are the exact ones rounded once", "[number]", (Three<q8_8, q8_8, q8_8>),
    (Three<q8_8, q16_16, q16_16>), (Three<q16_16, q16_16, q16_16>), (Three<q14_16, q14_16, q16_16>),
    (Three<q16_16, q16_16, Whole>), (Three<Fixed<32, 16>, Fixed<31, 30>, q16_16>),
    (Three<Fixed<62, 46>, Fixed<30, 30>, q16_16>), (Three<Fixed<62, 32>, q16_16, q8_8>),
    (Three<Fixed<63, 46>, Fixed<63, 60>, q16_16>),
    (Three<Fixed<63, 0>, Fixed<31, 30>, Fixed<63, 0>>),
    (Three<Fixed<64, 46>, Fixed<62, 60>, q16_16>), (Three<Fixed<94, 76>, Fixed<96, 60>, q16_16>),
    (Three<Fixed<110, 92>, Fixed<127, 100>, q24_8>),
    (Three<Fixed<127, 64>, Fixed<127, 64>, q16_16>), (Three<Fixed<126, 60>, Fixed<126, 60>, Whole>),
    (Three<Fixed<127, 100>, Fixed<127, 20>, Fixed<63, 32>>),
    (Three<Fixed<127, 64>, Fixed<127, 64>, Fixed<127, 64>>),
    (Three<Fixed<128, 64>, Fixed<128, 64>, Fixed<128, 64>>),
    (Three<Fixed<126, 20>, Fixed<64, 120>, Fixed<31, 16>>),
    (Three<Fixed<31, 0>, Fixed<127, 100>, Fixed<31, 30>>),
    (Three<Fixed<200, 90>, Fixed<250, 100>, Fixed<100, 30>>),
    (Three<Fixed<31, 16>, Fixed<31, 16>, Fixed<20, -12>>)) {
  using N = typename TestType::Numerator;
  using D = typename TestType::Denominator;
  using T = typename TestType::Result;
  constexpr int shift = T::frac - N::frac + D::frac;
  Random random(0x20e1);
  INFO(random);
  int inside = 0, zero = 0;
  for (int i = 0; i < 60'000; ++i) {
    const D d = random_fixed<D>(random);
    N n = random_fixed<N>(random);
    if (random.coin()) {  // n / d at or next to a multiple of half a step of the result
      const BigInteger half_steps = 2 * big_raw(random_fixed<T>(random)) + random.between(0, 1);
      n = fixed_from<N>(Ratio(half_steps * big_raw(d), 1, -shift - 1).floor() +
                        random.between(-1, 1));
    }
    BigInteger floor, nearest;
    if (d == 0) {
      floor = nearest = n > 0 ? big_raw(T::max()) : n < 0 ? big_raw(T::lowest()) : BigInteger(0);
      ++zero;
    } else {
      const Ratio exact(big_raw(n), big_raw(d), shift);
      floor = exact.floor();
      nearest = exact.nearest();
      inside += nearest == clamped<T>(nearest) ? 1 : 0;
    }
    const bool right = big_raw(quotient_floor<T>(n, d)) == clamped<T>(floor) &&
                       big_raw(quotient_nearest<T>(n, d)) == clamped<T>(nearest);
    if (!right) FAIL("raw n = " << big_raw(n) << ", raw d = " << big_raw(d));
  }
  CHECK(inside > 5'000);
  CHECK(zero > 50);
}

TEMPLATE_TEST_CASE("rounding: square roots are the exact ones rounded down and up", "[number]",
                   (Two<q8_8, q8_8>), (Two<q16_16, q16_16>), (Two<q24_8, q16_16>),
                   (Two<Fixed<31, 0>, q16_16>), (Two<Fixed<32, 0>, Fixed<40, 16>>),
                   (Two<Fixed<20, 10>, Fixed<31, 24>>), (Two<Fixed<62, 32>, Fixed<32, 16>>),
                   (Two<Fixed<63, 32>, q8_8>), (Two<Fixed<63, 0>, Fixed<63, 0>>),
                   (Two<Fixed<63, 1>, Fixed<40, 1>>), (Two<Fixed<64, 32>, Fixed<32, 16>>),
                   (Two<Fixed<64, 0>, Fixed<40, 0>>), (Two<Fixed<66, 32>, q16_16>),
                   (Two<Fixed<126, 92>, Fixed<63, 46>>), (Two<Fixed<127, 60>, Fixed<63, 30>>),
                   (Two<Fixed<127, 0>, Fixed<64, 0>>), (Two<Fixed<128, 0>, Fixed<65, 0>>),
                   (Two<Fixed<63, 0>, Fixed<70, 32>>), (Two<Fixed<127, 1>, Fixed<80, 1>>),
                   (Two<Fixed<200, 100>, Fixed<63, 10>>), (Two<Fixed<31, 30>, Fixed<31, -5>>),
                   (Two<Fixed<256, 192>, Fixed<63, 32>>), (Two<Fixed<300, 172>, Fixed<65, 0>>),
                   (Two<Fixed<319, 255>, Fixed<64, 32>>)) {
  using A = typename TestType::First;
  using T = typename TestType::Second;
  constexpr int shift = 2 * T::frac - A::frac;
  Random random(0x20e2);
  INFO(random);
  int inside = 0;
  for (int i = 0; i < 60'000; ++i) {
    A x = random_fixed<A>(random);
    if (random.coin()) {  // a square of a result, or next to one
      const BigInteger root = big_raw(random_fixed<T>(random));
      x = fixed_from<A>(Ratio(root * root, 1, -shift).floor() + random.between(-1, 1));
    }
    const BigInteger result = big_raw(sqrt_floor<T>(x));
    if (x <= 0) {
      REQUIRE(result == 0);
      continue;
    }
    // result^2 <= raw * 2^shift < (result + 1)^2, unless the root is out of the range of T.
    const Ratio square(big_raw(x), 1, shift);
    const BigInteger above = (result + 1) * (result + 1);
    const bool reaches = result * result * square.denominator <= square.numerator;
    const bool stops = square.numerator < above * square.denominator;
    const bool at_end = result == big_raw(T::max());
    if (!reaches || !(stops || at_end)) FAIL("raw " << big_raw(x) << ", root " << result);
    const bool is_exact = result * result * square.denominator == square.numerator;
    const BigInteger up = is_exact || at_end ? result : BigInteger(result + 1);
    if (big_raw(sqrt_ceil<T>(x)) != up) FAIL("raw " << big_raw(x) << ", root up");
    inside += stops ? 1 : 0;
  }
  CHECK(inside > 5'000);
}

TEMPLATE_TEST_CASE("rounding: for floating point the functions are the plain operations",
                   "[number]", float, double) {
  using F = TestType;
  const F x = F(2.75), y = F(-0.5);
  CHECK(floor_to<F>(x) == x);
  CHECK(ceil_to<F>(x) == x);
  CHECK(nearest_to<F>(x) == x);
  CHECK(saturate_to<F>(x) == x);
  CHECK(narrow<3>(x) == x);
  CHECK(narrow_product<3>(x, y) == x * y);
  CHECK(narrow_sum<3>(x, y) == x + y);
  CHECK(narrow_difference<3>(x, y) == x - y);
  CHECK(scale_up<3>(x, 5) == x);
  CHECK(headroom(x) == 0);
  CHECK(quotient_floor<F>(x, y) == x / y);
  CHECK(quotient_nearest<F>(x, y) == x / y);
  CHECK(sqrt_floor<F>(F(6.25)) == F(2.5));
  CHECK(sqrt_ceil<F>(F(6.25)) == F(2.5));
  CHECK(half(x) == F(1.375));
  CHECK(abs(y) == F(0.5));
}
