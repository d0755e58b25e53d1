// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/kernel/gjk.hpp"
#include "detent/shape/aabb.hpp"

namespace detent {

namespace detail {

/// A nonempty box as a convex body for GJK.
template <Scalar S, int N>
class AabbBody {
 public:
  static constexpr int dimension = N;

  explicit constexpr AabbBody(const Aabb<S, N>& box) noexcept : box_(box) {}

  [[nodiscard]] constexpr const Vec<S, N>& some() const noexcept { return box_.min; }
  [[nodiscard]] constexpr const Vec<S, N>& low() const noexcept { return box_.min; }
  [[nodiscard]] constexpr const Vec<S, N>& high() const noexcept { return box_.max; }

  template <int, Number V, Number T>
  [[nodiscard]] constexpr Vec<S, N> extreme(const Vec<V, N>& v, const Vec<T, N>&,
                                            bool farthest) const noexcept {
    return make_vec<N>([&](int i) { return (v[i] > 0) == farthest ? box_.max[i] : box_.min[i]; });
  }

 private:
  Aabb<S, N> box_;
};

}  // namespace detail

/// Whether `box` and `hull` share a point.
///
/// domain: every input; an empty box or hull overlaps nothing
/// exact:  yes or no exact; touching counts                       (tests/oracle/aabb_hull.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr bool overlaps(const Aabb<S, N>& box,
                                      const ConvexHull<S, N>& hull) noexcept {
  if (is_empty(box) || is_empty(hull)) return false;
  return detail::bodies_overlap(detail::AabbBody(box), detail::HullBody(hull));
}
template <Scalar S, int N>
[[nodiscard]] constexpr bool overlaps(const ConvexHull<S, N>& hull,
                                      const Aabb<S, N>& box) noexcept {
  return overlaps(box, hull);
}

}  // namespace detent
