// SPDX-License-Identifier: MIT
#pragma once

// A ray against a shape:
//   raycast(ray, shape)          -> std::optional<S>             distance
//   raycast_hit(ray, shape)      -> std::optional<RayHit<S, N>>  distance, point, normal
//   raycast_interval(ray, shape) -> std::optional<Interval<S>>   enter, exit

#include "detent/query/raycast/aabb.hpp"
#include "detent/query/raycast/capsule.hpp"
#include "detent/query/raycast/compound.hpp"
#include "detent/query/raycast/frustum.hpp"
#include "detent/query/raycast/hit.hpp"
#include "detent/query/raycast/hull.hpp"
#include "detent/query/raycast/obb.hpp"
#include "detent/query/raycast/plane.hpp"
#include "detent/query/raycast/segment.hpp"
#include "detent/query/raycast/sphere.hpp"
#include "detent/query/raycast/triangle.hpp"
#include "detent/query/wrong_call.hpp"

// In programs that link `detent::detent`.
#if defined(DETENT_USE_LIBRARY) && DETENT_USE_LIBRARY
#include "detent/instantiations.hpp"
#endif
