// SPDX-License-Identifier: MIT
#pragma once

// Terrain: heights on a grid, without a heap and without a tree:
//   height_field(corner, cell, columns, rows, heights) -> std::optional<HeightField<S>>
// and every query of scene/mesh.hpp, with a height field instead of a mesh. A `PlacedField` is a
// translated field: it has the same queries, and scenes hold it as `FieldInstance`.

#include "detent/scene/height_field/asset.hpp"
#include "detent/scene/height_field/height_field.hpp"
#include "detent/scene/height_field/instance.hpp"
#include "detent/scene/height_field/placed.hpp"
#include "detent/scene/height_field/walk.hpp"
#include "detent/scene/mesh/cast.hpp"
#include "detent/scene/mesh/closest_point.hpp"
#include "detent/scene/mesh/closest_points.hpp"
#include "detent/scene/mesh/contact.hpp"
#include "detent/scene/mesh/contains.hpp"
#include "detent/scene/mesh/distance.hpp"
#include "detent/scene/mesh/overlaps.hpp"
#include "detent/scene/mesh/pairs.hpp"
#include "detent/scene/mesh/raycast.hpp"
