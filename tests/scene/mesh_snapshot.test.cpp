// SPDX-License-Identifier: MIT
#include "detent/scene/snapshot.hpp"

#include <array>
#include <vector>

#include "detent/scene/mesh/instance.hpp"
#include "detent/scene/mesh/owned.hpp"
#include "detent/scene/sync_test.hpp"
#include "support/catch.hpp"
#include "support/seal.hpp"

using namespace detent;
using S = q16_16;
using Vec3 = Vec<S, 3>;
using Asset = MeshAsset<S>;
using Assets = std::vector<Asset>;
using Placed = PlacedMesh<S>;
using Toys = Scene<S, 3, Sphere, MeshInstance>;

namespace {

Vec3 at(int x, int y, int z) { return {S(x), S(y), S(z)}; }

/// A strip of `count` triangles.
OwnedMesh<S> strip(int count) {
  std::vector<Triangle<S, 3>> triangles;
  for (int i = 0; i < count; ++i) triangles.push_back({at(i, 0, 0), at(i + 1, 0, 0), at(i, 1, 0)});
  return OwnedMesh<S>{std::span<const Triangle<S, 3>>(triangles)};
}

const OwnedMesh<S> rock = strip(3), wall = strip(50);
const Assets assets{Asset(7, rock.view()), Asset(9, wall.view())};

/// A ball, a moving rock, a fixed wall, a rock in a frame, and an object without a mesh.
Toys toys() {
  Toys scene;
  scene.add(Sphere{at(0, 0, 0), S(1)});
  scene.add(Placed{&assets[0], {.translation = at(5, 0, 0)}});
  scene.add(Placed{&assets[1]}, {.motion = Motion::fixed});
  const auto frame = *scene.add_frame({.translation = at(0, 0, 3)});
  scene.add(Placed{&assets[0]}, {.frame = frame});
  scene.add(Placed{});
  return scene;
}

}  // namespace

TEST_CASE("snapshot of meshes: the scene is restored with any copy of its meshes") {
  Toys scene = toys();
  const auto bytes = snapshot(scene);
  const auto before = digest(scene);
  CHECK(scene.move({1, 2}, at(1, 1, 1)));
  CHECK(scene.remove({3, 5}));
  CHECK(digest(scene) != before);
  const Assets copies = assets;
  REQUIRE(restore(scene, bytes, copies) == Restored::yes);
  CHECK(digest(scene) == before);
  CHECK(snapshot(scene) == bytes);
  CHECK(scene.shape<Placed>({1, 2})->asset == &copies[0]);
  CHECK(scene.shape<Placed>({3, 5})->transform.translation == at(0, 0, 3));
  CHECK(scene.nearest(Ray<S, 3>{{S(5), S(0), S(9)}, -Direction<S, 3>::along(2)}) ==
        Found<S>{S(9), {1, 2}});
}

TEST_CASE("snapshot of meshes: a moving mesh takes 89 bytes for any number of triangles") {
  Toys scene;
  const auto none = snapshot(scene).size();
  scene.add(Placed{&assets[0]});
  CHECK(snapshot(scene).size() == none + 89);
  scene.add(Placed{&assets[1]});
  CHECK(snapshot(scene).size() == none + 2 * 89);
}

TEST_CASE("snapshot of meshes: the bytes of version 1 never change") {
  CHECK(assets[0].digest() == 0x396d6b53fcaada56u);
  CHECK(digest(toys()) == 0x6454eaf033b35856u);
  const auto bytes = snapshot(toys());
  CHECK(detail::load_word<std::uint64_t>(bytes.data() + bytes.size() - 8) == 0x5af7bc8b96776e64u);
}

TEST_CASE(
    "restore of meshes: an unknown id or other triangles are refused, and the scene is unchanged") {
  Toys scene = toys();
  const auto bytes = snapshot(scene);
  CHECK(scene.move({1, 2}, at(1, 1, 1)));
  const auto before = snapshot(scene);
  const auto refused = [&](const Assets& meshes) {
    const auto result = restore(scene, bytes, meshes);
    CHECK(snapshot(scene) == before);
    CHECK(scene.shape<Placed>({1, 2})->asset == &assets[0]);
    return result;
  };
  CHECK(restore(scene, bytes) == Restored::unknown_mesh);
  CHECK(snapshot(scene) == before);
  CHECK(refused({}) == Restored::unknown_mesh);
  CHECK(refused({assets[1]}) == Restored::unknown_mesh);
  CHECK(refused({Asset(8, rock.view())}) == Restored::unknown_mesh);
  CHECK(refused({Asset(7, wall.view())}) == Restored::other_mesh);
  CHECK(refused({Asset(7, Mesh<S>())}) == Restored::other_mesh);
  CHECK(describe(Restored::unknown_mesh) ==
        "the snapshot refers to a mesh, hull or height field by an id that none of the given ones "
        "has");
  CHECK(describe(Restored::other_mesh) ==
        "the snapshot refers to a mesh, hull or height field of this id with other triangles, "
        "points or heights");
  const Assets two{Asset(7, wall.view()), assets[0]};
  REQUIRE(restore(scene, bytes, two) == Restored::yes);
  CHECK(scene.shape<Placed>({1, 2})->asset == &two[1]);
}

TEST_CASE("restore of meshes: a forged reference is refused") {
  Toys scene = toys();
  const auto bytes = snapshot(scene);
  const auto before = digest(scene);
  constexpr std::size_t rock_at =
      48 + 64 + 41 + 25;  // after the header, the frame, the ball and the rock's object header
  const auto forged = [&](std::size_t place, std::uint32_t word) {
    auto copy = bytes;
    detail::store_word(copy.data() + place, word);
    test::seal(copy);
    const auto result = restore(scene, copy, assets);
    if (result != Restored::yes) CHECK(digest(scene) == before);
    return result;
  };
  CHECK(forged(rock_at, 8) == Restored::unknown_mesh);
  CHECK(forged(rock_at, 9) == Restored::other_mesh);
  CHECK(forged(rock_at + 4, 1) == Restored::other_mesh);
  CHECK(forged(rock_at + 12 + 12, 5) == Restored::corrupted);  // an axis that is not a direction
  CHECK(forged(rock_at + 12, 5) == Restored::yes);             // another translation
  CHECK(scene.shape<Placed>({1, 2})->transform.translation.x == S::from_raw(5));
}

TEST_CASE("restore of meshes: fixed ones are compared by digest, and need not be given") {
  Toys scene, other, same;
  scene.add(Placed{&assets[1]}, {.motion = Motion::fixed});
  scene.add(Sphere{at(1, 2, 3), S(1)});
  const auto bytes = snapshot(scene);
  const Assets swapped{Asset(9, rock.view())}, copies = assets;
  other.add(Placed{swapped.data()}, {.motion = Motion::fixed});
  CHECK(restore(other, bytes) == Restored::other_fixed_part);
  same.add(Placed{&copies[1]}, {.motion = Motion::fixed});
  CHECK(restore(same, bytes) == Restored::yes);
  CHECK(digest(same) == digest(scene));
}

TEST_CASE("sync test: names the fields in which scenes of meshes diverge") {
  Toys scene = toys();
  SyncTest<Toys, int> test(3);
  const auto simulate = [](Toys& world, int x) { CHECK(world.move({1, 2}, at(x, 0, 0))); };
  for (int frame = 0; frame < 8; ++frame) CHECK_FALSE(test.step(scene, frame, simulate));
  int hidden = 0;
  const auto desync = test.step(scene, 0, [&](Toys& world, int) {
    CHECK(world.move({1, 2}, at(++hidden, 0, 0)));
  });
  REQUIRE(desync);
  CHECK(desync->object == ObjectId{1, 2});
  CHECK(desync->field.view() == "object 1:2 (mesh) translation.x");
}
