// SPDX-License-Identifier: MIT
#include "detent/number/filter/products.hpp"

#include "number/big_integer.hpp"
#include "support/catch.hpp"

namespace detent::test {
namespace {

/// a b against c d: equal, a few units apart in one factor, or random.
template <class A, class B, class C, class D, int Bits>
int count_wrong(std::uint64_t seed) {
  Random random(seed);
  const auto draw = [&] {
    const std::int64_t drawn = random.wide(Bits);
    return BigInteger(drawn < 0 ? -drawn : drawn);
  };
  const auto fixed = [&]<class T>(T, const BigInteger& x) {
    return T::from_raw(integer_from<typename T::raw_type>(x));
  };
  int wrong = 0;
  for (int i = 0; i < 20'000; ++i) {
    const BigInteger p = draw(), q = draw(), r = draw(), s = draw();
    BigInteger c = p * r;
    if (random.coin()) c += random.between(-3, 3);
    if (random.one_in(4)) c = draw() * draw();
    if (c < 0) c = 0;
    const auto fixed_a = fixed(A(), p * q);
    const auto fixed_b = fixed(B(), r * s);
    const auto fixed_c = fixed(C(), c);
    const auto fixed_d = fixed(D(), q * s);
    // The products are in steps of 2^-(sum of the fractional bits).
    const BigInteger left = p * q * r * s * power_of_two(C::frac + D::frac);
    const BigInteger right = c * q * s * power_of_two(A::frac + B::frac);
    const int sign = left > right ? 1 : left < right ? -1 : 0;
    if (compare_products(fixed_a, fixed_b, fixed_c, fixed_d) != sign) ++wrong;
    if (compare_products(fixed_c, fixed_d, fixed_a, fixed_b) != -sign) ++wrong;
  }
  return wrong;
}

TEST_CASE("products: the sign of a difference of products, however wide they are") {
  using Long = Fixed<126, 40>;
  CHECK(count_wrong<Long, Long, Long, Long, 63>(0x7001) == 0);
  CHECK(count_wrong<Long, Long, Fixed<126, 30>, Fixed<126, 49>, 63>(0x7002) == 0);
  CHECK(count_wrong<Fixed<60, 20>, Fixed<60, 20>, Fixed<60, 20>, Fixed<60, 20>, 30>(0x7003) == 0);
  CHECK(count_wrong<Fixed<62, 20>, Long, Fixed<90, 30>, Fixed<80, 30>, 31>(0x7004) == 0);
  CHECK(count_wrong<Fixed<150, 20>, Fixed<61, 20>, Fixed<62, 20>, Fixed<140, 22>, 30>(0x7005) == 0);
}

TEST_CASE("products: float and double compare what they compute") {
  CHECK(compare_products(2.0, 3.0, 6.0, 1.0) == 0);
  CHECK(compare_products(2.0F, 3.0F, 7.0F, 1.0F) == -1);
  CHECK(compare_products(2.0F, 3.0F, 5.0F, 1.0F) == 1);
}

}  // namespace
}  // namespace detent::test
