// SPDX-License-Identifier: MIT
#pragma once

#include "detent/math/components.hpp"
#include "detent/math/width.hpp"
#include "detent/number/filter/long_quadratic.hpp"
#include "detent/query/kernel/point_segment.hpp"
#include "detent/shape/capsule.hpp"
#include "detent/shape/ray.hpp"

namespace detent::detail {

/// The line of a ray against the cylinder about the axis of a capsule, which contains the capsule:
/// |(m + t d) x e|^2 = r^2 e^2. Here e leads from the end that the ray faces to the other end, and m
/// from the facing end to the ray's origin. k, a, det, ee and de are d x e, |k|^2, m . k, |e|^2 and
/// d . e.
template <Scalar S, int N, Number Length, Number Radius>
struct RayCylinder {
  // The bits of |v| |d| for a difference v of points, and of |u| |v| |d| for two of them: see
  // `RayTriangle`.
  static constexpr int along = along_bits<S, Length>;
  static constexpr int volume = bits_of<Length> + along + 1;

  constexpr RayCylinder(const Direction<S, N>& direction, const Vec<Length, N>& from_end,
                        const Vec<Length, N>& axis, const Radius& r) noexcept
      : d(direction),
        m(from_end),
        e(axis),
        radius(r),
        k(cross(d, e)),
        a(narrow_square<2 * along>(k)),
        det(determinant()),
        ee(squared_length(e)),
        de(dot(e, d)) {}

  /// The quadratic of the side, a t^2 + 2 b t + c = |(m + t d) x e|^2 - r^2 e^2, for a line that
  /// meets the cylinder.
  [[nodiscard]] constexpr auto side() const noexcept {
    return LongQuadratic(a, approach(), start(), reach(), ee);
  }

  /// Whether |m . k| > r (|kx| + |ky| + |kz|), which is at least r |k|; in 2D, whether both ends
  /// are on one side of the line by more than r |d|. It decides most misses, in integers half as
  /// long as those of `reach`.
  [[nodiscard]] constexpr bool is_far() const noexcept {
    if constexpr (N == 2) {
      const auto first = cross(m, d.vec());
      const auto last = first + k;
      const auto reach = radius * longest();
      return (first > reach && last > reach) || (first < -reach && last < -reach);
    } else {
      return abs(det) > sum_of_magnitudes(k) * radius;
    }
  }

  /// `approach` is b = k . (m x e), by Lagrange's identity; `start` is c.
  [[nodiscard]] constexpr auto approach() const noexcept { return dot(m, d) * ee - de * dot(m, e); }
  [[nodiscard]] constexpr auto start() const noexcept {
    return narrow_square<bits_of<decltype(ee * ee)>>(cross(m, e)) - square(radius) * ee;
  }

  /// (b^2 - a c) / e^2 = r^2 a - (m . k)^2 by Lagrange's identity: negative if the line misses the
  /// cylinder.
  [[nodiscard]] constexpr auto reach() const noexcept { return square(radius) * a - square(det); }

  Direction<S, N> d;
  Vec<Length, N> m;
  Vec<Length, N> e;
  Radius radius;
  decltype(cross(Direction<S, N>(), Vec<Length, N>())) k;
  decltype(narrow_square<2 * along>(cross(Direction<S, N>(), Vec<Length, N>()))) a;
  decltype(narrow<volume>(Length() * dot(Vec<Length, N>(), Direction<S, N>()))) det;
  decltype(squared_length(Vec<Length, N>())) ee;
  decltype(dot(Vec<Length, N>(), Direction<S, N>())) de;

 private:
  /// m . (d x e), which is 0 in 2D, where the vectors are coplanar.
  [[nodiscard]] constexpr auto determinant() const noexcept {
    if constexpr (N == 2) {
      return decltype(narrow<volume>(m.x * k))();
    } else {
      return narrow_dot<volume>(m, k);
    }
  }

  /// A bound on the length of any direction, which is within 2^-13 of 1.
  [[nodiscard]] static constexpr auto longest() noexcept {
    if constexpr (is_fixed<S>) {
      return Fixed<13, 12>::from_raw(4097);
    } else {
      return S(4097) / 4096;
    }
  }
};

/// The axis of `capsule`, starting at the end that `ray` faces.
template <Scalar S, int N>
[[nodiscard]] constexpr Segment<S, N> facing_axis(const Ray<S, N>& ray,
                                                  const Capsule<S, N>& capsule) noexcept {
  if (dot(capsule.b - capsule.a, ray.direction) < 0) return {capsule.b, capsule.a};
  return {capsule.a, capsule.b};
}

/// Returns f(cylinder) for a ray and a capsule about `axis`, in the narrowest integers that hold
/// them.
template <Scalar S, int N, class F>
[[nodiscard]] constexpr auto with_cylinder(const Ray<S, N>& ray, const Segment<S, N>& axis,
                                           const S& radius, const F& f) noexcept {
  return by_width<29>(
      [&]<Number L, Number R>(const Vec<L, N>& m, const Vec<L, N>& e, const R& r) {
        return f(RayCylinder<S, N, L, R>(ray.direction, m, e, r));
      },
      ray.origin - axis.start, axis.end - axis.start, radius);
}

}  // namespace detent::detail
