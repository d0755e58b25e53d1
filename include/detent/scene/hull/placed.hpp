// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <type_traits>

#include "detent/query/cast/pair.hpp"
#include "detent/query/closest_point/hull.hpp"
#include "detent/query/contains/hull.hpp"
#include "detent/query/distance/hull.hpp"
#include "detent/query/intersects/hull.hpp"
#include "detent/query/overlaps/aabb_hull.hpp"
#include "detent/query/overlaps/capsule_hull.hpp"
#include "detent/query/overlaps/hull_hull.hpp"
#include "detent/query/overlaps/obb_hull.hpp"
#include "detent/query/overlaps/plane_hull.hpp"
#include "detent/query/overlaps/sphere_hull.hpp"
#include "detent/query/overlaps/triangle_hull.hpp"
#include "detent/query/raycast/hull.hpp"
#include "detent/scene/asset_instance.hpp"
#include "detent/scene/hull/asset.hpp"
#include "detent/scene/mesh/surface.hpp"
#include "detent/scene/put.hpp"
#include "detent/scene/separate.hpp"
#include "detent/scene/shape_tag.hpp"
#include "detent/shape/bounding_box.hpp"

namespace detent {

template <Scalar S, int N>
inline constexpr detail::AssetNames detail::asset_names<PlacedHull<S, N>>{"hull",
                                                                          "digest of its points"};

/// The hull moved by a vector: the translation is rounded to nearest and clamped.
template <Scalar S, int N>
[[nodiscard]] constexpr PlacedHull<S, N> translated(const PlacedHull<S, N>& hull,
                                                    const Vec<S, N>& by) noexcept {
  auto result = hull;
  result.transform.translation = nearest_to<S>(hull.transform.translation + by);
  return result;
}

/// The hull moved from a local frame to the world: the transforms are composed and rounded.
template <Scalar S, int N>
[[nodiscard]] constexpr PlacedHull<S, N> placed(const Transform<S, N>& transform,
                                                const PlacedHull<S, N>& hull) noexcept {
  return {hull.asset, compose(transform, hull.transform)};
}

namespace detail {

template <Scalar S, int N>
inline constexpr std::uint8_t shape_tag<PlacedHull<S, N>> = 8;

/// The transformed points of a hull.
template <Scalar S, int N>
class HullPoints {
 public:
  explicit constexpr HullPoints(const PlacedHull<S, N>& placed) noexcept {
    if (placed.asset == nullptr) return;
    const auto& transform = placed.transform;
    const bool is_moved = only_moves(transform);
    for (const auto& point : placed.asset->hull().points) {
      points_[count_++] = is_moved ? nearest_to<S>(point + transform.translation)
                                   : transform_point(transform, point);
    }
  }
  [[nodiscard]] constexpr ConvexHull<S, N> hull() const noexcept {
    return {std::span<const Vec<S, N>>(points_).first(count_)};
  }

 private:
  std::array<Vec<S, N>, HullAsset<S, N>::capacity> points_;
  std::size_t count_ = 0;
};

}  // namespace detail

/// Queries of a placed hull: those of the convex hull of its transformed points, each rounded.
template <Scalar S, int N>
[[nodiscard]] constexpr Aabb<S, N> bounding_box(const PlacedHull<S, N>& placed) noexcept {
  return bounding_box(detail::HullPoints(placed).hull());
}
template <Scalar S, int N>
[[nodiscard]] constexpr bool contains(const PlacedHull<S, N>& placed,
                                      const Vec<S, N>& point) noexcept {
  return contains(detail::HullPoints(placed).hull(), point);
}
template <Scalar S, int N>
[[nodiscard]] constexpr Vec<S, N> closest_point(const PlacedHull<S, N>& placed,
                                                const Vec<S, N>& point) noexcept {
  return closest_point(detail::HullPoints(placed).hull(), point);
}
template <Scalar S, int N>
[[nodiscard]] constexpr S distance(const PlacedHull<S, N>& placed,
                                   const Vec<S, N>& point) noexcept {
  return distance(detail::HullPoints(placed).hull(), point);
}
template <Scalar S, int N>
[[nodiscard]] constexpr bool intersects(const Segment<S, N>& segment,
                                        const PlacedHull<S, N>& placed) noexcept {
  return intersects(segment, detail::HullPoints(placed).hull());
}
template <Scalar S, int N>
[[nodiscard]] constexpr std::optional<S> raycast(const Ray<S, N>& ray,
                                                 const PlacedHull<S, N>& placed) noexcept {
  return raycast(ray, detail::HullPoints(placed).hull());
}
template <Scalar S, int N>
[[nodiscard]] constexpr std::optional<RayHit<S, N>> raycast_hit(
    const Ray<S, N>& ray, const PlacedHull<S, N>& placed) noexcept {
  return raycast_hit(ray, detail::HullPoints(placed).hull());
}
template <Scalar S, int N>
[[nodiscard]] constexpr std::optional<Interval<S>> raycast_interval(
    const Ray<S, N>& ray, const PlacedHull<S, N>& placed) noexcept {
  return raycast_interval(ray, detail::HullPoints(placed).hull());
}

namespace detail {

template <Scalar S, int N>
struct CastAt<PlacedHull<S, N>> {
  template <class Shape>
  [[nodiscard]] static constexpr std::optional<S> distance(
      const Cast<Shape>& moving, const PlacedHull<S, N>& placed) noexcept {
    return cast_distance(moving.shape, moving.direction, moving.max_distance,
                         HullPoints(placed).hull());
  }
};

template <class Shape, Scalar S, int N>
[[nodiscard]] constexpr std::optional<S> cast_distance(const Shape& shape,
                                                       const Direction<S, N>& direction,
                                                       const std::type_identity_t<S>& max_distance,
                                                       const PlacedHull<S, N>& placed) noexcept {
  return cast_distance(shape, direction, max_distance, HullPoints(placed).hull());
}

}  // namespace detail

/// Where a moving shape first touches a placed hull, or nothing: see query/cast.hpp.
template <class Shape, Scalar S, int N>
[[nodiscard]] constexpr std::optional<CastHit<S, N>> cast(
    const Shape& shape, const Direction<S, N>& direction,
    const std::type_identity_t<S>& max_distance, const PlacedHull<S, N>& placed) noexcept {
  return cast(shape, direction, max_distance, detail::HullPoints(placed).hull());
}

/// A shape to test against a placed hull: one that has `overlaps` with convex hulls.
template <class Shape, class S, int N>
concept MeetsHulls =
    !is_surface_type<Shape> && requires(const Shape& shape, const ConvexHull<S, N>& hull) {
  { overlaps(shape, hull) } -> std::same_as<bool>;
};

/// Whether a placed hull and another shape overlap.
template <Scalar S, int N, MeetsHulls<S, N> Shape>
[[nodiscard]] constexpr bool overlaps(const PlacedHull<S, N>& placed, const Shape& shape) noexcept {
  return overlaps(detail::HullPoints(placed).hull(), shape);
}
template <Scalar S, int N, MeetsHulls<S, N> Shape>
[[nodiscard]] constexpr bool overlaps(const Shape& shape, const PlacedHull<S, N>& placed) noexcept {
  return overlaps(shape, detail::HullPoints(placed).hull());
}
template <Scalar S, int N>
[[nodiscard]] constexpr bool overlaps(const PlacedHull<S, N>& a,
                                      const PlacedHull<S, N>& b) noexcept {
  return overlaps(detail::HullPoints(a).hull(), detail::HullPoints(b).hull());
}
/// Transforms the points once for all triangles of a surface.
template <template <class> class Surface, Scalar S>
requires is_surface<Surface>
[[nodiscard]] constexpr bool overlaps(const Surface<S>& surface,
                                      const PlacedHull<S, 3>& placed) noexcept {
  return overlaps(surface, detail::HullPoints(placed).hull());
}
template <template <class> class Surface, Scalar S>
requires is_surface<Surface>
[[nodiscard]] constexpr bool overlaps(const PlacedHull<S, 3>& placed,
                                      const Surface<S>& surface) noexcept {
  return overlaps(surface, detail::HullPoints(placed).hull());
}

}  // namespace detent
