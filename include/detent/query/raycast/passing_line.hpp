// SPDX-License-Identifier: MIT
#pragma once

#include "detent/shape/ray.hpp"
#include "detent/shape/triangle.hpp"

namespace detent::detail {

/// The line of a ray, to leave out triangles that it passes by in less time than `raycast` takes.
///
/// Along the line, a triangle is seen as the triangle of its corners' offsets (x, y, z) from the
/// line's origin at z d - (x, y, z) d.z, of which two coordinates are left. The line meets it only
/// if that one has the origin of the plane on no outer side: if no two edges turn about it in
/// different ways. Every number is exact, so nothing that the line touches is left out.
///                                                        (tests/query/raycast/passing_line.test.cpp)
///
/// source: Woop, Benthin and Wald, Watertight Ray/Triangle Intersection (2013), without division
template <Scalar S>
class PassingLine {
 public:
  explicit constexpr PassingLine(const Ray<S, 3>& ray) noexcept
      : origin_(ray.origin), direction_(ray.direction) {}

  /// Whether the line is found to pass by `triangle`: never by scalars that round, which could only
  /// guess, nor along directions without z, where all corners are seen in one line.
  [[nodiscard]] constexpr bool passes(const Triangle<S, 3>& triangle) const noexcept {
    if constexpr (is_fixed<S>) {
      const auto a = seen(triangle.a), b = seen(triangle.b), c = seen(triangle.c);
      const auto ab = turn(a, b), bc = turn(b, c), ca = turn(c, a);
      const bool left = int{ab > 0} + int{bc > 0} + int{ca > 0} != 0;
      const bool right = int{ab < 0} + int{bc < 0} + int{ca < 0} != 0;
      return left && right;
    } else {
      return false;
    }
  }

  [[nodiscard]] constexpr auto seen(const Vec<S, 3>& corner) const noexcept {
    const auto w = corner - origin_;
    const auto& d = direction_.vec();
    return Vec{narrow_cross<seen_bits>(Vec{w.x, w.z}, Vec{d.x, d.z}),
               narrow_cross<seen_bits>(Vec{w.y, w.z}, Vec{d.y, d.z})};
  }
  /// d.z times the volume w_a x w_b . d
  template <Number T>
  [[nodiscard]] static constexpr auto turn(const Vec<T, 2>& a, const Vec<T, 2>& b) noexcept {
    return narrow_cross<turn_bits>(a, b);
  }

 private:
  // With offsets w of components up to m: at most sqrt(2) m |d|, and |d|^2 times the sqrt(3) m^2 of
  // the largest triangle in a cube, doubled.
  static constexpr int seen_bits = bits_of<decltype(S() - S())> + direction_component<S>::frac + 1;
  static constexpr int turn_bits = 2 * seen_bits - 1;

  Vec<S, 3> origin_;
  Direction<S, 3> direction_;
};

}  // namespace detent::detail
