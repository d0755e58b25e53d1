// SPDX-License-Identifier: MIT
#pragma once

#include "detent/dynamics/axial.hpp"

namespace detent::detail {

/// The sum of up to three products of short numbers, of magnitudes of at most 2^30 (1 + 2^-28)
/// steps, and long ones, of at most 52 bits, rounded to nearest once, in 64-bit words.
///
/// A long number is 2^22 u + l with 0 <= l < 2^22. The sum over the u is at most 3 2^60 (1 +
/// 2^-28), that over the l less than 2^54. Their sum in units of 2^22, rounded down with a sticky
/// last bit for the remainder, rounds like the exact sum, because at least two more bits are
/// rounded off.
template <class T, class Short, class Long, int N>
[[nodiscard]] constexpr T nearest_dot(const Vec<Short, N>& a, const Vec<Long, N>& b) noexcept {
  if constexpr (is_fixed<T>) {
    constexpr int cut = 22;
    using Whole = Fixed<62, Short::frac + Long::frac - cut>;
    static_assert(N <= 3 && Short::bits <= 31 && Long::bits <= 52 && Whole::frac >= T::frac + 2);
    using Raw = typename Whole::raw_type;
    constexpr Raw mask = (Raw(1) << cut) - 1;
    Raw upper = 0, lower = 0;
    for (int i = 0; i < N; ++i) {
      const Raw x = a[i].raw(), y = b[i].raw();
      upper += x * (y >> cut);
      lower += x * (y & mask);
    }
    const Raw rest = (lower & mask) != 0 ? 1 : 0;
    return nearest_to<T>(Whole::assume_raw((upper + (lower >> cut)) | rest));
  } else {
    return nearest_to<T>(dot(a, b));
  }
}

/// n / d rounded to nearest, for d > 0 and numbers of at most 53 bits on one grid. Most quotients
/// are below 2^32 steps and take one 64-bit division.
template <class T, class N, class D>
[[nodiscard]] constexpr T quotient_of_long(const N& n, const D& d) noexcept {
  if constexpr (is_fixed<T>) {
    static_assert(N::frac == D::frac && N::bits <= 53 && D::bits <= 53 && T::bits <= 31);
    using Raw = typename D::raw_type;
    const Raw magnitude = is_negative(n.raw()) ? -n.raw() : n.raw();
    if (magnitude >> (32 - T::frac) < d.raw()) {
      auto quotient = short_quotient(shift_left(integer_cast<Int128>(magnitude), T::frac), d.raw());
      // Modulo 2^64: the remainder is less than d.
      const Raw rest = wrapping_subtract<Raw>(shift_left(magnitude, T::frac),
                                              wrapping_multiply<Raw>(quotient, d.raw()));
      const Raw to_next = d.raw() - rest;
      if (rest > to_next || (rest == to_next && (quotient & 1) != 0)) ++quotient;
      return clamp_raw<T>(is_negative(n.raw()) ? -quotient : quotient);
    }
  }
  return quotient_nearest<T>(n, d);
}

}  // namespace detent::detail
