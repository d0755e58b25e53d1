// SPDX-License-Identifier: MIT
#pragma once

// Segments against every shape, both closed sets, in either order:
//   intersects(segment, shape) -> bool

#include "detent/query/intersects/aabb.hpp"
#include "detent/query/intersects/capsule.hpp"
#include "detent/query/intersects/compound.hpp"
#include "detent/query/intersects/hull.hpp"
#include "detent/query/intersects/obb.hpp"
#include "detent/query/intersects/plane.hpp"
#include "detent/query/intersects/segment.hpp"
#include "detent/query/intersects/sphere.hpp"
#include "detent/query/intersects/triangle.hpp"
#include "detent/query/wrong_call.hpp"
