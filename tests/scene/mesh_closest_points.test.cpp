// SPDX-License-Identifier: MIT
#include "detent/scene/mesh/closest_points.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "detent/scene/height_field.hpp"
#include "detent/scene/mesh.hpp"
#include "oracle/draw_shape.hpp"
#include "query/raycast/helpers.hpp"
#include "scene/mesh_helpers.hpp"

namespace detent::test {
namespace {

template <Scalar S>
using Points = std::pair<Vec<S, 3>, Vec<S, 3>>;

/// The nearest triangle by a plain loop; among equal distances, the first.
template <Scalar S, class Shape>
Points<S> expected_points(const std::vector<Triangle<S, 3>>& triangles, const Shape& shape) {
  const auto nearest = std::min_element(
      triangles.begin(), triangles.end(),
      [&](const auto& a, const auto& b) { return distance(a, shape) < distance(b, shape); });
  if (nearest == triangles.end()) return {};
  return closest_points(*nearest, shape);
}

template <class Shape, Scalar S>
void compare(const Mesh<S>& mesh, const std::vector<Triangle<S, 3>>& triangles,
             oracle::Draw<S, 3>& draw, HitRate& rate) {
  const auto setting = oracle::draw_setting(draw, oracle::Kind::general, 150);
  const auto shape = oracle::draw_shape<Shape>(draw, setting);
  const auto expected = expected_points(triangles, shape);
  rate.count(expected.first != expected.second);
  CHECK(closest_points(mesh, shape) == expected);
  // The same triangle; the canonical point may differ.
  const auto swapped = closest_points(shape, mesh);
  if (expected.first != expected.second) {
    CHECK(swapped == Points<S>{expected.second, expected.first});
  }
}

TEST_CASE("mesh: the closest points are those of the first nearest triangle", "[mesh]") {
  using S = q16_16;
  HitRate rate;
  for_meshes<S>(0xc15d, 6, [&](auto, const auto& triangles, auto, auto& draw) {
    const auto owned = mesh_of(triangles);
    const auto mesh = owned.view();
    compare<Sphere<S, 3>>(mesh, triangles, draw, rate);
    compare<Obb<S, 3>>(mesh, triangles, draw, rate);
    compare<Plane<S, 3>>(mesh, triangles, draw, rate);
    compare<Capsule<S, 3>>(mesh, triangles, draw, rate);
  });
  INFO(rate);
  CHECK(rate.percent() >= 20);
}

TEST_CASE("mesh: closest points of two meshes are those of their first nearest triangles",
          "[mesh]") {
  using S = q16_16;
  std::vector<Triangle<S, 3>> others;
  for_meshes<S>(0xc15e, 3, [&](auto, const auto& triangles, auto, auto&) {
    S least = largest<S>;
    Points<S> expected;
    bool is_first = true;
    for (const auto& ours : triangles) {
      for (const auto& theirs : others) {
        const S apart = distance(ours, theirs);
        if (!is_first && apart >= least) continue;
        is_first = false;
        least = apart;
        expected = closest_points(ours, theirs);
      }
    }
    const auto a = mesh_of(triangles), b = mesh_of(others);
    CHECK(closest_points(a.view(), b.view()) == expected);
    others.assign(triangles.begin(),
                  triangles.begin() + std::min<std::ptrdiff_t>(30, std::ssize(triangles)));
  });
}

TEST_CASE("height field: closest points of a shape", "[mesh]") {
  using S = q16_16;
  std::vector<S> heights(4 * 4, num<S>(1));
  const auto field = *height_field<S>({num<S>(0), num<S>(0)}, num<S>(1), 4, 4, heights);
  const Sphere<S, 3> ball{at<S, 3>(0, 5, 0), num<S>(1)};
  CHECK(closest_points(field, ball) == Points<S>{at<S, 3>(0, 1, 0), at<S, 3>(0, 4, 0)});
  CHECK(closest_points(ball, field) == Points<S>{at<S, 3>(0, 4, 0), at<S, 3>(0, 1, 0)});
  const Sphere<S, 3> nothing{at<S, 3>(0, 5, 0), num<S>(-1)};
  CHECK(closest_points(field, nothing) == Points<S>());
}

}  // namespace
}  // namespace detent::test
