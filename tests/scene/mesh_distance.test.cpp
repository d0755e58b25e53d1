// SPDX-License-Identifier: MIT
#include "detent/scene/mesh/distance.hpp"

#include <algorithm>
#include <vector>

#include "detent/scene/height_field.hpp"
#include "detent/scene/mesh.hpp"
#include "oracle/draw_shape.hpp"
#include "query/raycast/helpers.hpp"
#include "scene/mesh_helpers.hpp"

namespace detent::test {
namespace {

template <Scalar S, class Shape>
S least_of(const std::vector<Triangle<S, 3>>& triangles, const Shape& shape) {
  S least = largest<S>;
  for (const auto& triangle : triangles) least = std::min(least, distance(triangle, shape));
  return least;
}

template <class Shape, Scalar S>
void compare(const Mesh<S>& mesh, const std::vector<Triangle<S, 3>>& triangles,
             oracle::Draw<S, 3>& draw, HitRate& rate) {
  const auto setting = oracle::draw_setting(draw, oracle::Kind::general, 150);
  const auto shape = oracle::draw_shape<Shape>(draw, setting);
  const S expected = least_of(triangles, shape);
  rate.count(expected > S(0));
  CHECK(distance(mesh, shape) == expected);
  CHECK(distance(shape, mesh) == expected);
}

TEMPLATE_TEST_CASE("mesh: its distance to a shape is that of its nearest triangle", "[mesh]",
                   q16_16, q8_8) {
  using S = TestType;
  HitRate rate;
  for_meshes<S>(0xd157, 12, [&](auto, const auto& triangles, auto, auto& draw) {
    const auto owned = mesh_of(triangles);
    const auto mesh = owned.view();
    support::SceneShapes<S, 3>::template and_also<Segment<S, 3>>::for_each(
        [&]<class Shape>(const Shape&) { compare<Shape>(mesh, triangles, draw, rate); });
  });
  INFO(rate);
  CHECK(rate.percent() >= 20);
}

TEMPLATE_TEST_CASE("mesh: the distance of two meshes is that of their nearest triangles", "[mesh]",
                   q16_16, q8_8) {
  using S = TestType;
  HitRate rate;
  std::vector<Triangle<S, 3>> others;
  for_meshes<S>(0xd158, 6, [&](auto, const auto& triangles, auto, auto&) {
    const auto ours = mesh_of(triangles), theirs = mesh_of(others);
    S expected = largest<S>;
    for (const auto& triangle : triangles)
      expected = std::min(expected, least_of(others, triangle));
    rate.count(expected > S(0));
    CHECK(distance(ours.view(), theirs.view()) == expected);
    CHECK(distance(theirs.view(), ours.view()) == expected);
    others.assign(triangles.begin(),
                  triangles.begin() + std::min<std::ptrdiff_t>(40, std::ssize(triangles)));
  });
  INFO(rate);
  CHECK(rate.percent() >= 20);
}

TEST_CASE("height field: its distance to a shape or mesh is that of its nearest triangle",
          "[mesh]") {
  using S = q16_16;
  std::vector<S> heights(9 * 9);
  for (std::size_t i = 0; i < heights.size(); ++i) heights[i] = num<S>(double((i * 7) % 5) / 2);
  const auto field = *height_field<S>({num<S>(-4), num<S>(-4)}, num<S>(1), 9, 9, heights);
  std::vector<Triangle<S, 3>> triangles;
  detail::visit_parts_where(
      field, [](const auto&) { return true; },
      [&](std::span<const MeshTriangle<S>> parts) {
        for (const auto& part : parts) triangles.push_back(part.triangle);
        return Walk::go_on;
      });
  REQUIRE(triangles.size() == 128);
  for (int x = -8; x <= 8; ++x) {
    const Capsule<S, 3> capsule{at<S, 3>(x, 5, 1), at<S, 3>(x + 1, 4, x), num<S>(0.75)};
    CHECK(distance(field, capsule) == least_of(triangles, capsule));
    const Triangle leaf{at<S, 3>(x, 3), at<S, 3>(x, 4), at<S, 3>(0, 4, x)};
    CHECK(distance(field, mesh_of<S>({leaf}).view()) == least_of(triangles, leaf));
  }
  CHECK(distance(field, Plane<S, 3>{toward<S, 3>(0, 1), num<S>(-3)}) == num<S>(3));
}

}  // namespace
}  // namespace detent::test
