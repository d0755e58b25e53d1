// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/kernel/segment_triangle.hpp"
#include "detent/query/kernel/within_triangle.hpp"
#include "detent/shape/capsule.hpp"

namespace detent {

/// Whether `triangle` and `capsule` share a point: the capsule's segment crosses the triangle or
/// comes within the radius of an edge, or one of its ends comes within the radius of the face.
///
/// domain: every input; a negative radius is an empty capsule and overlaps nothing; a collapsed
///         triangle is the segment or point that its corners span
/// exact:  yes or no exact; touching counts                 (tests/oracle/capsule_pairs.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr bool overlaps(const Triangle<S, N>& triangle,
                                      const Capsule<S, N>& capsule) noexcept {
  const auto& [a, b, c] = triangle;
  const auto& radius = capsule.radius;
  if (radius < 0) return false;
  const Segment axis{capsule.a, capsule.b};
  if (detail::are_apart(detail::Bounds(a, b, c), detail::Bounds(axis.start, axis.end), radius)) {
    return false;
  }
  return detail::segment_meets(axis, triangle) ||
         detail::within_face(triangle, axis.start, radius) ||
         detail::within_face(triangle, axis.end, radius) ||
         detail::within_reach(Segment{a, b}, axis, radius) ||
         detail::within_reach(Segment{b, c}, axis, radius) ||
         detail::within_reach(Segment{c, a}, axis, radius);
}
template <Scalar S, int N>
[[nodiscard]] constexpr bool overlaps(const Capsule<S, N>& capsule,
                                      const Triangle<S, N>& triangle) noexcept {
  return overlaps(triangle, capsule);
}

}  // namespace detent
