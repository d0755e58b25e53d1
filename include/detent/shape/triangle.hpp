// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "detent/math/vec.hpp"
#include "detent/shape/fields.hpp"

namespace detent {

/// The points between three corners: a surface with two sides in 3D, a solid in 2D.
///
/// Collinear corners make it the segment that they span, equal corners a point.
template <Scalar S, int N>
struct Triangle {
  Vec<S, N> a;
  Vec<S, N> b;
  Vec<S, N> c;

  [[nodiscard]] friend constexpr bool operator==(const Triangle&,
                                                 const Triangle&) noexcept = default;
};

template <Scalar S, int N>
struct detail::ShapeFields<Triangle<S, N>> {
  static constexpr std::string_view name = "triangle", names[] = {"a", "b", "c"};

  template <class Self, class F>
  static constexpr auto of(Self& triangle, const F& f) {
    return f(triangle.a, triangle.b, triangle.c);
  }
};

template <Scalar S, int N>
Triangle(Vec<S, N>, Vec<S, N>, Vec<S, N>) -> Triangle<S, N>;

}  // namespace detent
