// SPDX-License-Identifier: MIT
#include "detent/number/filter/unit_length.hpp"

#include <algorithm>
#include <cstdint>
#include <type_traits>

#include "number/big_integer.hpp"
#include "support/catch.hpp"

using namespace detent;
using namespace detent::test;

namespace {

using Numerator = Fixed<63, 46>;
using Denominator = Fixed<61, 60>;
constexpr std::int64_t one = std::int64_t{1} << 60;

// `quotient_floor` has no fast path.
void check(std::int64_t n, std::int64_t d, int error_bits) {
  const auto numerator = Numerator::from_raw(n);
  const auto denominator = Denominator::from_raw(d);
  const auto error = Numerator::from_raw(std::int64_t{1} << error_bits);
  const auto [quotient, is_sure] =
      decide_quotient_floor<q16_16>(Approximate{numerator, error}, denominator);
  const auto least = std::max<std::int64_t>(n - error.raw(), 0);
  CHECK(quotient == quotient_floor<q16_16>(numerator, denominator));
  if (is_sure) CHECK(quotient_floor<q16_16>(Numerator::from_raw(least), denominator) == quotient);
}

}  // namespace

TEST_CASE("decide_quotient_floor: correct however near 1 the denominator is") {
  Random random(20260601);
  INFO(random);
  for (int i = 0; i < 20000; ++i) {
    const std::int64_t n = std::abs(random.edgy(62));
    const std::int64_t e = random.coin() ? random.wide(33) : random.wide(59);
    check(n, one + e, static_cast<int>(random.below(33)));
    // A multiple of the denominator on the result's grid, and its neighbours.
    const std::int64_t multiple = random.between(0, (std::int64_t{1} << 31) - 1) << 30;
    for (const int k : {-1, 0, 1}) check(std::max<std::int64_t>(multiple + k, 0), one, i % 33);
  }
}

TEST_CASE("divide_by_length: correct at every step and next to it") {
  Random random(20260602);
  INFO(random);
  const auto check_one = [](auto n, auto d, auto unit) {
    using T = decltype(unit);
    // floor(sqrt(n^2 / d)) on the grid of T.
    const BigInteger squared = (big_raw(n) * big_raw(n)) / big_raw(d);
    constexpr int shift = 2 * (decltype(n)::frac - T::frac) - decltype(d)::frac;
    static_assert(shift == 0);
    CHECK(big_raw(divide_by_length<T>(n, d)) == clamped<T>(sqrt(squared)));
  };
  for (int i = 0; i < 20000; ++i) {
    const auto d = Denominator::from_raw(one + (random.coin() ? random.wide(32) : 0));
    check_one(Numerator::from_raw(random.edgy(62)), d, q16_16());
    // A multiple of the root of the denominator, and its neighbours.
    const BigInteger k = random.between(0, (std::int64_t{1} << 31) - 1);
    const BigInteger n = sqrt(BigInteger(k * k * big_raw(d)));
    for (const int j : {-1, 0, 1, 2}) check_one(fixed_from<Numerator>(n + j), d, q16_16());

    const auto small =
        Fixed<29, 28>::from_raw((1 << 28) + static_cast<std::int32_t>(random.edgy(16)));
    check_one(Fixed<31, 22>::from_raw(static_cast<std::int32_t>(random.edgy(30))), small, q8_8());
    const BigInteger m = sqrt(BigInteger((k % 32768) * (k % 32768) * big_raw(small)));
    for (const int j : {0, 1}) check_one(fixed_from<Fixed<31, 22>>(m + j), small, q8_8());
  }
}

TEST_CASE("decide_unit_quotient: correct next to midpoints, and unsure only there") {
  Random random(20261127);
  INFO(random);
  const auto check_near = [&]<int F>(auto unit, std::integral_constant<int, F>) {
    using T = decltype(unit);
    using Number = Fixed<F + 1, F>;
    using Raw = typename Number::raw_type;
    constexpr int shift = F - T::frac;
    constexpr std::int64_t one_raw = std::int64_t{1} << F, most = (std::int64_t{4} << F / 2) + 4;
    int wrong = 0, needless = 0, unsure = 0;
    for (int i = 0; i < 20000; ++i) {
      const bool is_far = random.one_in(4);
      const std::int64_t e = random.coin() ? (random.coin() ? most : -most)
                             : is_far      ? random.between(-one_raw / 2, one_raw / 2)
                                           : random.between(-most, most);
      const auto d = Number::from_raw(static_cast<Raw>(one_raw + e));
      // Next to a midpoint: (2 k + 1) / 2 steps, times d.
      const std::int64_t limit = std::int64_t{1} << T::frac;
      const BigInteger odd = 2 * random.between(-limit, limit - 1) + 1;
      const BigInteger middle = odd * big_raw(d) / power_of_two(T::frac + 1);
      for (const int away : {0, 1, 2, 4, 8, 16, 32, 64}) {
        const BigInteger n = middle + (random.coin() ? away : -away);
        if (abs(n) > big_raw(d)) continue;
        const auto numerator = fixed_from<Number>(n);
        const auto decided = decide_unit_quotient<T>(numerator, d);
        const auto exact = quotient_nearest<T>(numerator, d);
        wrong += decided.is_sure && decided.value != exact ? 1 : 0;
        const bool is_near = -most <= e && e <= most;
        needless += is_near && away == 64 && shift > 8 && !decided.is_sure ? 1 : 0;
        unsure += is_near && !decided.is_sure ? 1 : 0;
      }
    }
    CHECK(wrong == 0);
    CHECK(needless == 0);
    CHECK(unsure > 50'000);
  };
  check_near(Fixed<31, 30>(), std::integral_constant<int, 60>());
  check_near(Fixed<15, 14>(), std::integral_constant<int, 28>());
}
