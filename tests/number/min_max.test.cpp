// SPDX-License-Identifier: MIT
#include "detent/number/min_max.hpp"

#include <algorithm>
#include <concepts>
#include <type_traits>

#include "detent/number/literals.hpp"
#include "number/big_integer.hpp"
#include "support/catch.hpp"

using namespace detent::literals;
using namespace detent::test;
using detent::Fixed, detent::q14_16, detent::q16_16, detent::q24_8, detent::q8_8;

namespace {

// The type represents every number of both, and no more.
static_assert(std::same_as<detent::common_fixed<q16_16, q14_16>, q16_16>);
static_assert(std::same_as<detent::common_fixed<q8_8, q16_16>, q16_16>);
static_assert(std::same_as<detent::common_fixed<q16_16, q24_8>, Fixed<39, 16>>);
static_assert(std::same_as<detent::common_fixed<Fixed<32, 16>, q16_16>, Fixed<32, 16>>);
static_assert(std::same_as<detent::common_fixed<Fixed<30, 15>, q16_16>, Fixed<32, 16>>, "2^31");
static_assert(std::same_as<decltype(detent::min(q16_16(), q16_16())), q16_16>);

// A limit of another type than the number determines the type; a finer grid is kept.
static_assert(std::same_as<decltype(detent::clamp(Fixed<48, 16>(), q16_16(), q14_16())), q16_16>);
static_assert(
    std::same_as<decltype(detent::clamp(Fixed<62, 32>(), q16_16(), q16_16())), Fixed<47, 32>>);
static_assert(detent::clamp(q16_16::max() * 2_q16_16, -1_q16_16, 1.5_q16_16) == 1.5_q16_16);
static_assert(detent::clamp(1_q8_8, 2_q16_16, 40_q16_16) == 2);

// With `using namespace` for both, our numbers use ours and other types use std's.
namespace both {
using namespace std;
using namespace detent;
static_assert(same_as<decltype(min(1_q16_16, 2_q16_16)), q16_16> && max(1_q8_8, 2_q8_8) == 2 &&
              clamp(5_q16_16, 1_q16_16, 2_q16_16) == 2);
static_assert(min(1_q16_16, 2_q8_8) == 1 && max(-1_q24_8, -2_q8_8) == -1);
static_assert(min(1, 2) == 1 && max(1.5, 2.5) == 2.5 && clamp(0.5f, 1.0f, 2.0f) == 1.0f);
static_assert(max({1_q16_16, 3_q16_16, 2_q16_16}) == 3);
}  // namespace both

template <class A, class B>
concept HasMin = requires(A a, B b) {
  detent::min(a, b);
  detent::max(a, b);
};
template <class A, class B>
concept HasClamp = requires(A a, B b) {
  detent::clamp(a, b, b);
};
static_assert(HasMin<q16_16, q8_8> && HasClamp<q16_16, q8_8> && !HasMin<q16_16, int> &&
              !HasMin<double, q16_16> && !HasClamp<q16_16, int> && !HasClamp<q16_16, double>);

template <class A, class B>
struct Two {
  using First = A;
  using Second = B;
};

TEMPLATE_TEST_CASE("min, max, clamp: return the exact numbers, for any two types", "[number]",
                   (Two<q16_16, q16_16>), (Two<q16_16, q8_8>), (Two<q24_8, q16_16>),
                   (Two<Fixed<62, 32>, q16_16>), (Two<Fixed<30, 15>, q16_16>),
                   (Two<Fixed<5, 40>, Fixed<126, 3>>)) {
  using A = typename TestType::First;
  using B = typename TestType::Second;
  Random random(0x3a5);
  INFO(random);
  for (int i = 0; i < 3'000; ++i) {
    const A a = random_fixed<A>(random);
    const B b = random_fixed<B>(random), c = random_fixed<B>(random);
    const B low = detent::min(b, c), high = detent::max(b, c);
    const BigRational x = rational(a), least = rational(low), greatest = rational(high);
    const BigRational clamped = x < least ? least : greatest < x ? greatest : x;
    const bool right = rational(detent::min(a, b)) == std::min(x, rational(b)) &&
                       rational(detent::max(a, b)) == std::max(x, rational(b)) &&
                       rational(detent::min(b, a)) == std::min(x, rational(b)) &&
                       rational(detent::max(b, a)) == std::max(x, rational(b)) &&
                       rational(detent::clamp(a, low, high)) == clamped;
    if (!right) FAIL(x << ", " << rational(b) << ", " << rational(c));
  }
}

}  // namespace
