// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdlib>
#include <optional>
#include <vector>

#include "detent/scene/height_field.hpp"
#include "detent/scene/mesh.hpp"
#include "detent/scene/mesh/cast.hpp"
#include "query/raycast/helpers.hpp"
#include "scene/mesh_helpers.hpp"

namespace detent::test {
/// The first triangle that a shape touches, by a loop over all triangles.
template <Scalar S, class Shape>
std::optional<MeshHit<S>> first_of(const Cast<Shape>& moving,
                                   const std::vector<Triangle<S, 3>>& triangles) {
  std::optional<MeshHit<S>> first;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const auto distance =
        detail::cast_distance(moving.shape, moving.direction, moving.max_distance, triangles[i]);
    if (!distance) continue;
    const MeshHit<S> hit{*distance, static_cast<std::uint32_t>(i)};
    if (!first || hit < *first) first = hit;
  }
  return first;
}

template <Scalar S, class Shape, class Surface>
void compare(const Cast<Shape>& moving, const Surface& surface,
             const std::vector<Triangle<S, 3>>& triangles, HitRate& rate) {
  const auto expected = first_of(moving, triangles);
  rate.count(expected.has_value());
  const auto& [shape, direction, length] = moving;
  REQUIRE(cast_nearest(shape, direction, length, surface) == expected);
  REQUIRE(detail::cast_distance(shape, direction, length, surface) ==
          (expected ? std::optional(expected->distance) : std::nullopt));
  const auto hit = cast(shape, direction, length, surface);
  REQUIRE(hit.has_value() == expected.has_value());
  if (expected) REQUIRE(hit == cast(shape, direction, length, triangles[expected->index]));
}

/// Casts a shape of each kind at a surface: towards one of its triangles, in a random direction, or
/// as far as the first touch and one step farther.
template <bool is_round, Scalar S, class Surface>
void compare_shapes(const Surface& surface, const std::vector<Triangle<S, 3>>& triangles,
                    MeshKind kind, std::int64_t reach, oracle::Draw<S, 3>& draw, HitRate& rate) {
  auto& random = draw.random;
  const auto ask = [&](const auto& shape, const Ray<S, 3>& ray) {
    Cast moving{shape, ray.direction, random.coin() ? largest<S> : ray.max_distance};
    compare(moving, surface, triangles, rate);
    if (const auto first = first_of(moving, triangles)) {
      moving.max_distance = first->distance;
      compare(moving, surface, triangles, rate);
      moving.max_distance = next_up(moving.max_distance);
      compare(moving, surface, triangles, rate);
    }
  };
  const auto ray = draw_mesh_ray(draw, triangles, kind, reach);
  const auto size = [&] {
    return draw.scalar(kind == MeshKind::extreme ? std::abs(draw.extreme())
                                                 : random.between(-reach / 64, reach / 4));
  };
  const auto& at = ray.origin;
  const oracle::Raw<3> raw{at.x.raw(), at.y.raw(), at.z.raw()};
  const auto beside = [&] { return draw.vec(draw.near(raw, reach / 4 + 1)); };
  const auto other = beside();
  const Vec extents{size(), size(), size()};
  if constexpr (is_round) {
    ask(Sphere{at, size()}, ray);
    ask(Capsule{at, other, size()}, ray);
  } else {
    ask(bounding_box(Segment{at, other}), ray);
    ask(Obb{at, extents, draw.rotation()}, ray);
    ask(Triangle{at, other, beside()}, ray);
    const std::array points{at, other, beside(), beside()};
    ask(ConvexHull<S, 3>{points}, ray);
  }
}

/// Compares casts at meshes and at placed meshes of a seed.
template <bool is_round, Scalar S>
void compare_casts_at_meshes(std::uint64_t seed, int rounds) {
  HitRate rate;
  for_meshes<S>(seed, rounds, 7, [&](MeshKind kind, const auto& triangles, auto reach, auto& draw) {
    const OwnedMesh<S> owned{std::span<const Triangle<S, 3>>(triangles)};
    compare_shapes<is_round>(owned.view(), triangles, kind, reach, draw, rate);
    const MeshAsset<S> asset(1, owned.view());
    PlacedMesh<S> placed_mesh{&asset};
    placed_mesh.transform.translation = draw.vec(draw.point(reach));
    if (draw.random.coin()) placed_mesh.transform.rotation = draw.rotation();
    auto there = triangles;
    for (auto& triangle : there) triangle = placed(placed_mesh.transform, triangle);
    compare_shapes<is_round>(placed_mesh, there, kind, reach, draw, rate);
  });
  INFO(rate);
  CHECK(rate.percent() >= 30);
  CHECK(rate.percent() < 90);
}

}  // namespace detent::test
