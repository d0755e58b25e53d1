// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <map>
#include <vector>

#include "bench/as_scalar.hpp"
#include "detent/scene/mesh/owned.hpp"

namespace detent::bench {

/// The corners of a terrain, in rows and columns.
inline constexpr int terrain_side = 33;

/// A bumpy terrain of 2048 triangles around the origin, whose squares have sides of `cell` units.
template <Scalar S>
OwnedMesh<S> build_terrain(int cell) {
  constexpr std::array heights{0, 3, 1, 4, -2, 2, -3, -1, 5, -4, 1};  // in sixteenths of a cell
  const auto corner = [&](int column, int row) {
    const int height = heights[static_cast<std::size_t>(column * 3 + row * 5) % heights.size()];
    const auto along = [&](int i) { return as_number<S>((i - terrain_side / 2) * cell); };
    return Vec<S, 3>{along(column), as_number<S>(height * cell / 16.0), along(row)};
  };
  std::vector<Triangle<S, 3>> triangles;
  for (int row = 0; row + 1 < terrain_side; ++row) {
    for (int column = 0; column + 1 < terrain_side; ++column) {
      const auto left = corner(column, row + 1), right = corner(column + 1, row);
      triangles.push_back({corner(column, row), left, right});
      triangles.push_back({right, left, corner(column + 1, row + 1)});
    }
  }
  return OwnedMesh<S>(triangles);
}

/// The same, built once.
template <Scalar S>
Mesh<S> terrain_mesh(int cell) {
  static std::map<int, OwnedMesh<S>> meshes;
  auto& mesh = meshes[cell];
  if (mesh.view().triangles.empty()) mesh = build_terrain<S>(cell);
  return mesh.view();
}

template <Scalar S, int N>
struct Terrain {
  int cell = 0;
  Mesh<S> mesh{};
};
template <Scalar S, int N>
Terrain<S, N> as(const Terrain<double, N>& terrain) {
  return {terrain.cell, terrain_mesh<S>(terrain.cell)};
}

}  // namespace detent::bench
