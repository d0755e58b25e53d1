// SPDX-License-Identifier: MIT
#pragma once

// The point of a shape closest to `point`; `point` itself if inside:
//   closest_point(shape, point) -> Vec<S, N>

#include "detent/query/closest_point/aabb.hpp"
#include "detent/query/closest_point/capsule.hpp"
#include "detent/query/closest_point/compound.hpp"
#include "detent/query/closest_point/frustum.hpp"
#include "detent/query/closest_point/hull.hpp"
#include "detent/query/closest_point/obb.hpp"
#include "detent/query/closest_point/plane.hpp"
#include "detent/query/closest_point/ray.hpp"
#include "detent/query/closest_point/segment.hpp"
#include "detent/query/closest_point/sphere.hpp"
#include "detent/query/closest_point/triangle.hpp"
#include "detent/query/wrong_call.hpp"
