// SPDX-License-Identifier: MIT
#pragma once

// Whether a segment and a shape, both closed sets, share a point; in either order:
//   intersects(segment, shape) -> bool

#include "detent/query/intersects/aabb.hpp"
#include "detent/query/intersects/capsule.hpp"
#include "detent/query/intersects/compound.hpp"
#include "detent/query/intersects/frustum.hpp"
#include "detent/query/intersects/hull.hpp"
#include "detent/query/intersects/obb.hpp"
#include "detent/query/intersects/plane.hpp"
#include "detent/query/intersects/segment.hpp"
#include "detent/query/intersects/sphere.hpp"
#include "detent/query/intersects/triangle.hpp"
#include "detent/query/wrong_call.hpp"
