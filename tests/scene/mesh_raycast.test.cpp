// SPDX-License-Identifier: MIT
#include "detent/scene/mesh/raycast.hpp"

#include <algorithm>
#include <vector>

#include "oracle/seeds.hpp"
#include "query/raycast/helpers.hpp"
#include "scene/mesh_helpers.hpp"

namespace detent::test {
namespace {

/// All hits of a ray by a loop over all triangles, sorted.
template <Scalar S>
std::vector<MeshHit<S>> hits_one_by_one(const Ray<S, 3>& ray,
                                        const std::vector<Triangle<S, 3>>& triangles) {
  std::vector<MeshHit<S>> hits;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    if (const auto distance = raycast(ray, triangles[i])) {
      hits.push_back({*distance, static_cast<std::uint32_t>(i)});
    }
  }
  std::sort(hits.begin(), hits.end());
  return hits;
}

/// Compares rays against meshes of a seed with a loop over all triangles.
template <Scalar S>
void compare_rays(std::uint64_t seed, int rounds, int bits, HitRate& rate) {
  for_meshes<S>(seed, rounds, bits, [&](auto kind, const auto& triangles, auto reach, auto& draw) {
    const OwnedMesh<S> owned{std::span<const Triangle<S, 3>>(triangles)};
    const auto mesh = owned.view();
    for (int k = 0; k < 25; ++k) {
      const auto ray = draw_mesh_ray(draw, triangles, kind, reach);
      const auto expected = hits_one_by_one(ray, triangles);
      rate.count(!expected.empty());
      REQUIRE(raycast_any(ray, mesh) == !expected.empty());
      const auto nearest = raycast_nearest(ray, mesh);
      REQUIRE(nearest.has_value() == !expected.empty());
      const auto hit = raycast_hit(ray, mesh);
      REQUIRE(hit.has_value() == nearest.has_value());
      if (nearest) {
        REQUIRE(*nearest == expected.front());
        REQUIRE(*hit == *raycast_hit(ray, triangles[nearest->index]));
        REQUIRE(raycast(ray, mesh) == nearest->distance);
      }
      std::vector<MeshHit<S>> found(draw.random.below(expected.size() + 3));
      REQUIRE(raycast_all(ray, mesh, std::span(found)) == expected.size());
      const auto kept = static_cast<std::ptrdiff_t>(std::min(found.size(), expected.size()));
      REQUIRE(std::equal(found.begin(), found.begin() + kept, expected.begin()));
    }
  });
}

TEMPLATE_TEST_CASE("mesh: rays hit what a loop over all triangles finds", "[mesh]",
                   DETENT_FIXED_SCALARS) {
  HitRate rate;
  compare_rays<TestType>(0x3e5, 20, 8, rate);
  CHECK(rate.is_balanced());
}

TEMPLATE_TEST_CASE("mesh: many more rays hit what loops over many more triangles find",
                   "[mesh][.demand]", DETENT_FIXED_SCALARS) {
  HitRate rate;
  for (const auto seed : oracle::demanded_seeds()) {
    compare_rays<TestType>(seed, 20, 11, rate);
  }
  CHECK(rate.is_balanced());
}

TEMPLATE_TEST_CASE("mesh: an empty mesh is never hit", "[mesh]", q16_16, q8_8, float, double) {
  using S = TestType;
  const Mesh<S> nothing;
  const Ray ray{Vec<S, 3>(), toward<S, 3>(1)};
  CHECK_FALSE(raycast(ray, nothing));
  CHECK_FALSE(raycast_any(ray, nothing));
  CHECK(raycast_all(ray, nothing, std::span<MeshHit<S>>()) == 0);
  CHECK(is_empty(bounding_box(nothing)));
}

TEMPLATE_TEST_CASE("mesh: the nearest triangle is hit, whatever their order", "[mesh]", q16_16,
                   q8_8, float, double) {
  using S = TestType;
  const auto layer = [](double z) {
    return Triangle{at<S, 3>(-1, -1, z), at<S, 3>(1, -1, z), at<S, 3>(0, 1, z)};
  };
  const std::array triangles{layer(10), layer(5), layer(5), layer(20)};
  const OwnedMesh<S> owned{std::span<const Triangle<S, 3>>(triangles)};
  const Ray ray{Vec<S, 3>(), toward<S, 3>(0, 0, 1)};
  CHECK(raycast_nearest(ray, owned.view()) == MeshHit<S>{num<S>(5), 1});
  std::array<MeshHit<S>, 3> hits;
  CHECK(raycast_all(ray, owned.view(), std::span<MeshHit<S>>(hits)) == 4);
  CHECK(hits ==
        std::array{MeshHit<S>{num<S>(5), 1}, MeshHit<S>{num<S>(5), 2}, MeshHit<S>{num<S>(10), 0}});
}

}  // namespace
}  // namespace detent::test
