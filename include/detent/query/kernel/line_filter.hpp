// SPDX-License-Identifier: MIT
#pragma once

#include "detent/number/filter/filtered.hpp"
#include "detent/shape/ray.hpp"
#include "detent/shape/triangle.hpp"

namespace detent::detail {

/// Filter for the line of a ray: rules out triangles that it misses, faster than `raycast`, by
/// their corners projected along the line (docs/filters.md, lemma 11).
///
/// source: Woop, Benthin and Wald, Watertight Ray/Triangle Intersection (2013), without division
template <Scalar S>
class LineFilter {
 public:
  explicit constexpr LineFilter(const Ray<S, 3>& ray) noexcept
      : origin_(ray.origin), direction_(ray.direction) {}

  /// Whether the line meets `triangle`: `no` or `unsure`. Always unsure for scalars that round,
  /// which could only guess, and for directions with z = 0, which would project all corners onto
  /// one line.
  [[nodiscard]] constexpr Filtered meets(const Triangle<S, 3>& triangle) const noexcept {
    if constexpr (is_fixed<S>) {
      const auto a = seen(triangle.a), b = seen(triangle.b), c = seen(triangle.c);
      const auto ab = turn(a, b), bc = turn(b, c), ca = turn(c, a);
      const bool left = int{ab > 0} + int{bc > 0} + int{ca > 0} != 0;
      const bool right = int{ab < 0} + int{bc < 0} + int{ca < 0} != 0;
      return left && right ? Filtered::no : Filtered::unsure;
    } else {
      return Filtered::unsure;
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
  // For offsets w with components up to m: at most sqrt(2) m |d|, and at most |d|^2 times sqrt(3)
  // m^2, where the latter is twice the area of the largest triangle in a cube.
  static constexpr int seen_bits = bits_of<decltype(S() - S())> + direction_component<S>::frac + 1;
  static constexpr int turn_bits = 2 * seen_bits - 1;

  Vec<S, 3> origin_;
  Direction<S, 3> direction_;
};

}  // namespace detent::detail
