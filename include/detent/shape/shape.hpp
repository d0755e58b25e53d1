// SPDX-License-Identifier: MIT
#pragma once

// The shape layer: shapes, their bounds and measures, and moved shapes.

#include "detent/shape/aabb.hpp"
#include "detent/shape/bounding_box.hpp"
#include "detent/shape/bounding_sphere.hpp"
#include "detent/shape/camera.hpp"
#include "detent/shape/capsule.hpp"
#include "detent/shape/compound.hpp"
#include "detent/shape/frustum.hpp"
#include "detent/shape/hull.hpp"
#include "detent/shape/measure.hpp"
#include "detent/shape/moved.hpp"
#include "detent/shape/obb.hpp"
#include "detent/shape/orbit_camera.hpp"
#include "detent/shape/plane.hpp"
#include "detent/shape/ray.hpp"
#include "detent/shape/segment.hpp"
#include "detent/shape/sphere.hpp"
#include "detent/shape/triangle.hpp"
