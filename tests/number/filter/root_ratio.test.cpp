// SPDX-License-Identifier: MIT
#include "detent/number/filter/root_ratio.hpp"

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
  int wrong = 0, open = 0, asked = 0;
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
    const auto near = ratio.nearest(Length::from_raw(integer_from<typename Length::raw_type>(x)),
                                    T::from_raw(static_cast<typename T::raw_type>(y)));
    if (!near) {
      ++open;
    } else if (big_raw(*near) != nearest_of(BigRational(over << Frac, length << finer))) {
      ++wrong;
    }
  }
  CHECK(asked > 5'000);
  CHECK(wrong == 0);
  CHECK(open < asked / 20);
}

TEST_CASE("root_ratio: what is not left open is the quotient rounded to nearest") {
  examine<31, 30>(0x4001);
  examine<15, 14>(0x4002);
}

TEST_CASE("root_ratio: float and double give the textbook quotient") {
  CHECK(root_ratio<float>(4.0F, 2.0F).nearest(1.0F, 0.5F) == 0.0F);
  CHECK(root_ratio<double>(4.0, 2.0).nearest(1.0, -0.5) == 1.0);
}

}  // namespace
}  // namespace detent::test
