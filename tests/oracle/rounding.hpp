// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "oracle/point.hpp"

namespace detent::oracle {

/// `over / under` rounded to the nearest integer, ties to even.
inline Integer nearest_quotient(const Integer& over, const Integer& under) {
  const Integer down = floor_quotient(over, under);
  const Integer twice_rest = 2 * (over - down * under);
  const bool odd = (down % 2) != 0;
  return twice_rest > under || (twice_rest == under && odd) ? Integer(down + 1) : down;
}

/// The sign of x - y sqrt(square).
inline int sign_of_difference(const Integer& x, const Integer& y, const Integer& square) {
  const int x_sign = x.sign(), y_sign = square.is_zero() ? 0 : y.sign();
  if (x_sign != y_sign) return x_sign < y_sign ? -1 : 1;
  const Integer excess = x * x - y * y * square;
  return x_sign < 0 ? -excess.sign() : excess.sign();
}

/// Whether `given` is core + radius * v / |v| on one axis, rounded to nearest, ties to even; v
/// points away from the core.
template <int N>
bool is_rounded(const Integer& given, const Place<N>& core, std::size_t axis, const Integer& radius,
                const Vector<N>& v) {
  const Integer square = dot(v, v);
  const Integer twice = 2 * (given * core.under - core.over[axis]);
  const Integer step = 2 * radius * v[axis] * core.under;
  // twice - under <= step / |v| <= twice + under
  const int below = sign_of_difference(step, twice - core.under, square);
  const int above = sign_of_difference(step, twice + core.under, square);
  if (below == 0 || above == 0) return given % 2 == 0;
  return below > 0 && above < 0;
}

}  // namespace detent::oracle
