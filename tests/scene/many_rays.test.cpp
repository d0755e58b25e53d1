// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <vector>

#include "detent/query/batch.hpp"
#include "detent/scene/mesh.hpp"
#include "detent/scene/scene.hpp"
#include "scene/mesh_helpers.hpp"

namespace detent::test {
namespace {

/// Rays similar to their predecessors: the same origin, direction or length, or equal; sometimes
/// unrelated.
template <Scalar S>
std::vector<Ray<S, 3>> draw_neighbours(oracle::Draw<S, 3>& draw,
                                       const std::vector<Triangle<S, 3>>& triangles, MeshKind kind,
                                       std::int64_t reach) {
  std::vector<Ray<S, 3>> rays;
  auto ray = draw_mesh_ray(draw, triangles, kind, reach);
  for (int i = 0; i < 50; ++i) {
    const auto other = draw_mesh_ray(draw, triangles, kind, reach);
    if (draw.random.coin()) ray = other;
    if (draw.random.one_in(8)) ray.direction = other.direction;
    if (draw.random.one_in(8)) ray.max_distance = other.max_distance;
    if (draw.random.one_in(2)) ray.max_distance = largest<S>;
    rays.push_back(ray);
  }
  return rays;
}

TEMPLATE_TEST_CASE("many rays: a mesh gives the results of single raycasts", "[mesh]",
                   DETENT_FIXED_SCALARS) {
  using S = TestType;
  HitRate rate;
  for_meshes<S>(0x3a2, 12, [&](auto kind, const auto& triangles, auto reach, auto& draw) {
    const OwnedMesh<S> owned{std::span<const Triangle<S, 3>>(triangles)};
    const auto mesh = owned.view();
    const auto rays = draw_neighbours(draw, triangles, kind, reach);
    // In a frame around the mesh, in one that leaves out a part of it, and in an empty one.
    const auto around = bounding_box(mesh);
    const Vec<S, 3> origin{};
    for (const auto& frame :
         {around, Aabb<S, 3>{origin, around.max}, Aabb<S, 3>{around.max, origin}}) {
      std::vector<typename RayBatch<S, 3>::Block> blocks(batch_blocks(rays.size()));
      const RayBatch<S, 3> batch(rays, frame, blocks);
      std::vector<std::optional<S>> answers(rays.size(), S(1));
      raycast_each(batch, mesh, std::span(answers));
      bool any = false;
      for (std::size_t i = 0; i < rays.size(); ++i) {
        INFO("ray " << i);
        REQUIRE(answers[i] == raycast(rays[i], mesh));
        rate.count(answers[i].has_value());
        any |= answers[i].has_value();
      }
      REQUIRE(raycast_any(batch, mesh) == any);
    }
  });
  INFO(rate.percent());
  CHECK(rate.is_balanced());
}

TEMPLATE_TEST_CASE("many rays: a scene gives the results of single raycasts", "[scene]", q16_16,
                   q8_8, float) {
  using S = TestType;
  Random random(0x5ce3e);
  HitRate rate;
  const auto corner = [&](int limit) {
    std::array<int, 3> numbers{};
    for (auto& x : numbers) x = static_cast<int>(random.between(-limit, limit));
    return numbers;
  };
  const auto vec = [](const std::array<int, 3>& x) { return Vec<S, 3>{S(x[0]), S(x[1]), S(x[2])}; };
  for (int round = 0; round < 6; ++round) {
    Scene<S, 3, Sphere, Aabb> scene;
    for (int i = 0; i < 60; ++i) {
      const Traits traits{.layers = random.coin() ? 1u : 2u,
                          .motion = random.one_in(4) ? Motion::fixed : Motion::moving};
      // Some objects touch or repeat others, so that distances are equal.
      const auto at = vec(corner(random.coin() ? 5 : 30));
      if (random.coin()) {
        scene.add(Sphere<S, 3>{at, S(4)}, traits);
      } else {
        scene.add(bounding_box(Sphere<S, 3>{at, S(5)}), traits);
      }
    }
    std::vector<Ray<S, 3>> rays;
    auto from = corner(40), to = corner(25);
    for (int i = 0; i < 150; ++i) {
      if (random.one_in(4)) from = corner(40);
      if (random.coin()) to = corner(25);
      std::array<int, 3> way{};
      for (std::size_t k = 0; k < 3; ++k) way[k] = to[k] - from[k];
      const auto direction = normalize(vec(way));
      if (!direction) continue;
      rays.push_back(
          {vec(from), *direction, random.one_in(4) ? S(random.coin() ? 5 : 50) : S(100)});
    }
    const std::span<const Ray<S, 3>> all(rays);
    std::array<bool, 150> any{};
    const auto compare = [&](const auto& filter) {
      scene.any_each(all, std::span(any), filter);
      for (std::size_t i = 0; i < rays.size(); ++i) {
        REQUIRE(any[i] == scene.any(rays[i], filter));
        rate.count(any[i]);
      }
    };
    compare(Everything());
    compare(InLayers{2});
    // With less room, only the results that fit are written.
    any.fill(true);
    scene.any_each(all, std::span(any).first(2));
    REQUIRE(std::count(any.begin() + 2, any.end(), true) == 148);
  }
  INFO(rate.percent());
  CHECK(rate.is_balanced());
}

}  // namespace
}  // namespace detent::test
