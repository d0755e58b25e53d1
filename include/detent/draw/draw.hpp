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
