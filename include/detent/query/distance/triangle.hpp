// SPDX-License-Identifier: MIT
#pragma once

#include "detent/math/width.hpp"
#include "detent/number/filter/leading.hpp"
#include "detent/query/distance/segment.hpp"
#include "detent/query/kernel/feature.hpp"

namespace detent {

namespace detail {

/// The squared distance from the point `w` to the plane through 0 spanned by `b` and `c`:
/// (n . w)^2 / n^2 with n = b x c.
template <Number T>
[[nodiscard]] constexpr auto squared_distance_from_face(const Vec<T, 3>& b, const Vec<T, 3>& c,
                                                        const Vec<T, 3>& w) noexcept {
  const auto normal = cross(b, c);
  return Fraction{square(dot(normal, w)), squared_length(normal)};
}

}  // namespace detail

/// The squared distance from `point` to `triangle`: 0 inside a 2D triangle, which is solid, and
/// (n . w)^2 / n^2 above the face of a 3D triangle, with n = (b - a) x (c - a) and w from a to the
/// point.
///
/// domain: every input; a collapsed triangle is the segment or point that its corners span
/// exact:  the fraction is the exact value                  (tests/oracle/point_triangle.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr auto squared_distance(const Triangle<S, N>& triangle,
                                              const Vec<S, N>& point) noexcept {
  const auto nearest = detail::nearest_feature(triangle, point);
  using ToEdge = decltype(squared_distance(nearest.edge, point));
  if constexpr (N == 2) {
    if (nearest.is_face) return ToEdge{{}, decltype(ToEdge::denominator)(1)};
    return squared_distance(nearest.edge, point);
  } else {
    const auto to_face = detail::squared_distance_from_face(
        triangle.b - triangle.a, triangle.c - triangle.a, point - triangle.a);
    using Result = decltype(to_face);
    if (nearest.is_face) return to_face;
    const ToEdge to_edge = squared_distance(nearest.edge, point);
    return Result{decltype(to_face.numerator)(to_edge.numerator),
                  decltype(to_face.denominator)(to_edge.denominator)};
  }
}

namespace detail {

/// The distance from the point `w` to the plane through 0 spanned by `b` and `c`, which are not
/// parallel, rounded down.
///
/// Filter: the quotient |height| / |normal| of leading bits (docs/filters.md, lemma 31). A step that
/// it might reach is compared exactly.
template <Number Distance, Number T>
[[nodiscard]] constexpr Distance distance_from_face(const Vec<T, 3>& b, const Vec<T, 3>& c,
                                                    const Vec<T, 3>& w) noexcept {
  if constexpr (is_fixed<Distance> && has_filters) {
    const auto normal = cross(b, c);
    const auto height = abs(dot(normal, w));
    if (height == 0) return Distance(0);
    const auto squared = squared_length(normal);
    const auto floor = decide_floor<Distance>(
        Approximate{over_root(Leading(height), Leading(squared)), Relative{43}});
    if (floor.is_sure) return floor.value;
    if (floor.value > 0) {
      const bool is_reached = square(floor.value) * squared <= square(height);
      constexpr auto step = Distance::from_raw(1);
      return is_reached ? floor.value : narrow<Distance::bits>(floor.value - step);
    }
  }
  return by_width<20>(
      [](const auto&... x) { return sqrt_floor<Distance>(squared_distance_from_face(x...)); }, b, c,
      w);
}

/// `distance` to a triangle, in a result type that may differ from its coordinates.
template <Number Distance, Scalar S, int N>
[[nodiscard]] constexpr Distance distance_to(const Triangle<S, N>& triangle,
                                             const Vec<S, N>& point) noexcept {
  const auto& [a, b, c] = triangle;
  const auto find = [&](const auto& ab, const auto& ac, const auto& ap, const auto& bp,
                        const auto& cp) {
    if (are_parallel(ab, ac)) return distance_to<Distance>(collapsed(triangle), point);
    switch (nearest_part(ab, ac, ap, bp, cp)) {
      case TrianglePart::a:
        return sqrt_floor<Distance>(squared_length(ap));
      case TrianglePart::b:
        return sqrt_floor<Distance>(squared_length(bp));
      case TrianglePart::c:
        return sqrt_floor<Distance>(squared_length(cp));
      case TrianglePart::ab:
        return distance_from_edge<Distance>(ab, ap);
      case TrianglePart::ac:
        return distance_from_edge<Distance>(ac, ap);
      case TrianglePart::bc:
        return distance_to<Distance>(Segment<S, N>{triangle.b, triangle.c}, point);
      case TrianglePart::face:
        break;
    }
    if constexpr (N == 2) {
      return Distance(0);
    } else {
      return distance_from_face<Distance>(ab, ac, ap);
    }
  };
  return by_width<30>(find, b - a, c - a, point - a, point - b, point - c);
}

}  // namespace detail

/// The distance from `point` to `triangle`, 0 inside a 2D triangle.
///
/// units:  world units
/// domain: every input; clamped to the greatest scalar
/// exact:  rounded down, error in [0, 1) ULP                (tests/oracle/point_triangle.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr S distance(const Triangle<S, N>& triangle,
                                   const Vec<S, N>& point) noexcept {
  return detail::distance_to<S>(triangle, point);
}

}  // namespace detent
