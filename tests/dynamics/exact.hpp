// SPDX-License-Identifier: MIT
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <cstdint>

#include "detent/number/fixed.hpp"

namespace detent::test {

using Rational = boost::multiprecision::cpp_rational;

/// The value of a number of at most 64 bits.
template <int B, int F>
Rational exact(const Fixed<B, F>& x) {
  return Rational(std::int64_t(x.raw())) / Rational(std::int64_t{1} << F);
}

}  // namespace detent::test
