// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "detent/dynamics/terrain.hpp"
#include "detent/scene/mesh/owned.hpp"
#include "dynamics/stage.hpp"

// Worlds with meshes and height fields.
namespace detent::test {

template <Scalar S>
using Ground = World<S, 3, Sphere, Capsule, Aabb, Obb, BodyHull, BodyMesh, BodyHeightField>;

template <Scalar S>
Vec<S, 3> point(double x, double y, double z) {
  return {num<S>(x), num<S>(y), num<S>(z)};
}

/// The triangles of a square from -size to size with `cells` cells per side, at these heights.
template <Scalar S, class Height>
std::vector<Triangle<S, 3>> square(int cells, double size, const Height& height) {
  std::vector<Triangle<S, 3>> triangles;
  const double cell = 2 * size / cells;
  const auto corner = [&](int i, int j) {
    const double x = cell * i - size, z = cell * j - size;
    return point<S>(x, height(x, z), z);
  };
  for (int j = 0; j < cells; ++j) {
    for (int i = 0; i < cells; ++i) {
      triangles.push_back({corner(i, j), corner(i, j + 1), corner(i + 1, j)});
      triangles.push_back({corner(i + 1, j), corner(i, j + 1), corner(i + 1, j + 1)});
    }
  }
  return triangles;
}

/// A mesh with its asset.
template <Scalar S>
struct Owned {
  OwnedMesh<S> mesh;
  MeshAsset<S> asset;

  explicit Owned(const std::vector<Triangle<S, 3>>& triangles, std::uint32_t id = 1)
      : mesh(triangles), asset(id, mesh.view()) {}
};

template <Scalar S>
BodyOptions<S, 3> fixed() {
  BodyOptions<S, 3> options;
  options.motion = BodyMotion::fixed;
  return options;
}

inline const auto level = [](double, double) { return 0.0; };
}  // namespace detent::test
