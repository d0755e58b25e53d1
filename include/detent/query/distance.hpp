// SPDX-License-Identifier: MIT
#pragma once

// The distance from a point to a shape and between two shapes; for two points see math/vec.hpp:
//   distance(shape, point)         -> S                   rounded down, 0 inside
//   distance(a, b)                 -> S                   rounded down, 0 if they share a point
//   squared_distance(shape, point) -> Fixed or Fraction   exact; not for sphere and capsule, where
//                                                         it is not rational

#include "detent/query/distance/aabb.hpp"
#include "detent/query/distance/capsule.hpp"
#include "detent/query/distance/compound.hpp"
#include "detent/query/distance/frustum.hpp"
#include "detent/query/distance/hull.hpp"
#include "detent/query/distance/obb.hpp"
#include "detent/query/distance/pair.hpp"
#include "detent/query/distance/plane.hpp"
#include "detent/query/distance/ray.hpp"
#include "detent/query/distance/segment.hpp"
#include "detent/query/distance/sphere.hpp"
#include "detent/query/distance/triangle.hpp"
#include "detent/query/wrong_call.hpp"
