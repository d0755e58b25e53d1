// SPDX-License-Identifier: MIT
#include "detent/scene/snapshot.hpp"

#include <array>
#include <vector>

#include "support/catch.hpp"
#include "support/seal.hpp"

using namespace detent;
using S = q16_16;
using Vec3 = Vec<S, 3>;
using Ball = Sphere<S, 3>;
using Box = Obb<S, 3>;
using Balls = Scene<S, 3, Sphere>;
using Toys = Scene<S, 3, Sphere, Obb>;

namespace {

Vec3 at(int x, int y, int z) { return {S(x), S(y), S(z)}; }

Toys toys() {
  Toys scene;
  scene.add(Ball{at(0, 0, 0), S(1)}, {.layers = 2, .user = 77});
  scene.add(Box{at(3, 0, 0), at(1, 1, 1), {}}, {.motion = Motion::fixed});
  const auto frame = *scene.add_frame({.translation = at(10, 0, 0)});
  const auto inner = *scene.add_frame({.translation = at(0, 5, 0)}, frame);
  scene.add(Box{at(0, 0, 0), at(1, 1, 1), {}}, {.frame = inner});
  scene.add(Ball{at(1, 2, 3), S(4)});
  return scene;
}

}  // namespace

TEST_CASE("snapshot: restores a scene, including the ids of its next additions") {
  Toys scene = toys();
  const auto bytes = snapshot(scene);
  const auto before = digest(scene);
  Toys other = scene;
  CHECK(scene.remove({0, 1}));
  CHECK(scene.add(Ball{at(9, 9, 9), S(2)}) == ObjectId{0, 7});
  CHECK(scene.move_frame({0, 3}, {.translation = at(-10, 0, 0)}));
  CHECK(scene.move({3, 6}, at(1, 1, 1)));
  CHECK(digest(scene) != before);
  REQUIRE(restore(scene, bytes) == Restored::yes);
  CHECK(digest(scene) == before);
  CHECK(snapshot(scene) == bytes);
  CHECK(scene.shape<Box>({2, 5})->center == at(10, 5, 0));
  CHECK(scene.nearest(at(10, 5, 0)) == Found<S>{S(0), {2, 5}});
  CHECK(scene.add(Ball{}) == other.add(Ball{}));
}

TEST_CASE("snapshot: restores into a scene without objects, whatever indices are free") {
  Balls scene;
  for (int i = 0; i < 20; ++i) scene.add(Ball{at(i, 0, 0), S(1)});
  for (std::uint32_t i = 0; i < 20; ++i) {
    if (i % 7 != 5) CHECK(scene.remove({i, i + 1}));
  }
  Balls fresh;
  REQUIRE(restore(fresh, snapshot(scene)) == Restored::yes);
  CHECK(fresh.size() == 3);
  CHECK(digest(fresh) == digest(scene));
}

TEST_CASE("snapshot: an empty snapshot empties a scene") {
  Balls scene;
  const auto nothing = snapshot(scene);
  CHECK(nothing.size() == 56);
  scene.add(Ball{at(0, 0, 0), S(1)});
  REQUIRE(restore(scene, nothing) == Restored::yes);
  CHECK(scene.size() == 0);
  CHECK_FALSE(scene.any(at(0, 0, 0)));
}

TEST_CASE("snapshot: a moving sphere takes 41 bytes") {
  Balls scene;
  scene.add(Ball{at(0, 0, 0), S(1)});
  const auto one = snapshot(scene).size();
  scene.add(Ball{at(5, 0, 0), S(1)});
  CHECK(snapshot(scene).size() == one + 41);
}

TEST_CASE("snapshot: the bytes of version 1 never change") {
  CHECK(digest(toys()) == 0xb6de270536116997u);
  const auto bytes = snapshot(toys());
  CHECK(detail::load_word<std::uint64_t>(bytes.data() + bytes.size() - 8) == 0x05e61db055eb5427u);
}

TEST_CASE("snapshot: returns the size needed if there is too little room") {
  const Toys scene = toys();
  std::array<std::byte, 1024> room{};
  const auto size = snapshot(scene, room);
  for (const std::size_t less : {0u, 10u, 48u, 100u}) {
    CHECK(snapshot(scene, std::span(room).first(less)) == size);
  }
  std::array<std::byte, 100> small{};
  CHECK(snapshot(scene, std::span(small).first(99)) == size);
  CHECK(small[99] == std::byte{0});
  CHECK(snapshot(scene, room) == size);
  CHECK(std::vector(room.begin(), room.begin() + static_cast<long>(size)) == snapshot(scene));
}

TEST_CASE("restore: every shortened or changed snapshot is refused, and the scene is unchanged") {
  Toys scene = toys();
  const auto bytes = snapshot(scene);
  scene.move({0, 1}, at(1, 0, 0));
  const auto before = snapshot(scene);
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    const auto cut = std::span(bytes).first(size);
    CHECK(restore(scene, cut) == Restored::truncated);
  }
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    for (int bit = 0; bit < 8; ++bit) {
      auto changed = bytes;
      changed[i] ^= static_cast<std::byte>(1 << bit);
      CHECK(restore(scene, changed) != Restored::yes);
    }
  }
  auto longer = bytes;
  longer.push_back(std::byte{0});
  CHECK(restore(scene, longer) == Restored::corrupted);
  CHECK(snapshot(scene) == before);
}

TEST_CASE("restore: the status says why it refuses") {
  Toys scene = toys();
  const auto bytes = snapshot(scene);
  auto changed = bytes;
  changed[0] = std::byte{0};
  CHECK(restore(scene, changed) == Restored::no_snapshot);
  changed = bytes;
  changed[4] = std::byte{2};
  CHECK(restore(scene, changed) == Restored::other_version);
  Balls balls;
  CHECK(restore(balls, bytes) == Restored::other_scene);
  Scene<q14_16, 3, Sphere, Obb> narrow;
  CHECK(restore(narrow, bytes) == Restored::other_scene);
  Toys without;
  CHECK(restore(without, bytes) == Restored::other_fixed_part);
  BoundedScene<Bounded<4>, S, 3, Sphere, Obb> small;  // no frames
  small.add_as({1, 2}, Box{at(3, 0, 0), at(1, 1, 1), {}}, {.motion = Motion::fixed});
  CHECK(restore(small, bytes) == Restored::no_room);
  CHECK(describe(Restored::truncated) == "the snapshot is cut off");
}

TEST_CASE("restore: every part of a forged snapshot is checked") {
  Toys scene = toys();
  const auto bytes = snapshot(scene);
  const auto before = digest(scene);
  const auto forged = [&](std::size_t place, std::uint32_t word) {
    auto copy = bytes;
    detail::store_word(copy.data() + place, word);
    test::seal(copy);
    return restore(scene, copy);
  };
  constexpr std::size_t frames = 48, frame = 64, objects = frames + 2 * frame;
  CHECK(forged(12, 0) == Restored::corrupted);                  // no generation is valid
  CHECK(forged(16, 0xffffffffu) == Restored::corrupted);        // more frames than bytes
  CHECK(forged(20, 0xffffffffu) == Restored::corrupted);        // more objects than bytes
  CHECK(forged(20, 2) == Restored::corrupted);                  // fewer
  CHECK(forged(frames + 4, 0) == Restored::corrupted);          // a frame without generation
  CHECK(forged(frames + 8, 1) == Restored::corrupted);          // a parent younger than its child
  CHECK(forged(frames + 24, 5) == Restored::corrupted);         // an axis that is not a direction
  CHECK(forged(frames + frame, 0) == Restored::corrupted);      // two frames with one index
  CHECK(forged(frames + frame + 8, 7) == Restored::corrupted);  // no such parent
  CHECK(forged(objects, 1) == Restored::corrupted);             // the index of a fixed object
  CHECK(forged(objects, 2) == Restored::corrupted);             // indices out of order
  CHECK(forged(objects + 4, 99) == Restored::corrupted);        // a generation yet to come
  CHECK(forged(objects + 20, 5) == Restored::corrupted);        // no such frame
  CHECK(forged(objects + 24, 0) == Restored::corrupted);        // not a type of shape
  CHECK(forged(bytes.size() - 49, 0xffffffffu) == Restored::no_room);
  CHECK(forged(objects + 8, 5) == Restored::yes);  // other layers
  CHECK(digest(scene) != before);
}

TEST_CASE("digest: of a scene and, by id, of an object") {
  Toys scene = toys();
  const auto all = digest(scene);
  const auto one = digest_of(scene, {0, 1}), other = digest_of(scene, {3, 6});
  CHECK(one != other);
  CHECK(digest_of(scene, {0, 2}) == std::nullopt);
  scene.set_user({0, 1}, 78);
  CHECK(digest(scene) != all);
  CHECK(digest_of(scene, {0, 1}) != one);
  CHECK(digest_of(scene, {3, 6}) == other);
  scene.set_user({0, 1}, 77);
  CHECK(digest(scene) == all);
  const Toys copy = scene;
  CHECK(digest(copy) == all);
}
