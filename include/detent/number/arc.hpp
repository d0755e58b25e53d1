// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>

#include "detent/number/angle.hpp"
#include "detent/number/root.hpp"

// Arcs: an angle given by its sine and cosine up to a common factor, fractions of it, and half of a
// given angle. Formulas for vectors and quaternions use these and round once.

namespace detent {

namespace detail {

/// The phase of the vector (a, b), 0 <= b <= a and 2^62 <= a < 2^63: at most an eighth of a turn.
///
/// Like `octant_phase`, from the quotient b / a in Q62. The quotient is off by less than two of its
/// units, which is 1.3 units of 2^-64 turn.
constexpr std::uint64_t long_octant_phase(std::uint64_t b, std::uint64_t a) noexcept {
  const auto quotient = [](std::uint64_t numerator, int shift, std::uint64_t denominator) {
    const Int128 shifted = shift_left(integer_cast<Int128>(Wide<2>(numerator)), shift);
    return integer_cast<std::uint64_t>(
        divide_floor(shifted, integer_cast<Int128>(Wide<2>(denominator))).quotient);
  };
  const std::uint64_t q = quotient(b, 62, a);
  const std::uint64_t i = (q + (std::uint64_t{1} << 56)) >> 57;  // nearest to 32 q
  // t = (q - i / 32) / (1 + q i / 32)
  const std::uint64_t at = i << 57;
  const std::uint64_t apart = q < at ? at - q : q - at;  // at most 2^56
  const std::uint64_t denominator = (std::uint64_t{1} << 62) + (q >> 5) * i + (((q & 31) * i) >> 5);
  return arc_phase(i, quotient(apart, 69, denominator), q < at);
}

/// The phase of the angle in [0, 1/2] turn whose sine and cosine are in the ratio of
/// sqrt(squared_sine) to `cosine`; 0 when both are 0.
///
/// exact: off by less than 3 units of 2^-64 turn; exact at multiples of an eighth of a turn
///        (tests/number/arc.test.cpp)
template <int Bits1, int Frac1, int Bits2, int Frac2>
constexpr std::uint64_t phase_of_arc(const Fixed<Bits1, Frac1>& squared_sine,
                                     const Fixed<Bits2, Frac2>& cosine) noexcept {
  static_assert(Frac1 == 2 * Frac2);
  using Integer = IntegerFor<(std::max)({Bits1, 2 * Bits2, 127}) + 1>;
  const Integer opposite = integer_cast<Integer>(squared_sine.raw());
  const Integer adjacent = wrapping_multiply<Integer>(cosine.raw(), cosine.raw());
  const int length = bit_length((std::max)(opposite, adjacent));
  if (length == 0) return 0;
  // Scales both squares by the same power of 4, so that the greater has 125 or 126 bits: their
  // roots, of about 2^62, lose less than 1.
  const int shift = (126 - length) & ~1;
  const auto root = [shift](const Integer& square) {
    const auto scaled = integer_cast<Wide<2>>(shift >= 0 ? shift_left(square, shift)
                                                         : shift_right_floor(square, -shift));
    return square_root_floor(scaled.word(1), scaled.word(0));
  };
  const std::uint64_t up = root(opposite), along = root(adjacent);
  constexpr std::uint64_t quarter = std::uint64_t{1} << 62;
  const std::uint64_t acute =
      up > along ? quarter - long_octant_phase(along, up) : long_octant_phase(up, along);
  return is_negative(cosine.raw()) ? 2 * quarter - acute : acute;
}

/// The phase of half an angle, in (-1/4, 1/4] turn.
template <int B, int F>
constexpr std::uint64_t half_phase(Angle<Fixed<B, F>> angle) noexcept {
  constexpr std::uint32_t half_turn = std::uint32_t{1} << 31;
  const std::uint64_t half = std::uint64_t{angle.raw()} << 31;
  return angle.raw() > half_turn ? half + (std::uint64_t{1} << 63) : half;
}

template <class Sine, class Cosine>
struct HalfAngle {
  Sine sine;
  Cosine cosine;
};

template <class T>
struct ArcWeights {
  T start;
  T end;
};

}  // namespace detail

/// `times` the angle in [0, 1/2] turn whose sine and cosine are in the ratio of sqrt(squared_sine)
/// to `cosine`; 0 when both are 0.
///
/// exact:  off by less than 0.5 + 2^-28 units for `times` up to 2    (tests/number/arc.test.cpp)
template <Scalar S, int Bits1, int Frac1, int Bits2, int Frac2>
[[nodiscard]] constexpr Angle<S> angle_of_arc(const Fixed<Bits1, Frac1>& squared_sine,
                                              const Fixed<Bits2, Frac2>& cosine,
                                              int times = 1) noexcept {
  const std::uint64_t phase =
      detail::phase_of_arc(squared_sine, cosine) * static_cast<std::uint64_t>(times);
  constexpr std::uint64_t half = std::uint64_t{1} << 31;
  return Angle<S>::from_raw(static_cast<std::uint32_t>((phase + half) >> 32));
}

/// sin((1 - t) a) and sin(t a) for the angle a of `angle_of_arc` and t in [0, 1]: the weights of
/// the ends of an arc for its point at t.
///
/// exact: off by less than 2^-59 each                                 (tests/number/arc.test.cpp)
template <int Bits1, int Frac1, int Bits2, int Frac2, int B, int F>
[[nodiscard]] constexpr auto arc_weights(const Fixed<Bits1, Frac1>& squared_sine,
                                         const Fixed<Bits2, Frac2>& cosine,
                                         const Fixed<B, F>& t) noexcept {
  using Sine = Fixed<62, 62>;
  const std::uint64_t phase = detail::phase_of_arc(squared_sine, cosine);
  const auto whole = Fixed<64, 0>::assume_raw(integer_cast<Int128>(Wide<2>(phase)));
  const auto part = integer_cast<std::uint64_t>(nearest_to<Fixed<64, 0>>(whole * t).raw());
  return detail::ArcWeights<Sine>{Sine::assume_raw(sine_q62(phase - part)),
                                  Sine::assume_raw(sine_q62(part))};
}

/// Sine and cosine of half an angle in (-1/2, 1/2] turn; the cosine is not negative.
///
/// exact: off by less than 2^-61
template <int B, int F>
[[nodiscard]] constexpr auto half_sine_cosine(Angle<Fixed<B, F>> angle) noexcept {
  using Sine = Fixed<62, 62>;
  const std::uint64_t phase = detail::half_phase(angle);
  return detail::HalfAngle<Sine, Sine>{Sine::assume_raw(sine_q62(phase)),
                                       Sine::assume_raw(cosine_q62(phase))};
}

/// `half_sine_cosine` with a relative error of the sine below 2^-61, even for tiny angles.
template <int B, int F>
[[nodiscard]] constexpr auto half_tangent(Angle<Fixed<B, F>> angle) noexcept {
  // Like `sine_q62`: sin(pi z / 2) = z f(z^2), z in Q62 and f in Q63, but the product keeps all
  // bits.
  using Sine = Fixed<126, 125>;
  const std::uint64_t phase = detail::half_phase(angle);
  const bool negative = phase >> 63 != 0;
  const std::uint64_t z = negative ? 0 - phase : phase;
  const auto square = multiply_words(z, z);
  const std::uint64_t w = (square.high << 3) | (square.low >> 61);
  const auto product = multiply_words(z, detail::alternating_series(detail::sine_series, w));
  const auto sine =
      Sine::assume_raw(integer_cast<Int128>(Wide<2>::from_words({product.low, product.high})));
  using Cosine = Fixed<62, 62>;
  return detail::HalfAngle<Sine, Cosine>{negative ? narrow<126>(-sine) : sine,
                                         Cosine::assume_raw(cosine_q62(phase))};
}

#if __STDC_HOSTED__
template <Scalar S, std::floating_point F>
[[nodiscard]] constexpr Angle<S> angle_of_arc(F squared_sine, F cosine, int times = 1) noexcept {
  const F angle = std::atan2(std::sqrt(squared_sine), cosine);
  return times == 1 ? Angle<S>::from_raw(angle)
                    : Angle<S>::from_radians(static_cast<F>(times) * angle);
}
template <std::floating_point F>
[[nodiscard]] constexpr auto arc_weights(F squared_sine, F cosine, F t) noexcept {
  const F angle = std::atan2(std::sqrt(squared_sine), cosine);
  return detail::ArcWeights<F>{std::sin((1 - t) * angle), std::sin(t * angle)};
}
template <std::floating_point F>
[[nodiscard]] constexpr auto half_sine_cosine(Angle<F> angle) noexcept {
  return detail::HalfAngle<F, F>{std::sin(angle.raw() / 2), std::cos(angle.raw() / 2)};
}
template <std::floating_point F>
[[nodiscard]] constexpr auto half_tangent(Angle<F> angle) noexcept {
  return half_sine_cosine(angle);
}
#endif

}  // namespace detent
