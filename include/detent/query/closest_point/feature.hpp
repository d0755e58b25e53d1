// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/contains/parallel.hpp"
#include "detent/shape/triangle.hpp"

namespace detent::detail {

/// The part of a triangle that is closest to a point: its face, or else an edge or a corner (a
/// segment of equal ends).
template <Scalar S, int N>
struct NearestFeature {
  bool is_face;
  Segment<S, N> edge;
};

/// Which part of `triangle` holds its point closest to `point`; of a collapsed triangle, the
/// segment that it is. In 2D the point is over the face when it is inside.
///
/// Products of the dot products tell on which side of an edge the point lies: by Lagrange's
/// identity d1 d4 - d3 d2 = (ab x ac) . (ap x bp), and so on.
///
/// source: Ericson, Real-Time Collision Detection, 5.1.5
template <Scalar S, int N>
[[nodiscard]] constexpr NearestFeature<S, N> nearest_feature(const Triangle<S, N>& triangle,
                                                             const Vec<S, N>& point) noexcept {
  using Edge = Segment<S, N>;
  const auto& a = triangle.a;
  const auto& b = triangle.b;
  const auto& c = triangle.c;
  const auto ab = b - a, ac = c - a;
  if (are_parallel(ab, ac)) return {false, collapsed(triangle)};

  const auto ap = point - a;
  const auto d1 = dot(ab, ap), d2 = dot(ac, ap);
  if (d1 <= 0 && d2 <= 0) return {false, Edge{a, a}};

  const auto bp = point - b;
  const auto d3 = dot(ab, bp), d4 = dot(ac, bp);
  if (d3 >= 0 && d4 <= d3) return {false, Edge{b, b}};
  if (d1 >= 0 && d3 <= 0 && d1 * d4 <= d3 * d2) return {false, Edge{a, b}};

  const auto cp = point - c;
  const auto d5 = dot(ab, cp), d6 = dot(ac, cp);
  if (d6 >= 0 && d5 <= d6) return {false, Edge{c, c}};
  if (d2 >= 0 && d6 <= 0 && d5 * d2 <= d1 * d6) return {false, Edge{a, c}};
  if (d4 >= d3 && d5 >= d6 && d3 * d6 <= d5 * d4) return {false, Edge{b, c}};
  return {true, Edge{}};
}

}  // namespace detent::detail
