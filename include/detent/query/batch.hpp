// SPDX-License-Identifier: MIT
#pragma once

// One ray against many shapes of one type, and many rays against one shape:
//   raycast_first(ray, shapes)          -> std::optional<BatchHit<S>>  index, distance
//   raycast_any(ray, shapes)            -> bool
//   raycast_each(ray, shapes, answers)     answers[i] = raycast(ray, shapes[i])
//   raycast_any(rays, shape)            -> bool
//   raycast_each(rays, shape, answers)
// where `shapes` is a ShapeBatch and `rays` a RayBatch. Queries only read: any number of threads may
// share a batch.                                                   (tests/scene/threads.cpp)

#include "detent/query/batch/bounds.hpp"
#include "detent/query/batch/rays.hpp"
#include "detent/query/batch/shapes.hpp"
