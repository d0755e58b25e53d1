// SPDX-License-Identifier: MIT
#include "detent/number/filter/along.hpp"

#include <cstdint>

#include "detent/number/filter/near_half.hpp"
#include "number/big_integer.hpp"
#include "support/catch.hpp"

using namespace detent;
using namespace detent::test;

TEST_CASE("rough_along: each component is within 2^-13 steps and a little") {
  Random random(20260711);
  INFO(random);
  const auto check = [&](auto component, auto scalar) {
    using T = decltype(component);
    using S = decltype(scalar);
    for (int i = 0; i < 5000; ++i) {
      const int bits = static_cast<int>(random.between(1, std::min(T::bits, 62)));
      std::array<T, 3> v;
      for (auto& c : v) {
        c = T::from_raw(static_cast<typename T::raw_type>(random.edgy(random.coin() ? bits : 1)));
      }
      if (v == std::array<T, 3>{}) continue;
      const auto length =
          S::from_raw(static_cast<typename S::raw_type>(std::abs(random.edgy(S::bits - 1))));
      const auto parts = rough_along(length, v);
      BigInteger squared = 0;
      for (const auto& c : v) squared += big_raw(c) * big_raw(c);
      for (std::size_t k = 0; k < 3; ++k) {
        // (|part| -+ margin)^2 |v|^2 are on either side of (length v)^2.
        const BigInteger exact = (big_raw(length) * big_raw(v[k])) << 30;
        const BigInteger part = abs(big_raw(parts[k])),
                         margin = power_of_two(17) + power_of_two(10);
        const BigInteger below = part > margin ? BigInteger(part - margin) : BigInteger(0);
        CHECK(below * below * squared <= exact * exact);
        CHECK((part + margin) * (part + margin) * squared > exact * exact);
        CHECK((parts[k].raw() == 0 || (parts[k].raw() < 0) == (v[k].raw() < 0)));
      }
    }
  };
  const std::array<Fixed<63, 46>, 3> zero{};
  CHECK(rough_along(q16_16(1), zero)[0] == 0);
  check(Fixed<32, 16>(), q16_16());
  check(Fixed<63, 46>(), q16_16());
  check(Fixed<16, 8>(), q8_8());
  check(Fixed<47, 38>(), q8_8());
}

TEST_CASE("nearest_by: what x leaves open, the exact number decides") {
  using X = Fixed<61, 46>;
  Random random(20260712);
  INFO(random);
  for (int i = 0; i < 20000; ++i) {
    const std::int64_t whole = random.edgy(30) << 30;
    const std::int64_t middle = random.coin() ? std::int64_t{1} << 29 : random.between(0, 1 << 30);
    const std::int64_t exact = whole + middle + (random.one_in(3) ? 0 : random.wide(18));
    const auto x = X::from_raw(exact + random.between(-(1 << 18) + 1, (1 << 18) - 1));
    const auto number = X::from_raw(exact);
    const auto nearest =
        nearest_by<q16_16>(x, [&](const auto& half) { return (number > half) - (number < half); });
    CHECK(nearest == nearest_to<q16_16>(number));
  }
}
