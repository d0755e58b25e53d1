// SPDX-License-Identifier: MIT
#include "diff.hpp"

#include "detent/scene/height_field.hpp"
#include "detent/scene/hull.hpp"
#include "detent/scene/mesh/instance.hpp"
#include "detent/scene/snapshot.hpp"
#include "error.hpp"
#include "scene/any_scene.hpp"
#include "support/catch.hpp"
#include "support/seal.hpp"
#include "support/shapes.hpp"

using namespace detent;
using S = q16_16;
using Vec3 = Vec<S, 3>;
using Toys = Scene<S, 3, Sphere, Obb>;

namespace {

Vec3 at(int x, int y, int z) { return {S(x), S(y), S(z)}; }

Toys toys() {
  Toys scene;
  scene.add(Sphere{at(0, 0, 0), S(1)});
  const auto frame = *scene.add_frame({});
  scene.add(Obb<S, 3>{at(5, 0, 0), at(1, 1, 1), {}}, {.frame = frame});
  scene.add(Sphere{at(9, 9, 9), S(2)}, {.motion = Motion::fixed});
  return scene;
}

template <class Scene>
std::string bytes_of(const Scene& scene) {
  const auto bytes = snapshot(scene);
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

cli::SnapshotDifference compare(const std::string& a, const std::string& b) {
  return cli::compare_snapshots("a.snap", a, "b.snap", b);
}

std::string refusal(const std::string& a, const std::string& b) {
  try {
    (void)compare(a, b);
  } catch (const cli::InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("diff: equal snapshots have no difference") {
  const auto result = compare(bytes_of(toys()), bytes_of(toys()));
  CHECK(result.is_none);
  CHECK(result.text.empty());
}

TEST_CASE("diff: names fields in decimal and raw, and objects that only one side has") {
  Toys scene = toys();
  scene.replace({0, 1}, Sphere<S, 3>{{S(0), S::from_raw(1), S(0)}, S(1)});
  scene.set_user({0, 1}, 5);
  scene.move_frame({0, 2}, {.translation = at(0, 0, -3)});
  CHECK(compare(bytes_of(toys()), bytes_of(scene)).text ==
        "frame 0:2 translation.z: 0 (raw 0) | -3 (raw -196608)\n"
        "object 0:1 (sphere) user: 0x0000000000000000 | 0x0000000000000005\n"
        "object 0:1 (sphere) center.y: 0 (raw 0) | 0.0000152587890625 (raw 1)\n");
  scene = toys();
  scene.remove({1, 3});
  scene.add(Sphere{at(1, 1, 1), S(1)});
  scene.replace({0, 1}, Obb<S, 3>{at(0, 0, 0), at(1, 1, 1), {}});
  scene.move({2, 4}, at(1, 0, 0));
  const auto text = compare(bytes_of(toys()), bytes_of(scene)).text;
  CHECK(text.starts_with("digest of the fixed objects: 0x"));
  CHECK(
      text.ends_with("next generation: 5 | 6\n"
                     "object 0:1 (sphere) type: sphere | obb\n"
                     "object 1:3 (obb): only in a.snap\n"
                     "object 1:5 (sphere): only in b.snap\n"));
}

TEST_CASE("diff: reads every scalar of the tool in both dimensions") {
  using Shapes = support::SceneShapes<double, 2>;
  test::AnyScene<double, 2> flat;
  Shapes::for_each([&](const auto& shape) { flat.add(shape); });
  const auto before = bytes_of(flat);
  for (std::uint32_t i = 0; i < Shapes::size; ++i) flat.move({i, i + 1}, {0.5, 0});
  const auto text = compare(before, bytes_of(flat)).text;
  Shapes::for_each([&](const auto& shape) {
    CHECK(text.find(" (" + std::string(support::name_of(shape)) + ") ") != std::string::npos);
  });
  CHECK(text.find("object 0:1 (sphere) center.x: 0 (raw 0x0000000000000000) | 0.5 (raw "
                  "0x3fe0000000000000)\n") != std::string::npos);
  Scene<q8_8, 2, Sphere> small;
  CHECK(compare(bytes_of(small), bytes_of(small)).is_none);
}

TEST_CASE("diff: names meshes by id, digest and transform") {
  std::array parts{MeshTriangle<S>{{at(0, 0, 0), at(1, 0, 0), at(0, 1, 0)}, 0}};
  std::array<MeshNode<S>, 1> nodes;
  const auto view = *build_mesh<S>(std::span(parts), std::span(nodes));
  const MeshAsset<S> rock(7, view), wall(9, view), nothing(7, Mesh<S>());
  const auto with = [](const MeshAsset<S>& asset, const Transform<S, 3>& transform) {
    Scene<S, 3, Sphere, MeshInstance> scene;
    scene.add(PlacedMesh{&asset, transform});
    return bytes_of(scene);
  };
  const auto before = with(rock, {});
  CHECK(compare(before, with(rock, {.translation = at(0, 3, 0), .scale = S(2)})).text ==
        "object 0:1 (mesh) translation.y: 0 (raw 0) | 3 (raw 196608)\n"
        "object 0:1 (mesh) scale: 1 (raw 65536) | 2 (raw 131072)\n");
  CHECK(compare(before, with(wall, {})).text == "object 0:1 (mesh) mesh: 7 | 9\n");
  CHECK(compare(before, with(nothing, {}))
            .text.starts_with("object 0:1 (mesh) digest of its triangles: 0x"));
}

TEST_CASE("diff: names hulls and height fields by id, digest and pose") {
  const std::array corners{at(0, 0, 0), at(1, 0, 0), at(0, 1, 0)};
  const auto rock = *hull_asset(7, ConvexHull{corners});
  const auto stone = *hull_asset(7, ConvexHull{std::span(corners).first(2)});
  const std::array<S, 4> heights{};
  const FieldAsset<S> ground(8, *height_field<S>({S(0), S(0)}, S(1), 2, 2, heights));
  const auto with = [&](const HullAsset<S, 3>& asset, int x, int y) {
    Scene<S, 3, HullInstance, FieldInstance> scene;
    scene.add(PlacedHull{&asset, {.translation = at(x, 0, 0)}});
    scene.add(PlacedField{&ground, at(0, y, 0)});
    return bytes_of(scene);
  };
  const auto before = with(rock, 0, 0);
  CHECK(compare(before, with(rock, 3, 2)).text ==
        "object 0:1 (hull) translation.x: 0 (raw 0) | 3 (raw 196608)\n"
        "object 1:2 (height field) translation.y: 0 (raw 0) | 2 (raw 131072)\n");
  CHECK(compare(before, with(stone, 0, 0))
            .text.starts_with("object 0:1 (hull) digest of its points: 0x"));
  const std::array<Vec<S, 2>, 1> point{};
  const auto dot = *hull_asset(1, ConvexHull{point});
  Scene<S, 2, HullInstance> flat;
  flat.add(PlacedHull{&dot});
  CHECK(compare(bytes_of(flat), bytes_of(flat)).is_none);
}

TEST_CASE("diff: bytes that are not a snapshot are refused by name") {
  const auto right = bytes_of(toys());
  CHECK(refusal("", right).starts_with("a.snap: the snapshot is cut off; "));
  CHECK(refusal(right, right.substr(1)).starts_with("b.snap: these bytes are not a snapshot; "));
  CHECK(refusal(right, "DTNW" + right.substr(4)).starts_with("b.snap: a snapshot of a world; "));
  auto changed = right;
  changed[60] = static_cast<char>(changed[60] + 1);
  CHECK(
      refusal(right, changed).starts_with("b.snap: the bytes of the snapshot have been changed; "));
  CHECK(refusal(right, bytes_of(Scene<q14_16, 3, Sphere>()))
            .starts_with("b.snap: has a different scalar or dimension than a.snap; "));
  CHECK(refusal(bytes_of(Scene<Fixed<20, 10>, 3, Sphere>()), right)
            .starts_with("a.snap: the tool does not support its scalar or dimension; "));
}

namespace {

/// The status of `restore` for the bytes into an empty scene of this type.
template <class Scene>
Restored restored(const std::string& bytes) {
  Scene scene;
  return restore(scene, std::as_bytes(std::span(bytes)));
}

/// The bytes with a valid checksum.
std::string sealed(std::string bytes) {
  test::seal(std::as_writable_bytes(std::span(bytes)));
  return bytes;
}

/// Changes every byte except those that identify the kind of scene, and compares both verdicts.
template <class Scene>
void check_same_verdicts(const Scene& scene) {
  const auto right = bytes_of(scene);
  REQUIRE(restored<Scene>(right) == Restored::yes);
  test::HitRate rate;
  for (std::size_t i = 0; i < right.size() - detail::SnapshotHeader::checksum_size; ++i) {
    const bool is_of_scene = (i >= 6 && i < 12) || (i >= 24 && i < 36);
    if (is_of_scene) continue;
    for (const int change : {1, 2, 3, -1, -2, 4, 64, 0x80}) {
      auto bytes = right;
      bytes[i] = static_cast<char>(bytes[i] + change);
      bytes = sealed(bytes);
      INFO("byte " << i << " of " << bytes.size() << " changed by " << change);
      const auto verdict = restored<Scene>(bytes);
      if (verdict == Restored::no_room) continue;  // a larger scene may have room
      const bool is_restored = verdict == Restored::yes;
      const auto refused = refusal(bytes, right);
      CHECK(refused.empty() == is_restored);
      rate.count(is_restored);
    }
  }
  INFO(rate);
  CHECK(rate.percent() >= 20);
  CHECK(rate.percent() <= 80);
}

}  // namespace

TEST_CASE("diff: refuses exactly the bytes that restore refuses") {
  Scene<S, 3, Sphere, Obb, Plane> scene;
  const auto first = *scene.add_frame({});
  const auto second = *scene.add_frame({.translation = at(1, 2, 3)}, first);
  scene.add(Sphere{at(0, 0, 0), S(1)});
  scene.add(Obb<S, 3>{at(5, 0, 0), at(1, 1, 1), {}}, {.frame = second});
  scene.add(Plane<S, 3>{{}, S(5)}, {.frame = first});
  scene.add(Sphere{at(3, 0, 0), S(1)});
  scene.remove({1, 4});
  check_same_verdicts(scene);

  test::AnyScene<q8_8, 2> flat;
  support::SceneShapes<q8_8, 2>::for_each([&](const auto& shape) { flat.add(shape); });
  check_same_verdicts(flat);

  Scene<float, 3, Sphere, Plane> rounded;
  rounded.add(Sphere<float, 3>{});
  rounded.add(Plane<float, 3>{});
  check_same_verdicts(rounded);
}

TEST_CASE("diff: refuses impossible sets of shapes, and shapes that are not in the set") {
  const auto right = bytes_of(toys());
  constexpr std::size_t shapes = 10;  // the header's two bytes
  for (const int set : {0, 1, 0x0b, 0x02, 0x08, 0x100, 0x800a}) {
    auto bytes = right;
    bytes[shapes] = static_cast<char>(set);
    bytes[shapes + 1] = static_cast<char>(set >> 8);
    INFO(set);
    CHECK(
        refusal(sealed(bytes), right).starts_with("a.snap: its contents are not a valid snapshot"));
  }
  CHECK(refusal(sealed(right), right).empty());
}
