// SPDX-License-Identifier: MIT
#include "detent/scene/mesh/pairs.hpp"

#include <algorithm>
#include <vector>

#include "detent/scene/height_field.hpp"
#include "detent/scene/mesh.hpp"
#include "detent/shape/moved.hpp"
#include "oracle/seeds.hpp"
#include "query/raycast/helpers.hpp"
#include "scene/mesh_helpers.hpp"

namespace detent::test {
namespace {

template <Scalar S>
bool any_pair(const std::vector<Triangle<S, 3>>& a, const std::vector<Triangle<S, 3>>& b) {
  return std::any_of(a.begin(), a.end(), [&](const auto& ours) {
    return std::any_of(b.begin(), b.end(),
                       [&](const auto& theirs) { return overlaps(ours, theirs); });
  });
}

/// Compares meshes of a seed with others against a loop over all pairs of triangles.
template <Scalar S>
void compare_pairs(std::uint64_t seed, int rounds, int bits, HitRate& rate) {
  for_meshes<S>(seed, rounds, bits, [&](auto kind, const auto& triangles, auto reach, auto& draw) {
    auto& random = draw.random;
    const auto ours = mesh_of(triangles);
    for (int k = 0; k < 3; ++k) {
      const auto other_kind = random.coin() ? kind : mesh_kinds[random.below(mesh_kinds.size())];
      const auto other_reach = std::max<std::int64_t>(reach >> random.below(6), 2);
      auto others = draw_mesh(draw, other_kind, random.below(80), other_reach);
      const auto by = draw.vec(draw.point(random.coin() ? reach : other_reach));
      if (random.coin()) {
        for (auto& triangle : others) triangle = translated(triangle, by);
      }
      const bool expected = any_pair(triangles, others);
      const auto theirs = mesh_of(others);
      rate.count(expected);
      REQUIRE(overlaps(ours.view(), theirs.view()) == expected);
      REQUIRE(overlaps(theirs.view(), ours.view()) == expected);
    }
    REQUIRE(overlaps(ours.view(), ours.view()) == !triangles.empty());
  });
}

TEMPLATE_TEST_CASE("mesh: two meshes overlap exactly if two of their triangles do", "[mesh]",
                   q16_16, q8_8) {
  check_balance([](HitRate& rate) { compare_pairs<TestType>(0x9a125, 60, 8, rate); });
}

TEMPLATE_TEST_CASE("mesh: many more pairs overlap as loops over many more triangles do",
                   "[mesh][.demand]", q16_16, q8_8) {
  check_balance([](HitRate& rate) {
    for (const auto seed : oracle::demanded_seeds()) compare_pairs<TestType>(seed, 60, 11, rate);
  });
}

TEMPLATE_TEST_CASE("mesh: a plane overlaps it exactly if it overlaps one of its triangles",
                   "[mesh]", q16_16, q8_8) {
  using S = TestType;
  HitRate rate;
  for_meshes<S>(0x97a9e, 15, [&](auto, const auto& triangles, auto reach, auto& draw) {
    const auto owned = mesh_of(triangles);
    for (int k = 0; k < 8; ++k) {
      const auto normal = draw.random.coin() ? draw.axis_direction() : draw.any_direction();
      const auto target =
          draw.random.coin() ? draw_target(draw, triangles, reach) : draw.point(3 * reach);
      const Plane<S, 3> plane{normal, nearest_to<S>(dot(normal, draw.vec(target)))};
      const bool expected =
          std::any_of(triangles.begin(), triangles.end(),
                      [&](const auto& triangle) { return overlaps(plane, triangle); });
      rate.count(expected);
      REQUIRE(overlaps(owned.view(), plane) == expected);
      REQUIRE(overlaps(plane, owned.view()) == expected);
    }
  });
  INFO(rate);
  CHECK(rate.is_balanced());
}

TEMPLATE_TEST_CASE("mesh: contains the points of its triangles", "[mesh]", q16_16, q8_8) {
  using S = TestType;
  HitRate rate;
  for_meshes<S>(0xc02a1, 15, [&](auto, const auto& triangles, auto reach, auto& draw) {
    if (triangles.empty()) return;
    const auto owned = mesh_of(triangles);
    for (int k = 0; k < 8; ++k) {
      const auto& some = triangles[draw.random.below(triangles.size())];
      const auto point =
          draw.random.one_in(4) ? some.b : draw.vec(draw_target(draw, triangles, reach));
      const bool expected =
          std::any_of(triangles.begin(), triangles.end(),
                      [&](const auto& triangle) { return contains(triangle, point); });
      rate.count(expected);
      REQUIRE(contains(owned.view(), point) == expected);
    }
  });
  INFO(rate);
  CHECK(rate.is_balanced());
}

TEMPLATE_TEST_CASE("mesh: pairs that touch, are coplanar, collapsed or empty", "[mesh]", q16_16,
                   q8_8, float, double) {
  using S = TestType;
  const auto one = [](const Vec<S, 3>& a, const Vec<S, 3>& b, const Vec<S, 3>& c) {
    return mesh_of<S>({Triangle{a, b, c}});
  };
  const auto floor = one(at<S, 3>(0, 0, 0), at<S, 3>(4, 0, 0), at<S, 3>(0, 4, 0));
  const auto ask = [&](const OwnedMesh<S>& other) { return overlaps(floor.view(), other.view()); };
  CHECK(ask(one(at<S, 3>(1, 1, 0), at<S, 3>(1, 1, 5), at<S, 3>(2, 1, 5))));  // a corner
  CHECK(ask(one(at<S, 3>(2, 2, 0), at<S, 3>(4, 4, 0), at<S, 3>(4, 2, 0))));  // in one plane
  CHECK_FALSE(ask(one(at<S, 3>(3, 2, 0), at<S, 3>(4, 4, 0), at<S, 3>(4, 2, 0))));
  CHECK(ask(one(at<S, 3>(1, 1, -1), at<S, 3>(1, 1, -1), at<S, 3>(1, 1, 1))));      // a segment
  CHECK(ask(one(at<S, 3>(2, 2, 0), at<S, 3>(2, 2, 0), at<S, 3>(2, 2, 0))));        // a point
  CHECK_FALSE(ask(one(at<S, 3>(1, 1, 1), at<S, 3>(2, 1, 1), at<S, 3>(1, 2, 1))));  // above
  CHECK_FALSE(ask(OwnedMesh<S>()));
  CHECK_FALSE(overlaps(Mesh<S>(), Mesh<S>()));
  CHECK_FALSE(overlaps(Mesh<S>(), HeightField<S>()));
  CHECK_FALSE(overlaps(HeightField<S>(), HeightField<S>()));

  const Plane<S, 3> ground{toward<S, 3>(0, 0, 1), num<S>(0)};
  CHECK(overlaps(ground, floor.view()));
  CHECK_FALSE(overlaps(Mesh<S>(), ground));
  CHECK_FALSE(overlaps(HeightField<S>(), ground));
  const auto both_sides =
      mesh_of<S>({{at<S, 3>(0, 0, 1), at<S, 3>(4, 0, 1), at<S, 3>(0, 4, 1)},
                  {at<S, 3>(0, 0, -1), at<S, 3>(4, 0, -1), at<S, 3>(0, 4, -1)}});
  CHECK_FALSE(overlaps(both_sides.view(), ground));
  CHECK_FALSE(contains(Mesh<S>(), Vec<S, 3>()));
  CHECK(contains(floor.view(), at<S, 3>(2, 2, 0)));
  CHECK_FALSE(contains(floor.view(), at<S, 3>(3, 2, 0)));
}

}  // namespace
}  // namespace detent::test
