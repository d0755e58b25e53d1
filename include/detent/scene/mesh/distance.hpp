// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <optional>
#include <span>

#include "detent/query/distance/pair.hpp"
#include "detent/scene/mesh/parts.hpp"

namespace detent {

namespace detail {

/// A stand-in for `shape` whose distance to a box is no greater: its bounding box, or the shape
/// itself if it has none.
template <class Shape>
[[nodiscard]] constexpr auto culled_as(const Shape& shape) noexcept {
  if constexpr (requires { bounding_box(shape); }) {
    return bounding_box(shape);
  } else {
    return shape;
  }
}

/// The lesser of `least` and the distance between `shape` and the triangles of `surface`.
/// to_shape(triangle, least) returns the distance of one triangle, exact if it is below `least`.
template <class Surface, class Shape, Scalar S, class ToShape>
[[nodiscard]] constexpr S least_distance(const Surface& surface, const Shape& shape, S least,
                                         const ToShape& to_shape) noexcept {
  const auto reach = culled_as(shape);
  visit_parts<S>(
      surface,
      [&](const Aabb<S, 3>& box) {
        const S to_box = distance(box, reach);
        return to_box < least ? std::optional(to_box) : std::nullopt;
      },
      [&](const S& to_box) { return to_box < least; },
      [&](std::span<const MeshTriangle<S>> triangles) {
        for (const auto& part : triangles) {
          least = (std::min)(least, to_shape(part.triangle, least));
        }
        return stop_if(least == S(0));
      });
  return least;
}
template <class Surface, class Shape, Scalar S>
[[nodiscard]] constexpr S least_distance(const Surface& surface, const Shape& shape,
                                         const S& least) noexcept {
  return least_distance(surface, shape, least, [&](const Triangle<S, 3>& triangle, const S&) {
    return distance(triangle, shape);
  });
}

template <class Shape, class S>
concept HasDistance = HaveDistance<Triangle<S, 3>, Shape>;

}  // namespace detail

/// The distance between `surface` and `shape`: that of its nearest triangle, 0 if they share a
/// point. A shape inside a closed mesh is as far from it as from its triangles.
///
/// units:  world units
/// domain: every input; clamped to the greatest scalar, which is the result for an empty shape and
///         a surface without triangles
/// exact:  rounded down, error in [0, 1) ULP               (tests/scene/mesh_distance.test.cpp)
template <template <class> class Surface, Scalar S, detail::HasDistance<S> Shape>
requires is_surface<Surface>
[[nodiscard]] constexpr S distance(const Surface<S>& surface, const Shape& shape) noexcept {
  return detail::least_distance(surface, shape, largest<S>);
}
template <template <class> class Surface, Scalar S, detail::HasDistance<S> Shape>
requires is_surface<Surface>
[[nodiscard]] constexpr S distance(const Shape& shape, const Surface<S>& surface) noexcept {
  return distance(surface, shape);
}

/// The distance between two surfaces: that of their nearest triangles.
///
/// exact:  as above                                        (tests/scene/mesh_distance.test.cpp)
template <template <class> class A, template <class> class B, Scalar S>
requires(is_surface<A>&& is_surface<B>) [[nodiscard]] constexpr S
    distance(const A<S>& a, const B<S>& b) noexcept {
  return detail::least_distance(a, b, largest<S>,
                                [&](const Triangle<S, 3>& triangle, const S& least) {
                                  return detail::least_distance(b, triangle, least);
                                });
}

}  // namespace detent
