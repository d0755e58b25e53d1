// SPDX-License-Identifier: MIT
#pragma once

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/mpfr.hpp>
#include <concepts>
#include <cstdint>

#include "number/big_integer.hpp"

namespace detent::test {

/// Real numbers to about 200 bits, by MPFR.
using Real = boost::multiprecision::number<
    boost::multiprecision::mpfr_float_backend<60, boost::multiprecision::allocate_stack>,
    boost::multiprecision::et_off>;

inline Real pi() { return boost::math::constants::pi<Real>(); }

template <int Bits, int Frac>
Real real(const Fixed<Bits, Frac>& x) {
  return ldexp(Real(big_raw(x)), -Frac);
}
template <std::floating_point F>
Real real(F x) {
  return Real(x);
}

/// A binary angle in radians, in (-pi, pi].
inline Real radians_of(std::uint32_t binary_angle) {
  const auto value = static_cast<std::int32_t>(binary_angle - 1);
  return ldexp((Real(value) + 1) * pi(), -31);
}

/// The distance from `x` to `exact` in units of 2^-frac.
inline double ulps(const Real& x, const Real& exact, int frac) {
  return static_cast<double>(ldexp(abs(x - exact), frac));
}

/// The integer nearest to `x`; the caller knows that `x` is not a tie.
inline std::int64_t nearest_integer(const Real& x) {
  return static_cast<std::int64_t>(floor(x + Real(0.5)));
}

}  // namespace detent::test
