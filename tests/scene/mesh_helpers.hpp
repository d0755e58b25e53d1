// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "detent/scene/mesh/owned.hpp"
#include "oracle/draw.hpp"
#include "oracle/space.hpp"
#include "support/catch.hpp"

namespace detent::test {

/// Kinds of meshes.
enum class MeshKind { soup, sheet, lattice, duplicates, collapsed, extreme };
inline constexpr std::array mesh_kinds{MeshKind::soup,      MeshKind::sheet,
                                       MeshKind::lattice,   MeshKind::duplicates,
                                       MeshKind::collapsed, MeshKind::extreme};

template <Scalar S>
OwnedMesh<S> mesh_of(const std::vector<Triangle<S, 3>>& triangles) {
  return OwnedMesh<S>{std::span<const Triangle<S, 3>>(triangles)};
}

/// A mesh of a kind, within `reach` raw units except for extreme ones.
template <Scalar S>
std::vector<Triangle<S, 3>> draw_mesh(oracle::Draw<S, 3>& draw, MeshKind kind, std::size_t count,
                                      std::int64_t reach) {
  auto& random = draw.random;
  const auto point = [&] { return draw.point(reach); };
  const auto vec = [&](const auto& raw) { return draw.vec(raw); };
  std::vector<Triangle<S, 3>> triangles(count);
  const std::int64_t step = std::max<std::int64_t>(reach / 4, 1);
  for (std::size_t i = 0; i < count; ++i) {
    const auto a = point();
    const std::int64_t size = std::max<std::int64_t>(reach / 4, 2);
    switch (kind) {
      case MeshKind::soup:
        triangles[i] = {vec(a), vec(draw.near(a, size)), vec(draw.near(a, size))};
        break;
      case MeshKind::sheet: {  // cells of a grid with shared edges, in a slanted plane
        const auto column = static_cast<std::int64_t>(i / 2 % 8) - 4;
        const auto row = static_cast<std::int64_t>(i / 16) - 4;
        const auto corner = [&](std::int64_t x, std::int64_t y) {
          return vec(oracle::Raw<3>{x * step, y * step, (x - y) * step / 4});
        };
        const auto low = corner(column, row), high = corner(column + 1, row + 1);
        triangles[i] = i % 2 == 0 ? Triangle{low, corner(column + 1, row), high}
                                  : Triangle{low, high, corner(column, row + 1)};
        break;
      }
      case MeshKind::lattice: {  // few distinct corners: shared, coplanar and crossing
        const auto corner = [&] {
          return vec(oracle::Raw<3>{random.between(-2, 2) * step, random.between(-2, 2) * step,
                                    random.between(-1, 1) * step});
        };
        triangles[i] = {corner(), corner(), corner()};
        break;
      }
      case MeshKind::duplicates:
        triangles[i] = i < 3 ? Triangle{vec(a), vec(point()), vec(point())} : triangles[i % 3];
        break;
      case MeshKind::collapsed: {
        const auto b = draw.near(a, size);
        triangles[i] = {vec(a), vec(random.coin() ? a : b), vec(b)};
        break;
      }
      default:
        triangles[i] = {vec(draw.extreme_point()), vec(draw.extreme_point()),
                        vec(draw.extreme_point())};
    }
  }
  return triangles;
}

/// A point near a corner, an edge or the inside of one of the mesh's triangles.
template <Scalar S>
oracle::Raw<3> draw_target(oracle::Draw<S, 3>& draw, const std::vector<Triangle<S, 3>>& mesh,
                           std::int64_t reach) {
  if (mesh.empty() || draw.random.one_in(4)) return draw.point(reach);
  const auto& triangle = mesh[draw.random.below(mesh.size())];
  const auto weight_b = draw.random.between(0, 4);
  const auto weight_c = draw.random.between(0, 4 - weight_b);
  oracle::Raw<3> target{};
  for (int i = 0; i < 3; ++i) {
    const std::int64_t a = triangle.a[i].raw(), b = triangle.b[i].raw(), c = triangle.c[i].raw();
    target[static_cast<std::size_t>(i)] =
        ((4 - weight_b - weight_c) * a + weight_b * b + weight_c * c) / 4;
  }
  return draw.random.coin() ? target : draw.near(target, std::max<std::int64_t>(reach / 16, 1));
}

template <Scalar S>
Ray<S, 3> draw_mesh_ray(oracle::Draw<S, 3>& draw, const std::vector<Triangle<S, 3>>& mesh,
                        MeshKind kind, std::int64_t reach) {
  const auto target = draw_target(draw, mesh, reach);
  const auto length = draw.reach(2 * reach);
  if (draw.random.one_in(4)) {
    const auto direction = draw.random.coin() ? draw.axis_direction() : draw.any_direction();
    const auto back = draw.random.between(0, 2 * reach);
    return {draw.vec(draw.moved(target, direction, -back)), direction, length};
  }
  const auto origin = kind == MeshKind::extreme ? draw.extreme_point() : draw.point(2 * reach);
  const auto start = draw.vec(origin);
  const oracle::Raw<3> raw{start.x.raw(), start.y.raw(), start.z.raw()};
  return {start, draw.towards(raw, target), length};
}

/// Calls body(kind, triangles, reach, draw) with meshes of every kind, in many sizes below
/// 2^size_bits.
template <Scalar S, class Body>
void for_meshes(std::uint64_t seed, int rounds, int size_bits, const Body& body) {
  oracle::Draw<S, 3> draw(seed);
  for (int i = 0; i < rounds; ++i) {
    for (const auto kind : mesh_kinds) {
      const auto reach = draw.scale() / 4 + 2;
      const std::size_t count =
          draw.random.one_in(8)
              ? draw.random.below(9)
              : draw.random.below(std::uint64_t{1} << draw.random.between(2, size_bits));
      INFO("kind " << static_cast<int>(kind) << ", seed " << draw.random.seed());
      body(kind, draw_mesh(draw, kind, count, reach), reach, draw);
    }
  }
}
template <Scalar S, class Body>
void for_meshes(std::uint64_t seed, int rounds, const Body& body) {
  for_meshes<S>(seed, rounds, 8, body);
}

/// Calls `compare(rate)`, and requires that between 30 and 70 percent of what it counts are hits.
template <class Compare>
void check_balance(const Compare& compare) {
  HitRate rate;
  compare(rate);
  INFO(rate);
  CHECK(rate.is_balanced());
}

}  // namespace detent::test
