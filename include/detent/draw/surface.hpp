// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "detent/draw/flat.hpp"
#include "detent/draw/hull.hpp"
#include "detent/scene/hull/placed.hpp"
#include "detent/scene/mesh/surface.hpp"

namespace detent {

namespace detail {

template <template <class> class Surface, Scalar S, class Visit>
constexpr void for_each_triangle(const Surface<S>& surface, const Visit& visit) {
  visit_within(surface, bounding_box(surface), [&](std::span<const MeshTriangle<S>> parts) {
    for (const auto& part : parts) visit(part.triangle);
    return Walk::go_on;
  });
}

}  // namespace detail

/// Draws a mesh or a height field, placed or not: three lines per triangle, so inner edges are
/// drawn twice.
template <class Sink, template <class> class Surface, Scalar S>
requires is_surface<Surface> && DrawSink<Sink, S, 3>
constexpr void draw(Sink& sink, const Surface<S>& surface, const Colour& colour) {
  detail::for_each_triangle(surface, [&](const auto& triangle) { draw(sink, triangle, colour); });
}
/// Draws its triangles.
template <class Sink, template <class> class Surface, Scalar S>
requires is_surface<Surface> && DrawSink<Sink, S, 3>
constexpr void draw_solid(Sink& sink, const Surface<S>& surface, const Colour& colour) {
  detail::for_each_triangle(surface,
                            [&](const auto& triangle) { draw_solid(sink, triangle, colour); });
}

/// Draws the hull of the transformed points.
template <class Sink, Scalar S, int N>
requires DrawSink<Sink, S, N>
constexpr void draw(Sink& sink, const PlacedHull<S, N>& placed, const Colour& colour) {
  draw(sink, detail::HullPoints(placed).hull(), colour);
}
template <class Sink, Scalar S>
requires DrawSink<Sink, S, 3>
constexpr void draw_solid(Sink& sink, const PlacedHull<S, 3>& placed, const Colour& colour) {
  draw_solid(sink, detail::HullPoints(placed).hull(), colour);
}

}  // namespace detent
