// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/kernel/point_triangle.hpp"
#include "detent/query/kernel/within_segment.hpp"

namespace detent::detail {

/// The projection of the point `p` onto the triangle 0, `b`, `c` along its normal n = b x c:
/// barycentric weights times n^2, which is 0 for a collapsed triangle.
///
/// n . (b x p), n . (p x c) and n^2 are computed by Lagrange's identity.
///
/// source: Ericson, Real-Time Collision Detection, 5.1.5
template <Number T, Number P>
struct PlaceOverFace {
  constexpr PlaceOverFace(const Vec<T, 3>& b, const Vec<T, 3>& c, const Vec<P, 3>& p) noexcept {
    const auto bb = squared_length(b), cc = squared_length(c), bc = dot(b, c);
    const auto bp = dot(b, p), cp = dot(c, p);
    of_b = cc * bp - bc * cp;
    of_c = bb * cp - bc * bp;
    const auto whole = bb * cc - bc * bc;
    of_a = whole - of_b - of_c;
    is_flat = !(whole > 0);
  }

  /// Whether the point is straight above or below the face, where no edge is closer.
  [[nodiscard]] constexpr bool is_over() const noexcept {
    return !is_flat && of_a >= 0 && of_b >= 0 && of_c >= 0;
  }

  using Product = decltype(dot(Vec<T, 3>(), Vec<P, 3>()) * dot(Vec<T, 3>(), Vec<T, 3>()));
  using Weight = decltype(Product() - Product());
  decltype(Weight() - Weight() - Weight()) of_a;
  Weight of_b, of_c;
  bool is_flat;
};

/// Whether the point `p` is within `reach` >= 0 of the triangle 0, `b`, `c`: of its face, or of an
/// edge that it is beyond.
template <Number T, Number R>
[[nodiscard]] constexpr bool within_corners(const Vec<T, 3>& b, const Vec<T, 3>& c,
                                            const Vec<T, 3>& p, const R& reach) noexcept {
  const PlaceOverFace place(b, c, p);
  if (place.is_over()) return within_level(b, c, p, reach);
  const auto is_beyond = [&](const auto& weight) { return place.is_flat || weight < 0; };
  return (is_beyond(place.of_c) && within_edge(b, p, reach)) ||
         (is_beyond(place.of_b) && within_edge(c, p, reach)) ||
         (is_beyond(place.of_a) && within_edge(c - b, p - b, reach));
}

/// Whether the point `p` is straight above or below the triangle and within `reach` of it.
template <Number T, Number R>
[[nodiscard]] constexpr bool within_face(const Vec<T, 3>& b, const Vec<T, 3>& c, const Vec<T, 3>& p,
                                         const R& reach) noexcept {
  return PlaceOverFace(b, c, p).is_over() && within_level(b, c, p, reach);
}

/// Whether `point` is straight above or below the face of `triangle`, where no edge is closer, and
/// within `reach` >= 0 of it; in 2D, whether it is in the triangle.
template <Scalar S, Number R>
[[nodiscard]] constexpr bool within_face(const Triangle<S, 2>& triangle, const Vec<S, 2>& point,
                                         const R&) noexcept {
  return holds(triangle, point);
}
template <Scalar S, Number R>
[[nodiscard]] constexpr bool within_face(const Triangle<S, 3>& triangle, const Vec<S, 3>& point,
                                         const R& reach) noexcept {
  const auto& [a, b, c] = triangle;
  return by_width<29>([](const auto&... x) { return within_face(x...); }, b - a, c - a, point - a,
                      reach);
}

/// Whether `point` is within `reach` >= 0 of `triangle`.
template <Scalar S, int N, Number R>
[[nodiscard]] constexpr bool within_reach(const Triangle<S, N>& triangle, const Vec<S, N>& point,
                                          const R& reach) noexcept {
  const auto& [a, b, c] = triangle;
  if (are_apart(Bounds(a, b, c), Bounds(point), reach)) return false;
  if constexpr (N == 2) {
    return holds(triangle, point) || within_reach(Segment{a, b}, point, reach) ||
           within_reach(Segment{b, c}, point, reach) || within_reach(Segment{c, a}, point, reach);
  } else {
    return by_width<29>([](const auto&... x) { return within_corners(x...); }, b - a, c - a,
                        point - a, reach);
  }
}

}  // namespace detent::detail
