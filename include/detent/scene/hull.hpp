// SPDX-License-Identifier: MIT
#pragma once

// Convex hulls in scenes: a `HullAsset` is a hull with an id, a `PlacedHull` that hull transformed:
//   hull_asset(id, ConvexHull{points})      -> std::optional<HullAsset<S, N>>
//   Scene<q16_16, 3, Sphere, HullInstance>  holds PlacedHull{&asset, transform}
// A `PlacedHull` has every query of a `ConvexHull`.

#include "detent/scene/hull/asset.hpp"
#include "detent/scene/hull/instance.hpp"
#include "detent/scene/hull/placed.hpp"
