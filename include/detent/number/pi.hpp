// SPDX-License-Identifier: MIT
#pragma once

#include <numbers>

#include "detent/number/scalar.hpp"

namespace detent {

namespace detail {

/// pi and 4 pi / 3, rounded to a multiple of 2^-124.
inline constexpr auto pi = Fixed<126, 124>::assume_raw(
    integer_cast<Int128>(Wide<2>::from_words({0x313198a2e0370734u, 0x3243f6a8885a308du})));
inline constexpr auto four_thirds_pi = Fixed<127, 124>::assume_raw(
    integer_cast<Int128>(Wide<2>::from_words({0x96eccb83d59eb446u, 0x430548e0b5cd9611u})));

}  // namespace detail

/// x pi, off by at most 2^-125 x.
template <Number T>
[[nodiscard]] constexpr auto times_pi(const T& x) noexcept {
  if constexpr (is_fixed<T>) {
    return x * detail::pi;
  } else {
    return x * std::numbers::pi_v<T>;
  }
}

/// x 4 pi / 3, off by at most 2^-125 x.
template <Number T>
[[nodiscard]] constexpr auto times_four_thirds_pi(const T& x) noexcept {
  if constexpr (is_fixed<T>) {
    return x * detail::four_thirds_pi;
  } else {
    return x * (4 * std::numbers::pi_v<T> / 3);
  }
}

}  // namespace detent
