// SPDX-License-Identifier: MIT
#include "detent/number/filter/short_vector.hpp"

#include <cstdlib>

#include "number/big_integer.hpp"
#include "support/catch.hpp"

namespace detent::test {
namespace {

template <std::size_t N>
void check_steps(std::uint64_t seed) {
  using T = q16_16;
  Random random(seed);
  for (int i = 0; i < 4000; ++i) {
    std::array<T, N> v;
    const int bits = static_cast<int>(random.below(32));
    for (auto& c : v) c = T::from_raw(static_cast<std::int32_t>(random.edgy(bits)));
    if (v == std::array<T, N>{}) continue;
    CAPTURE(seed, i);
    const ShortVector vector(v);
    const auto unit = vector.unit();
    BigInteger squared = 0;
    for (const auto& c : v) squared += big_raw(c) * big_raw(c);
    const auto size = std::abs(random.edgy(random.coin() ? 31 : 2));
    const auto raw = static_cast<std::int32_t>((std::min)(size, (std::int64_t{1} << 31) - 1));
    for (const auto& length : {T::from_raw(raw), T::from_raw(-raw)}) {
      const auto steps = unit.steps(length);
      for (std::size_t k = 0; k < N; ++k) {
        // (part - margin) |v| < length v < (part + margin) |v|, where (x |v|)^2 has the sign of x.
        const BigInteger exact = (big_raw(length) * big_raw(v[k])) << 30;
        const BigInteger part = big_raw(steps.value[k]), margin = steps.error.raw();
        const auto with_sign = [](const BigInteger& x) {
          return x < 0 ? BigInteger(-x * x) : BigInteger(x * x);
        };
        CHECK(with_sign(part - margin) * squared < with_sign(exact));
        CHECK(with_sign(part + margin) * squared > with_sign(exact));
      }
    }
    const BigInteger root = sqrt(squared);
    for (int away = -1; away <= 1; ++away) {
      const BigInteger near = root + away;
      if (near < 0 || near > (BigInteger(1) << 32) - 2) continue;
      const auto length = Fixed<32, 16>::from_raw(integer_from<std::int64_t>(near));
      CHECK(vector.is_longer_than(length) == (squared > near * near));
    }
  }
}

TEST_CASE("ShortVector: steps along it are within their error, and its length is exact") {
  check_steps<2>(0x5001);
  check_steps<3>(0x5002);
}

TEST_CASE("ShortVector: the longest vector and lengths of both signs") {
  using T = q16_16;
  const T least = T::from_raw(-2147483647 - 1);
  const ShortVector longest(std::array{least, least, least});
  using Length = Fixed<32, 16>;
  CHECK(longest.is_longer_than(Length::from_raw(3719550786)));  // floor(sqrt(3) 2^31)
  CHECK_FALSE(longest.is_longer_than(Length::from_raw(3719550787)));
  CHECK(longest.is_longer_than(Length::from_raw(0)));
  const ShortVector one(std::array{T::from_raw(1), T::from_raw(0)});
  CHECK_FALSE(one.is_longer_than(Length::from_raw(1)));
  const ShortVector pythagorean(std::array{T::from_raw(3), T::from_raw(-4)});
  CHECK_FALSE(pythagorean.is_longer_than(Length::from_raw(5)));
  CHECK(pythagorean.is_longer_than(Length::from_raw(4)));
  const auto steps = pythagorean.unit().steps(T::from_raw(-5)).value;
  CHECK(nearest_to<T>(steps[0]) == T::from_raw(-3));
  CHECK(nearest_to<T>(steps[1]) == T::from_raw(4));
}

}  // namespace
}  // namespace detent::test
