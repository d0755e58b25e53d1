// SPDX-License-Identifier: MIT
#include <algorithm>
#include <vector>

#include "detent/query/overlaps/compound.hpp"
#include "detent/scene/mesh.hpp"
#include "oracle/seeds.hpp"
#include "query/raycast/helpers.hpp"
#include "scene/mesh_helpers.hpp"

namespace detent::test {
namespace {

/// Compares a shape with a mesh, in both orders and as a list, against a loop over all triangles.
template <Scalar S, class Shape>
bool overlaps_as_one_by_one(const Mesh<S>& mesh, const std::vector<Triangle<S, 3>>& triangles,
                            const Shape& shape, std::size_t room) {
  std::vector<std::uint32_t> expected;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    if (overlaps(triangles[i], shape)) expected.push_back(static_cast<std::uint32_t>(i));
  }
  std::vector<std::uint32_t> found(room);
  REQUIRE(overlaps(mesh, shape) == !expected.empty());
  REQUIRE(overlaps(shape, mesh) == !expected.empty());
  REQUIRE(overlaps_all(mesh, shape, std::span(found)) == expected.size());
  const auto kept = static_cast<std::ptrdiff_t>(std::min(room, expected.size()));
  REQUIRE(std::equal(found.begin(), found.begin() + kept, expected.begin()));
  return !expected.empty();
}

/// Compares shapes with meshes of a seed against a loop over all triangles.
template <Scalar S>
void compare_shapes(std::uint64_t seed, int rounds, int bits, HitRate& rate) {
  for_meshes<S>(seed, rounds, bits, [&](auto, const auto& triangles, auto reach, auto& draw) {
    const OwnedMesh<S> owned{std::span<const Triangle<S, 3>>(triangles)};
    const auto mesh = owned.view();
    auto& random = draw.random;
    for (int k = 0; k < 8; ++k) {
      const auto target = draw_target(draw, triangles, reach);
      const auto size = [&] { return draw.scalar(random.between(-reach / 64, reach / 3)); };
      const auto center = draw.vec(target);
      const auto other = draw.vec(draw.near(target, reach / 3 + 1));
      const auto room = random.below(triangles.size() + 2);
      const auto ask = [&](const auto& shape) {
        rate.count(overlaps_as_one_by_one(mesh, triangles, shape, room));
      };
      ask(Sphere{center, size()});
      ask(Aabb{center, other});
      ask(Obb{center, Vec{size(), size(), size()}, draw.rotation()});
      ask(Capsule{center, other, size()});
      ask(Triangle{center, other, draw.vec(draw.near(target, reach / 3 + 1))});
      const std::array corners{center, other};
      ask(ConvexHull<S, 3>{corners});
      const Segment segment{center, other};
      REQUIRE(intersects(segment, mesh) ==
              std::any_of(triangles.begin(), triangles.end(),
                          [&](const auto& triangle) { return intersects(segment, triangle); }));
    }
  });
}

TEMPLATE_TEST_CASE("mesh: a shape overlaps it exactly if it overlaps one of its triangles",
                   "[mesh]", q16_16, q8_8) {
  check_balance([](HitRate& rate) { compare_shapes<TestType>(0x0e51a9, 8, 8, rate); });
}

TEMPLATE_TEST_CASE("mesh: many more shapes overlap as loops over many more triangles do",
                   "[mesh][.demand]", q16_16, q8_8) {
  check_balance([](HitRate& rate) {
    for (const auto seed : oracle::demanded_seeds()) compare_shapes<TestType>(seed, 8, 11, rate);
  });
}

TEMPLATE_TEST_CASE("mesh: the nearest triangle to a point is that of a loop over all", "[mesh]",
                   q16_16, q8_8) {
  using S = TestType;
  for_meshes<S>(0xc105e, 8, [&](auto, const auto& triangles, auto reach, auto& draw) {
    const OwnedMesh<S> owned{std::span<const Triangle<S, 3>>(triangles)};
    const auto mesh = owned.view();
    for (int k = 0; k < 8; ++k) {
      const auto point =
          draw.vec(draw.random.one_in(4) ? draw.extreme_point() : draw.point(2 * reach));
      std::size_t best = triangles.size();
      for (std::size_t i = 0; i < triangles.size(); ++i) {
        if (best == triangles.size() ||
            distance(triangles[i], point) < distance(triangles[best], point)) {
          best = i;
        }
      }
      const auto nearest = nearest_triangle(mesh, point);
      REQUIRE(nearest.has_value() == !triangles.empty());
      if (!nearest) {
        REQUIRE(closest_point(mesh, point) == point);
        REQUIRE(distance(mesh, point) == largest<S>);
        continue;
      }
      REQUIRE(nearest->index == best);
      REQUIRE(nearest->distance == distance(triangles[best], point));
      REQUIRE(nearest->point == closest_point(triangles[best], point));
      REQUIRE(closest_point(mesh, point) == nearest->point);
      REQUIRE(distance(mesh, point) == nearest->distance);
    }
  });
}

TEMPLATE_TEST_CASE("mesh: an empty shape overlaps nothing", "[mesh]", q16_16, float) {
  using S = TestType;
  const std::array triangles{Triangle{at<S, 3>(-1), at<S, 3>(1), at<S, 3>(0, 1)}};
  const OwnedMesh<S> owned{std::span<const Triangle<S, 3>>(triangles)};
  CHECK(overlaps(owned.view(), Sphere{Vec<S, 3>(), num<S>(0)}));
  CHECK_FALSE(overlaps(owned.view(), Sphere{Vec<S, 3>(), num<S>(-1)}));
  CHECK_FALSE(overlaps(owned.view(), Aabb{at<S, 3>(1), at<S, 3>(-1)}));
  CHECK_FALSE(overlaps(Mesh<S>(), Sphere{Vec<S, 3>(), num<S>(1)}));
  CHECK(overlaps(owned.view(), Compound{std::array{Sphere{at<S, 3>(1), num<S>(0)}}}));
}

}  // namespace
}  // namespace detent::test
