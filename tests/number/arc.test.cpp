// SPDX-License-Identifier: MIT
#include "detent/number/arc.hpp"

#include <algorithm>
#include <cstdint>

#include "number/real.hpp"
#include "support/catch.hpp"

using namespace detent;
using namespace detent::test;

namespace {

using Square = Fixed<132, 0>;
using Side = Fixed<66, 0>;

constexpr std::uint64_t phase(int squared_sine, int cosine) {
  return detail::phase_of_arc(Square(squared_sine), Side(cosine));
}
constexpr std::uint64_t eighth = std::uint64_t{1} << 61;
static_assert(phase(0, 0) == 0 && phase(0, 7) == 0 && phase(0, -7) == 4 * eighth);
static_assert(phase(9, 3) == eighth && phase(9, -3) == 3 * eighth && phase(2, 0) == 2 * eighth);

using A = Angle<q16_16>;
static_assert(half_sine_cosine(A()).sine == 0 && half_sine_cosine(A()).cosine == 1);
static_assert(half_sine_cosine(A::turn(1, 2)).sine == 1);
static_assert(half_tangent(A::turn(1, 2)).sine == 1 && half_tangent(A::turn(1, 2)).cosine == 0);
static_assert(half_tangent(A::turn(-1, 4)).sine < 0 && half_tangent(A::turn(-1, 4)).cosine > 0);

Real turns(const Real& radians) { return radians / (2 * pi()); }

}  // namespace

TEST_CASE("arc: the phase of any ratio is off by less than 3 units of 2^-64 turn") {
  Random random(50);
  double worst = 0;
  for (int i = 0; i < 40'000; ++i) {
    // Squares up to 2^132, some of them from sides; sides of similar and of different length.
    const int length = static_cast<int>(random.below(132));
    const auto square = Square::assume_raw(
        integer_from<Square::raw_type>(abs(big(random_wide<3>(random))) >> (191 - length)));
    const BigInteger near = sqrt(big_raw(square)) + random.between(-3, 3);
    const auto side = random.coin()
                          ? fixed_from<Side>(near * (random.coin() ? 1 : -1))
                          : fixed_from<Side>(big(random_wide<2>(random)) >> random.below(128));
    if (square == 0 && side == 0) continue;
    const Real exact = atan2(sqrt(real(square)), real(side));
    const Real found = ldexp(Real(detail::phase_of_arc(square, side)), -64);
    worst = std::max(worst, ulps(found, turns(exact), 64));
  }
  INFO(random);
  CAPTURE(worst);
  CHECK(worst < 3);
  CHECK(worst > 1.6);
}

TEST_CASE("arc: the weights of a part are off by less than 2^-59") {
  Random random(51);
  double worst = 0;
  for (int i = 0; i < 20'000; ++i) {
    const auto square = Square(random.wide(62) & INT64_MAX);
    const auto side = Side(random.wide(31) & INT64_MAX);
    const auto t = q16_16::from_raw(static_cast<std::int32_t>(random.below(65'537)));
    const auto weights = arc_weights(square, side, t);
    const Real angle = atan2(sqrt(real(square)), real(side));
    worst = std::max({worst, ulps(real(weights.start), sin((1 - real(t)) * angle), 59),
                      ulps(real(weights.end), sin(real(t) * angle), 59)});
  }
  INFO(random);
  CAPTURE(worst);
  CHECK(worst < 1);
  CHECK(worst > 0.35);
}

TEST_CASE("arc: half an angle has sines and cosines within 2^-61, the wide sine relatively") {
  Random random(52);
  double worst = 0, worst_wide = 0;
  for (int i = 0; i < 20'000; ++i) {
    const auto angle = A::from_raw(static_cast<std::uint32_t>(random.edgy(32)));
    const Real half = radians_of(angle.raw()) / 2;
    const auto [sine, cosine] = half_sine_cosine(angle);
    const auto wide = half_tangent(angle);
    worst = std::max({worst, ulps(real(sine), sin(half), 61), ulps(real(cosine), cos(half), 61)});
    REQUIRE(wide.cosine == cosine);
    if (angle == A()) continue;
    worst_wide = std::max(worst_wide, ulps(real(wide.sine) / sin(half), Real(1), 61));
  }
  INFO(random);
  CAPTURE(worst, worst_wide);
  CHECK(worst < 1);
  CHECK(worst > 0.45);
  CHECK(worst_wide < 1);
}
