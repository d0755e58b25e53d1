// SPDX-License-Identifier: MIT
#pragma once

#include "detent/dynamics/contact.hpp"

namespace detent::detail {

/// The center of b relative to that of a, along the world's axes: rounded to nearest and clamped.
template <Scalar S, int N>
[[nodiscard]] constexpr Vec<typename Formats<S>::Lever, N> offset_between(
    const Support<S, N>& a, const Support<S, N>& b) noexcept {
  return make_vec<N>(
      [&](int i) { return saturate_to<typename Formats<S>::Lever>(b.place[i] - a.place[i]); });
}

/// The pose of b in the frame of a: every number is a sum of products rounded to nearest once.
///
/// |axis| |offset| < 2^30 2^31 sqrt(3) (1 + 2^-28) fits 62 bits.
template <Scalar S, int N>
[[nodiscard]] constexpr RelativePose<S, N> relative_pose(
    const Support<S, N>& a, const Support<S, N>& b,
    const Vec<typename Formats<S>::Lever, N>& offset) noexcept {
  using F = Formats<S>;
  RelativePose<S, N> pose;
  for (int i = 0; i < N; ++i) {
    const auto& axis = a.axes[static_cast<std::size_t>(i)];
    pose.translation[i] = nearest_to<typename F::Lever>(narrow_dot<62>(axis, offset));
    for (std::size_t j = 0; j < std::size_t{N}; ++j) {
      pose.axes[j][i] = nearest_to<typename F::Ratio>(narrow_dot<62>(axis, b.axes[j]));
    }
  }
  return pose;
}

}  // namespace detent::detail
