// SPDX-License-Identifier: MIT
#pragma once

// Whether a point is in a shape, which is a closed set:
//   contains(shape, point) -> bool

#include "detent/query/contains/aabb.hpp"
#include "detent/query/contains/capsule.hpp"
#include "detent/query/contains/compound.hpp"
#include "detent/query/contains/frustum.hpp"
#include "detent/query/contains/hull.hpp"
#include "detent/query/contains/obb.hpp"
#include "detent/query/contains/plane.hpp"
#include "detent/query/contains/ray.hpp"
#include "detent/query/contains/segment.hpp"
#include "detent/query/contains/sphere.hpp"
#include "detent/query/contains/triangle.hpp"
#include "detent/query/wrong_call.hpp"
