// SPDX-License-Identifier: MIT
#include "detent/query/kernel/rounded_point.hpp"

#include <algorithm>
#include <array>
#include <iterator>

#include "detent/query/kernel/length.hpp"
#include "number/big_integer.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace detent::test {
namespace {

TEST_CASE("points between two others: the filter never contradicts the exact quotient", "[query]") {
  Random random(0x5b3d);
  using Far = detail::Length<q16_16>;
  using From = Fixed<63, 46>;
  using Part = Fixed<90, 60>;
  int unsure = 0;
  constexpr int asked = 20000;
  for (int i = 0; i < asked; ++i) {
    CAPTURE(i);
    const int shift = static_cast<int>(random.below(31));
    const auto number = [&](std::int64_t limit) { return random.between(-limit, limit) >> shift; };
    // On the grid, or between its points.
    const bool is_whole = random.coin();
    const auto from =
        From::from_raw(number(std::int64_t{1} << 61) & (is_whole ? ~0LL << 30 : ~0LL));
    const auto step = Fixed<34, 16>::from_raw(number(std::int64_t{1} << 33));
    // Powers of two and small numbers make ties.
    auto under = random.coin() ? std::int64_t{1} << (1 + random.below(40))
                               : random.between(2, std::int64_t{1} << (2 + random.below(58)));
    const auto over = random.between(1, under - 1);
    const Part part = Part::from_raw(over), whole = Part::from_raw(under);
    const auto ratio = make_ratio_below_one(part, whole);
    const auto exact = quotient_nearest<Far>(from * whole + step * part, whole);
    const auto decided = decide_between<Far>(from, step, ratio);
    unsure += decided.is_sure ? 0 : 1;
    if (decided.is_sure) REQUIRE(decided.value == exact);
    REQUIRE(detail::nearest_between<Far>(from, step, ratio) == exact);
    REQUIRE(detail::nearest_between<q16_16>(from, step, ratio) ==
            quotient_nearest<q16_16>(from * whole + step * part, whole));
  }
  CHECK(unsure > 0);
  CHECK(unsure < asked / 4);
}

/// x |x|: the squares keep their signs.
BigInteger signed_square(const BigInteger& x) {
  return x < 0 ? BigInteger(-x * x) : BigInteger(x * x);
}

/// Whether x is p + radius v / |v| rounded to nearest, ties to even, and clamped: with twice the
/// steps, x - p - 1/2 and x - p + 1/2 times |v| are on either side of radius v.
bool is_rounded(const BigInteger& x, const BigInteger& p, const BigInteger& radius,
                const BigInteger& v, const BigInteger& squared) {
  const BigInteger exact = signed_square(2 * radius * v);
  const BigInteger below = signed_square(2 * (x - p) - 1) * squared;
  const BigInteger above = signed_square(2 * (x - p) + 1) * squared;
  const bool is_even = x % 2 == 0;
  const bool is_reached = is_even ? below <= exact : below < exact;
  const bool is_next = is_even ? above < exact : above <= exact;
  if (x == big_raw(largest<q16_16>)) return is_reached;
  if (x == big_raw(lowest<q16_16>)) return !is_next;
  return is_reached && !is_next;
}

TEST_CASE("points beyond others: ties, near ties and the ends of the range", "[query]") {
  using S = q16_16;
  using V = Fixed<32, 16>;
  Random random(0x5b3e);
  int clamped = 0;
  constexpr int asked = 20000;
  for (int i = 0; i < asked; ++i) {
    CAPTURE(i);
    const int bits = static_cast<int>(random.below(31));
    const auto number = [&](int most) {
      return S::from_raw(static_cast<std::int32_t>(
          std::clamp<std::int64_t>(random.edgy(most), -0x7fffffff, 0x7fffffff)));
    };
    const auto p = make_vec<3>([&](int) { return number(31); });
    // Short vectors with whole lengths, and those along an axis, make ties.
    auto v = make_vec<3>([&](int) { return V(number(random.coin() ? bits : 2)); });
    if (random.one_in(4)) v.y = v.z = V(0);
    if (random.one_in(4)) v = Vec<V, 3>{V::from_raw(6), V::from_raw(-8), V(0)};
    const S radius = S::from_raw(static_cast<std::int32_t>(
        std::clamp<std::int64_t>(random.edgy(random.coin() ? 31 : 6), 1, 0x7fffffff)));
    if (detail::is_zero(v)) continue;
    const auto found = detail::rounded_beyond(p, radius, v);
    const auto back = detail::rounded_beyond(p, radius, narrow_negative(v));
    BigInteger squared = 0;
    for (int k = 0; k < 3; ++k) squared += big_raw(v[k]) * big_raw(v[k]);
    for (int k = 0; k < 3; ++k) {
      CAPTURE(k);
      clamped += found[k] == largest<S> || found[k] == lowest<S> ? 1 : 0;
      REQUIRE(
          is_rounded(big_raw(found[k]), big_raw(p[k]), big_raw(radius), big_raw(v[k]), squared));
      REQUIRE(
          is_rounded(big_raw(back[k]), big_raw(p[k]), big_raw(radius), -big_raw(v[k]), squared));
    }
  }
  CHECK(clamped > asked / 100);
}

TEST_CASE("points beyond others: ties of rational points are rounded to even", "[query]") {
  using S = q16_16;
  using V = Fixed<32, 16>;
  using Over = Fixed<33, 16>;
  using Under = Fixed<2, 0>;
  struct Whole {
    std::array<int, 3> v;
    int length;
  };
  // Vectors with whole lengths.
  constexpr Whole wholes[] = {{{3, 4, 0}, 5},    {{1, -2, 2}, 3}, {{-2, 3, 6}, 7},
                              {{12, 0, -5}, 13}, {{8, 4, 1}, 9},  {{6, -2, 9}, 11}};
  Random random(0x5b3f);
  for (int i = 0; i < 4000; ++i) {
    CAPTURE(i);
    const auto& whole = wholes[random.below(std::size(wholes))];
    const auto scale = std::int64_t{1} << random.below(27);
    const auto times = random.between(1, std::int64_t{1} << random.below(27));
    const auto v = make_vec<3>(
        [&](int k) { return V::from_raw(scale * whole.v[static_cast<std::size_t>(k)]); });
    const auto radius = S::from_raw(static_cast<std::int32_t>(times * whole.length));
    const detail::RationalPoint<Over, Under, 3> p{
        make_vec<3>([&](int) { return Over::from_raw(2 * random.between(-1 << 29, 1 << 29) + 1); }),
        Under(2)};
    const auto found = detail::rounded_beyond(p, radius, v);
    for (int k = 0; k < 3; ++k) {
      CAPTURE(k);
      const auto twice = p.over[k].raw() + 2 * times * whole.v[static_cast<std::size_t>(k)];
      const auto below = (twice - 1) / 2;  // the exact coordinate is below + 1/2
      REQUIRE(found[k].raw() == below + (below & 1));
    }
  }
}

}  // namespace
}  // namespace detent::test
