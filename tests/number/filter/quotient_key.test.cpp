// SPDX-License-Identifier: MIT
#include "detent/number/filter/quotient_key.hpp"

#include "number/big_integer.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace detent::test {
namespace {

using X = Fixed<240, 48>;
using Square = Fixed<250, 64>;

/// A quotient x / sqrt(square): its key, and its square with the sign of x.
struct Quotient {
  QuotientKey<X> key;
  BigRational signed_square;

  Quotient(const BigInteger& x, const BigInteger& square)
      : key(X::from_raw(integer_from<X::raw_type>(x)),
            Square::from_raw(integer_from<Square::raw_type>(square))),
        signed_square(BigRational(x < 0 ? BigInteger(-(x * x)) : BigInteger(x * x), square)) {}
};

/// A number below 2^(bits + 61), of any length.
BigInteger draw(Random& random, std::uint64_t bits) {
  const std::int64_t high = random.wide(60);
  return BigInteger(high) << static_cast<int>(random.below(bits));
}

TEST_CASE("quotient key: the order is that of the exact quotients where it is sure") {
  Random random(0x9e41);
  int wrong = 0, unsure = 0, ties = 0;
  for (int i = 0; i < 20'000; ++i) {
    const BigInteger x = draw(random, 100), root = draw(random, 50);
    BigInteger square = root * root + draw(random, 2);
    if (square <= 0) square = 1;
    BigInteger y = draw(random, 100), other = square;
    const auto choice = random.below(4);
    if (choice == 0) {  // the same quotient
      const BigInteger factor = 1 + random.below(1000);
      y = x * factor;
      other = square * factor * factor;
    } else if (choice == 1) {  // nearly the same
      y = x + (x >> static_cast<int>(30 + random.below(30)));
    } else if (choice == 2) {
      y = x;
      other = square + (square >> static_cast<int>(30 + random.below(30)));
    }
    const Quotient p(x, square), q(y, other);
    const bool less = p.key.is_surely_less(q.key), greater = q.key.is_surely_less(p.key);
    wrong += less && !(p.signed_square < q.signed_square) ? 1 : 0;
    wrong += greater && !(q.signed_square < p.signed_square) ? 1 : 0;
    // Keys must order quotients whose relative difference exceeds 2^-40.
    const BigRational apart = p.signed_square - q.signed_square;
    const BigRational magnitude =
        p.signed_square < 0 ? BigRational(-p.signed_square) : p.signed_square;
    const bool is_clear = (apart < 0 ? BigRational(-apart) : apart) * power_of_two(39) > magnitude;
    wrong += is_clear && !less && !greater ? 1 : 0;
    unsure += !less && !greater ? 1 : 0;
    ties += p.signed_square == q.signed_square ? 1 : 0;
  }
  CHECK(wrong == 0);
  CHECK(ties > 4000);
  CHECK(unsure > ties + 1000);
}

TEST_CASE("quotient key: 0 is below the least positive number") {
  using Short = Fixed<20, 0>;
  const QuotientKey<Short> zero(Short(0), Short(7));
  const QuotientKey<Short> least(Short(1), Short(1000));
  const QuotientKey<Short> negative(Short(-1), Short(1000));
  CHECK(zero.is_surely_less(least));
  CHECK(negative.is_surely_less(zero));
  CHECK(!zero.is_surely_less(zero));
}

}  // namespace
}  // namespace detent::test
