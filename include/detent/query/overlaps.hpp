// SPDX-License-Identifier: MIT
#pragma once

// Two shapes, both closed sets, in either order:
//   overlaps(a, b) -> bool

#include "detent/query/overlaps/aabb_aabb.hpp"
#include "detent/query/overlaps/aabb_capsule.hpp"
#include "detent/query/overlaps/aabb_hull.hpp"
#include "detent/query/overlaps/aabb_obb.hpp"
#include "detent/query/overlaps/aabb_plane.hpp"
#include "detent/query/overlaps/aabb_triangle.hpp"
#include "detent/query/overlaps/capsule_capsule.hpp"
#include "detent/query/overlaps/compound.hpp"
#include "detent/query/overlaps/hull_hull.hpp"
#include "detent/query/overlaps/obb_capsule.hpp"
#include "detent/query/overlaps/obb_hull.hpp"
#include "detent/query/overlaps/obb_obb.hpp"
#include "detent/query/overlaps/obb_plane.hpp"
#include "detent/query/overlaps/obb_triangle.hpp"
#include "detent/query/overlaps/plane_capsule.hpp"
#include "detent/query/overlaps/plane_plane.hpp"
#include "detent/query/overlaps/plane_triangle.hpp"
#include "detent/query/overlaps/sphere_aabb.hpp"
#include "detent/query/overlaps/sphere_capsule.hpp"
#include "detent/query/overlaps/sphere_obb.hpp"
#include "detent/query/overlaps/sphere_plane.hpp"
#include "detent/query/overlaps/sphere_sphere.hpp"
#include "detent/query/overlaps/sphere_triangle.hpp"
#include "detent/query/overlaps/triangle_capsule.hpp"
#include "detent/query/overlaps/triangle_hull.hpp"
#include "detent/query/overlaps/triangle_triangle.hpp"
