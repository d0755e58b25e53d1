// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "detent/math/vec.hpp"
#include "detent/shape/fields.hpp"

namespace detent {

/// The points between two corners on every axis; a rectangle in 2D.
///
/// Equal corners on an axis make the box flat; min > max on any axis makes it empty.
template <Scalar S, int N>
struct Aabb {
  Vec<S, N> min;
  Vec<S, N> max;

  [[nodiscard]] friend constexpr bool operator==(const Aabb&, const Aabb&) noexcept = default;
};

template <Scalar S, int N>
struct detail::ShapeFields<Aabb<S, N>> {
  static constexpr std::string_view name = "aabb", names[] = {"min", "max"};

  template <class Self, class F>
  static constexpr auto of(Self& box, const F& f) {
    return f(box.min, box.max);
  }
};

template <Scalar S, int N>
Aabb(Vec<S, N>, Vec<S, N>) -> Aabb<S, N>;

/// Whether the box holds no point: min > max on some axis.
template <Scalar S, int N>
[[nodiscard]] constexpr bool is_empty(const Aabb<S, N>& box) noexcept {
  for (int i = 0; i < N; ++i) {
    if (box.min[i] > box.max[i]) return true;
  }
  return false;
}

}  // namespace detent
