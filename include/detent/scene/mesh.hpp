// SPDX-License-Identifier: MIT
#pragma once

// Triangle meshes with a tree over them, without a heap:
//   build_mesh(triangles, nodes)            -> std::optional<Mesh<S>>     in the caller's storage
//   raycast_nearest(ray, mesh)              -> std::optional<MeshHit<S>>  distance, index
//   raycast_any(ray, mesh)                  -> bool
//   raycast_all(ray, mesh, hits)            -> how many, sorted by (distance, index)
//   raycast(ray, mesh), raycast_hit(ray, mesh)   as for other shapes
//   cast_nearest(shape, direction, distance, mesh)   -> std::optional<MeshHit<S>>
//   cast(shape, direction, distance, mesh)   as at other targets
//   overlaps(mesh, shape), overlaps(shape, mesh), overlaps_all(mesh, shape, indices)
//   overlaps(mesh, plane), overlaps(mesh, mesh), contains(mesh, point), intersects(segment, mesh)
//   nearest_triangle(mesh, point)           -> std::optional<MeshNearest<S>>
//   closest_point(mesh, point), distance(mesh, point)
// A `PlacedMesh` is a transformed mesh: it has the same queries, and scenes hold it as
// `MeshInstance`. `scene/mesh/owned.hpp` has a mesh that owns its storage, in std::vector.

#include "detent/scene/mesh/asset.hpp"
#include "detent/scene/mesh/cast.hpp"
#include "detent/scene/mesh/closest_point.hpp"
#include "detent/scene/mesh/closest_points.hpp"
#include "detent/scene/mesh/contact.hpp"
#include "detent/scene/mesh/contains.hpp"
#include "detent/scene/mesh/distance.hpp"
#include "detent/scene/mesh/instance.hpp"
#include "detent/scene/mesh/mesh.hpp"
#include "detent/scene/mesh/overlaps.hpp"
#include "detent/scene/mesh/pairs.hpp"
#include "detent/scene/mesh/placed.hpp"
#include "detent/scene/mesh/raycast.hpp"
