// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "detent/dynamics/contact.hpp"
#include "detent/dynamics/local.hpp"
#include "detent/dynamics/manifold/pair.hpp"
#include "detent/math/width.hpp"

namespace detent::detail {

/// The center of b relative to that of a, along the world's axes: rounded to nearest and clamped.
template <Scalar S, int N>
[[nodiscard]] constexpr Vec<typename Formats<S>::Lever, N> offset_between(
    const Support<S, N>& a, const Support<S, N>& b) noexcept {
  return make_vec<N>(
      [&](int i) { return saturate_to<typename Formats<S>::Lever>(b.place[i] - a.place[i]); });
}

/// The position of b in the frame of a: every number is a sum of products rounded to nearest once.
///
/// |axis| |offset| < 2^30 2^31 sqrt(3) (1 + 2^-28) fits 62 bits.
template <Scalar S, int N>
[[nodiscard]] constexpr Vec<typename Formats<S>::Lever, N> relative_place(
    const Support<S, N>& a, const Vec<typename Formats<S>::Lever, N>& offset) noexcept {
  return make_vec<N>([&](int i) {
    return nearest_to<typename Formats<S>::Lever>(
        narrow_dot<62>(a.axes[static_cast<std::size_t>(i)], offset));
  });
}

/// The pose of b in the frame of a, rounded in the same way.
template <Scalar S, int N>
[[nodiscard]] constexpr RelativePose<S, N> relative_pose(
    const Support<S, N>& a, const Support<S, N>& b,
    const Vec<typename Formats<S>::Lever, N>& offset) noexcept {
  RelativePose<S, N> pose;
  pose.translation = relative_place(a, offset);
  for (int i = 0; i < N; ++i) {
    const auto& axis = a.axes[static_cast<std::size_t>(i)];
    for (std::size_t j = 0; j < std::size_t{N}; ++j) {
      pose.axes[j][i] = nearest_to<typename Formats<S>::Ratio>(narrow_dot<62>(axis, b.axes[j]));
    }
  }
  return pose;
}

/// Whether two hulls are surely more than the margin apart, because the second is above a face of
/// the first; false for other shapes.
template <class A, class B, Scalar S, int N>
[[nodiscard]] constexpr bool is_surely_beyond(
    [[maybe_unused]] const Support<S, N>& support,
    [[maybe_unused]] const Vec<typename Formats<S>::Lever, N>& offset, [[maybe_unused]] const A& a,
    [[maybe_unused]] const B& b, [[maybe_unused]] const typename Formats<S>::Gap& margin) noexcept {
  if constexpr (has_filters && is_hull_solid<A> && is_hull_solid<B>) {
    return ball_is_above(faces_of(a), faces_of(b), relative_place(support, offset), margin);
  } else {
    return false;
  }
}

/// Whether two balls or capsules are surely more than the margin apart, because their centers are.
///
/// Axes are those of a rotation, rounded: products with them are off by less than 2^-28 of the
/// offset, which is less than 2^33 steps even if it is clamped. With the roundings of both cores
/// and of the distance, the error is less than 2^10 steps.
template <Scalar S, int N>
[[nodiscard]] constexpr bool centers_are_apart(
    [[maybe_unused]] const BodyExtent<S, N>& a, [[maybe_unused]] const BodyExtent<S, N>& b,
    [[maybe_unused]] const Vec<typename Formats<S>::Lever, N>& offset,
    [[maybe_unused]] const typename Formats<S>::Gap& margin) noexcept {
  using Gap = typename Formats<S>::Gap;
  if constexpr (is_fixed<S> && has_filters) {
    using Limit = Fixed<43, Gap::frac>;
    auto limit = Limit((a.radius + b.radius) + margin + Gap::assume_raw(1 << 10));
    for (int i = 0; i < N; ++i) {
      limit = narrow<43>(limit + (a.half_extents[i] + b.half_extents[i]));
    }
    // Up to 2^31 steps, the square fits 62 bits and that of the offset 64.
    if (limit < 0 || !fits<31>(limit) || margin == (Gap::max)()) return false;
    std::uint64_t squared = 0;
    for (int i = 0; i < N; ++i) {
      const auto d = static_cast<std::uint64_t>(offset[i].raw());
      squared += d * d;
    }
    const auto reach = static_cast<std::uint64_t>(limit.raw());
    return squared >= reach * reach;
  } else {
    return false;
  }
}

}  // namespace detent::detail
