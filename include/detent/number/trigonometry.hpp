// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "detent/number/rounding.hpp"
#include "detent/number/wide.hpp"

// Sine and arc tangent on integers. A phase is an angle modulo one turn in units of 2^-64 turn; a
// binary angle is its upper half. Sums of either wrap, like angles.

namespace detent {

namespace detail {

/// c[0] - w (c[1] - w (c[2] - ...)), where c[k] is in units of 2^-(E + k) and w in units of 2^-63;
/// the result is in units of 2^-E. With decreasing coefficients no difference is negative.
template <std::size_t Terms>
constexpr std::uint64_t alternating_series(const std::array<std::uint64_t, Terms>& c,
                                           std::uint64_t w) noexcept {
  std::uint64_t sum = c[Terms - 1];
  for (std::size_t k = Terms - 1; k-- > 0;) sum = c[k] - multiply_words(sum, w).high;
  return sum;
}

/// sin(pi z / 2) / z as a series in z^2 on [0, 1], E = 63: the equioscillating fit, off by 2^-71.8.
/// Coefficients are rounded from the last to the first, refitting the rest each time. c[1] is 2
/// larger than the fit: this centers the truncation error of the steps and makes a quarter turn
/// give exactly 1. If c[0] were 1 smaller, a sine would fall on a tie of Q2.30
/// (tests/number/angle_exhaustive.cpp).
inline constexpr std::array<std::uint64_t, 10> sine_series = {
    0xc90fdaa22168c235u, 0xa55de7312df295f0u, 0x28cd78ceeb55c27fu, 0x04cb4b3398af4ac0u,
    0x00541e0d21faa6deu, 0x0003c60e9fb6bdd5u, 0x00001e8f43330821u, 0x000000b7d69994abu,
    0x00000003556d17b8u, 0x000000000bf226cbu};

/// atan(t) / (2 pi t) as a series in (64 t)^2 on [0, 1/64], E = 66: fitted in the same way, off by
/// 2^-67.8.
inline constexpr std::array<std::uint64_t, 4> arc_tangent_series = {
    0xa2f9836e4e441487u, 0x0006ca6579eddc89u, 0x00000082613577aau, 0x000000000ba2d5d3u};

/// atan(i / 32), a phase, rounded to nearest.
inline constexpr std::array<std::uint64_t, 33> arc_tangents = {
    0x0000000000000000u, 0x0145d7e159046278u, 0x028b0d430e589aedu, 0x03ceff89ac340906u,
    0x051111d41ddd9a1bu, 0x0650acb69b4fe3aeu, 0x078d3fce842e72ecu, 0x08c64325576561a1u,
    0x09fb385b5ee39e8eu, 0x0b2bab954758b68au, 0x0c57342a84c77619u, 0x0d7d7514ea1efdbau,
    0x0e9e1d24179d5a77u, 0x0fb8e6f93f4ca68fu, 0x10cd98d1293ee442u, 0x11dc042355a3c0ddu,
    0x12e4051d9df30866u, 0x13e58203d3c358a8u, 0x14e06a7aa3c7ddeeu, 0x15d4b6c4888c7725u,
    0x16c266f6edfc1e3eu, 0x17a9822cde870c11u, 0x188a15bbbca863e4u, 0x1964346db496e206u,
    0x1a37f5c4c419ef33u, 0x1b05754878e5b08cu, 0x1bccd1dfdd02723fu, 0x1c8e2d3876e8e159u,
    0x1d49ab3ac8b1bb50u, 0x1dff718c563e1741u, 0x1eafa71eebf23a7bu, 0x1f5a73cca450a08du,
    0x2000000000000000u};

}  // namespace detail

/// The sine of a phase, in units of 2^-62.
///
/// result: odd in the phase; 0 and +-1 at the quarter turns
/// exact:  off by less than 2 units, by less than 1.1 at binary angles
///         (tests/number/angle_exhaustive.cpp)
[[nodiscard]] constexpr std::int64_t sine_q62(std::uint64_t phase) noexcept {
  constexpr std::uint64_t quarter = std::uint64_t{1} << 62;
  const bool negative = phase > 2 * quarter;
  const std::uint64_t half = negative ? 0 - phase : phase;
  const std::uint64_t z = half > quarter ? 2 * quarter - half : half;
  const auto square = multiply_words(z, z);
  const std::uint64_t w = (square.high << 3) | (square.low >> 61);
  const auto product = multiply_words(z, detail::alternating_series(detail::sine_series, w));
  const std::uint64_t magnitude =
      (product.high << 1) + (product.low >> 63) + ((product.low >> 62) & 1);
  const auto sine = static_cast<std::int64_t>(magnitude);
  return negative ? -sine : sine;
}

/// The cosine of a phase, in units of 2^-62, with the error of the sine.
[[nodiscard]] constexpr std::int64_t cosine_q62(std::uint64_t phase) noexcept {
  return sine_q62(phase + (std::uint64_t{1} << 62));
}

namespace detail {

/// atan(i / 32) + atan(t), or - atan(t), as a phase; i <= 32 and `t64` is 64 t in Q63, at most 1.
///
/// Errors in units of 2^-64 turn: table and sum 1, products and fit 0.2.
constexpr std::uint64_t arc_phase(std::uint64_t i, std::uint64_t t64, bool backward) noexcept {
  const auto square = multiply_words(t64, t64);
  const std::uint64_t w = (square.high << 1) | (square.low >> 63);
  const std::uint64_t factor = alternating_series(arc_tangent_series, w);
  const std::uint64_t correction = (multiply_words(t64, factor).high + 64) >> 7;
  const std::uint64_t nearest = arc_tangents[static_cast<std::size_t>(i)];
  return backward ? nearest - correction : nearest + correction;
}

/// The phase of the vector (a, b), 0 <= b <= a <= 2^31, 0 < a: at most an eighth of a turn.
///
/// With i / 32 nearest to b / a, atan(b / a) = atan(i / 32) + atan(t),
/// t = (32 b - i a) / (32 a + i b), |t| <= 1/64. The error of t adds 1.3 units of
/// 2^-64 turn to those of `arc_phase`.
constexpr std::uint64_t octant_phase(std::uint64_t b, std::uint64_t a) noexcept {
  const std::uint64_t i = (64 * b + a) / (2 * a);
  const std::uint64_t ahead = 32 * b, behind = i * a;
  const std::uint64_t n = ahead < behind ? behind - ahead : ahead - behind;  // at most 2^30
  const std::uint64_t d = 32 * a + i * b;                                    // at most 2^37
  // 64 n / d in units of 2^-54, 27 bits at a time, then half a unit if there is a remainder.
  const std::uint64_t leading = (n << 33) / d, rest = (n << 33) % d;
  const std::uint64_t trailing = (rest << 27) / d;
  const bool exact = trailing * d == rest << 27;
  const std::uint64_t t =
      (((leading << 27) | trailing) << 9) | (exact ? 0u : 256u);  // 64 n / d, Q63
  return arc_phase(i, t, ahead < behind);
}

using Fine = Fixed<126, 124>;

/// 2 pi, rounded to nearest.
inline constexpr auto fine_two_pi = Fixed<127, 124>::assume_raw(
    integer_cast<Int128>(Wide<2>::from_words({0x62633145c06e0e69u, 0x6487ed5110b4611au})));

/// Whether the vector (a, b) of `octant_phase` lies above the ray at `turns`; it is never on the
/// ray.
///
/// The sign of b cos - a sin. Over all rays halfway between two binary angles in the octant and all
/// a, b up to 2^31, its magnitude is at least 2^-59.7 (angle_exhaustive.cpp tries them all, with
/// continued fractions); the series, truncated at 2^-124, are off by less than 2^-115.
constexpr bool lies_above(std::uint64_t b, std::uint64_t a, const Fixed<30, 33>& turns) noexcept {
  const Fine x = nearest_to<Fine>(turns * fine_two_pi);
  Fine term(1), cosine(1), sine(0);
  for (int k = 1; sign_of(term.raw()) != 0; ++k) {
    term = quotient_floor<Fine>(term * x, Fixed<31, 0>(k));
    auto& sum = k % 2 == 0 ? cosine : sine;
    if (k % 4 < 2) {
      sum += term;
    } else {
      sum -= term;
    }
  }
  return Fixed<33, 0>(b) * cosine > Fixed<33, 0>(a) * sine;
}

/// `octant_phase` rounded to the nearest binary angle.
constexpr std::uint32_t octant_angle(std::uint64_t b, std::uint64_t a) noexcept {
  const std::uint64_t phase = octant_phase(b, a);
  constexpr std::uint64_t half = std::uint64_t{1} << 31;
  constexpr std::uint64_t slack = 4;  // above the error of the phase
  const auto whole = static_cast<std::uint32_t>(phase >> 32);
  const std::uint64_t fraction = phase & (2 * half - 1);
  if (fraction < half - slack) return whole;
  if (fraction > half + slack) return whole + 1;
  const auto halfway = Fixed<30, 33>::assume_raw(static_cast<std::int32_t>(2 * whole + 1));
  return lies_above(b, a, halfway) ? whole + 1 : whole;
}

}  // namespace detail

/// The angle from the x axis to the vector (x, y), counter-clockwise, in units of 2^-32 turn.
///
/// domain: every x and y of at most 32 bits; 0 for the zero vector
/// exact:  rounded to nearest; ties do not occur, since no angle halfway between two binary angles
///         has a rational tangent      (tests/number/angle.test.cpp,
///         tests/number/angle_exhaustive.cpp)
[[nodiscard]] constexpr std::uint32_t binary_angle(std::int32_t y, std::int32_t x) noexcept {
  constexpr std::uint32_t quarter = std::uint32_t{1} << 30;
  const auto magnitude = [](std::int32_t v) {
    const auto bits = static_cast<std::uint32_t>(v);
    return std::uint64_t{v < 0 ? 0 - bits : bits};
  };
  const std::uint64_t along = magnitude(x), up = magnitude(y);
  if (along == 0 && up == 0) return 0;
  std::uint32_t angle =
      up > along ? quarter - detail::octant_angle(along, up) : detail::octant_angle(up, along);
  if (x < 0) angle = 2 * quarter - angle;
  return y < 0 ? 0 - angle : angle;
}

}  // namespace detent
