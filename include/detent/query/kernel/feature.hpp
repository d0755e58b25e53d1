// SPDX-License-Identifier: MIT
#pragma once

#include "detent/math/components.hpp"
#include "detent/math/width.hpp"
#include "detent/query/kernel/collapsed.hpp"
#include "detent/shape/triangle.hpp"

namespace detent::detail {

/// The feature of a triangle closest to a point: its face, an edge, or a corner (a segment with
/// equal ends).
template <Scalar S, int N>
struct NearestFeature {
  bool is_face;
  Segment<S, N> edge;
};

/// The corners, edges and face of a triangle of corners a, b, c.
enum class TrianglePart { a, b, c, ab, ac, bc, face };

/// The feature closest to a point p, for a triangle with an area, from the vectors between its
/// corners and to p.
///
/// Products of the dot products give the side of an edge on which the point lies: by Lagrange's
/// identity d1 d4 - d3 d2 = (ab x ac) . (ap x bp), and so on.
///
/// source: Ericson, Real-Time Collision Detection, 5.1.5
template <Number T, int N>
[[nodiscard]] constexpr TrianglePart nearest_part(const Vec<T, N>& ab, const Vec<T, N>& ac,
                                                  const Vec<T, N>& ap, const Vec<T, N>& bp,
                                                  const Vec<T, N>& cp) noexcept {
  const auto d1 = dot(ab, ap), d2 = dot(ac, ap);
  if (d1 <= 0 && d2 <= 0) return TrianglePart::a;
  const auto d3 = dot(ab, bp), d4 = dot(ac, bp);
  if (d3 >= 0 && d4 <= d3) return TrianglePart::b;
  if (d1 >= 0 && d3 <= 0 && d1 * d4 <= d3 * d2) return TrianglePart::ab;
  const auto d5 = dot(ab, cp), d6 = dot(ac, cp);
  if (d6 >= 0 && d5 <= d6) return TrianglePart::c;
  if (d2 >= 0 && d6 <= 0 && d5 * d2 <= d1 * d6) return TrianglePart::ac;
  if (d4 >= d3 && d5 >= d6 && d3 * d6 <= d5 * d4) return TrianglePart::bc;
  return TrianglePart::face;
}

/// The feature of `triangle` closest to `point`; for a collapsed triangle, its segment. In 2D it is
/// the face if the point is inside.
template <Scalar S, int N>
[[nodiscard]] constexpr NearestFeature<S, N> nearest_feature(const Triangle<S, N>& triangle,
                                                             const Vec<S, N>& point) noexcept {
  using Edge = Segment<S, N>;
  const auto& [a, b, c] = triangle;
  const auto ab = b - a, ac = c - a;
  if (are_parallel(ab, ac)) return {false, collapsed(triangle)};
  switch (by_width<30>([](const auto&... v) { return nearest_part(v...); }, ab, ac, point - a,
                       point - b, point - c)) {
    case TrianglePart::a:
      return {false, Edge{a, a}};
    case TrianglePart::b:
      return {false, Edge{b, b}};
    case TrianglePart::c:
      return {false, Edge{c, c}};
    case TrianglePart::ab:
      return {false, Edge{a, b}};
    case TrianglePart::ac:
      return {false, Edge{a, c}};
    case TrianglePart::bc:
      return {false, Edge{b, c}};
    case TrianglePart::face:
      break;
  }
  return {true, Edge{}};
}

}  // namespace detent::detail
