// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <cstdint>
#include <type_traits>

#include "detent/number/rounding.hpp"
#include "detent/number/trigonometry.hpp"

#if __STDC_HOSTED__
#include <cmath>
#include <numbers>

#include "detent/number/floating.hpp"
#endif

namespace detent {

/// An angle modulo one turn: a binary angle for a `Fixed`, radians for `float` and `double`.
template <Scalar S>
class Angle;

namespace detail {

/// The types for intermediate sines, and for their quotients up to 4, before the final rounding.
/// Products with two components of a direction fit 128 bits.
template <Scalar S>
struct Precise {
  using Sine = S;
  using Ratio = S;
};
template <int Bits, int Frac>
struct Precise<Fixed<Bits, Frac>> {
  using Sine = Fixed<62, 62>;
  using Ratio = Fixed<62, 60>;
};

/// 2 pi and 1 / (2 pi), with as many bits as allow products with a scalar to fit 128 bits. Every
/// such product is rounded correctly (tests/number/angle.test.cpp: "constants").
inline constexpr auto two_pi = Fixed<94, 91>::assume_raw(
    integer_cast<Int128>(Wide<2>::from_words({0x885a308d313198a3u, 0x3243f6a8u})));
inline constexpr auto turns_per_radian = Fixed<95, 97>::assume_raw(
    integer_cast<Int128>(Wide<2>::from_words({0x27220a94fe13abe9u, 0x517cc1b7u})));

}  // namespace detail

/// An angle in units of 2^-32 turn. Counter-clockwise is positive; sums wrap, exactly.
template <int Bits, int Frac>
class Angle<Fixed<Bits, Frac>> {
  using S = Fixed<Bits, Frac>;

 public:
  using raw_type = std::uint32_t;

  constexpr Angle() noexcept = default;

  /// raw / 2^32 of a turn.
  [[nodiscard]] static constexpr Angle from_raw(raw_type raw) noexcept {
    Angle angle;
    angle.raw_ = raw;
    return angle;
  }

  /// numerator / denominator of a turn: `turn(1, 4)` is a right angle.
  ///
  /// domain: every numerator; 0 for the denominator 0, which is a caller's bug
  /// exact:  rounded to nearest, ties to even
  [[nodiscard]] static constexpr Angle turn(int numerator, int denominator) noexcept {
    DETENT_ASSERT(denominator != 0);
    if (denominator == 0) return Angle();
    using Whole = Fixed<31, 0>;
    return from_turns(quotient_nearest<Fixed<64, 32>>(Whole(numerator), Whole(denominator)));
  }

  /// exact: rounded to nearest, ties to even
  [[nodiscard]] static constexpr Angle from_degrees(S degrees) noexcept {
    return from_turns(quotient_nearest<Turns>(degrees, Fixed<9, 0>(360)));
  }

  /// exact: rounded to nearest
  [[nodiscard]] static constexpr Angle from_radians(S radians) noexcept {
    return from_turns(nearest_to<Turns>(radians * detail::turns_per_radian));
  }

  /// The angle in units of 2^-32 turn, from 0 to a turn.
  [[nodiscard]] constexpr raw_type raw() const noexcept { return raw_; }

  // Parentheses protect names from the macros of Arduino.h; callers with those macros write
  // (angle.degrees)() too.

  /// The angle in (-180, 180], rounded to nearest, ties to even, and clamped.
  [[nodiscard]] constexpr S(degrees)() const noexcept {
    return nearest_to<S>(signed_turns() * Fixed<9, 0>(360));
  }

  /// The angle in (-pi, pi], rounded to nearest and clamped.
  [[nodiscard]] constexpr S(radians)() const noexcept {
    return nearest_to<S>(signed_turns() * detail::two_pi);
  }

  [[nodiscard]] friend constexpr Angle operator+(Angle a, Angle b) noexcept {
    return from_raw(a.raw_ + b.raw_);
  }
  [[nodiscard]] friend constexpr Angle operator-(Angle a, Angle b) noexcept {
    return from_raw(a.raw_ - b.raw_);
  }
  [[nodiscard]] constexpr Angle operator-() const noexcept { return from_raw(0 - raw_); }
  constexpr Angle& operator+=(Angle other) noexcept { return *this = *this + other; }
  constexpr Angle& operator-=(Angle other) noexcept { return *this = *this - other; }

  [[nodiscard]] friend constexpr bool operator==(Angle, Angle) noexcept = default;

 private:
  using Turns = Fixed<63, 32>;

  template <int B>
  static constexpr Angle from_turns(const Fixed<B, 32>& turns) noexcept {
    return from_raw(integer_cast<raw_type>(turns.raw()));
  }

  /// In (-1/2, 1/2].
  constexpr Fixed<32, 32> signed_turns() const noexcept {
    constexpr auto half = std::int64_t{1} << 31;
    const std::int64_t raw = raw_;
    return Fixed<32, 32>::assume_raw(raw > half ? raw - 2 * half : raw);
  }

  raw_type raw_ = 0;
};

#if __STDC_HOSTED__
/// An angle in radians. Inputs and sums are reduced to [-pi, pi], without promises.
template <Scalar S>
requires std::floating_point<S>
class Angle<S> {
 public:
  using raw_type = S;

  constexpr Angle() noexcept = default;

  [[nodiscard]] static constexpr Angle from_raw(S radians) noexcept {
    Angle angle;
    angle.raw_ = radians;
    return angle;
  }
  [[nodiscard]] static constexpr Angle turn(int numerator, int denominator) noexcept {
    if (denominator == 0) return Angle();
    return from_turns(static_cast<S>(numerator) / static_cast<S>(denominator));
  }
  [[nodiscard]] static constexpr Angle from_degrees(S degrees) noexcept {
    return from_turns(degrees / 360);
  }
  [[nodiscard]] static constexpr Angle from_radians(S radians) noexcept {
    return from_raw(std::remainder(radians, two_pi));
  }

  /// The angle in radians; `radians` is the same, `degrees` converts.
  [[nodiscard]] constexpr S raw() const noexcept { return raw_; }
  [[nodiscard]] constexpr S(degrees)() const noexcept { return raw_ * (360 / two_pi); }
  [[nodiscard]] constexpr S(radians)() const noexcept { return raw_; }

  [[nodiscard]] friend constexpr Angle operator+(Angle a, Angle b) noexcept {
    return from_radians(a.raw_ + b.raw_);
  }
  [[nodiscard]] friend constexpr Angle operator-(Angle a, Angle b) noexcept {
    return from_radians(a.raw_ - b.raw_);
  }
  [[nodiscard]] constexpr Angle operator-() const noexcept { return from_raw(-raw_); }
  constexpr Angle& operator+=(Angle other) noexcept { return *this = *this + other; }
  constexpr Angle& operator-=(Angle other) noexcept { return *this = *this - other; }

  [[nodiscard]] friend constexpr bool operator==(Angle, Angle) noexcept = default;

 private:
  static constexpr S two_pi = 2 * std::numbers::pi_v<S>;

  static constexpr Angle from_turns(S turns) noexcept {
    return from_raw(std::remainder(turns, S(1)) * two_pi);
  }

  S raw_ = 0;
};
#endif

/// Appends to a digest: the raw angle.
template <class D, Scalar S>
constexpr void append(D& digest, Angle<S> angle) noexcept {
  digest.add(angle.raw());
}

namespace detail {

template <class To, class S>
using to_or_own = std::conditional_t<std::is_void_v<To>, S, To>;

template <int B, int F>
constexpr std::uint64_t phase_of(Angle<Fixed<B, F>> angle) noexcept {
  return std::uint64_t{angle.raw()} << 32;
}

template <class T>
struct SineCosine {
  T sine;
  T cosine;
};

}  // namespace detail

/// The sine of an angle, as the angle's scalar or, with `sin<T>(angle)`, as a given type.
///
/// domain: every angle; T any `Fixed` with at most 30 fractional bits
/// result: 0, 1 and -1 at the quarter turns; sin(-a) = -sin(a); clamped to T
/// exact:  rounded to nearest; no sine of a binary angle is rational except 0 and +-1, so ties do
///         not occur                                        (tests/number/angle_exhaustive.cpp)
template <class To = void, int B, int F>
[[nodiscard]] constexpr auto sin(Angle<Fixed<B, F>> angle) noexcept {
  using T = detail::to_or_own<To, Fixed<B, F>>;
  static_assert(T::frac <= 30, "detent: sines are correctly rounded to at most 30 fractional bits");
  return nearest_to<T>(Fixed<62, 62>::assume_raw(sine_q62(detail::phase_of(angle))));
}

/// The cosine of an angle: `sin` a quarter turn ahead.
template <class To = void, int B, int F>
[[nodiscard]] constexpr auto cos(Angle<Fixed<B, F>> angle) noexcept {
  using A = Angle<Fixed<B, F>>;
  return sin<To>(angle + A::from_raw(std::uint32_t{1} << 30));
}

/// The angle from the x axis to the vector (x, y).
///
/// domain: every x and y; 0 for the zero vector
/// result: in (-1/2, 1/2] turn; exact along the axes and the diagonals; atan2(-y, x) = -atan2(y, x)
/// exact:  rounded to nearest; ties do not occur                   (tests/number/angle.test.cpp)
template <int B, int F>
[[nodiscard]] constexpr Angle<Fixed<B, F>> atan2(
    Fixed<B, F> y, Fixed<B, F> x) noexcept requires Scalar<Fixed<B, F>> {
  return Angle<Fixed<B, F>>::from_raw(binary_angle(y.raw(), x.raw()));
}

/// Sine and cosine before rounding, for formulas that round once at the end: off by less than
/// 2^-61.
template <int B, int F>
[[nodiscard]] constexpr auto sine_cosine(Angle<Fixed<B, F>> angle) noexcept {
  using Sine = Fixed<62, 62>;
  const std::uint64_t phase = detail::phase_of(angle);
  return detail::SineCosine<Sine>{Sine::assume_raw(sine_q62(phase)),
                                  Sine::assume_raw(cosine_q62(phase))};
}

#if __STDC_HOSTED__

/// Sine, cosine and arc tangent of `float` and `double`: those of `<cmath>`.
template <class To = void, std::floating_point F>
[[nodiscard]] constexpr auto sin(Angle<F> angle) noexcept {
  return static_cast<detail::to_or_own<To, F>>(std::sin(angle.raw()));
}
template <class To = void, std::floating_point F>
[[nodiscard]] constexpr auto cos(Angle<F> angle) noexcept {
  return static_cast<detail::to_or_own<To, F>>(std::cos(angle.raw()));
}
template <std::floating_point F>
[[nodiscard]] constexpr Angle<F> atan2(F y, F x) noexcept {
  return Angle<F>::from_raw(std::atan2(y, x));
}
template <std::floating_point F>
[[nodiscard]] constexpr detail::SineCosine<F> sine_cosine(Angle<F> angle) noexcept {
  return {sin(angle), cos(angle)};
}
#endif

}  // namespace detent
