// SPDX-License-Identifier: MIT
#pragma once

#include "detent/math/vec.hpp"

namespace detent {

/// The points between three corners: a surface with two sides in 3D, a solid in 2D.
///
/// Corners in one line make it the segment, equal corners the point, that they span.
template <Scalar S, int N>
struct Triangle {
  Vec<S, N> a;
  Vec<S, N> b;
  Vec<S, N> c;

  [[nodiscard]] friend constexpr bool operator==(const Triangle&,
                                                 const Triangle&) noexcept = default;
};

/// The canonical bytes of a digest: the fields in order.
template <class D, Scalar S, int N>
constexpr void append(D& digest, const Triangle<S, N>& triangle) noexcept {
  digest.add(triangle.a, triangle.b, triangle.c);
}

template <Scalar S, int N>
Triangle(Vec<S, N>, Vec<S, N>, Vec<S, N>) -> Triangle<S, N>;

}  // namespace detent
