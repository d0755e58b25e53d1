// SPDX-License-Identifier: MIT
#include "detent/number/fixed.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <compare>
#include <concepts>
#include <cstdint>
#include <functional>
#include <limits>
#include <type_traits>
#include <unordered_set>
#include <utility>

#include "detent/number/rounding.hpp"
#include "detent/number/text.hpp"
#include "number/big_integer.hpp"
#include "support/catch.hpp"

using namespace detent;
using namespace detent::test;

namespace {

template <class T, int Bits, int Frac>
concept Is = std::same_as<std::remove_cvref_t<T>, Fixed<Bits, Frac>>;

template <class A, class B>
using Sum = decltype(std::declval<A>() + std::declval<B>());
template <class A, class B>
using Product = decltype(std::declval<A>() * std::declval<B>());

// The containers.
static_assert(std::same_as<q8_8::raw_type, std::int16_t> && sizeof(q8_8) == 2);
static_assert(std::same_as<q14_16::raw_type, std::int32_t> && sizeof(q16_16) == 4);
static_assert(std::same_as<Fixed<16, 0>::raw_type, std::int32_t>);
static_assert(std::same_as<Fixed<32, 0>::raw_type, std::int64_t>);
static_assert(std::same_as<Fixed<64, 0>::raw_type, Int128> && sizeof(Fixed<127, 0>) == 16);
static_assert(std::same_as<Fixed<128, 0>::raw_type, Wide<4>> && sizeof(Fixed<255, 0>) == 32);
static_assert(std::same_as<Fixed<256, 0>::raw_type, Wide<5>> && sizeof(Fixed<319, 0>) == 40);
static_assert(std::is_trivially_copyable_v<q16_16> && std::is_trivially_copyable_v<Fixed<255, 0>>);
static_assert(std::is_nothrow_default_constructible_v<q16_16> && q16_16().raw() == 0);
static_assert(q16_16::bits == 31 && q16_16::frac == 16);

// The types of results: enough bits, and room for +2^Bits if the operands can produce it.
static_assert(Is<Sum<q16_16, q16_16>, 32, 16> && Is<Sum<q14_16, q14_16>, 30, 16>);
static_assert(Is<Sum<Fixed<30, 16>, Fixed<30, 16>>, 32, 16>, "31 fills its container");
static_assert(Is<Sum<q16_16, Fixed<30, 30>>, 46, 30> && Is<Sum<q8_8, q16_16>, 32, 16>);
static_assert(Is<decltype(q16_16() - q14_16()), 32, 16> && Is<decltype(q8_8() - q8_8()), 16, 8>);
static_assert(Is<Product<q16_16, q16_16>, 62, 32> && Is<Product<q8_8, q8_8>, 30, 16>);
static_assert(Is<Product<Fixed<32, 16>, Fixed<31, 30>>, 64, 46>, "63 fills its container");
static_assert(Is<Product<Fixed<63, 20>, Fixed<64, 10>>, 128, 30>);
static_assert(Is<decltype(-q16_16()), 32, 16> && Is<decltype(-q14_16()), 29, 16>);
static_assert(Is<decltype(abs(q8_8())), 16, 8> && Is<decltype(abs(q14_16())), 29, 16>);
static_assert(-q16_16::lowest() == 32768 && abs(q16_16::lowest()) == 32768);
static_assert(-q14_16::lowest() == 8192 && q14_16::lowest() * q14_16::lowest() == 67108864);
static_assert(q16_16::lowest() * q16_16::lowest() == 1073741824);

// Conversions that lose bits do not compile.
static_assert(!std::is_convertible_v<Product<q16_16, q16_16>, q16_16>);
static_assert(!std::is_constructible_v<q16_16, Product<q16_16, q16_16>>);
static_assert(!std::is_assignable_v<q16_16&, Sum<q16_16, q16_16>>);
static_assert(!std::is_constructible_v<q24_8, q16_16> && !std::is_constructible_v<q16_16, q24_8>);
static_assert(!std::is_constructible_v<q14_16, q16_16> &&
              !std::is_constructible_v<Fixed<31, 30>, q16_16>);
static_assert(!std::is_constructible_v<q16_16, decltype(-q16_16())>);
static_assert(!std::is_constructible_v<Fixed<31, 16>, Fixed<30, 15>>, "2^30 doubled is out");
// Lossless conversions are implicit, except from integers, whose unit is easily mistaken.
static_assert(std::is_convertible_v<q14_16, q16_16> && std::is_convertible_v<q8_8, q16_16>);
static_assert(std::is_convertible_v<q16_16, Fixed<63, 32>> && std::is_convertible_v<q8_8, q24_8>);
static_assert(std::is_convertible_v<Fixed<15, 0>, Fixed<31, 16>>);
static_assert(std::is_constructible_v<q16_16, int> && !std::is_convertible_v<int, q16_16>);
static_assert(!std::is_constructible_v<q16_16, double> && !std::is_convertible_v<q16_16, double>);
static_assert(std::is_constructible_v<double, q16_16> && !std::is_constructible_v<int, q16_16>);
static_assert(!std::is_constructible_v<bool, q16_16>);
static_assert(!std::is_assignable_v<q16_16&, double> && !std::is_convertible_v<float, q16_16>);

// Conversions from other types clamp to the range.
static_assert(q16_16::max().raw() == std::numeric_limits<std::int32_t>::max());
static_assert(q16_16::lowest().raw() == std::numeric_limits<std::int32_t>::min());
static_assert(q14_16::max().raw() == (1 << 29) - 1 && q14_16::lowest().raw() == -(1 << 29));
static_assert(q14_16::from_raw(1 << 29) == q14_16::max());
static_assert(q14_16::from_raw(std::numeric_limits<std::int32_t>::min()) == q14_16::lowest());
static_assert(q16_16(32767).raw() == 32767 * 65536 && q16_16(-32768) == q16_16::lowest());
static_assert(saturate_to<q16_16>(32768) == q16_16::max());
static_assert(saturate_to<q16_16>(-32769) == q16_16::lowest());
static_assert(saturate_to<q16_16>(std::numeric_limits<std::int64_t>::min()) == q16_16::lowest());
static_assert(saturate_to<q8_8>(std::numeric_limits<std::uint64_t>::max()) == q8_8::max());
static_assert(q8_8(true) == 1 && q8_8('\x05') == 5 && q16_16(std::int8_t{-7}) == -7);
static_assert(saturate_to<Fixed<14, 14>>(1) == Fixed<14, 14>::max(),
              "+2^Bits comes from arithmetic only");

// Comparisons compare values, not bits.
static_assert(q16_16(1) == q8_8(1) && q16_16(1) == 1 && 1 == q16_16(1) && q16_16(2) > 1);
static_assert(q16_16(-1) < 0u && q16_16(-1) < std::numeric_limits<std::uint64_t>::max());
static_assert(0 < q16_16::from_raw(1) && q16_16::from_raw(-1) < 0 && q16_16::from_raw(65537) > 1);
static_assert(q16_16::max() < 32768 && q16_16::lowest() == -32768 && q16_16(1) != 2);
static_assert((q16_16(1) <=> q24_8(2)) == std::strong_ordering::less);
static_assert((q24_8(2) <=> q16_16(1)) == std::strong_ordering::greater);
static_assert(std::is_same_v<decltype(q16_16() <=> 0), std::strong_ordering>);
// 350 bits apart: no integer type fits both.
static_assert(Fixed<300, 0>(1) > Fixed<300, 300>::max() && Fixed<300, 0>() < Fixed<20, 319>::max());
static_assert(Fixed<319, 0>::lowest() < Fixed<319, 319>::lowest() &&
              Fixed<9, 0>() == Fixed<9, 319>());

template <class F>
constexpr F plus(F x, int y) {
  x += y;
  return x;
}
static_assert(plus(q16_16(2), 3) == 5 && plus(q8_8(100), -300 + 200) == 0);
static_assert([] {
  q16_16 position(3);
  const q16_16 velocity = q16_16::from_raw(3 << 15), dt = q16_16::from_raw(65536 / 64);
  position += velocity * dt;  // typical game code
  position -= q16_16::from_raw(1);
  position *= q16_16::from_raw(1 << 15);
  return position.raw() == ((3 * 65536 + 1536 - 1) / 2 + 1);  // the tie goes to the even 99072
}());

template <class A, class B>
struct Two {
  using First = A;
  using Second = B;
};

// Products over 255 bits may not compile, so some pairs are only compared and added.
template <class A, class B>
inline constexpr bool has_product = A::bits + B::bits <= 318;
template <class A, class B>
inline constexpr bool has_sum =
    std::max(A::bits - A::frac, B::bits - B::frac) + std::max(A::frac, B::frac) <= 317;

// All compared in one assertion, because an assertion costs more than its condition.
template <class A, class B>
bool order_is(const A& a, const B& b, std::strong_ordering order) {
  return (a <=> b) == order && (b <=> a) == (0 <=> order) && (a == b) == (order == 0) &&
         (a != b) == (order != 0) && (a < b) == (order < 0) && (a <= b) == (order <= 0) &&
         (a > b) == (order > 0) && (a >= b) == (order >= 0) && (b < a) == (order > 0);
}

template <class A, class B>
void check_order(const A& a, const B& b, const BigRational& x, const BigRational& y) {
  const int sign = x.compare(y);
  const auto order = sign < 0   ? std::strong_ordering::less
                     : sign > 0 ? std::strong_ordering::greater
                                : std::strong_ordering::equal;
  if (!order_is(a, b, order)) FAIL("a = " << x << ", b = " << y);
}

}  // namespace

// clang-format off
#define DETENT_TEST_PAIRS                                                                      \
  (Two<q8_8, q8_8>), (Two<q14_16, q14_16>), (Two<q16_16, q16_16>), (Two<q8_8, q16_16>),        \
  (Two<q24_8, q16_16>), (Two<q16_16, Fixed<30, 30>>), (Two<Fixed<32, 16>, Fixed<31, 30>>),     \
  (Two<Fixed<15, 30>, Fixed<15, 0>>), (Two<Fixed<62, 32>, Fixed<62, 60>>),                     \
  (Two<Fixed<63, 32>, q16_16>), (Two<Fixed<63, 0>, Fixed<63, 63>>),                            \
  (Two<Fixed<64, 32>, Fixed<63, 33>>), (Two<Fixed<100, 20>, Fixed<27, 0>>),                    \
  (Two<Fixed<127, 60>, Fixed<63, 10>>), (Two<Fixed<127, 64>, Fixed<127, 0>>),                  \
  (Two<Fixed<128, 64>, Fixed<127, 100>>), (Two<Fixed<150, 20>, Fixed<160, 100>>),              \
  (Two<Fixed<31, -4>, Fixed<20, 50>>), (Two<Fixed<255, 0>, Fixed<63, 63>>),                    \
  (Two<Fixed<255, 0>, Fixed<255, 255>>), (Two<Fixed<319, 100>, Fixed<319, 319>>),              \
  (Two<Fixed<1, 250>, Fixed<40, -200>>)
// clang-format on

TEMPLATE_TEST_CASE("Fixed: sums, differences and products are exact", "[number]",
                   DETENT_TEST_PAIRS) {
  using A = typename TestType::First;
  using B = typename TestType::Second;
  Random random(0xf18ed);
  INFO(random);
  for (int i = 0; i < 50'000; ++i) {
    const A a = random_fixed<A>(random);
    const B b = random_fixed<B>(random);
    // Both in units of the finer grid, so that the oracle needs no fractions.
    constexpr int frac = std::max(A::frac, B::frac);
    const BigInteger x = big_raw(a) << (frac - A::frac), y = big_raw(b) << (frac - B::frac);
    const auto is = [](const auto& result, const BigInteger& expected) {
      return big_raw(result) == expected && abs(expected) <= power_of_two(result.bits);
    };
    bool exact = true;
    if constexpr (has_sum<A, B>) {
      static_assert(Sum<A, B>::frac == frac);
      exact = is(a + b, x + y) && is(a - b, x - y) && is(b - a, y - x);
    }
    if constexpr (has_product<A, B>) {
      static_assert(Product<A, B>::frac == A::frac + B::frac);
      exact = exact && is(a * b, big_raw(a) * big_raw(b));
    }
    if constexpr (A::bits < 319) {
      exact = exact && is(-a, -big_raw(a)) && is(abs(a), abs(big_raw(a)));
    }
    if (!exact) FAIL("a = " << rational(a) << ", b = " << rational(b));
  }
}

TEMPLATE_TEST_CASE("Fixed: comparisons between types are exact", "[number]", DETENT_TEST_PAIRS) {
  using A = typename TestType::First;
  using B = typename TestType::Second;
  Random random(0xf18ee);
  INFO(random);
  HitRate near;
  for (int i = 0; i < 50'000; ++i) {
    const A a = random_fixed<A>(random);
    const BigRational x = rational(a);
    // Half the time the closest B, or one next to it.
    const bool beside = random.coin();
    const B b = beside ? fixed_from<B>(floor_of(on_grid<B>(x)) + random.between(-1, 1))
                       : random_fixed<B>(random);
    const BigRational y = rational(b);
    check_order(a, b, x, y);
    near.count(beside);
  }
  CHECK(near.is_balanced());
}

TEMPLATE_TEST_CASE("Fixed: comparisons with integers are exact", "[number]", q8_8, q16_16, q24_8,
                   (Fixed<30, 30>), (Fixed<63, 32>), (Fixed<64, 0>), (Fixed<31, -8>),
                   (Fixed<127, 64>), (Fixed<200, 10>), (Fixed<319, 319>)) {
  Random random(0xf18ef);
  INFO(random);
  const auto sweep = [&random]<class I>(I) {
    for (int i = 0; i < 3'000; ++i) {
      const TestType a = random_fixed<TestType>(random);
      const BigRational x = rational(a);
      const BigInteger beside = floor_of(x) + random.between(-1, 1);
      const bool reachable =
          beside >= std::numeric_limits<I>::min() && beside <= std::numeric_limits<I>::max();
      const I b = reachable && random.coin() ? integer_from<I>(beside) : random_integer<I>(random);
      check_order(a, b, x, BigRational(b));
    }
  };
  sweep(std::int8_t{});
  sweep(std::uint8_t{});
  sweep(std::int16_t{});
  sweep(int{});
  sweep(unsigned{});
  sweep(std::int64_t{});
  sweep(std::uint64_t{});
}

TEMPLATE_TEST_CASE("Fixed: an implicit conversion keeps the value", "[number]", DETENT_TEST_PAIRS,
                   (Two<q14_16, q16_16>), (Two<Fixed<30, 16>, q16_16>),
                   (Two<Fixed<31, 15>, Fixed<32, 16>>), (Two<Fixed<15, 0>, q16_16>),
                   (Two<Fixed<31, 0>, Fixed<63, 32>>), (Two<Fixed<30, 0>, Fixed<62, 32>>),
                   (Two<Fixed<63, 0>, Fixed<127, 64>>), (Two<Fixed<127, 1>, Fixed<255, 129>>),
                   (Two<Fixed<31, -16>, Fixed<63, 16>>), (Two<Fixed<64, 0>, Fixed<128, 64>>),
                   (Two<Fixed<62, 0>, Fixed<63, 1>>), (Two<Fixed<63, 0>, Fixed<64, 1>>)) {
  using A = typename TestType::First;
  using B = typename TestType::Second;
  // Convertible exactly if every value of one type is one of the other, +2^Bits included.
  const auto convertible = []<class From, class To>(From, To) {
    const BigRational low = rational(fixed_from<From>(-power_of_two(From::bits)));
    const BigRational high = rational(fixed_from<From>(power_of_two(From::bits)));
    const BigRational to_low = rational(fixed_from<To>(-power_of_two(To::bits)));
    const BigRational to_high = rational(fixed_from<To>(power_of_two(To::bits)));
    const bool holds = From::frac <= To::frac && low >= to_low && high <= to_high;
    CHECK(std::is_convertible_v<From, To> == holds);
  };
  convertible(A(), B());
  convertible(B(), A());
  Random random(0xf18f0);
  INFO(random);
  for (int i = 0; i < 2'000; ++i) {
    const A a = random_fixed<A>(random);
    if constexpr (std::is_convertible_v<A, B>) {
      const B b = a;
      REQUIRE(rational(b) == rational(a));
    }
  }
}

TEMPLATE_TEST_CASE("Fixed: an integer becomes itself or an end of the range", "[number]", q8_8,
                   q14_16, q16_16, q24_8, (Fixed<14, 14>), (Fixed<10, 40>), (Fixed<63, 0>),
                   (Fixed<63, 32>), (Fixed<64, 0>), (Fixed<100, 90>), (Fixed<200, 0>),
                   (Fixed<20, -8>), (Fixed<3, -60>)) {
  Random random(0xf18f1);
  INFO(random);
  const auto sweep = [&random]<class I>(I) {
    for (int i = 0; i < 3'000; ++i) {
      const I value = random_integer<I>(random);
      const BigInteger exact = floor_of(on_grid<TestType>(BigRational(value)));
      const BigInteger nearest = nearest_of(on_grid<TestType>(BigRational(value)));
      if (big_raw(saturate_to<TestType>(value)) != clamped<TestType>(nearest)) {
        FAIL(BigInteger(value));
      }
#if DETENT_ASSERTIONS
      if (detail::is_out_of_range<TestType>(value)) continue;  // rejected by an assertion
#endif
      if (big_raw(TestType(value)) != clamped<TestType>(exact)) FAIL(BigInteger(value));
    }
  };
  sweep(std::int8_t{});
  sweep(std::uint8_t{});
  sweep(std::int16_t{});
  sweep(std::uint16_t{});
  sweep(int{});
  sweep(unsigned{});
  sweep(std::int64_t{});
  sweep(std::uint64_t{});
}

TEMPLATE_TEST_CASE("Fixed: raw bits outside the budget are clamped", "[number]", q8_8, q14_16,
                   q16_16, (Fixed<1, 0>), (Fixed<40, 0>), (Fixed<90, 0>), (Fixed<140, 0>),
                   (Fixed<300, 0>)) {
  Random random(0xf18f2);
  INFO(random);
  for (int i = 0; i < 10'000; ++i) {
    const auto raw = random_integer<typename TestType::raw_type>(random);
    REQUIRE(big_raw(TestType::from_raw(raw)) == clamped<TestType>(big(raw)));
  }
}

TEMPLATE_TEST_CASE("Fixed: compound assignment rounds the exact result once", "[number]",
                   (Two<q8_8, q8_8>), (Two<q14_16, q14_16>), (Two<q16_16, q16_16>),
                   (Two<q16_16, q24_8>), (Two<q24_8, q16_16>), (Two<q16_16, Fixed<30, 30>>),
                   (Two<q16_16, Fixed<62, 32>>), (Two<Fixed<63, 32>, q16_16>),
                   (Two<Fixed<100, 50>, Fixed<60, 55>>)) {
  using A = typename TestType::First;
  using B = typename TestType::Second;
  Random random(0xf18f3);
  INFO(random);
  HitRate in_range;
  const auto check = [&](const A& assigned, const BigRational& exact, auto assign) {
    const bool fits = exact >= rational(A::lowest()) && exact <= rational(A::max());
    in_range.count(fits);
#if DETENT_ASSERTIONS
    if (!fits) return;  // an assertion rejects it; a release build clamps
#endif
    A result = assigned;
    const A& same = assign(result);
    const BigInteger expected = clamped<A>(nearest_of(on_grid<A>(exact)));
    if (&same != &result || big_raw(result) != expected) {
      FAIL(assigned << " assigned " << exact << " became " << result);
    }
  };
  for (int i = 0; i < 5'000; ++i) {
    const A a = random_fixed<A>(random);
    const B b = random_fixed<B>(random);
    const int n = random_integer<std::int16_t>(random);
    const BigRational x = rational(a), y = rational(b);
    check(a, x + y, [&](A& r) -> A& { return r += b; });
    check(a, x - y, [&](A& r) -> A& { return r -= b; });
    check(a, x * y, [&](A& r) -> A& { return r *= b; });
    check(a, x + n, [&](A& r) -> A& { return r += n; });
    check(a, x - n, [&](A& r) -> A& { return r -= n; });
    check(a, x * n, [&](A& r) -> A& { return r *= n; });
  }
  INFO(in_range);
  CHECK(in_range.percent() >= 30);
  CHECK(in_range.percent() < 100);
}

namespace {

BigRational rational_of(double value) {
  int exponent = 0;
  const double mantissa = std::frexp(value, &exponent);
  const BigRational whole = static_cast<std::int64_t>(std::ldexp(mantissa, 53));
  return exponent >= 53 ? BigRational(whole * power_of_two(exponent - 53))
                        : BigRational(whole / power_of_two(53 - exponent));
}

}  // namespace

TEMPLATE_TEST_CASE("Fixed: a double becomes the nearest number", "[number]", q8_8, q14_16, q16_16,
                   q24_8, (Fixed<14, 14>), (Fixed<30, 30>), (Fixed<31, 0>), (Fixed<63, 32>),
                   (Fixed<63, 0>), (Fixed<62, 62>), (Fixed<20, 60>), (Fixed<20, -8>),
                   (Fixed<20, 900>)) {
  using F = TestType;
  using Limits = std::numeric_limits<double>;
  CHECK(F::from_double(Limits::quiet_NaN()) == 0);
  CHECK(F::from_double(-Limits::signaling_NaN()) == 0);
  CHECK(F::from_double(Limits::infinity()) == F::max());
  CHECK(F::from_double(-Limits::infinity()) == F::lowest());
  CHECK(F::from_double(Limits::max()) == F::max());
  CHECK(F::from_double(Limits::lowest()) == F::lowest());
  CHECK(F::from_double(-0.0).raw() == 0);
  CHECK(F::from_double(Limits::denorm_min()).raw() == 0);
  Random random(0xf18f4);
  INFO(random);
  for (int i = 0; i < 20'000; ++i) {
    double value = std::bit_cast<double>(random.next());
    if (!random.one_in(4)) {
      // In the range of F: values with few bits are often ties, those with many bits are next to
      // one.
      const double step = std::ldexp(1.0, -F::frac - 1);
      value = static_cast<double>(random.wide(F::bits < 53 ? F::bits + 2 : 62)) * step;
      if (random.coin()) value = std::nextafter(value, random.coin() ? 1e300 : -1e300);
    }
    if (!std::isfinite(value)) continue;
    const BigInteger nearest = nearest_of(on_grid<F>(rational_of(value)));
    if (big_raw(F::from_double(value)) != clamped<F>(nearest)) FAIL(value);
  }
}

TEMPLATE_TEST_CASE("Fixed: becomes the nearest double", "[number]", q8_8, q14_16, q16_16, q24_8,
                   (Fixed<30, 30>), (Fixed<63, 32>), (Fixed<64, 0>), (Fixed<63, -20>),
                   (Fixed<127, 64>), (Fixed<200, 90>), (Fixed<319, 319>)) {
  Random random(0xf18f5);
  INFO(random);
  for (int i = 0; i < 20'000; ++i) {
    const TestType x = random_fixed<TestType>(random);
    const double value = static_cast<double>(x);
    const BigRational exact = rational(x), error = abs(rational_of(value) - exact);
    const BigRational above = abs(rational_of(std::nextafter(value, 1e300)) - exact);
    const BigRational below = abs(rational_of(std::nextafter(value, -1e300)) - exact);
    const bool is_even = (std::bit_cast<std::uint64_t>(value) & 1) == 0;
    const bool is_nearest =
        error < std::min(above, below) || (is_even && error == std::min(above, below));
    if (!is_nearest) FAIL(exact << " became " << value);
    if constexpr (TestType::bits <= 53) {
      if (x <= TestType::max()) REQUIRE(TestType::from_double(value) == x);
    }
  }
}

TEST_CASE("Fixed: can be used as a key", "[number]") {
  std::unordered_set<q16_16> keys;
  for (int i = -500; i < 500; ++i) keys.insert(q16_16::from_raw(i * 4099));
  CHECK(keys.size() == 1'000);
  CHECK(keys.contains(q16_16::from_raw(4099)));
  CHECK_FALSE(keys.contains(q16_16::from_raw(4098)));
  CHECK(std::hash<q8_8>()(q8_8(3)) == std::hash<q8_8>()(q8_8(3)));
  CHECK(std::hash<Fixed<63, 0>>()(Fixed<63, 0>(1)) != std::hash<Fixed<63, 0>>()(Fixed<63, 0>(2)));
}
