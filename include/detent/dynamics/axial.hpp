// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include "detent/dynamics/formats.hpp"

namespace detent::detail {

/// An axial quantity: a number in 2D, a vector in 3D.
template <Number T, int N>
using Axial = std::array<T, std::size_t{N == 2 ? 1 : 3}>;

/// r x n, each component rounded to nearest.
///
/// At most |r| |n|, which is below 2^29 sqrt(3) (1 + 2^-28) steps: it fits a moment.
template <Scalar S, int N, class F = Formats<S>>
[[nodiscard]] constexpr Axial<typename F::Moment, N> moment(
    const Vec<typename F::Arm, N>& r, const Vec<typename F::Ratio, N>& n) noexcept {
  const auto about = [&](int j, int k) {
    return nearest_to<typename F::Moment>(narrow_cross<62>(Vec<typename F::Arm, 2>{r[j], r[k]},
                                                           Vec<typename F::Ratio, 2>{n[j], n[k]}));
  };
  if constexpr (N == 2) {
    return {about(0, 1)};
  } else {
    return {about(1, 2), about(2, 0), about(0, 1)};
  }
}

/// A symmetric matrix about the center of a body, such as an inertia: in 2D a number, in 3D the
/// entries 00, 11, 22, 12, 20, 01.
template <Number T, int N>
using Spread = std::array<T, std::size_t{N == 2 ? 1 : 6}>;

/// The index of the entry of row i and column j.
template <int N>
[[nodiscard]] constexpr std::size_t entry(int i, int j) noexcept {
  if constexpr (N == 2) return 0;
  return static_cast<std::size_t>(i == j ? i : 6 - i - j);
}

}  // namespace detent::detail
