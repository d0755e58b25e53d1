// SPDX-License-Identifier: MIT
#pragma once

#include "detent/scene/assets.hpp"
#include "detent/scene/hull/placed.hpp"

namespace detent {

/// Listed by scenes that hold convex hulls: `Scene<q16_16, 3, Sphere, HullInstance>` holds
/// `PlacedHull<q16_16, 3>`. Snapshots refer to hulls by id and digest.
template <Scalar S, int N>
using HullInstance = PlacedHull<S, N>;

}  // namespace detent
