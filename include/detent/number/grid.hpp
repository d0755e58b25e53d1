// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "detent/number/fixed.hpp"

// Grids whose steps are a power of two of a type's own, known only at run time.

namespace detent::detail {

/// x in steps of 2^exponent of its own, rounded to nearest, ties to even.
///
/// domain: exponents from 0 to 62
template <int Bits, int Frac>
requires(Bits <= 62)
    [[nodiscard]] constexpr Fixed<Bits, 0> steps_nearest(const Fixed<Bits, Frac>& x,
                                                         int exponent) noexcept {
  using Raw = typename Fixed<Bits, 0>::raw_type;
  const std::int64_t n = x.raw();
  if (exponent == 0) return Fixed<Bits, 0>::assume_raw(static_cast<Raw>(n));
  // Half a step less one, and one more if the number below is odd.
  const auto up = (std::int64_t{1} << (exponent - 1)) - 1 + (n >> exponent & 1);
  return Fixed<Bits, 0>::assume_raw(static_cast<Raw>((n + up) >> exponent));
}

/// The number of n steps of 2^exponent steps of T.
///
/// domain: the result is one of T
template <class T, int Bits>
[[nodiscard]] constexpr T of_steps(const Fixed<Bits, 0>& n, int exponent) noexcept {
  return T::assume_raw(
      static_cast<typename T::raw_type>(static_cast<std::int64_t>(n.raw()) << exponent));
}

/// The lowest `bits` bits of a number's integer.
template <int Bits, int Frac>
[[nodiscard]] constexpr std::uint64_t low_bits(const Fixed<Bits, Frac>& x, int bits) noexcept {
  return static_cast<std::uint64_t>(static_cast<std::int64_t>(x.raw())) &
         ((std::uint64_t{1} << bits) - 1);
}

/// The number whose integer has these lowest `bits` bits, of which the highest is its sign; clamped.
template <class T>
[[nodiscard]] constexpr T from_low_bits(std::uint64_t word, int bits) noexcept {
  const auto n = static_cast<std::int64_t>(word << (64 - bits)) >> (64 - bits);
  const T x = T::from_raw(static_cast<typename T::raw_type>(n));
  return x.raw() == n ? x : n < 0 ? T::lowest() : (T::max)();
}

}  // namespace detent::detail
