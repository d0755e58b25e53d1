// SPDX-License-Identifier: MIT
#include "detent/scene/mesh/placed.hpp"

#include <optional>
#include <vector>

#include "detent/scene/mesh.hpp"
#include "oracle/seeds.hpp"
#include "query/raycast/helpers.hpp"
#include "scene/mesh_helpers.hpp"
#include "scene/surface_loop.hpp"

namespace detent::test {
namespace {

/// Translates, within the range and beyond; rotates; mirrors, shrinks to a point or enlarges;
/// shears.
template <Scalar S>
Transform<S, 3> draw_transform(oracle::Draw<S, 3>& draw, std::int64_t reach) {
  auto& random = draw.random;
  Transform<S, 3> transform;
  const auto at_an_end = [&] {
    const auto end = random.coin() ? oracle::Draw<S, 3>::limit : -oracle::Draw<S, 3>::limit;
    return (random.coin() ? 0 : end) + random.between(-reach, reach);
  };
  transform.translation =
      draw.vec(random.one_in(3) ? oracle::Raw<3>{at_an_end(), at_an_end(), at_an_end()}
                                : draw.point(random.coin() ? reach : 2));
  if (random.coin()) return transform;
  transform.rotation = random.coin() ? draw.rotation() : draw.skewed();
  if (random.one_in(4)) {
    transform.rotation = Rotation<S, 3>::from_axes(
        {draw.any_direction(), draw.any_direction(), draw.any_direction()});
  }
  if (random.coin()) transform.scale = draw.scalar(random.between(-(2 << S::frac), 2 << S::frac));
  if (random.one_in(8)) transform.scale = random.coin() ? S(0) : draw.scalar(draw.extreme());
  return transform;
}

template <Scalar S>
TriangleLoop<S> placed_one_by_one(const Transform<S, 3>& transform,
                                  const std::vector<Triangle<S, 3>>& triangles) {
  TriangleLoop<S> loop;
  for (const auto& triangle : triangles) loop.triangles.push_back(placed(transform, triangle));
  return loop;
}

/// Compares a ray and shapes near one triangle with the mesh and with the loop. Returns the number
/// of hits.
template <Scalar S>
int same_answers(const PlacedMesh<S>& mesh, const TriangleLoop<S>& loop, MeshKind kind,
                 oracle::Draw<S, 3>& draw, std::int64_t reach) {
  auto& random = draw.random;
  const auto& triangles = loop.triangles;
  int hits = 0;
  const auto count = [&hits](bool hit) { hits += hit ? 1 : 0; };
  const auto ray = draw_mesh_ray(draw, triangles, kind, reach);
  const auto distance_to = raycast(ray, loop);
  count(distance_to.has_value());
  REQUIRE(raycast(ray, mesh) == distance_to);
  REQUIRE(raycast_any(ray, mesh) == distance_to.has_value());
  if (const auto first = raycast_nearest(ray, mesh)) {
    REQUIRE(raycast(ray, triangles[first->index]) == distance_to);
    REQUIRE(raycast_hit(ray, mesh) == raycast_hit(ray, triangles[first->index]));
  }

  const auto target = draw_target(draw, triangles, reach);
  const auto size = [&] { return draw.scalar(random.between(-reach / 64, reach / 3)); };
  const auto center = draw.vec(target);
  const auto other = draw.vec(draw.near(target, reach / 3 + 1));
  const auto ask = [&](const auto& shape) {
    const bool expected = overlaps(loop, shape);
    count(expected);
    REQUIRE(overlaps(mesh, shape) == expected);
    REQUIRE(overlaps(shape, mesh) == expected);
  };
  ask(Sphere{center, size()});
  ask(Aabb{center, other});
  ask(Obb{center, Vec{size(), size(), size()}, draw.rotation()});
  ask(Capsule{center, other, size()});
  ask(Triangle{center, other, draw.vec(draw.near(target, reach / 3 + 1))});
  const auto normal = draw.any_direction();
  ask(Plane<S, 3>{normal, nearest_to<S>(dot(normal, other))});
  const Segment segment{center, other};
  REQUIRE(intersects(segment, mesh) == intersects(segment, loop));
  REQUIRE(contains(mesh, center) == contains(loop, center));
  REQUIRE(distance(mesh, other) == distance(loop, other));
  return hits;
}

/// Compares meshes of a seed under many transforms with loops over their transformed triangles.
template <Scalar S>
void compare_placed(std::uint64_t seed, int rounds, int bits, HitRate& rate, HitRate& pairs) {
  for_meshes<S>(seed, rounds, bits, [&](auto kind, const auto& triangles, auto reach, auto& draw) {
    const OwnedMesh<S> owned{std::span<const Triangle<S, 3>>(triangles)};
    const MeshAsset<S> asset(1, owned.view());
    std::optional<PlacedMesh<S>> last;
    TriangleLoop<S> last_loop;
    for (int k = 0; k < 4; ++k) {
      const auto mesh = last && !draw.random.one_in(4)
                            ? translated(*last, draw.vec(draw.point(reach / 4)))
                            : PlacedMesh{&asset, draw_transform(draw, reach)};
      const auto loop = placed_one_by_one(mesh.transform, triangles);
      REQUIRE(is_empty(bounding_box(mesh)) == triangles.empty());
      for (int i = 0; i < 3; ++i) {
        const int hits = same_answers(mesh, loop, kind, draw, reach);
        for (int j = 0; j < 7; ++j) rate.count(j < hits);
      }
      if (last) {
        const bool expected = overlaps(loop, last_loop);
        pairs.count(expected);
        REQUIRE(overlaps(mesh, *last) == expected);
        REQUIRE(overlaps(owned.view(), mesh) == overlaps(TriangleLoop<S>{triangles}, loop));
      }
      last = mesh;
      last_loop = loop;
    }
  });
}

TEMPLATE_TEST_CASE("placed mesh: results equal those of its transformed triangles", "[mesh]",
                   q16_16, q8_8) {
  HitRate rate, pairs;
  compare_placed<TestType>(0x91ace, 12, 8, rate, pairs);
  INFO(rate << ", " << pairs);
  CHECK(rate.is_balanced());
  CHECK(pairs.is_balanced());
}

TEMPLATE_TEST_CASE("placed mesh: many more results equal those of many more transformed triangles",
                   "[mesh][.demand]", q16_16, q8_8) {
  HitRate rate, pairs;
  for (const auto seed : oracle::demanded_seeds()) {
    compare_placed<TestType>(seed, 12, 9, rate, pairs);
  }
  INFO(rate << ", " << pairs);
  CHECK(rate.is_balanced());
  CHECK(pairs.is_balanced());
}

TEMPLATE_TEST_CASE("placed mesh: translated in range, it gives the results of the original mesh",
                   "[mesh]", q16_16, q8_8) {
  using S = TestType;
  for_meshes<S>(0x30fe, 10, [&](MeshKind kind, const auto& triangles, auto reach, auto& draw) {
    if (kind == MeshKind::extreme) return;
    const OwnedMesh<S> owned{std::span<const Triangle<S, 3>>(triangles)};
    const MeshAsset<S> asset(1, owned.view());
    const auto by = draw.vec(draw.point(reach / 2));
    const auto there = translated(PlacedMesh{&asset}, by);
    for (int k = 0; k < 8; ++k) {
      const auto ray = draw_mesh_ray(draw, triangles, kind, reach);
      const Ray moved{nearest_to<S>(ray.origin + by), ray.direction, ray.max_distance};
      REQUIRE(moved.origin - by == ray.origin - Vec<S, 3>());
      REQUIRE(raycast_nearest(moved, there) == raycast_nearest(ray, owned.view()));
    }
  });
}

TEMPLATE_TEST_CASE("placed mesh: coordinates out of range are clamped", "[mesh]", q16_16, q8_8) {
  using S = TestType;
  const std::array triangles{Triangle{at<S, 3>(3), at<S, 3>(4), at<S, 3>(4, 2)},
                             Triangle{at<S, 3>(1), at<S, 3>(1, 0, 2), at<S, 3>(1, 2)}};
  const OwnedMesh<S> owned{std::span<const Triangle<S, 3>>(triangles)};
  const MeshAsset<S> asset(1, owned.view());
  const auto by = nearest_to<S>(largest<S> - S(2));
  const PlacedMesh mesh{&asset, {.translation = {by, num<S>(0), num<S>(0)}}};
  // The first triangle is out of range: clamping its corners makes it a segment.
  const Vec<S, 3> on_it{largest<S>, num<S>(1), num<S>(0)};
  CHECK(contains(mesh, on_it));
  CHECK(distance(mesh, on_it) == 0);
  CHECK(overlaps(mesh, Sphere{on_it, num<S>(0)}));
  CHECK(overlaps(mesh, Aabb{on_it, on_it}));
  CHECK(intersects(Segment{on_it, on_it}, mesh));
  const Vec<S, 3> before{moved(largest<S>, -1), num<S>(1), num<S>(0)};
  CHECK(raycast(Ray{before, toward<S, 3>(1)}, mesh) == moved(S(0), 1));
  CHECK_FALSE(contains(mesh, before));
  CHECK(raycast_nearest(Ray{{num<S>(0), num<S>(1), num<S>(0)}, toward<S, 3>(1)}, mesh)->index == 1);
  CHECK(bounding_box(mesh).max.x == largest<S>);
}

TEMPLATE_TEST_CASE("placed mesh: without an asset or triangles it is empty", "[mesh]", q16_16,
                   float) {
  using S = TestType;
  const MeshAsset<S> nothing;
  for (const auto& mesh : {PlacedMesh<S>(), PlacedMesh{&nothing}}) {
    CHECK(is_empty(bounding_box(mesh)));
    CHECK_FALSE(raycast(Ray{Vec<S, 3>(), toward<S, 3>(1)}, mesh));
    CHECK_FALSE(overlaps(mesh, Sphere{Vec<S, 3>(), num<S>(9)}));
    CHECK_FALSE(overlaps(mesh, Plane<S, 3>{}));
    CHECK_FALSE(overlaps(mesh, mesh));
    CHECK_FALSE(contains(mesh, Vec<S, 3>()));
    CHECK_FALSE(intersects(Segment{Vec<S, 3>(), Vec<S, 3>()}, mesh));
    CHECK(distance(mesh, Vec<S, 3>()) == largest<S>);
  }
}

TEMPLATE_TEST_CASE("mesh asset: the digest covers triangles and indices, not the tree", "[mesh]",
                   q16_16, q8_8) {
  using S = TestType;
  oracle::Draw<S, 3> draw(5);
  auto triangles = draw_mesh(draw, MeshKind::soup, 60, 1000);
  const OwnedMesh<S> sorted{std::span<const Triangle<S, 3>>(triangles)};
  std::vector<MeshTriangle<S>> parts;
  for (const auto& triangle : triangles) {
    parts.push_back({triangle, static_cast<std::uint32_t>(parts.size())});
  }
  const auto digest_of_list = [&] { return digest(Mesh<S>{{}, parts}); };
  CHECK(MeshAsset<S>(3, sorted.view()).digest() == digest_of_list());
  std::swap(parts[0].index, parts[1].index);
  CHECK(MeshAsset<S>(3, sorted.view()).digest() != digest_of_list());
  std::swap(parts[0].index, parts[1].index);
  parts[7].triangle.b.x =
      S::from_raw(static_cast<typename S::raw_type>(parts[7].triangle.b.x.raw() ^ 1));
  CHECK(MeshAsset<S>(3, sorted.view()).digest() != digest_of_list());
  CHECK(digest(Mesh<S>()) != digest_of_list());
}

}  // namespace
}  // namespace detent::test
