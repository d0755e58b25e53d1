// SPDX-License-Identifier: MIT
#pragma once

// Terrain: heights on a grid, without a heap and without a tree:
//   height_field(corner, cell, columns, rows, heights) -> std::optional<HeightField<S>>
// and every query of scene/mesh.hpp, with a height field in place of the mesh. A `PlacedField` is a
// field elsewhere, which the same queries take, and scenes as `FieldInstance`.

#include "detent/scene/height_field/asset.hpp"
#include "detent/scene/height_field/height_field.hpp"
#include "detent/scene/height_field/instance.hpp"
#include "detent/scene/height_field/placed.hpp"
#include "detent/scene/height_field/walk.hpp"
#include "detent/scene/mesh/closest_point.hpp"
#include "detent/scene/mesh/contains.hpp"
#include "detent/scene/mesh/overlaps.hpp"
#include "detent/scene/mesh/pairs.hpp"
#include "detent/scene/mesh/raycast.hpp"
