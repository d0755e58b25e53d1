// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "detent/math/direction.hpp"
#include "detent/shape/bounding_box.hpp"
#include "detent/shape/hull.hpp"

namespace detent {

template <Scalar S>
struct Camera;

namespace detail {

/// The half space {x : dot(normal, x) <= reach}.
template <Scalar S>
struct FrustumPlane {
  Direction<S, 3> normal;
  decltype(dot(Direction<S, 3>(), Vec<S, 3>())) reach;
};

}  // namespace detail

/// A camera's view volume: the convex hull of eight corners, in 3D only. It supports all queries of
/// a `ConvexHull`; scenes can be queried with one, but cannot hold one.
///
/// Corner i is on the right if i & 1, at the top if i & 2, and far if i & 4. Eight points in any
/// other order, or coplanar points, have a hull too, and every query is exact for it.
template <Scalar S>
class Frustum {
 public:
  using Corners = std::array<Vec<S, 3>, 8>;

  /// The frustum with these corners.
  explicit constexpr Frustum(const Corners& corners) noexcept : corners_(corners) {
    for (std::size_t i = 0; i < planes_.size(); ++i) planes_[i] = plane(i);
  }

  /// domain: cameras whose eight corners are in the range of the scalar; a clamped one bends the sides
  ///         inward, so that the frustum lacks parts of what the camera sees
  /// exact:  each coordinate of a corner is the exact one rounded to nearest, ties to even, and
  ///         clamped to the range of the scalar             (tests/shape/camera.test.cpp)
  explicit constexpr Frustum(const Camera<S>& camera) noexcept;  // in shape/camera.hpp

  [[nodiscard]] constexpr const Corners& corners() const noexcept { return corners_; }

  /// The frustum as a hull, a view of its corners.
  [[nodiscard]] constexpr ConvexHull<S, 3> hull() const noexcept { return {corners_}; }

  /// Six half spaces that contain the hull: right, left, top, bottom, far, near.
  ///
  /// A normal is rounded, and the reach is the exact maximum of dot(normal, corner). Each half
  /// space therefore contains all corners, and rounding cannot cut one off.
  [[nodiscard]] constexpr const std::array<detail::FrustumPlane<S>, 6>& planes() const noexcept {
    return planes_;
  }

  [[nodiscard]] friend constexpr bool operator==(const Frustum& a, const Frustum& b) noexcept {
    return a.corners_ == b.corners_;
  }

 private:
  /// The plane along both diagonals of a side, moved outward to touch the hull.
  constexpr detail::FrustumPlane<S> plane(std::size_t side) const noexcept {
    const std::size_t axis = side / 2;
    const std::size_t at = std::size_t{1} << axis, next = std::size_t{1} << (axis + 1) % 3,
                      other = std::size_t{1} << (axis + 2) % 3;
    const std::size_t from = side % 2 == 0 ? at : 0;
    const auto first = corners_[from ^ next ^ other] - corners_[from];
    const auto second = corners_[from ^ other] - corners_[from ^ next];
    auto normal = direction_of<S>(cross(first, second)).value_or(Direction<S, 3>());
    if (dot(normal, corners_[from] - corners_[from ^ at]) < 0) normal = -normal;
    auto reach = dot(normal, corners_[0]);
    for (const auto& corner : corners_) reach = (std::max)(reach, dot(normal, corner));
    return {normal, reach};
  }

  Corners corners_;
  std::array<detail::FrustumPlane<S>, 6> planes_;
};

template <Scalar S>
Frustum(const Camera<S>&) -> Frustum<S>;
template <Scalar S>
Frustum(const std::array<Vec<S, 3>, 8>&) -> Frustum<S>;

/// Appends to a digest: the corners in order.
template <class D, Scalar S>
constexpr void append(D& digest, const Frustum<S>& frustum) noexcept {
  for (const auto& corner : frustum.corners()) digest.add(corner);
}

/// The smallest box around a frustum, exactly.
template <Scalar S>
[[nodiscard]] constexpr Aabb<S, 3> bounding_box(const Frustum<S>& frustum) noexcept {
  return bounding_box(frustum.hull());
}

}  // namespace detent
