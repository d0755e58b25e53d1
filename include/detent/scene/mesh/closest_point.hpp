// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "detent/query/closest_point/triangle.hpp"
#include "detent/query/distance/triangle.hpp"
#include "detent/scene/mesh/surface.hpp"

namespace detent {

/// The triangle of a surface that is nearest to a point, and its distance.
template <Scalar S>
struct MeshNearest {
  S distance{};
  std::uint32_t index = 0;
  /// The nearest point of the triangle.
  Vec<S, 3> point;

  [[nodiscard]] friend constexpr bool operator==(const MeshNearest&,
                                                 const MeshNearest&) noexcept = default;
};

/// Appends to a digest: the fields in order.
template <class D, Scalar S>
constexpr void append(D& digest, const MeshNearest<S>& nearest) noexcept {
  digest.add(nearest.distance, nearest.index, nearest.point);
}

/// The triangle of `surface` nearest to `point`, or nothing if there are no triangles.
///
/// units:  world units
/// domain: every input
/// result: of triangles whose `distance`s are equal, even if only by rounding or clamping, the one
///         with the least index
/// exact:  the triangle is the nearest within 1 ULP; `distance` and `point` are the `distance` and
///         `closest_point` of the triangle               (tests/scene/mesh_overlaps.test.cpp)
template <template <class> class Surface, Scalar S>
requires is_surface<Surface>
[[nodiscard]] constexpr std::optional<MeshNearest<S>> nearest_triangle(
    const Surface<S>& surface, const Vec<S, 3>& point) noexcept {
  std::optional<MeshTriangle<S>> best;
  S least = largest<S>;
  visit_around(surface, point, [&](std::span<const MeshTriangle<S>> parts, S& limit) {
    for (const auto& part : parts) {
      const S to_part = distance(part.triangle, point);
      const bool nearer =
          !best || to_part < least || (to_part == least && part.index < best->index);
      if (!nearer) continue;
      best = part;
      least = to_part;
    }
    limit = least;
    return Walk::go_on;
  });
  if (!best) return std::nullopt;
  return MeshNearest<S>{least, best->index, closest_point(best->triangle, point)};
}

/// The closest point of the triangle of `surface` nearest to `point`; `point` itself if there are
/// no triangles.
template <template <class> class Surface, Scalar S>
requires is_surface<Surface>
[[nodiscard]] constexpr Vec<S, 3> closest_point(const Surface<S>& surface,
                                                const Vec<S, 3>& point) noexcept {
  const auto nearest = nearest_triangle(surface, point);
  return nearest ? nearest->point : point;
}

/// The distance from `point` to `surface`, rounded down and clamped to the range of the scalar; the
/// greatest scalar if there are no triangles.
template <template <class> class Surface, Scalar S>
requires is_surface<Surface>
[[nodiscard]] constexpr S distance(const Surface<S>& surface, const Vec<S, 3>& point) noexcept {
  const auto nearest = nearest_triangle(surface, point);
  return nearest ? nearest->distance : largest<S>;
}

}  // namespace detent
