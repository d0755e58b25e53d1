// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "detent/shape/triangle.hpp"

namespace detent {

/// Barycentric weights of a point in a triangle, as exact numerators over a common denominator:
/// a / total, b / total and c / total, with a + b + c = total > 0.
///
/// The point is in the triangle if none is negative.
template <Number T>
struct Barycentric {
  T a;
  T b;
  T c;
  T total;

  [[nodiscard]] friend constexpr bool operator==(const Barycentric&,
                                                 const Barycentric&) noexcept = default;
};

/// The weights divided by `total`, in type `T`, each rounded to nearest, ties to even, and clamped.
template <Number T, Number W>
[[nodiscard]] constexpr Vec<T, 3> nearest_to(const Barycentric<W>& weights) noexcept {
  return {quotient_nearest<T>(weights.a, weights.total),
          quotient_nearest<T>(weights.b, weights.total),
          quotient_nearest<T>(weights.c, weights.total)};
}

/// The barycentric weights of `point` in the 2D `triangle`, or nothing for a collapsed one.
///
/// domain: every input
/// exact:  always                                           (tests/oracle/point_triangle.test.cpp)
template <Scalar S>
[[nodiscard]] constexpr auto barycentric(const Triangle<S, 2>& triangle,
                                         const Vec<S, 2>& point) noexcept {
  const auto to_a = triangle.a - point, to_b = triangle.b - point, to_c = triangle.c - point;
  const auto ab = triangle.b - triangle.a, ac = triangle.c - triangle.a;
  auto total = cross(ab, ac);
  using Weight = decltype(total);
  using Result = std::optional<Barycentric<Weight>>;
  if (total == 0) return Result();
  auto a = cross(to_b, to_c), b = cross(to_c, to_a), c = cross(to_a, to_b);
  if (total < 0) {
    a = narrow_negative(a);
    b = narrow_negative(b);
    c = narrow_negative(c);
    total = narrow_negative(total);
  }
  return Result({a, b, c, total});
}

/// The barycentric weights in the 3D `triangle` of `point`, projected onto its plane, or nothing
/// for a collapsed triangle.
///
/// With n = (b - a) x (c - a), the weight of a is n . ((b - p) x (c - p)) / n . n, and so on.
///
/// domain: every input
/// exact:  always                                           (tests/oracle/point_triangle.test.cpp)
/// source: Ericson, Real-Time Collision Detection, 3.4
template <Scalar S>
[[nodiscard]] constexpr auto barycentric(const Triangle<S, 3>& triangle,
                                         const Vec<S, 3>& point) noexcept {
  const auto normal = cross(triangle.b - triangle.a, triangle.c - triangle.a);
  const auto to_a = triangle.a - point, to_b = triangle.b - point, to_c = triangle.c - point;
  const auto total = squared_length(normal);
  using Weight = decltype(squared_length(normal));
  using Result = std::optional<Barycentric<Weight>>;
  if (total == 0) return Result();
  return Result({dot(normal, cross(to_b, to_c)), dot(normal, cross(to_c, to_a)),
                 dot(normal, cross(to_a, to_b)), total});
}

}  // namespace detent
