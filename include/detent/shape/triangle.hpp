// SPDX-License-Identifier: MIT
#pragma once

#include "detent/math/vec.hpp"

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

/// Appends to a digest: the fields in order.
template <class D, Scalar S, int N>
constexpr void append(D& digest, const Triangle<S, N>& triangle) noexcept {
  digest.add(triangle.a, triangle.b, triangle.c);
}

template <Scalar S, int N>
Triangle(Vec<S, N>, Vec<S, N>, Vec<S, N>) -> Triangle<S, N>;

}  // namespace detent
