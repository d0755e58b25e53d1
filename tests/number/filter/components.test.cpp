// SPDX-License-Identifier: MIT
#include "detent/number/filter/components.hpp"

#include <cstdint>

#include "number/big_integer.hpp"
#include "support/catch.hpp"

namespace detent::test {
namespace {

BigInteger magnitude(std::int64_t x) { return BigInteger(x < 0 ? -x : x); }

/// Quotients for a radius of up to `Bits` bits and a direction with `Frac` fractional bits, as for
/// a ray and a sphere: none may be wrong, and few undecided.
template <int Bits, int Frac>
void examine(std::uint64_t seed) {
  using T = Fixed<Frac + 1, Frac>;
  using D = Fixed<2 * (Bits + Frac), 2 * (Frac + 16)>;
  using Length = Fixed<Bits + 2 * Frac, 2 * Frac + 16>;
  Random random(seed);
  int wrong = 0, unsure = 0, asked = 0;
  for (int i = 0; i < 20'000; ++i) {
    const BigInteger radius = magnitude(random.wide(Bits - 1)) + 1;
    const BigInteger length = (radius << (2 * Frac)) + random.between(-3, 3) * radius;
    BigInteger d = random.one_in(8) ? magnitude(random.wide(20)) : magnitude(random.wide(30)) << 1;
    d = d * d % (radius * radius << (2 * Frac));
    if (random.coin()) d = (radius * radius << (2 * Frac)) - 1 - d;
    const std::int64_t y = random.between(-(std::int64_t{1} << Frac), std::int64_t{1} << Frac);
    const BigInteger x = (length * random.between(-1000, 1000)) / 1000;

    // With many more bits than the result.
    constexpr int finer = 200;
    const BigInteger root = sqrt(BigInteger(d << (2 * finer)));
    const BigInteger over = (x << finer) - root * y;
    if (over > (length << finer) || over < -(length << finer)) continue;
    ++asked;
    const auto ratio =
        root_ratio<T>(D::from_raw(integer_from<typename D::raw_type>(d)),
                      Length::from_raw(integer_from<typename Length::raw_type>(length)));
    const auto nearest =
        ratio.decide_nearest(Length::from_raw(integer_from<typename Length::raw_type>(x)),
                             T::from_raw(static_cast<typename T::raw_type>(y)));
    if (!nearest.is_sure) {
      ++unsure;
    } else if (big_raw(nearest.value) != nearest_of(BigRational(over << Frac, length << finer))) {
      ++wrong;
    }
  }
  CHECK(asked > 5'000);
  CHECK(wrong == 0);
  CHECK(unsure < asked / 20);
}

TEST_CASE("root_ratio: a sure result is the quotient rounded to nearest") {
  examine<31, 30>(0x4001);
  examine<15, 14>(0x4002);
}

TEST_CASE("root_ratio: float and double give the textbook quotient") {
  CHECK(root_ratio<float>(4.0F, 2.0F).decide_nearest(1.0F, 0.5F).value == 0.0F);
  CHECK(root_ratio<double>(4.0, 2.0).decide_nearest(1.0, -0.5).value == 1.0);
}

TEST_CASE("step_along: each component is within its error") {
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
      const auto steps = step_along(length, v);
      BigInteger squared = 0;
      for (const auto& c : v) squared += big_raw(c) * big_raw(c);
      for (std::size_t k = 0; k < 3; ++k) {
        // (|part| -+ margin)^2 |v|^2 are on either side of (length v)^2.
        const BigInteger exact = (big_raw(length) * big_raw(v[k])) << 30;
        const BigInteger part = abs(big_raw(steps.value[k])), margin = steps.error.raw();
        const BigInteger below = part > margin ? BigInteger(part - margin) : BigInteger(0);
        CHECK(below * below * squared <= exact * exact);
        CHECK((part + margin) * (part + margin) * squared > exact * exact);
        CHECK((steps.value[k].raw() == 0 || (steps.value[k].raw() < 0) == (v[k].raw() < 0)));
      }
    }
  };
  const std::array<Fixed<63, 46>, 3> zero{};
  CHECK(step_along(q16_16(1), zero).value[0] == 0);
  check(Fixed<32, 16>(), q16_16());
  check(Fixed<63, 46>(), q16_16());
  check(Fixed<16, 8>(), q8_8());
  check(Fixed<47, 38>(), q8_8());
}

}  // namespace
}  // namespace detent::test
