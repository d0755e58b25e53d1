// SPDX-License-Identifier: MIT
#pragma once

#include "detent/shape/obb.hpp"

namespace detent::detail {

/// The components of a vector in the frame of `box`: dot(axis(i), v), with the axes exactly as
/// stored.
template <Scalar S, Number T, int N>
[[nodiscard]] constexpr auto in_frame(const Obb<S, N>& box, const Vec<T, N>& v) noexcept {
  return make_vec<N>([&](int i) { return dot(box.rotation.axis(i), v); });
}

/// The vector sum v[i] axis(i) in the world, for a vector in a rotated frame.
template <Scalar S, Number T, int N>
[[nodiscard]] constexpr auto from_frame(const Rotation<S, N>& frame, const Vec<T, N>& v) noexcept {
  return make_vec<N>(
      [&](int j) { return dot(make_vec<N>([&](int i) { return frame.axis(i)[j]; }), v); });
}
template <Scalar S, Number T, int N>
[[nodiscard]] constexpr auto from_frame(const Obb<S, N>& box, const Vec<T, N>& v) noexcept {
  return from_frame(box.rotation, v);
}

/// Whether `point` is in `box`.
template <Scalar S, int N>
[[nodiscard]] constexpr bool holds(const Obb<S, N>& box, const Vec<S, N>& point) noexcept {
  const auto from_center = point - box.center;
  for (int i = 0; i < N; ++i) {
    const auto along = dot(box.rotation.axis(i), from_center);
    if (along < -box.half_extents[i] || along > box.half_extents[i]) return false;
  }
  return true;
}

/// `along`, a coordinate in the frame of a box, clamped to [-half_extent, half_extent].
template <Number T, Scalar S>
[[nodiscard]] constexpr T clamp_to(const T& along, const S& half_extent) noexcept {
  const T high(half_extent), low(-half_extent);
  const T lowered = along > high ? high : along;
  return lowered < low ? low : lowered;
}

/// The excess of |dot(axis(i), point - center)| over half_extents[i] on each axis (0 if there is
/// none), with the sign of the dot product. The box must not be empty.
template <Scalar S, int N>
[[nodiscard]] constexpr auto excess(const Obb<S, N>& box, const Vec<S, N>& point) noexcept {
  const auto from_center = point - box.center;
  using Along = decltype(dot(box.rotation.axis(0), from_center));
  return make_vec<N>([&](int i) {
    const Along along = dot(box.rotation.axis(i), from_center);
    // Subtracting 0 <= half_extents[i] <= |along| from |along| leaves a number that fits its bits.
    return narrow_difference<bits_of<Along>>(along, clamp_to(along, box.half_extents[i]));
  });
}

/// Whether `v`, in the frame of a box, is no longer than `reach` >= 0.
template <Number T, Scalar S, int N>
[[nodiscard]] constexpr bool is_within(const Vec<T, N>& v, const S& reach) noexcept {
  for (int i = 0; i < N; ++i) {
    if (v[i] > reach || v[i] < -reach) return false;
  }
  // No component exceeds `reach`, on the grid of products with a direction, whose 1 is 2^(b - 1).
  constexpr int bits = bits_of<S> - 1 + bits_of<direction_component<S>>;
  return squared_length(narrow<bits>(v)) <= square(reach);
}

/// Whether `point` is within `reach` >= 0 of `box`, measured in the frame of the box.
template <Scalar S, int N>
[[nodiscard]] constexpr bool within_reach(const Obb<S, N>& box, const Vec<S, N>& point,
                                          const S& reach) noexcept {
  return !is_empty(box) && is_within(excess(box, point), reach);
}

}  // namespace detent::detail
