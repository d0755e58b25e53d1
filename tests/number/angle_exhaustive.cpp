// SPDX-License-Identifier: MIT
//
// The sweeps that prove the claims of angle.hpp: every binary angle, and for the arc tangent every
// ray at which its rounding changes. Four minutes on two cores.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include "detent/number/angle.hpp"
#include "number/best_fraction.hpp"
#include "number/sine_table.hpp"
#include "number/sweep.hpp"
#include "support/catch.hpp"

using namespace detent;
using namespace detent::test;

namespace {

/// |x| * 2^-127 as a power of two.
double log2_of(Word128 x) { return std::log2(static_cast<double>(x)) - 127; }

constexpr Word128 one = Word128{1} << 127;

/// The distance of a sine (units of 2^-127) from the nearest tie of a grid: an odd multiple of half
/// its step.
Word128 distance_to_tie(Word128 sine, int frac) {
  const Word128 step = Word128{1} << (127 - frac);
  const Word128 rest = sine % step, half = step / 2;
  return rest > half ? rest - half : half - rest;
}

struct SineSweep {
  std::uint64_t angles = 0, wrong_q16 = 0, wrong_q30 = 0, wrong_side = 0;
  double worst = 0;  // of sine_q62, in its units
  Word128 nearest_q16 = one, nearest_q30 = one;

  SineSweep& operator+=(const SineSweep& other) {
    angles += other.angles;
    wrong_q16 += other.wrong_q16;
    wrong_q30 += other.wrong_q30;
    wrong_side += other.wrong_side;
    worst = std::max(worst, other.worst);
    nearest_q16 = std::min(nearest_q16, other.nearest_q16);
    nearest_q30 = std::min(nearest_q30, other.nearest_q30);
    return *this;
  }

  /// Compares `kernel` in units of 2^-62 with `exact` in units of 2^-127, for the same sine.
  void compare(std::int64_t kernel, Word128 exact, bool negative) {
    const auto magnitude = static_cast<std::uint64_t>(negative ? -kernel : kernel);
    const Word128 found = Word128{magnitude} << 65;
    const double off = static_cast<double>(found > exact ? found - exact : exact - found);
    worst = std::max(worst, std::ldexp(off, -65));
    // Ties of every grid of up to 30 fractional bits are multiples of 2^-31 in (0, 1). A kernel
    // strictly between the same two of them as the exact sine is rounded like the exact one.
    const auto cell = [](Word128 x) { return std::min(x, one - 1) >> 96; };
    const bool is_exact = exact == 0 || exact == one;
    const bool on_tie = magnitude << 33 == 0 && magnitude != std::uint64_t{1} << 62;
    if (is_exact ? found != exact : on_tie || cell(found) != cell(exact)) ++wrong_side;
  }
};

std::int64_t rounded(Word128 magnitude, int frac) {
  return static_cast<std::int64_t>(((magnitude >> (126 - frac)) + 1) >> 1);
}

}  // namespace

TEST_CASE("sine and cosine: correctly rounded to up to 30 fractional bits for all 2^32 angles",
          "[.demand]") {
  using A = Angle<q16_16>;
  using q2_30 = Fixed<31, 30>;
  const auto& table = SineTable::instance();
  const auto total =
      sweep_all<SineSweep>("sines", std::uint64_t{1} << 30, [&](SineSweep& sweep, std::uint64_t i) {
        const auto offset = static_cast<std::uint32_t>(i);
        const auto [sine, cosine] = table(offset);
        const auto s16 = rounded(sine, 16), c16 = rounded(cosine, 16);
        const auto s30 = rounded(sine, 30), c30 = rounded(cosine, 30);
        const auto check = [&](std::uint32_t quarter, Word128 s, bool s_negative, Word128 c,
                               bool c_negative, std::int64_t s_16, std::int64_t c_16,
                               std::int64_t s_30, std::int64_t c_30) {
          const std::uint32_t raw = (quarter << 30) + offset;
          const A angle = A::from_raw(raw);
          sweep.compare(sine_q62(std::uint64_t{raw} << 32), s, s_negative);
          sweep.compare(cosine_q62(std::uint64_t{raw} << 32), c, c_negative);
          if (sin(angle).raw() != s_16 || cos(angle).raw() != c_16) ++sweep.wrong_q16;
          if (sin<q2_30>(angle).raw() != s_30 || cos<q2_30>(angle).raw() != c_30) ++sweep.wrong_q30;
          ++sweep.angles;
        };
        check(0, sine, false, cosine, false, s16, c16, s30, c30);
        check(1, cosine, false, sine, true, c16, -s16, c30, -s30);
        check(2, sine, true, cosine, true, -s16, -c16, -s30, -c30);
        check(3, cosine, true, sine, false, -c16, s16, -c30, s30);
        sweep.nearest_q16 = std::min(sweep.nearest_q16, distance_to_tie(sine, 16));
        sweep.nearest_q30 = std::min(sweep.nearest_q30, distance_to_tie(sine, 30));
      });
  WARN("sine_q62 is off by at most " << total.worst << " * 2^-62; the nearest tie of Q16.16 is 2^"
                                     << log2_of(total.nearest_q16) << " away, of Q2.30 2^"
                                     << log2_of(total.nearest_q30));
  CHECK(total.angles == std::uint64_t{1} << 32);
  CHECK(total.wrong_q16 == 0);
  CHECK(total.wrong_q30 == 0);
  CHECK(total.wrong_side == 0);
  CHECK(total.worst < 1.1);
}

namespace {

struct TieSweep {
  std::uint64_t rays = 0, asked = 0, wrong = 0;
  NearTie nearest{0, 0, one, false};

  TieSweep& operator+=(const TieSweep& other) {
    rays += other.rays;
    asked += other.asked;
    wrong += other.wrong;
    if (other.nearest.distance < nearest.distance) nearest = other.nearest;
    return *this;
  }
};

}  // namespace

// The rounding of an arc tangent depends on the sign of b cos - a sin on the ray halfway between
// two binary angles. This is the smallest magnitude of that number; octant_angle computes it with
// an error below 2^-80.
TEST_CASE("arc tangent: no vector is closer to a tie than 2^-59.7", "[.demand]") {
  const auto total = sweep_all<TieSweep>(
      "ties of arc tangents", std::uint64_t{1} << 29, [](TieSweep& sweep, std::uint64_t i) {
        const auto whole = static_cast<std::uint32_t>(i);
        const NearTie tie = nearest_tie(whole);
        ++sweep.rays;
        if (tie.distance < sweep.nearest.distance) sweep.nearest = tie;
        if (tie.distance >> (127 - 40) == 0) {
          ++sweep.asked;
          const auto x = static_cast<std::int32_t>(-static_cast<std::int64_t>(tie.a));
          const auto y = static_cast<std::int32_t>(tie.b);
          const std::uint32_t expected = 0x80000000u - (tie.above ? whole + 1 : whole);
          if (binary_angle(y, x) != expected) ++sweep.wrong;
        }
      });
  WARN("nearest tie: 2^" << log2_of(total.nearest.distance) << " at (" << total.nearest.a << ", "
                         << total.nearest.b << "); " << total.asked << " of " << total.rays
                         << " rays have a vector within 2^-40");
  CHECK(total.rays == std::uint64_t{1} << 29);
  CHECK(log2_of(total.nearest.distance) > -59.7);
  CHECK(total.asked > 100'000);
  CHECK(total.wrong == 0);
}
