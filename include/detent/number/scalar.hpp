// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <limits>

#include "detent/number/fixed.hpp"
#include "detent/number/mixed.hpp"

namespace detent {

/// Whether a type rounds each operation as the platform does: `float` and `double`. A test adds a
/// type that tracks this rounding (fuzz/traced.hpp).
template <class T>
inline constexpr bool is_floating = std::same_as<T, float> || std::same_as<T, double>;

/// A number that formulas compute with: a `Fixed` of any width, `float` or `double`.
template <class T>
concept Number = is_fixed<T> || is_floating<T>;

/// A number that coordinates are stored in: a `Fixed<Bits, Frac>` with 1 <= Bits <= 31 and
/// 0 <= Frac < Bits, `float` or `double`.
///
/// With at most 31 bits every query has an integer wide enough for its exact result. 31 bits are
/// also enough for a game world; `q14_16` and `q8_8` trade range for speed. With Frac < Bits the
/// number 1 exists: a transform without scaling has scale 1. With Frac >= 0 every integer in range
/// is on the grid. `Fixed<1, 0>` is the smallest, with coordinates from -2 to 1. `float` and
/// `double` use the same formulas, without promises, for comparison.
template <class T>
concept Scalar = Number<T> &&(!is_fixed<T> || requires {
  requires T::bits <= 31;
  requires T::frac >= 0;
  requires T::frac < T::bits;
});

/// The most bits that the magnitude of a number of this type needs; 0 for `float` and `double`,
/// whose bits are not counted.
template <Number T>
inline constexpr int bits_of = 0;
template <int Bits, int Frac>
inline constexpr int bits_of<Fixed<Bits, Frac>> = Bits;

/// x * x, exactly.
template <Number T>
[[nodiscard]] constexpr auto square(const T& x) noexcept {
  return x * x;
}

/// The greatest value of a number's type.
template <Number S>
inline constexpr S largest = (std::numeric_limits<S>::max)();
template <int Bits, int Frac>
inline constexpr Fixed<Bits, Frac> largest<Fixed<Bits, Frac>> = (Fixed<Bits, Frac>::max)();

/// The least value of a number's type.
template <Number S>
inline constexpr S lowest = std::numeric_limits<S>::lowest();
template <int Bits, int Frac>
inline constexpr Fixed<Bits, Frac> lowest<Fixed<Bits, Frac>> = Fixed<Bits, Frac>::lowest();

/// The integer that stores a scalar or a component of a direction; for `float` and `double` the
/// type itself.
template <Number T>
struct raw_of {
  using type = T;
};
template <int Bits, int Frac>
struct raw_of<Fixed<Bits, Frac>> {
  using type = typename Fixed<Bits, Frac>::raw_type;
};

namespace detail {

template <Scalar S>
struct direction_component_of {
  using type = S;
};
template <int Bits, int Frac>
struct direction_component_of<Fixed<Bits, Frac>> {
  static constexpr int width = value_bits<IntegerFor<Bits>>;
  using type = Fixed<width, width - 1>;
};

template <Scalar S, int Count>
struct finer_of {
  using type = S;
};
template <int Bits, int Frac, int Count>
struct finer_of<Fixed<Bits, Frac>, Count> {
  using type = Fixed<Bits + Count, Frac + Count>;
};

}  // namespace detail

/// The type of a component of a unit vector, as large as a scalar: Q2.30 for coordinates of 16 to
/// 31 bits and Q2.14 for shorter ones; `float` and `double` themselves.
///
/// The grid is never coarser, even for shorter scalars: proofs rely on lengths within 2^-13 of 1.
template <Scalar S>
using direction_component = typename detail::direction_component_of<S>::type;

/// The scalar with `Count` more bits after the point and the same range; `float` and `double`
/// themselves.
template <Scalar S, int Count>
using finer = typename detail::finer_of<S, Count>::type;

}  // namespace detent
