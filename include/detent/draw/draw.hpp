// SPDX-License-Identifier: MIT
#pragma once

// Debug drawing, to a sink of lines and triangles that you implement:
//   draw(sink, shape, colour)         the edges of a shape, as lines; planes take a region too
//   draw_solid(sink, shape, colour)   its surface, as triangles, in 3D
//   draw(sink, point, colour, size)   a cross; contacts and hits also draw their normals
//   draw_sweep(sink, shape, direction, distance, colour)   a moving shape, at its start and end
//   draw(sink, scene, colours)        every object of a scene
//   draw(sink, world, colours)        every body of a world, and draw_solid in 3D
//   draw_tree(sink, scene), draw_tree(sink, mesh)          the boxes of the trees
// Drawing changes none of its arguments. Points are rounded to the grid of the scalar and clamped
// to its range, so drawings are for display only.

#include "detent/draw/box.hpp"
#include "detent/draw/compound.hpp"
#include "detent/draw/flat.hpp"
#include "detent/draw/hit.hpp"
#include "detent/draw/hull.hpp"
#include "detent/draw/round.hpp"
#include "detent/draw/scene.hpp"
#include "detent/draw/sink.hpp"
#include "detent/draw/surface.hpp"
#include "detent/draw/world.hpp"
#include "detent/query/kernel/argument.hpp"

namespace detent {

namespace detail {

template <class Sink, class Point>
inline constexpr bool takes_lines = false;
template <class Sink, Scalar S, int N>
inline constexpr bool takes_lines<Sink, Vec<S, N>> = DrawSink<Sink, S, N>;

template <class Sink, class Shape>
concept NoSink = IsArgument<Shape> && !takes_lines<Sink, typename PointOf<Shape>::type>;

}  // namespace detail

/// Catches sinks that lack a member. If it were deleted, clang would list every `draw`.
template <class Sink, class Shape, class... Rest>
requires detail::NoSink<Sink, Shape>
void draw(Sink&, const Shape&, const Rest&...) {
  static_assert(!detail::NoSink<Sink, Shape>,
                "detent: a sink has line(a, b, colour) and, in 3D, triangle(a, b, c, colour)");
}

}  // namespace detent
