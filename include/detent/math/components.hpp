// SPDX-License-Identifier: MIT
#pragma once

#include "detent/math/vec.hpp"

namespace detent::detail {

template <Number T, int N>
[[nodiscard]] constexpr bool is_zero(const Vec<T, N>& v) noexcept {
  for (int i = 0; i < N; ++i) {
    if (v[i] != 0) return false;
  }
  return true;
}

/// The axis of the component of greatest magnitude; the first in case of a tie.
template <Number T, int N>
[[nodiscard]] constexpr int longest_axis(const Vec<T, N>& v) noexcept {
  int longest = 0;
  for (int i = 1; i < N; ++i) {
    if (abs(v[i]) > abs(v[longest])) longest = i;
  }
  return longest;
}

/// The sum of the magnitudes of a vector's components.
template <Number T>
[[nodiscard]] constexpr auto sum_of_magnitudes(const Vec<T, 2>& v) noexcept {
  return abs(v.x) + abs(v.y);
}
template <Number T>
[[nodiscard]] constexpr auto sum_of_magnitudes(const Vec<T, 3>& v) noexcept {
  return abs(v.x) + abs(v.y) + abs(v.z);
}

/// A vector without component `axis`, in the order that preserves orientation.
template <Number T>
[[nodiscard]] constexpr Vec<T, 2> without(const Vec<T, 3>& v, int axis) noexcept {
  return {v[(axis + 1) % 3], v[(axis + 2) % 3]};
}

/// Whether two vectors, or a direction and a vector, are parallel; 0 is parallel to every vector.
template <class U, Number T, int N>
[[nodiscard]] constexpr bool are_parallel(const U& u, const Vec<T, N>& v) noexcept {
  const auto area = cross(u, v);
  if constexpr (N == 2) {
    return area == 0;
  } else {
    return is_zero(area);
  }
}

}  // namespace detent::detail
