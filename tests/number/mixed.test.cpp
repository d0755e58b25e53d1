// SPDX-License-Identifier: MIT
#include "detent/number/mixed.hpp"

#include <concepts>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "detent/number/literals.hpp"
#include "detent/number/rounding.hpp"
#include "number/big_integer.hpp"
#include "support/catch.hpp"

using namespace detent;
using namespace detent::literals;
using namespace detent::test;

namespace {

// An integer counts with all bits of its type.
static_assert(std::same_as<decltype(q16_16() * 2), Fixed<62, 16>>);
static_assert(std::same_as<decltype(2 * q16_16()), Fixed<62, 16>>);
static_assert(std::same_as<decltype(1 + q16_16()), Fixed<48, 16>>);
static_assert(std::same_as<decltype(q8_8() - std::int8_t{1}), Fixed<16, 8>>);
static_assert(q16_16::max() * std::numeric_limits<int>::lowest() ==
              -(q16_16::max() * 2147483647) - q16_16::max());
static_assert(1.5_q16_16 * 2 == 3 && 1 + 1.5_q16_16 == 2.5_q16_16 && 1 - 1.5_q16_16 == -0.5_q16_16);
static_assert(1.5_q16_16 - 1u == 0.5_q16_16 && -1 * 1.5_q16_16 == -1.5_q16_16);
static_assert([] {
  auto x = 1.5_q16_16;
  x += 1;
  x *= 3;
  x -= 2u;
  return x;
}() == 5.5_q16_16);

// Operations without an exact result, or with floating point, are rejected.
template <class A, class B>
concept Divides = requires(A a, B b) {
  a / b;
};
template <class A, class B>
concept DividesInPlace = requires(A& a, B b) {
  a /= b;
};
template <class A, class B>
concept Adds = requires(A a, B b) {
  a + b;
};
template <class A, class B>
concept Multiplies = requires(A a, B b) {
  a* b;
};
template <class A, class B>
concept AddsInPlace = requires(A& a, B b) {
  a += b;
};
template <class A, class B>
concept Compares = requires(A a, B b) {
  a == b;
};
template <class A, class B>
concept Orders = requires(A a, B b) {
  a < b;
};
static_assert(!Divides<q16_16, q16_16> && !Divides<q16_16, int> && !Divides<int, q16_16> &&
              !Divides<q16_16, double> && !DividesInPlace<q16_16, int>);
static_assert(!Adds<q16_16, double> && !Adds<float, q16_16> && !Multiplies<q16_16, double> &&
              !Multiplies<float, q16_16> && !AddsInPlace<q16_16, double>);
static_assert(!Compares<q16_16, double> && !Compares<float, q16_16> && !Orders<q16_16, double> &&
              !Orders<float, q16_16>);
static_assert(Adds<q16_16, q8_8> && Adds<q16_16, long> && AddsInPlace<q16_16, short> &&
              Compares<q16_16, int> && Orders<unsigned, q16_16>);

TEMPLATE_TEST_CASE("mixed: sums, differences and products with integers are exact", "[number]",
                   q16_16, q8_8, (Fixed<62, 32>), (Fixed<20, -3>)) {
  Random random(0x20261122);
  INFO(random);
  const auto sweep = [&random]<class I>(I) {
    for (int i = 0; i < 2'000; ++i) {
      const auto x = random_fixed<TestType>(random);
      const I n = random_integer<I>(random);
      const BigRational exact = rational(x), whole = BigRational(n);
      const bool right = rational(x + n) == exact + whole && rational(n + x) == exact + whole &&
                         rational(x - n) == exact - whole && rational(n - x) == whole - exact &&
                         rational(x * n) == exact * whole && rational(n * x) == exact * whole;
      if (!right) FAIL(exact << " and " << whole);
    }
  };
  sweep(std::int8_t{});
  sweep(int{});
  sweep(std::uint64_t{});
}

}  // namespace
