// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <utility>

#include "detent/number/fraction.hpp"
#include "detent/query/kernel/convex_body.hpp"
#include "detent/query/kernel/rounded_point.hpp"
#include "detent/shape/aabb.hpp"

// The closest points of two boxes with the same axes.

namespace detent::detail {

template <Scalar S, int N>
[[nodiscard]] constexpr bool holds(const Aabb<S, N>& box, const Vec<S, N>& point) noexcept {
  bool is_inside = true;
  for (int i = 0; i < N; ++i) {
    is_inside = is_inside && box.min[i] <= point[i] && point[i] <= box.max[i];
  }
  return is_inside;
}

/// Where the segment from p, which is outside, to q enters a box, rounded to nearest, or nothing.
template <Scalar S, int N>
[[nodiscard]] constexpr std::optional<Vec<S, N>> entry_of(const Vec<S, N>& p, const Vec<S, N>& q,
                                                          const Aabb<S, N>& box) noexcept {
  const auto e = q - p;
  using T = std::remove_cvref_t<decltype(e.x)>;
  Fraction<T, T> enter{T(0), T(1)}, leave{T(1), T(1)};
  for (int i = 0; i < N; ++i) {
    const auto low = box.min[i] - p[i], high = box.max[i] - p[i];
    if (e[i] == 0) {
      if (low > 0 || high < 0) return std::nullopt;
      continue;
    }
    const auto first = make_fraction(e[i] > 0 ? low : high, e[i]);
    const auto last = make_fraction(e[i] > 0 ? high : low, e[i]);
    const auto is_less = [](const auto& a, const auto& b) {
      return a.numerator * b.denominator < b.numerator * a.denominator;
    };
    if (is_less(enter, first)) enter = first;
    if (is_less(last, leave)) leave = last;
    if (is_less(leave, enter)) return std::nullopt;
  }
  const auto& whole = enter.denominator;
  return rounded<S>(RationalPoint{p * whole + e * enter.numerator, whole});
}

/// As `common_point` chooses it.
template <Scalar S, int N>
[[nodiscard]] constexpr Vec<S, N> common_point_of_boxes(const Aabb<S, N>& a,
                                                        const Aabb<S, N>& b) noexcept {
  const auto corners_a = AabbBody(a).corners(), corners_b = AabbBody(b).corners();
  for (const auto& corner : corners_a) {
    if (holds(b, corner)) return corner;
  }
  for (const auto& corner : corners_b) {
    if (holds(a, corner)) return corner;
  }
  std::optional<Vec<S, N>> found;
  const auto try_segments = [&](const auto& corners, const Aabb<S, N>& box) {
    for (std::size_t i = 0; i < corners.size() && !found; ++i) {
      for (std::size_t j = i + 1; j < corners.size() && !found; ++j) {
        found = entry_of(corners[i], corners[j], box);
      }
    }
  };
  try_segments(corners_a, b);
  try_segments(corners_b, a);
  // Nothing is found only with scalars that round.
  return found.value_or(a.min);
}

/// The closest points of two boxes: on each axis the facing ends if the boxes are apart there,
/// otherwise the first common coordinate. If they are apart on no axis, a common point.
template <Scalar S, int N>
[[nodiscard]] constexpr std::pair<Vec<S, N>, Vec<S, N>> closest_points_of_boxes(
    const Aabb<S, N>& a, const Aabb<S, N>& b) noexcept {
  const auto nearest = [](const Aabb<S, N>& box, const Aabb<S, N>& other) {
    return make_vec<N>([&](int i) {
      const S common = (std::max)(box.min[i], other.min[i]);
      return box.max[i] < common ? box.max[i] : common;
    });
  };
  const auto on_a = nearest(a, b), on_b = nearest(b, a);
  if (on_a != on_b) return {on_a, on_b};
  const auto point = common_point_of_boxes(a, b);
  return {point, point};
}

}  // namespace detent::detail
