// SPDX-License-Identifier: MIT
#pragma once

// Terrain: heights on a grid, without a heap and without a tree:
//   height_field(corner, cell, columns, rows, heights) -> std::optional<HeightField<S>>
// and every query of scene/mesh.hpp, with a height field in place of the mesh.

#include "detent/scene/height_field/height_field.hpp"
#include "detent/scene/height_field/walk.hpp"
#include "detent/scene/mesh/closest_point.hpp"
#include "detent/scene/mesh/contains.hpp"
#include "detent/scene/mesh/overlaps.hpp"
#include "detent/scene/mesh/pairs.hpp"
#include "detent/scene/mesh/raycast.hpp"
