// SPDX-License-Identifier: MIT
#pragma once

#include <type_traits>

#include "detent/scene/assets.hpp"
#include "detent/scene/mesh/cast.hpp"
#include "detent/scene/mesh/closest_point.hpp"
#include "detent/scene/mesh/contains.hpp"
#include "detent/scene/mesh/overlaps.hpp"
#include "detent/scene/mesh/pairs.hpp"
#include "detent/scene/mesh/placed.hpp"
#include "detent/scene/mesh/raycast.hpp"

namespace detent {

/// Listed by scenes that hold meshes, in 3D: `Scene<q16_16, 3, Sphere, MeshInstance>` holds
/// `PlacedMesh<q16_16>`. Snapshots refer to meshes by id and digest.
template <Scalar S, int N>
using MeshInstance = std::enable_if_t<N == 3, PlacedMesh<S>>;

}  // namespace detent
