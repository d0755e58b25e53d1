// SPDX-License-Identifier: MIT
#pragma once

#include <iterator>
#include <tuple>
#include <type_traits>

#include "detent/query/overlaps/aabb_aabb.hpp"
#include "detent/query/overlaps/aabb_plane.hpp"
#include "detent/scene/hull/placed.hpp"
#include "detent/scene/mesh/surface.hpp"
#include "detent/shape/bounding_box.hpp"

namespace detent {

namespace detail {

/// Calls f(shape) for the convex parts of a solid that may touch `box`: of a shape, a list of
/// shapes, a compound, a surface of triangles, or a callable that does this.
template <Scalar S, int N, class T, class F>
constexpr void visit_parts_in(const Aabb<S, N>& box, const T& solid, const F& f) {
  if constexpr (requires { solid(box, f); }) {
    solid(box, f);
  } else if constexpr (is_compound<T>) {
    for_each_part(solid, [&](const auto& part) { visit_parts_in(box, part, f); });
  } else if constexpr (is_surface_type<T>) {
    visit_within(solid, box, [&](const auto& parts) {
      for (const auto& part : parts) {
        if (overlaps(box, bounding_box(part.triangle))) f(part.triangle);
      }
      return Walk::go_on;
    });
  } else if constexpr (std::is_same_v<T, PlacedHull<S, N>>) {
    const HullPoints<S, N> points(solid);
    if (overlaps(box, bounding_box(points.hull()))) f(points.hull());
  } else if constexpr (requires { std::begin(solid); }) {
    for (const auto& part : solid) visit_parts_in(box, part, f);
  } else if constexpr (std::is_same_v<T, Plane<S, N>>) {
    if (overlaps(solid, box)) f(solid);
  } else {
    if (overlaps(box, bounding_box(solid))) f(solid);
  }
}

}  // namespace detail

/// The obstacles of particles, in this order. Called with a box and a function f, it calls f(shape)
/// for each convex shape that may touch the box. It refers to its parts, which must outlive it.
template <Scalar S, int N, class... Parts>
class Obstacles {
 public:
  /// See `obstacles`.
  explicit constexpr Obstacles(const Parts&... parts) noexcept : parts_(parts...) {}

  template <class F>
  constexpr void operator()(const Aabb<S, N>& box, const F& f) const {
    std::apply([&](const Parts&... part) { (detail::visit_parts_in(box, part, f), ...); }, parts_);
  }

 private:
  std::tuple<const Parts&...> parts_;
};

/// Obstacles for `ParticleSystem::step`: shapes, lists of shapes, compounds, placed meshes, hulls
/// and height fields, `obstacles_of(world)`, `obstacles_of(scene)`, or any callable that takes a
/// box and a function and calls that function with convex shapes.
template <Scalar S, int N, class... Parts>
[[nodiscard]] constexpr Obstacles<S, N, Parts...> obstacles(const Parts&... parts) noexcept {
  return Obstacles<S, N, Parts...>(parts...);
}

}  // namespace detent
