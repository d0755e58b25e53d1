// SPDX-License-Identifier: MIT
#include "detent/number/filter/unit_length.hpp"

#include <algorithm>
#include <cstdint>

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
