// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "detent/scene/height_field.hpp"
#include "detent/scene/hull.hpp"
#include "detent/scene/mesh.hpp"
#include "detent/scene/mesh/owned.hpp"
#include "detent/scene/snapshot.hpp"
#include "draw/sheet.hpp"
#include "oracle/space.hpp"
#include "support/catch.hpp"

namespace detent::test {
namespace {

template <Scalar S, int N>
bool is_within(const Aabb<S, N>& inner, const Aabb<S, N>& outer) {
  for (int i = 0; i < N; ++i) {
    if (inner.min[i] < outer.min[i] || inner.max[i] > outer.max[i]) return false;
  }
  return true;
}

/// The boxes of a sheet that contains only boxes, 12 lines each, or 4 in 2D.
template <Scalar S, int N>
std::vector<std::pair<Aabb<S, N>, Colour>> boxes(const Sheet<S, N>& sheet) {
  constexpr std::size_t lines = N == 2 ? 4 : 12;
  std::vector<std::pair<Aabb<S, N>, Colour>> all;
  for (std::size_t i = 0; i < sheet.lines.size(); i += lines) {
    std::vector<Vec<S, N>> points;
    for (std::size_t k = i; k < i + lines; ++k) {
      points.insert(points.end(), {sheet.lines[k].a, sheet.lines[k].b});
    }
    all.push_back({bounding_box<S, N>(points), sheet.lines[i].colour});
  }
  return all;
}

TEMPLATE_TEST_CASE("draw: draws every object of a scene, and leaves the scene unchanged", "[draw]",
                   DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  Scene<S, N, Sphere, Aabb, Plane> scene;
  Sheet<S, N> sheet;
  draw(sheet, scene);
  draw_tree(sheet, scene);
  CHECK(sheet.is_blank());

  constexpr std::size_t circle = N == 2 ? 32 : 96, box = N == 2 ? 4 : 12, plane = N == 2 ? 1 : 18;
  const auto ball = scene.add(Sphere{at<S, N>(1), num<S>(1)});
  scene.add(Sphere{at<S, N>(1), num<S>(-1)});
  scene.add(Aabb{at<S, N>(1), at<S, N>(2, 2, 2)}, {.motion = Motion::fixed});
  scene.add(Plane<S, N>{toward<S, N>(0, 1), num<S>(3)}, {.motion = Motion::fixed});
  const auto before = digest(scene);
  draw(sheet, scene, ColourByMotion{{1, 1, 1}, {2, 2, 2}}, DrawRegion{at<S, N>(5, 9), num<S>(4)});
  REQUIRE(sheet.lines.size() == circle + box + plane);
  for (std::size_t i = 0; i < sheet.lines.size(); ++i) {
    CHECK(sheet.lines[i].colour == (i < circle ? Colour{1, 1, 1} : Colour{2, 2, 2}));
  }
  for (std::size_t i = circle + box; i < sheet.lines.size(); ++i) {
    CHECK((sheet.lines[i].a[1] == num<S>(3) && sheet.lines[i].b[1] == num<S>(3)));
    CHECK(std::abs(static_cast<double>(sheet.lines[i].a[0]) - 5) <= 4);
  }
  Sheet<S, N> kinds;
  draw(kinds, scene, ColourByKind());
  CHECK(kinds.lines.front().colour != kinds.lines[circle].colour);
  CHECK(kinds.lines[circle].colour != kinds.lines.back().colour);
  // The caller's own function.
  Sheet<S, N> one;
  draw(one, scene,
       [&](const ObjectInfo& object, const auto&) { return object.id == ball ? ink : Colour(); });
  CHECK(std::count_if(one.lines.begin(), one.lines.end(),
                      [](const auto& line) { return line.colour == ink; }) == circle);
  CHECK(digest(scene) == before);
}

TEMPLATE_TEST_CASE("draw_tree: each box contains those below, and each object is in a leaf",
                   "[draw]", DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  Random random(1);
  Scene<S, N, Sphere, Aabb, Plane> scene;
  std::vector<Aabb<S, N>> objects;
  for (int i = 0; i < 200; ++i) {
    const Sphere<S, N> ball{any_point<S, N>(random), any_length<S>(random)};
    scene.add(ball, {.motion = random.coin() ? Motion::moving : Motion::fixed});
    objects.push_back(bounding_box(ball));
  }
  Sheet<S, N> sheet;
  draw_tree(sheet, scene);
  const auto all = boxes(sheet);
  CHECK(all.size() > 200 + 25);
  for (const auto& object : objects) {
    CHECK(std::any_of(all.begin(), all.end(),
                      [&](const auto& box) { return is_within(object, box.first); }));
  }
  // Depth first: a box at one level follows the box around it, at the level before.
  std::vector<Aabb<S, N>> path;
  for (const auto& [box, colour] : all) {
    std::size_t level = 0;
    while (palette_colour(level) != colour) ++level;
    REQUIRE(level <= path.size());
    path.resize(level);
    if (level > 0) CHECK(is_within(box, path.back()));
    path.push_back(box);
  }
  // A plane is unbounded: its box is the whole range.
  Scene<S, N, Plane> flat;
  flat.add(Plane<S, N>{toward<S, N>(0, 1), num<S>(3)});
  Sheet<S, N> one;
  draw_tree(one, flat);
  REQUIRE(one.lines.size() == (N == 2 ? 4 : 12));
  if constexpr (is_fixed<S>) {
    CHECK(boxes(one)[0].first == Aabb{filled<S, N>(lowest<S>), filled<S, N>(largest<S>)});
  }
}

TEMPLATE_TEST_CASE("draw: meshes, height fields and hulls, placed or not", "[draw]",
                   DETENT_EVERY_SCALAR) {
  using S = TestType;
  std::vector<Triangle<S, 3>> triangles;
  for (int i = 0; i < 60; ++i) {
    triangles.push_back(
        {at<S, 3>(i % 8, i / 8), at<S, 3>(i % 8 + 1, i / 8), at<S, 3>(i % 8, i / 8 + 1, 1)});
  }
  const OwnedMesh<S> mesh(triangles);
  const auto sheet = drawn<S, 3>(mesh.view());
  CHECK(sheet.lines.size() == 180);
  CHECK(drawn_solid<S>(mesh.view()).faces.size() == 60);
  const MeshAsset<S> asset(1, mesh.view());
  Transform<S, 3> moved;
  moved.translation = at<S, 3>(1, 2, 3);
  const auto placed = drawn<S, 3>(PlacedMesh{&asset, moved});
  REQUIRE(placed.lines.size() == 180);
  for (std::size_t i = 0; i < 180; ++i) {
    CHECK(placed.lines[i].a == nearest_to<S>(sheet.lines[i].a + at<S, 3>(1, 2, 3)));
  }
  CHECK(drawn<S, 3>(PlacedMesh<S>()).is_blank());
  CHECK(drawn<S, 3>(Mesh<S>()).is_blank());

  std::array<S, 12> heights{};
  heights[5] = num<S>(2);
  const auto field = *height_field<S>(at<S, 2>(-1, -1), num<S>(1), 4, 3, heights);
  const auto terrain = drawn<S, 3>(field);
  CHECK(terrain.lines.size() == 36);
  CHECK(drawn_solid<S>(field).faces.size() == 12);
  for (const auto& point : terrain.points()) {
    const bool is_peak = point.x == num<S>(0) && point.z == num<S>(0);
    CHECK(point.y == num<S>(is_peak ? 2 : 0));
  }
  const FieldAsset<S> ground(2, field);
  CHECK(drawn<S, 3>(PlacedField{&ground, at<S, 3>(1, 1, 1)}).lines.size() == 36);

  const std::array corners{at<S, 3>(0), at<S, 3>(1), at<S, 3>(0, 1), at<S, 3>(0, 0, 1)};
  const auto hull = *hull_asset(3, ConvexHull{corners});
  CHECK(drawn<S, 3>(PlacedHull{&hull, moved}).lines.size() == 6);
  CHECK(drawn_solid<S>(PlacedHull{&hull, moved}).faces.size() == 4);
  CHECK(drawn<S, 3>(PlacedHull<S, 3>()).is_blank());

  Scene<S, 3, Sphere, MeshInstance, FieldInstance, HullInstance> scene;
  scene.add(PlacedMesh{&asset, moved});
  scene.add(PlacedField{&ground, at<S, 3>(1, 1, 1)});
  scene.add(PlacedHull{&hull, moved});
  Sheet<S, 3> whole;
  draw(whole, scene);
  CHECK(whole.lines.size() == 180 + 36 + 6);

  // The trees: every triangle is in a box, and every box in the root.
  Sheet<S, 3> tree;
  draw_tree(tree, mesh.view());
  const auto parts = boxes(tree);
  CHECK(parts.size() >= 60 / 4);
  for (const auto& triangle : triangles) {
    CHECK(std::any_of(parts.begin(), parts.end(), [&](const auto& part) {
      return is_within(bounding_box(triangle), part.first);
    }));
  }
  for (const auto& part : parts) CHECK(is_within(part.first, bounding_box(mesh.view())));
  Sheet<S, 3> cells;
  draw_tree(cells, field);
  CHECK(boxes(cells).size() == 2 * 6 - 2);  // a binary tree over six cells, without the root
  Sheet<S, 3> none;
  draw_tree(none, Mesh<S>());
  draw_tree(none, HeightField<S>());
  CHECK(none.is_blank());
}

constexpr int bounded_lines() {
  BoundedScene<Bounded<4>, q16_16, 3, Sphere, Aabb> scene;
  scene.add(Aabb<q16_16, 3>{});
  scene.add(Aabb<q16_16, 3>{});
  Counts<q16_16, 3> counts;
  draw(counts, scene, ColourByKind());
  draw_tree(counts, scene);
  return counts.lines;
}
static_assert(bounded_lines() == 4 * 12);

}  // namespace
}  // namespace detent::test
