// SPDX-License-Identifier: MIT
#include "detent/number/filter/leg.hpp"

#include <algorithm>
#include <cstdint>

#include "number/big_integer.hpp"
#include "support/catch.hpp"

using namespace detent;
using namespace detent::test;

namespace {

/// The least `square` with square - over^2 / under >= root^2 for a random root, or one off; and its
/// leg.
struct Triangle {
  BigInteger square, leg;
};
Triangle draw(Random& random, const BigInteger& over, const BigInteger& under) {
  const BigInteger root = std::abs(random.wide(30));
  BigInteger square = (root * root * under + over * over + under - 1) / under;
  square += random.between(-1, 1);
  if (square * under < over * over) square += 1;
  return {square, sqrt(BigInteger((square * under - over * over) / under))};
}

template <class Square, class R>
void check(const Triangle& triangle, const R& ratio) {
  if (triangle.square > big_raw(Square::max())) return;
  const auto square = fixed_from<Square>(triangle.square);
  const auto leg = leg_floor<q16_16>(square, ratio, [&] {
    return Fraction{square * ratio.under - ratio.over * ratio.over, ratio.under};
  });
  CHECK(big_raw(leg) == clamped<q16_16>(triangle.leg));
}

}  // namespace

TEST_CASE("leg_floor: both widths round down the exact root") {
  using Narrow = Fixed<62, 32>;
  using Full = Fixed<66, 32>;
  Random random(20260721);
  INFO(random);
  for (int i = 0; i < 20000; ++i) {
    const std::int64_t under = std::abs(random.wide(static_cast<int>(random.between(2, 60)))) + 2;
    const std::int64_t over = random.between(1, under - 1);
    const auto triangle = draw(random, over, under);
    const auto a = Narrow::from_raw(over), b = Narrow::from_raw(under);
    check<Narrow>(triangle, make_ratio_below_one(a, b));
    check<Full>(triangle, make_ratio_below_one(Full(a), Full(b)));
  }
}

TEST_CASE("leg_floor: beside a direction, too") {
  Random random(20260722);
  INFO(random);
  for (int i = 0; i < 20000; ++i) {
    const std::int64_t under = (std::int64_t{1} << 60) + random.edgy(32);
    const std::int64_t over = std::abs(random.wide(62));
    check<Fixed<66, 32>>(
        draw(random, over, under),
        make_ratio_near_one(Fixed<63, 46>::from_raw(over), Fixed<61, 60>::from_raw(under)));
  }
}
