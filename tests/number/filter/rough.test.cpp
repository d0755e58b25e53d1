// SPDX-License-Identifier: MIT
#include "detent/number/filter/rough.hpp"

#include "number/big_integer.hpp"
#include "support/catch.hpp"

namespace detent::test {
namespace {

using T = Fixed<31, 16>;
using Long = Fixed<250, 100>;

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
BigRational value(const Rough& x) {
  return x.exponent < 0 ? BigRational(BigInteger(x.word), power_of_two(-x.exponent))
                        : BigRational(BigInteger(x.word) * power_of_two(x.exponent));
}
/// Whether `x` is off by at most 2^-bits of `exact`.
bool is_close(const Rough& x, const BigRational& exact, int bits) {
  const BigRational error = value(x) - exact;
  return (error < 0 ? BigRational(-error) : error) * power_of_two(bits) <= exact &&
         (x.word == 0 || (x.word >> 63) == 1);
}

TEST_CASE("rough: sums, products, quotients and roots keep their leading bits") {
  Random random(0x5001);
  int wrong = 0;
  for (int i = 0; i < 20'000; ++i) {
    const BigInteger raw_a = draw(random), raw_b = draw(random);
    const BigRational one = power_of_two(100), a = raw_a / one, b = raw_b / one;
    const Rough rough_a(fixed<Long>(raw_a)), rough_b(fixed<Long>(raw_b));
    wrong += is_close(rough_a, a, 62) ? 0 : 1;
    wrong += is_close(rough_a + rough_b, a + b, 60) ? 0 : 1;
    wrong += is_close(rough_a * rough_b, a * b, 60) ? 0 : 1;
    if (b != 0) wrong += is_close(rough_a / rough_b, a / b, 56) ? 0 : 1;
    const BigRational root = value(sqrt(rough_a));
    wrong += is_close(Rough(fixed<Long>(raw_a)), root * root, 42) ? 0 : 1;
    const int order = a < b ? -1 : a > b ? 1 : 0;
    const int sign = Rough::compare<56>(rough_a, rough_b);
    wrong += sign == order || sign == 0 ? 0 : 1;
    wrong += Rough::compare<56>(rough_a, rough_a) == 0 ? 0 : 1;
  }
  CHECK(wrong == 0);
}

TEST_CASE("rough: zero is added to numbers of any length") {
  // At compile time a shift by a negative number is an error.
  constexpr Rough zero(Fixed<62, 44>(0)), least(Fixed<62, 60>::from_raw(1));
  constexpr auto is_least = [=](const Rough& x) {
    return x.word == least.word && x.exponent == least.exponent;
  };
  static_assert(is_least(least + zero));
  static_assert(is_least(zero + least));
}

TEST_CASE("rough: a floor is the floor of every number within the error, or left open") {
  Random random(0x5002);
  int wrong = 0, open = 0, asked = 0;
  for (int i = 0; i < 20'000; ++i) {
    const std::int64_t step = random.between(1, (std::int64_t{1} << 30) - 1);
    const BigInteger raw = (BigInteger(step) << 84) + (BigInteger(random.next()) << 20);
    const auto floor = floor_of<T>(Rough(fixed<Long>(raw)));
    ++asked;
    if (!floor) ++open;
    if (floor && floor->raw() != step) ++wrong;
    // A step itself, and numbers off by less than the error, are never decided.
    const BigInteger exact = BigInteger(step) << 84, error = exact >> 45;
    if (floor_of<T>(Rough(fixed<Long>(exact)))) ++wrong;
    if (floor_of<T>(Rough(fixed<Long>(exact - error)))) ++wrong;
    if (floor_of<T>(Rough(fixed<Long>(exact + error)))) ++wrong;
  }
  CHECK(wrong == 0);
  CHECK(open < asked / 100);
  CHECK(!floor_of<T>(Rough(fixed<Long>(power_of_two(115)))));
  CHECK(!floor_of<T>(Rough()));
  CHECK(floor_of<T>(Rough(fixed<Long>(power_of_two(83)))) == T());
}

TEST_CASE("rough: a difference of products is rounded to nearest, or left open") {
  using Component = Fixed<31, 30>;
  Random random(0x5003);
  int wrong = 0, open = 0, asked = 0;
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
    const Rough one(Fixed<3, 0>(1)), p = one / Rough(fixed<Long>(length)),
                                     q = Rough(fixed<Long>(s)) * p;
    const auto near = nearest_difference<Component>(p, fixed<Long>(x), q, fixed<Long>(y));
    if (!near) {
      ++open;
    } else if (big_raw(*near) != nearest_of(exact * power_of_two(30))) {
      ++wrong;
    }
  }
  CHECK(asked > 5'000);
  CHECK(wrong == 0);
  CHECK(open < asked / 100);
}

TEST_CASE("rough: vectors are compared with a length exactly") {
  using Number = Fixed<100, 20>;
  Random random(0x5004);
  int wrong = 0;
  for (int i = 0; i < 20'000; ++i) {
    // The vector 2 3 6 and its length 7, scaled, and off by a unit.
    const BigInteger unit = draw(random) % power_of_two(90);
    const std::array near{BigInteger(2 * unit), BigInteger(3 * unit), BigInteger(-6 * unit)};
    BigInteger length = 7 * unit + random.between(-1, 1);
    if (length < 0) length = 0;
    const BigInteger over = 49 * unit * unit - length * length;
    const std::array v{fixed<Number>(near[0]), fixed<Number>(near[1]), fixed<Number>(near[2])};
    if (compare_length(v, fixed<Number>(length)) != (over > 0) - (over < 0)) ++wrong;
    const std::array flat{fixed<Number>(3 * unit), fixed<Number>(-4 * unit)};
    if (compare_length(flat, fixed<Number>(5 * unit)) != 0) ++wrong;
  }
  CHECK(wrong == 0);
  CHECK(compare_length(std::array{3.0, 4.0}, 5.0) == 0);
}

}  // namespace
}  // namespace detent::test
