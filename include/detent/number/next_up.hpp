// SPDX-License-Identifier: MIT
#pragma once

#include "detent/number/scalar.hpp"

namespace detent {

/// The next greater number of the type, or x if it is the greatest; `float` and `double` are
/// returned unchanged.
template <Number T>
[[nodiscard]] constexpr T next_up(const T& x) noexcept {
  if constexpr (!is_fixed<T>) {
    return x;
  } else {
    using Raw = typename T::raw_type;
    return x < (T::max)() ? T::assume_raw(wrapping_add<Raw>(x.raw(), Raw(1))) : x;
  }
}

namespace detail {

/// The numbers one raw unit after and before x. The caller proves that they are in range.
template <Number T>
[[nodiscard]] constexpr T next_raw(const T& x) noexcept {
  return T::assume_raw(static_cast<typename T::raw_type>(x.raw() + 1));
}
template <Number T>
[[nodiscard]] constexpr T previous_raw(const T& x) noexcept {
  return T::assume_raw(static_cast<typename T::raw_type>(x.raw() - 1));
}

}  // namespace detail

}  // namespace detent
