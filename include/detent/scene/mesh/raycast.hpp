// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <compare>
#include <cstddef>
#include <optional>
#include <span>

#include "detent/cull/keep_first.hpp"
#include "detent/number/next_up.hpp"
#include "detent/query/kernel/line_filter.hpp"
#include "detent/query/raycast/triangle.hpp"
#include "detent/scene/mesh/surface.hpp"

namespace detent {

/// A hit of a ray on a triangle of a mesh or height field. Ordered by distance, then by the
/// triangle's index.
template <Scalar S>
struct MeshHit {
  S distance{};
  std::uint32_t index = 0;

  [[nodiscard]] friend constexpr bool operator==(const MeshHit&, const MeshHit&) noexcept = default;
  [[nodiscard]] friend constexpr bool operator<(const MeshHit& a, const MeshHit& b) noexcept {
    return a.distance != b.distance ? a.distance < b.distance : a.index < b.index;
  }
};

/// Appends to a digest: the fields in order.
template <class D, Scalar S>
constexpr void append(D& digest, const MeshHit<S>& hit) noexcept {
  digest.add(hit.distance, hit.index);
}

namespace detail {

/// Visits the triangles of `surface` that `ray` touches, roughly nearest first: calls
/// visit(part, distance, limit).
template <template <class> class Surface, Scalar S, class Visit>
constexpr void visit_hits(const Ray<S, 3>& ray, const Surface<S>& surface,
                          const Visit& visit) noexcept {
  const LineFilter<S> line(ray);
  auto shorter = ray;
  visit_along(surface, ray, [&](std::span<const MeshTriangle<S>> parts, S& limit) {
    for (const auto& part : parts) {
      if (line.meets(part.triangle) == Filtered::no) continue;
      const auto distance = raycast(shorter, part.triangle);
      if (distance && visit(part, *distance, shorter.max_distance) == Walk::stop) return Walk::stop;
    }
    limit = shorter.max_distance;
    return Walk::go_on;
  });
}

/// The first hit of a ray on a surface, and its triangle.
template <Scalar S>
struct FoundOnSurface {
  MeshHit<S> hit;
  Triangle<S, 3> triangle;
};

template <template <class> class Surface, Scalar S>
[[nodiscard]] constexpr std::optional<FoundOnSurface<S>> first_on_surface(
    const Ray<S, 3>& ray, const Surface<S>& surface) noexcept {
  std::optional<FoundOnSurface<S>> best;
  visit_hits(ray, surface, [&](const MeshTriangle<S>& part, const S& distance, S& limit) {
    const MeshHit<S> hit{distance, part.index};
    if (!best || hit < best->hit) best = FoundOnSurface<S>{hit, part.triangle};
    // Of hits that round down to the same distance, the least index wins.
    limit = (std::min)(ray.max_distance, next_up(best->hit.distance));
    return Walk::go_on;
  });
  return best;
}

}  // namespace detail

/// The first triangle of `surface` that `ray` touches and the distance, or nothing.
///
/// units:  lengths in world units
/// domain: every input; rays and triangles as for `raycast(ray, triangle)`
/// result: of triangles whose distances round down to the same number, the one with the least index
/// exact:  hit or miss exact; distance rounded down, error in [0, 1) ULP
///         (tests/scene/mesh_raycast.test.cpp)
template <template <class> class Surface, Scalar S>
requires is_surface<Surface>
[[nodiscard]] constexpr std::optional<MeshHit<S>> raycast_nearest(
    const Ray<S, 3>& ray, const Surface<S>& surface) noexcept {
  const auto found = detail::first_on_surface(ray, surface);
  if (!found) return std::nullopt;
  return found->hit;
}

/// Whether `ray` touches any triangle of `surface`.
///
/// exact:  yes or no exact                               (tests/scene/mesh_raycast.test.cpp)
template <template <class> class Surface, Scalar S>
requires is_surface<Surface>
[[nodiscard]] constexpr bool raycast_any(const Ray<S, 3>& ray, const Surface<S>& surface) noexcept {
  bool any = false;
  detail::visit_hits(ray, surface, [&](const MeshTriangle<S>&, const S&, S&) {
    any = true;
    return Walk::stop;
  });
  return any;
}

/// The number of triangles of `surface` that the ray touches. Writes the first hits, as many as
/// `out` holds, sorted by distance, then by index.
///
/// exact:  as for `raycast_nearest`                      (tests/scene/mesh_raycast.test.cpp)
template <template <class> class Surface, Scalar S>
requires is_surface<Surface>
[[nodiscard]] constexpr std::size_t raycast_all(const Ray<S, 3>& ray, const Surface<S>& surface,
                                                std::span<MeshHit<S>> out) noexcept {
  std::size_t count = 0;
  detail::visit_hits(ray, surface, [&](const MeshTriangle<S>& part, const S& distance, S&) {
    detail::keep_first(out, count++, MeshHit<S>{distance, part.index});
    return Walk::go_on;
  });
  detail::sort_kept(out, count);
  return count;
}

/// Distance along `ray` at which it first touches `surface`, or nothing: see `raycast_nearest`.
template <template <class> class Surface, Scalar S>
requires is_surface<Surface>
[[nodiscard]] constexpr std::optional<S> raycast(const Ray<S, 3>& ray,
                                                 const Surface<S>& surface) noexcept {
  const auto found = detail::first_on_surface(ray, surface);
  if (!found) return std::nullopt;
  return found->hit.distance;
}

/// Distance, point and normal where `ray` first touches `surface`, or nothing: those of the
/// triangle of `raycast_nearest`.
template <template <class> class Surface, Scalar S>
requires is_surface<Surface>
[[nodiscard]] constexpr std::optional<RayHit<S, 3>> raycast_hit(
    const Ray<S, 3>& ray, const Surface<S>& surface) noexcept {
  const auto found = detail::first_on_surface(ray, surface);
  if (!found) return std::nullopt;
  return raycast_hit(ray, found->triangle);
}

}  // namespace detent
