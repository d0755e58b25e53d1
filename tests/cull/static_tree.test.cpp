// SPDX-License-Identifier: MIT
#include "detent/cull/static_tree/build.hpp"

#include <algorithm>
#include <vector>

#include "detent/number/digest.hpp"
#include "scene/mesh_helpers.hpp"

namespace detent::test {
namespace {

template <Scalar S>
bool holds(const Aabb<S, 3>& outer, const Aabb<S, 3>& inner) {
  for (int i = 0; i < 3; ++i) {
    if (inner.min[i] < outer.min[i] || inner.max[i] > outer.max[i]) return false;
  }
  return true;
}

/// Traverses a tree, checks what queries rely on, and counts how often each item is in a leaf.
template <Scalar S>
struct Inspection {
  const Mesh<S>& mesh;
  std::vector<int> seen = std::vector<int>(mesh.triangles.size());
  std::vector<int> visited = std::vector<int>(mesh.tree.nodes.size());
  int depth = 0;
  bool boxes_hold = true;

  /// Returns the box of all items below a node.
  Aabb<S, 3> look(std::size_t place, int level) {
    auto inside = detail::no_box<Aabb<S, 3>>;
    depth = std::max(depth, level + 1);
    ++visited.at(place);
    const auto& node = mesh.tree.nodes[place];
    REQUIRE(node.children <= node.width);
    for (std::size_t i = 0; i < node.children; ++i) {
      const auto box = node.box(i);
      if (node.count[i] == 0) {
        const auto within = look(node.first[i], level + 1);
        boxes_hold = boxes_hold && holds(box, within);
        inside = bounding_box(inside, within);
        continue;
      }
      REQUIRE(node.count[i] <= StaticTree<S, 3>::leaf_size);
      for (const auto& part : mesh.triangles.subspan(node.first[i], node.count[i])) {
        boxes_hold = boxes_hold && holds(box, bounding_box(part));
        inside = bounding_box(inside, bounding_box(part));
        ++seen.at(part.index);
      }
    }
    return inside;
  }
};

TEMPLATE_TEST_CASE("static tree: every item is in one leaf, inside the boxes above it", "[mesh]",
                   DETENT_FIXED_SCALARS) {
  using S = TestType;
  for_meshes<S>(0x7ee, 40, [&](MeshKind, const auto& triangles, auto, auto&) {
    const OwnedMesh<S> owned{std::span<const Triangle<S, 3>>(triangles)};
    const auto mesh = owned.view();
    REQUIRE(mesh.tree.nodes.size() <= tree_capacity(triangles.size()));
    REQUIRE(mesh.tree.nodes.empty() == triangles.empty());
    if (triangles.empty()) return;
    Inspection<S> inspection{mesh};
    CHECK(inspection.look(0, 0) == mesh.tree.bounds);
    CHECK(inspection.boxes_hold);
    CHECK(inspection.depth <= static_tree_depth);
    CHECK(
        std::all_of(inspection.seen.begin(), inspection.seen.end(), [](int n) { return n == 1; }));
    CHECK(std::all_of(inspection.visited.begin(), inspection.visited.end(),
                      [](int n) { return n == 1; }));
    for (const auto& part : mesh.triangles) REQUIRE(part.triangle == triangles[part.index]);
  });
}

/// A triangle that is not measured with vectors.
template <Scalar S>
struct PlainTriangle {
  MeshTriangle<S> part;
};
template <Scalar S>
Aabb<S, 3> bounding_box(const PlainTriangle<S>& plain) {
  return detent::bounding_box(plain.part);
}

TEMPLATE_TEST_CASE("static tree: vectors make the same tree as numbers one by one", "[mesh]",
                   DETENT_FIXED_SCALARS) {
  using S = TestType;
  const auto compare = [](std::span<const Triangle<S, 3>> triangles) {
    const OwnedMesh<S> owned{triangles};
    std::vector<PlainTriangle<S>> plain;
    for (std::uint32_t i = 0; i < triangles.size(); ++i) plain.push_back({{triangles[i], i}});
    std::vector<MeshNode<S>> nodes(tree_capacity(plain.size()));
    const auto tree = build_tree<S, 3, PlainTriangle<S>>(std::span(plain), nodes);
    REQUIRE(tree);
    const auto mesh = owned.view();
    CHECK(std::equal(tree->nodes.begin(), tree->nodes.end(), mesh.tree.nodes.begin(),
                     mesh.tree.nodes.end()));
    CHECK(std::equal(plain.begin(), plain.end(), mesh.triangles.begin(), mesh.triangles.end(),
                     [](const auto& a, const auto& b) { return a.part == b; }));
  };
  for_meshes<S>(0x51a7e, 20,
                [&](MeshKind, const auto& triangles, auto, auto&) { compare(triangles); });
  // Long lists, in order, in reverse and shuffled.
  Random random(0x10f6);
  std::vector<Triangle<S, 3>> triangles;
  for (int i = 0; i < 3'000; ++i) {
    const auto number = [&] {
      return S::from_raw(static_cast<typename S::raw_type>(random.wide(S::bits)));
    };
    const auto point = [&] {
      const auto x = number(), y = number();
      return Vec<S, 3>{x, y, number()};
    };
    const auto a = point(), b = point();
    triangles.push_back({a, b, point()});
  }
  compare(triangles);
  std::sort(triangles.begin(), triangles.end(),
            [](const auto& a, const auto& b) { return a.a.x < b.a.x; });
  compare(triangles);
  std::reverse(triangles.begin(), triangles.end());
  compare(triangles);
}

TEST_CASE("static tree: uneven splits stop before the tree is too deep", "[mesh]") {
  // Sizes and positions double, so that the cheapest plane always splits off the largest few.
  std::vector<Triangle<q16_16, 3>> triangles;
  for (int bit = 0; bit < 31; ++bit) {
    for (int copy = 0; copy < 400; ++copy) {
      const auto x = q16_16::from_raw((1 << bit) + copy % (1 << std::min(bit, 4)));
      triangles.push_back({{x, q16_16(0), q16_16(0)}, {x, x, q16_16(0)}, {x, q16_16(0), x}});
    }
  }
  const OwnedMesh<q16_16> owned{std::span<const Triangle<q16_16, 3>>(triangles)};
  const auto mesh = owned.view();
  Inspection<q16_16> inspection{mesh};
  inspection.look(0, 0);
  CHECK(inspection.depth <= static_tree_depth);
  CHECK(inspection.boxes_hold);
}

TEST_CASE("static tree: with too little room for nodes it builds nothing and changes nothing",
          "[mesh]") {
  std::array<MeshTriangle<q16_16>, 8> triangles;
  for (std::uint32_t i = 0; i < 8; ++i) {
    const auto x = q16_16(7 - static_cast<int>(i));
    triangles[i] = {{{x, x, x}, {x, x, x}, {x, x, x}}, i};
  }
  const auto before = triangles;
  std::array<MeshNode<q16_16>, tree_capacity(8)> nodes;
  CHECK_FALSE(build_mesh<q16_16>(triangles, std::span(nodes).first(nodes.size() - 1)));
  CHECK(triangles == before);
  CHECK(build_mesh<q16_16>(triangles, nodes));
}

template <Scalar S>
inline constexpr std::uint64_t golden_nodes = 0x3e46b231b5e20489;  // q16_16 and q24_8: same bits
template <>
[[maybe_unused]] inline constexpr std::uint64_t golden_nodes<q14_16> = 0x248b652e01ee335c;
template <>
[[maybe_unused]] inline constexpr std::uint64_t golden_nodes<q8_8> = 0x06826d792ebcd1c3;

TEMPLATE_TEST_CASE("static tree: the same triangles give the same nodes on every machine", "[mesh]",
                   DETENT_FIXED_SCALARS) {
  using S = TestType;
  Digest digest;
  for_meshes<S>(0xd16e57, 4, [&](MeshKind, const auto& triangles, auto, auto&) {
    const OwnedMesh<S> owned{std::span<const Triangle<S, 3>>(triangles)};
    for (const auto& node : owned.view().tree.nodes) digest.add(node);
    for (const auto& part : owned.view().triangles) digest.add(part);
  });
  INFO(std::hex << digest.value());
  CHECK(digest.value() == golden_nodes<S>);
}

TEST_CASE("static tree: can be built at compile time", "[mesh]") {
  constexpr auto built = [] {
    std::array<MeshTriangle<q16_16>, 6> triangles;
    for (std::uint32_t i = 0; i < 6; ++i) {
      const auto x = q16_16(static_cast<int>(i));
      triangles[i] = {{{x, x, x}, {x, q16_16(0), x}, {q16_16(0), x, x}}, i};
    }
    std::array<MeshNode<q16_16>, tree_capacity(6)> nodes;
    const auto mesh = build_mesh<q16_16>(triangles, nodes);
    return mesh->tree.nodes.size();
  }();
  STATIC_REQUIRE(built == 1);
}

}  // namespace
}  // namespace detent::test
