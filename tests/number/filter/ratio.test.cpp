// SPDX-License-Identifier: MIT
#include "detent/number/filter/ratio.hpp"

#include <algorithm>
#include <cstdint>

#include "number/big_integer.hpp"
#include "support/catch.hpp"

using namespace detent;
using namespace detent::test;

namespace {

template <class S, class T, class R>
void check_product(const S& base, const T& x, const R& ratio) {
  const BigRational exact =
      rational(base) + rational(x) * rational(ratio.over) / rational(ratio.under);
  CHECK(big_raw(add_product(base, x, ratio)) == clamped<S>(nearest_of(on_grid<S>(exact))));
}

/// The least `square` with square - over^2 / under >= root^2 for a random root, or a number close to it; and the
/// other side.
struct Triangle {
  BigInteger square, side;
};
Triangle draw(Random& random, const BigInteger& over, const BigInteger& under) {
  const BigInteger root = std::abs(random.wide(30));
  BigInteger square = (root * root * under + over * over + under - 1) / under;
  square +=
      random.coin() ? random.between(-1, 1) : random.wide(static_cast<int>(random.between(1, 30)));
  const BigInteger least = (over * over + under - 1) / under;
  if (square < least) square = least;
  return {square, sqrt(BigInteger((square * under - over * over) / under))};
}

template <class Square, class R>
void check_side(const Triangle& triangle, const R& ratio, int& unsure) {
  if (triangle.square > big_raw(Square::max())) return;
  const auto square = fixed_from<Square>(triangle.square);
  const auto side = decide_side_floor<q16_16>(square, ratio);
  if (side.is_sure) CHECK(big_raw(side.value) == clamped<q16_16>(triangle.side));
  unsure += side.is_sure ? 0 : 1;
}

}  // namespace

TEST_CASE("ratio: a reciprocal is not too large, and within 2^-58") {
  Random random(20260701);
  INFO(random);
  for (int i = 0; i < 20000; ++i) {
    const auto top = std::uint64_t{1} << 63;
    const auto x = static_cast<std::uint64_t>(random.edgy(62)) * 2 | top;
    const BigInteger product = BigInteger(detail::reciprocal(x)) * x;
    CHECK(product < power_of_two(126));
    CHECK(product > power_of_two(126) - power_of_two(68));
  }
  CHECK(BigInteger(detail::reciprocal(std::uint64_t{1} << 63)) < power_of_two(63));
}

TEST_CASE("ratio: a product with any ratio is rounded once, halves to even") {
  // A triangle's normal n, n . w and n^2, and smaller values.
  using X = Fixed<61, 32>;
  using Over = Fixed<95, 48>;
  using Under = Fixed<124, 64>;
  Random random(20260702);
  INFO(random);
  for (int i = 0; i < 20000; ++i) {
    const auto base = q16_16::from_raw(static_cast<std::int32_t>(random.edgy(31)));
    const int length = static_cast<int>(random.between(2, 60));
    const auto x = X::from_raw(random.wide(length));
    const std::int64_t n = std::max<std::int64_t>(std::abs(random.wide(length)), std::abs(x.raw()));
    const auto under = fixed_from<Under>(std::max(BigInteger(n) * n, BigInteger(1)));
    // |x over / under| < 2^33 because |x| <= n; often a half.
    auto over = BigInteger(n) * random.wide(random.coin() ? 33 : 4);
    if (random.one_in(4)) over = over / 2 * 2 + n / 2;
    check_product(base, x, make_ratio(fixed_from<Over>(over), under));
  }
}

TEST_CASE("ratio: a product with a ratio below 1 is rounded once, in any width") {
  Random random(20260703);
  INFO(random);
  const auto check = [&](auto over_type, auto x_type, int length) {
    using Over = decltype(over_type);
    using X = decltype(x_type);
    for (int i = 0; i < 20000; ++i) {
      const auto start = q16_16::from_raw(static_cast<std::int32_t>(random.edgy(31)));
      auto end = q16_16::from_raw(static_cast<std::int32_t>(random.edgy(31)));
      if constexpr (X::bits == 30) {
        end = q16_16::from_raw(start.raw() / 2 + static_cast<std::int32_t>(random.wide(28)));
      }
      const BigInteger under =
          (BigInteger(std::abs(random.edgy(length - 6))) << random.below(5)) + 2;
      BigInteger over = under / (random.one_in(8) ? 2 : 1 + random.below(9)) - random.below(2);
      over = std::clamp(over, BigInteger(1), BigInteger(under - 1));
      const auto ratio = make_ratio_below_one(fixed_from<Over>(over), fixed_from<Over>(under));
      const auto x =
          X::from_raw(static_cast<typename X::raw_type>(std::int64_t{end.raw()} - start.raw()));
      if (x.raw() != std::int64_t{end.raw()} - start.raw()) continue;
      check_product(start, x, ratio);
      const BigRational error =
          rational(approximate_product(x, ratio).value) - rational(x) * BigRational(over, under);
      CHECK(abs(on_grid<q16_16>(error)) < BigRational(1, power_of_two(22)));
    }
  };
  check(Fixed<62, 32>(), Fixed<30, 16>(), 61);
  check(Fixed<66, 32>(), Fixed<32, 16>(), 66);
}

TEST_CASE("ratio: a product with a ratio over nearly 1 needs no division") {
  Random random(20260704);
  INFO(random);
  for (int i = 0; i < 20000; ++i) {
    const auto base = q16_16::from_raw(static_cast<std::int32_t>(random.edgy(31)));
    const auto x = Fixed<31, 30>::from_raw(static_cast<std::int32_t>(random.edgy(30)));
    const auto over = Fixed<63, 46>::from_raw(random.edgy(62));
    const std::int64_t excess = random.one_in(8) ? 0 : random.edgy(32);
    check_product(
        base, x,
        make_ratio_to_unit(over, Fixed<61, 60>::from_raw((std::int64_t{1} << 60) + excess)));
    const auto small_base = q8_8::from_raw(static_cast<std::int16_t>(random.edgy(15)));
    const auto small_x = Fixed<15, 14>::from_raw(static_cast<std::int16_t>(random.edgy(14)));
    const auto small_over = Fixed<31, 22>::from_raw(static_cast<std::int32_t>(random.edgy(30)));
    const auto small_excess = static_cast<std::int32_t>(random.edgy(16));
    check_product(
        small_base, small_x,
        make_ratio_to_unit(small_over, Fixed<29, 28>::from_raw((1 << 28) + small_excess)));
  }
}

TEST_CASE("decide_side_floor: both widths round the exact root down, or are unsure") {
  using Narrow = Fixed<62, 32>;
  using Full = Fixed<66, 32>;
  Random random(20260721);
  INFO(random);
  int unsure = 0;
  for (int i = 0; i < 20000; ++i) {
    const std::int64_t under = std::abs(random.wide(static_cast<int>(random.between(2, 60)))) + 2;
    const std::int64_t over = random.between(1, under - 1);
    const auto triangle = draw(random, over, under);
    const auto a = Narrow::from_raw(over), b = Narrow::from_raw(under);
    check_side<Narrow>(triangle, make_ratio_below_one(a, b), unsure);
    check_side<Full>(triangle, make_ratio_below_one(Full(a), Full(b)), unsure);
  }
  CHECK(unsure > 100);
  CHECK(unsure < 37'000);  // of 40,000
}

TEST_CASE("decide_side_floor: works along a direction") {
  Random random(20260722);
  INFO(random);
  int unsure = 0;
  for (int i = 0; i < 20000; ++i) {
    const std::int64_t under = (std::int64_t{1} << 60) + random.edgy(32);
    const std::int64_t over = std::abs(random.wide(62));
    check_side<Fixed<66, 32>>(
        draw(random, over, under),
        make_ratio_to_unit(Fixed<63, 46>::from_raw(over), Fixed<61, 60>::from_raw(under)), unsure);
  }
  CHECK(unsure > 100);
  CHECK(unsure < 19'000);
}

TEST_CASE(
    "decide_segment_distance: rounds the exact distance down, or is unsure between the ends") {
  using Product = Fixed<62, 32>;
  const auto limit = power_of_two(62);
  Random random(20260723);
  INFO(random);
  int unsure = 0, count = 0;
  for (int i = 0; i < 40000; ++i) {
    const std::int64_t under = std::abs(random.wide(static_cast<int>(random.between(2, 61)))) + 2;
    const auto over = random.one_in(4) ? under - 1 : random.between(1, under - 1);
    const auto triangle = draw(random, over, under);
    const auto whole = Product::from_raw(under);
    if (triangle.square < limit) {
      const auto square = fixed_from<Product>(triangle.square);
      const auto along = Product::from_raw(over);
      const auto distance = decide_segment_distance<q16_16>(square, along, whole);
      if (distance.is_sure) CHECK(big_raw(distance.value) == triangle.side);
      const auto clamped_distance = decide_segment_distance<q14_16>(square, along, whole);
      if (distance.is_sure) {
        CHECK(big_raw(clamped_distance.value) == clamped<q14_16>(triangle.side));
      }
      ++count;
      unsure += distance.is_sure ? 0 : 1;
    }
    // Closest to an end, exactly.
    const std::int64_t square = std::abs(random.wide(60)), past = under + std::abs(random.wide(60));
    const BigInteger root = sqrt(BigInteger(square));
    const auto before = decide_segment_distance<q16_16>(
        Product::from_raw(square), Product::from_raw(std::min<std::int64_t>(random.edgy(61), 0)),
        whole);
    CHECK((before.is_sure && big_raw(before.value) == root));
    if (BigInteger(2) * past - under + square >= limit) continue;
    const auto after = decide_segment_distance<q16_16>(Product::from_raw(2 * past - under + square),
                                                       Product::from_raw(past), whole);
    CHECK((after.is_sure && big_raw(after.value) == root));
  }
  const auto point = decide_segment_distance<q16_16>(Product::from_raw(81), Product(), Product());
  CHECK((point.is_sure && point.value.raw() == 9));
  CHECK(count > 30'000);
  CHECK(unsure > count / 10);
  CHECK(unsure < count * 4 / 5);
}

TEST_CASE(
    "decide_line_distance: rounds the exact distance down, or is unsure ahead of the origin") {
  using Product = Fixed<62, 32>;
  using Along = Fixed<61, 46>;
  using Whole = Fixed<61, 60>;
  Random random(20260724);
  INFO(random);
  int unsure = 0, count = 0;
  for (int i = 0; i < 40000; ++i) {
    const std::int64_t excess = random.coin() ? random.between(-4, 4) : random.edgy(32);
    const auto whole = Whole::from_raw((std::int64_t{1} << 60) + excess);
    const std::int64_t over = std::abs(random.wide(61));
    const auto triangle = draw(random, over, whole.raw());
    if (triangle.square < power_of_two(62)) {
      const auto distance = decide_line_distance<q16_16>(fixed_from<Product>(triangle.square),
                                                         Along::from_raw(over), whole);
      if (distance.is_sure) CHECK(big_raw(distance.value) == triangle.side);
      ++count;
      unsure += distance.is_sure ? 0 : 1;
    }
    const std::int64_t square = std::abs(random.wide(61));
    const auto before = decide_line_distance<q16_16>(
        Product::from_raw(square), Along::from_raw(std::min<std::int64_t>(random.edgy(60), 0)),
        whole);
    CHECK((before.is_sure && big_raw(before.value) == sqrt(BigInteger(square))));
  }
  CHECK(count > 20'000);
  CHECK(unsure > count / 10);
  CHECK(unsure < count * 4 / 5);
}
