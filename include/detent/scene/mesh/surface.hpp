// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "detent/cull/lanes.hpp"
#include "detent/cull/walk.hpp"
#include "detent/query/wrong_call.hpp"
#include "detent/shape/bounding_box.hpp"

namespace detent {

/// A triangle of a mesh, with an index chosen by its owner, unlike those of the others. Results name
/// this index and are ordered by it.
template <Scalar S>
struct MeshTriangle {
  Triangle<S, 3> triangle;
  std::uint32_t index = 0;

  [[nodiscard]] friend constexpr bool operator==(const MeshTriangle&,
                                                 const MeshTriangle&) noexcept = default;
};

/// Appends to a digest: the fields in order.
template <class D, Scalar S>
constexpr void append(D& digest, const MeshTriangle<S>& part) noexcept {
  digest.add(part.triangle, part.index);
}

/// The smallest box around the triangle.
template <Scalar S>
[[nodiscard]] constexpr Aabb<S, 3> bounding_box(const MeshTriangle<S>& part) noexcept {
  return bounding_box(part.triangle);
}

/// The same box as lanes, for triangles of 32-bit fixed-point numbers on machines with vectors: see
/// `around_three`.
template <Scalar S, class Numbers = detail::Lanes<std::int32_t>>
requires(detail::has_lanes&& is_fixed<S> && sizeof(S) == 4) [[nodiscard]] inline Numbers
    lanes_around(const MeshTriangle<S>& part) noexcept {
  static_assert(sizeof part == 40);
  return Numbers::around_three(&part);
}

/// Whether a template is a surface of triangles, which the queries of this folder take: a `Mesh` or
/// a `HeightField`. A surface has a `bounding_box`, parts as described in parts.hpp, and
///   visit_along(surface, ray, visit), visit_within(surface, box, visit),
///   visit_crossing(surface, segment, visit), visit_around(surface, point, visit),
/// walks (cull/walk.hpp) whose items are a std::span<const MeshTriangle<S>>; the first and the last
/// have a limit.
template <template <class> class Surface>
inline constexpr bool is_surface = false;

/// The same for a type.
template <class T>
inline constexpr bool is_surface_type = false;
template <template <class> class Surface, Scalar S>
inline constexpr bool is_surface_type<Surface<S>> = is_surface<Surface>;

namespace detail {

template <template <class> class Surface, Scalar S>
requires is_surface<Surface>
inline constexpr Argument argument<Surface<S>> = Argument::shape;
template <template <class> class Surface, Scalar S>
requires is_surface<Surface>
inline constexpr bool is_convex<Surface<S>> = false;
template <template <class> class Surface, Scalar S>
requires is_surface<Surface>
struct PointOf<Surface<S>> {
  using type = Vec<S, 3>;
};

/// Whether `test` holds for any of these triangles.
template <Scalar S, class Test>
[[nodiscard]] constexpr bool any_triangle(std::span<const MeshTriangle<S>> parts,
                                          const Test& test) noexcept {
  for (const auto& part : parts) {
    if (test(part.triangle)) return true;
  }
  return false;
}

/// Whether `test` holds for any triangle of `surface` near `box`; those far from it are culled.
template <template <class> class Surface, Scalar S, class Test>
requires is_surface<Surface>
[[nodiscard]] constexpr bool any_triangle_within(const Surface<S>& surface, const Aabb<S, 3>& box,
                                                 const Test& test) noexcept {
  return visit_within(surface, box, [&](std::span<const MeshTriangle<S>> parts) {
           return stop_if(any_triangle(parts, test));
         }) == Walk::stop;
}

}  // namespace detail

}  // namespace detent
