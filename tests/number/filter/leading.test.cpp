// SPDX-License-Identifier: MIT
#include "detent/number/filter/leading.hpp"

#include <optional>

#include "number/big_integer.hpp"
#include "support/catch.hpp"

namespace detent::test {
namespace {

using T = Fixed<31, 16>;
using Long = Fixed<250, 100>;

/// The floor of a number with square roots, or nothing if the filter is unsure.
std::optional<T> floor_of(const Leading& x) {
  const auto floor = decide_floor<T>(Approximate{x, Relative{42}});
  return floor.is_sure ? std::optional(floor.value) : std::nullopt;
}
/// A number >= 0 of any length up to 240 bits.
BigInteger draw(Random& random) {
  const std::int64_t high = random.wide(60), low = random.wide(60);
  const auto scale = static_cast<int>(random.below(120));
  return (BigInteger(high < 0 ? -high : high) << scale) * BigInteger(low < 0 ? -low : low);
}
template <class Number>
Number fixed(const BigInteger& raw) {
  return Number::from_raw(integer_from<typename Number::raw_type>(raw));
}
BigRational value(const Leading& x) {
  return x.exponent < 0 ? BigRational(BigInteger(x.word), power_of_two(-x.exponent))
                        : BigRational(BigInteger(x.word) * power_of_two(x.exponent));
}
/// Whether `x` is off by at most 2^-bits of `exact`.
bool is_within(const Leading& x, const BigRational& exact, int bits) {
  const BigRational error = value(x) - exact;
  return (error < 0 ? BigRational(-error) : error) * power_of_two(bits) <= exact &&
         (x.word == 0 || (x.word >> 63) == 1);
}

TEST_CASE("leading: sums, products, quotients and roots keep their leading bits") {
  Random random(0x5001);
  int wrong = 0;
  for (int i = 0; i < 20'000; ++i) {
    const BigInteger raw_a = draw(random), raw_b = draw(random);
    const BigRational one = power_of_two(100), a = raw_a / one, b = raw_b / one;
    const Leading leading_a(fixed<Long>(raw_a)), leading_b(fixed<Long>(raw_b));
    wrong += is_within(leading_a, a, 62) ? 0 : 1;
    wrong += is_within(leading_a + leading_b, a + b, 60) ? 0 : 1;
    wrong += is_within(leading_a * leading_b, a * b, 60) ? 0 : 1;
    if (b != 0) wrong += is_within(leading_a / leading_b, a / b, 56) ? 0 : 1;
    if (a != 0 && b != 0) {
      const BigRational quotient = value(over_root(leading_a, leading_b));
      wrong += is_within(leading_a * leading_a / leading_b, quotient * quotient, 42) ? 0 : 1;
    }
    const BigRational root = value(sqrt(leading_a));
    wrong += is_within(Leading(fixed<Long>(raw_a)), root * root, 42) ? 0 : 1;
    const int order = a < b ? -1 : a > b ? 1 : 0;
    const auto sign = decide(difference(leading_a, leading_b, Relative{56}));
    wrong += sign == Filtered(order) || sign == Filtered::unsure ? 0 : 1;
    wrong += decide(difference(leading_a, leading_a, Relative{56})) == Filtered::unsure ? 0 : 1;
  }
  CHECK(wrong == 0);
}

TEST_CASE("leading: zero is added to numbers of any length") {
  // At compile time, a shift by a negative number is an error.
  constexpr Leading zero(Fixed<62, 44>(0)), least(Fixed<62, 60>::from_raw(1));
  constexpr auto is_least = [=](const Leading& x) {
    return x.word == least.word && x.exponent == least.exponent;
  };
  static_assert(is_least(least + zero));
  static_assert(is_least(zero + least));
}

TEST_CASE(
    "leading: a floor is the floor of every number within the error, or the filter is unsure") {
  Random random(0x5002);
  int wrong = 0, unsure = 0, asked = 0;
  for (int i = 0; i < 20'000; ++i) {
    const std::int64_t step = random.between(1, (std::int64_t{1} << 30) - 1);
    const BigInteger raw = (BigInteger(step) << 84) + (BigInteger(random.next()) << 20);
    const auto floor = floor_of(Leading(fixed<Long>(raw)));
    ++asked;
    if (!floor) ++unsure;
    if (floor && floor->raw() != step) ++wrong;
    // A step itself, and numbers off by less than the error, are never decided.
    const BigInteger exact = BigInteger(step) << 84, error = exact >> 45;
    if (floor_of(Leading(fixed<Long>(exact)))) ++wrong;
    if (floor_of(Leading(fixed<Long>(exact - error)))) ++wrong;
    if (floor_of(Leading(fixed<Long>(exact + error)))) ++wrong;
  }
  CHECK(wrong == 0);
  CHECK(unsure < asked / 100);
  CHECK(!floor_of(Leading(fixed<Long>(power_of_two(115)))));
  CHECK(!floor_of(Leading()));
  CHECK(floor_of(Leading(fixed<Long>(power_of_two(83)))) == T());
}

TEST_CASE("leading: a difference of products is rounded to nearest, or the filter is unsure") {
  using Component = Fixed<31, 30>;
  Random random(0x5003);
  int wrong = 0, unsure = 0, asked = 0;
  for (int i = 0; i < 20'000; ++i) {
    // p x - q y with p = 1 / length and q = s / length.
    const BigInteger length = draw(random) + 1, s = draw(random) + 1;
    const BigInteger x = length * random.between(-1000, 1000) / 1000;
    const BigInteger y = length * random.between(-1000, 1000) / 1000 * power_of_two(100) / s;
    if (y >= power_of_two(250) || -y >= power_of_two(250)) continue;
    const BigRational exact =
        BigRational(x, length) - BigRational(s * y, length * power_of_two(100));
    if (exact > 1 || exact < -1) continue;
    ++asked;
    const Leading one(Fixed<3, 0>(1)), p = one / Leading(fixed<Long>(length)),
                                       q = Leading(fixed<Long>(s)) * p;
    const auto nearest = decide_nearest_difference<Component>(p, fixed<Long>(x), q, fixed<Long>(y));
    if (!nearest.is_sure) {
      ++unsure;
    } else if (big_raw(nearest.value) != nearest_of(exact * power_of_two(30))) {
      ++wrong;
    }
  }
  CHECK(asked > 5'000);
  CHECK(wrong == 0);
  CHECK(unsure < asked / 100);
}

TEST_CASE("leading: vectors are compared with a length exactly") {
  using Number = Fixed<100, 20>;
  Random random(0x5004);
  int wrong = 0;
  for (int i = 0; i < 20'000; ++i) {
    // The vector 2 3 6 and its length 7, scaled, and off by a unit.
    const BigInteger unit = draw(random) % power_of_two(90);
    const std::array offset{BigInteger(2 * unit), BigInteger(3 * unit), BigInteger(-6 * unit)};
    BigInteger length = 7 * unit + random.between(-1, 1);
    if (length < 0) length = 0;
    const BigInteger over = 49 * unit * unit - length * length;
    const std::array v{fixed<Number>(offset[0]), fixed<Number>(offset[1]),
                       fixed<Number>(offset[2])};
    if (compare_length(v, fixed<Number>(length)) != (over > 0) - (over < 0)) ++wrong;
    const std::array flat{fixed<Number>(3 * unit), fixed<Number>(-4 * unit)};
    if (compare_length(flat, fixed<Number>(5 * unit)) != 0) ++wrong;
  }
  CHECK(wrong == 0);
  CHECK(compare_length(std::array{3.0, 4.0}, 5.0) == 0);
}

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

TEST_CASE("compare_products: the sign of a difference of products of any width") {
  using Factor = Fixed<126, 40>;
  CHECK(count_wrong<Factor, Factor, Factor, Factor, 63>(0x7001) == 0);
  CHECK(count_wrong<Factor, Factor, Fixed<126, 30>, Fixed<126, 49>, 63>(0x7002) == 0);
  CHECK(count_wrong<Fixed<60, 20>, Fixed<60, 20>, Fixed<60, 20>, Fixed<60, 20>, 30>(0x7003) == 0);
  CHECK(count_wrong<Fixed<62, 20>, Factor, Fixed<90, 30>, Fixed<80, 30>, 31>(0x7004) == 0);
  CHECK(count_wrong<Fixed<150, 20>, Fixed<61, 20>, Fixed<62, 20>, Fixed<140, 22>, 30>(0x7005) == 0);
}

TEST_CASE("compare_products: float and double compare the computed products") {
  CHECK(compare_products(2.0, 3.0, 6.0, 1.0) == 0);
  CHECK(compare_products(2.0F, 3.0F, 7.0F, 1.0F) == -1);
  CHECK(compare_products(2.0F, 3.0F, 5.0F, 1.0F) == 1);
}

}  // namespace
}  // namespace detent::test
