// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "detent/math/vec.hpp"
#include "detent/number/filter/filtered.hpp"

namespace detent {

/// Whether |x| <= 2^(Bits - F), so that `narrow<Bits>(x)` is x; always true for scalars that round.
template <int Bits, Number T>
[[nodiscard]] constexpr bool fits([[maybe_unused]] const T& x) noexcept {
  if constexpr (bits_of<T> <= Bits) {
    return true;
  } else {
    return detail::is_within<Bits>(x.raw());
  }
}
template <int Bits, Number T, int N>
[[nodiscard]] constexpr bool fits(const Vec<T, N>& v) noexcept {
  bool all = true;  // no branch per component
  for (int i = 0; i < N; ++i) all = fits<Bits>(v[i]) && all;
  return all;
}

namespace detail {

template <int Bits, Number T>
[[nodiscard]] constexpr auto at_most(const T& x) noexcept {
  if constexpr (bits_of<T> <= Bits) {
    return x;
  } else {
    return narrow<Bits>(x);
  }
}
template <int Bits, Number T, int N>
[[nodiscard]] constexpr auto at_most(const Vec<T, N>& v) noexcept {
  return make_vec<N>([&](int i) { return at_most<Bits>(v[i]); });
}

/// The bits of the longest component, without its sign.
template <Number T, int N>
[[nodiscard]] constexpr int longest_bits(const Vec<T, N>& v) noexcept {
  int length = 0;
  for (int i = 0; i < N; ++i) length = (std::max)(length, bit_length(v[i].raw()));
  return length;
}
/// v without its `dropped` low bits, rounded down. T holds the rest.
template <class T, Number V, int N>
[[nodiscard]] constexpr Vec<T, N> without_low_bits(const Vec<V, N>& v, int dropped) noexcept {
  return make_vec<N>([&](int i) {
    return T::assume_raw(
        integer_cast<typename T::raw_type>(shift_right_floor(v[i].raw(), dropped)));
  });
}

}  // namespace detail

/// f(x...), computed in narrower integers if all operands, numbers or vectors, fit `Bits`.
///
/// A formula that needs 256 bits for the whole domain needs 128 for operands of ordinary size. `f`
/// is exact in both, so the width only changes the time. Small code has only the form for the whole
/// domain.
template <int Bits, class F, class... Operands>
[[nodiscard]] constexpr auto by_width(const F& f, const Operands&... x) noexcept {
  if constexpr (has_filters) {
    if ((fits<Bits>(x) && ...)) return f(detail::at_most<Bits>(x)...);
  }
  return f(x...);
}

}  // namespace detent
