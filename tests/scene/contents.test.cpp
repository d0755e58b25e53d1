// SPDX-License-Identifier: MIT
#include "detent/scene/contents.hpp"

#include <array>
#include <type_traits>
#include <utility>
#include <vector>

#include "detent/scene/snapshot.hpp"
#include "support/catch.hpp"

using namespace detent;
using S = q16_16;
using Vec3 = Vec<S, 3>;
using Ball = Sphere<S, 3>;
using Box = Aabb<S, 3>;
using Toys = Scene<S, 3, Sphere, Aabb>;
using FewToys = BoundedScene<Bounded<12, 3>, S, 3, Sphere, Aabb>;

namespace {

Vec3 at(int x, int y, int z) { return {S(x), S(y), S(z)}; }
Rotation<S, 3> quarter() { return Rotation<S, 3>::from_euler({}, {}, Angle<S>::turn(1, 4)); }

/// Moving and fixed objects, one in a frame, with trees of several levels and advanced generations.
template <class World>
void fill(World& scene) {
  for (int i = 0; i < 9; ++i) scene.add(Ball{at(3 * i, 0, 0), S(1)});
  scene.add(Box{at(0, 5, 0), at(1, 6, 1)}, {.motion = Motion::fixed});
  const auto frame = scene.add_frame({.translation = at(0, 0, 7)}).value_or(no_frame);
  scene.add(Ball{at(0, 0, 0), S(1)}, {.frame = frame});
  scene.remove({1, 2});
}

template <class World>
std::uint64_t state(const World& scene) {
  std::array<std::byte, 1024> room;
  return digest(scene) + snapshot(scene, room) + scene.overlaps(std::span<Overlap>());
}

/// Checks that it equals a new scene before and after adding objects.
template <class World>
void check_is_new(World& scene) {
  const auto bytes_of = [](const World& of) {
    std::vector<std::byte> bytes(snapshot(of, std::span<std::byte>()));
    snapshot(of, std::span(bytes));
    return bytes;
  };
  World fresh;
  CHECK(scene.size() == 0);
  CHECK_FALSE(scene.any(Ball{at(0, 0, 0), S(1000)}));
  CHECK_FALSE(scene.nearest(at(0, 0, 0)));
  CHECK_FALSE(scene.contains({0, 1}));
  CHECK(bytes_of(scene) == bytes_of(fresh));
  fill(scene);
  fill(fresh);
  CHECK(bytes_of(scene) == bytes_of(fresh));
  CHECK(digest(scene) == digest(fresh));
  CHECK(scene.nearest(at(0, 0, 9)) == fresh.nearest(at(0, 0, 9)));
}

}  // namespace

TEMPLATE_TEST_CASE("scene: a moved-from scene is like new", "", Toys, FewToys) {
  STATIC_REQUIRE(std::is_nothrow_move_constructible_v<TestType> &&
                 std::is_nothrow_move_assignable_v<TestType>);
  TestType scene;
  fill(scene);
  const auto before = state(scene);
  TestType second = std::move(scene);
  CHECK(state(second) == before);
  check_is_new(scene);

  TestType third;
  third.add(Ball{at(9, 9, 9), S(9)});
  third = std::move(second);
  CHECK(state(third) == before);
  check_is_new(second);

  TestType& same = third;
  third = std::move(same);
  CHECK(state(third) == before);
  third.move({0, 1}, at(1, 0, 0));
  const auto other = state(third);
  CHECK(other != before);
  std::swap(third, same);
  CHECK(state(third) == other);
  std::swap(third, second);
  CHECK(state(second) == other);
  CHECK(state(third) == before);
  CHECK(second.template shape<Ball>({0, 1})->center == at(1, 0, 0));

  const TestType copy = second;
  CHECK(state(copy) == state(second));
}

TEST_CASE("scene: no_object and no_frame refer to nothing, even in a full scene") {
  BoundedScene<Bounded<1, 1>, S, 3, Sphere> scene;
  const auto ball = scene.add(Ball{at(0, 0, 0), S(1)}).value_or(no_object);
  const auto none = scene.add(Ball{at(1, 0, 0), S(1)}).value_or(no_object);
  CHECK(scene.contains(ball));
  CHECK_FALSE(scene.contains(none));
  CHECK_FALSE(scene.move(none, at(1, 0, 0)));
  CHECK_FALSE(scene.replace(none, Ball{}));
  CHECK_FALSE(scene.replace_local(none, Ball{}));
  CHECK_FALSE(scene.set_layers(none, 2));
  CHECK_FALSE(scene.shape<Ball>(none));
  CHECK_FALSE(scene.frame_of(none));
  CHECK_FALSE(scene.visit(none, [](const auto&) { FAIL(); }));
  CHECK_FALSE(scene.remove(none));
  scene.remove(ball);
  const auto arm = scene.add_frame({}).value_or(no_frame);
  const auto hand = scene.add_frame({}).value_or(no_frame);
  CHECK(scene.frame(arm));
  CHECK_FALSE(scene.frame(hand));
  CHECK_FALSE(scene.move_frame(hand, {}));
  CHECK_FALSE(scene.add_frame({}, hand));
  CHECK_FALSE(scene.add(Ball{}, {.frame = hand}));
}

TEST_CASE("scene: frames give their transforms to parent and world") {
  Toys scene;
  const auto arm = scene.add_frame({.translation = at(10, 0, 0), .rotation = quarter()}).value();
  const auto hand = scene.add_frame({.translation = at(5, 0, 0), .scale = S(2)}, arm).value();
  const auto ball = scene.add(Ball{at(1, 0, 0), S(1)}, {.frame = hand}).value();
  const auto free = scene.add(Ball{at(1, 0, 0), S(1)}).value();
  CHECK(scene.frame(arm)->local == Transform<S, 3>{at(10, 0, 0), quarter(), S(1)});
  CHECK(scene.frame(arm)->world == scene.frame(arm)->local);
  CHECK(scene.frame(arm)->parent == FrameId{});
  CHECK(scene.frame(hand)->local == Transform<S, 3>{at(5, 0, 0), {}, S(2)});
  CHECK(scene.frame(hand)->world == Transform<S, 3>{at(10, 5, 0), quarter(), S(2)});
  CHECK(scene.frame(hand)->parent == arm);
  CHECK(scene.frame_of(ball) == hand);
  CHECK(scene.frame_of(free) == FrameId{});
  CHECK(scene.shape<Ball>(ball) == placed(scene.frame(hand)->world, Ball{at(1, 0, 0), S(1)}));
  CHECK_FALSE(scene.frame({}));
  CHECK_FALSE(scene.frame({hand.index, hand.generation + 1}));
  CHECK(scene.move_frame(arm, {.translation = at(1, 2, 3)}));
  CHECK(scene.frame(hand)->world == Transform<S, 3>{at(6, 2, 3), {}, S(2)});
}

TEST_CASE("scene: replace_local accepts what local_shape returns, and replace what shape returns") {
  Toys scene;
  const auto arm =
      scene.add_frame({.translation = at(10, 0, 0), .rotation = quarter(), .scale = S(3)}).value();
  const Ball given{at(1, 2, 3), S(1)};
  const auto inside = scene.add(given, {.frame = arm}).value();
  const auto outside = scene.add(given).value();
  const auto before = digest(scene);
  CHECK(scene.local_shape<Ball>(inside) == given);
  CHECK(scene.shape<Ball>(inside) == Ball{at(4, 3, 9), S(3)});
  CHECK_FALSE(scene.local_shape<Box>(inside));
  CHECK(scene.replace_local(inside, *scene.local_shape<Ball>(inside)));
  CHECK(digest(scene) == before);
  CHECK_FALSE(scene.replace(inside, *scene.shape<Ball>(inside)));
  CHECK(digest(scene) == before);

  CHECK(scene.local_shape<Ball>(outside) == scene.shape<Ball>(outside));
  CHECK(scene.replace(outside, *scene.shape<Ball>(outside)));
  CHECK(scene.replace_local(outside, *scene.local_shape<Ball>(outside)));
  CHECK(digest(scene) == before);

  CHECK(scene.replace_local(inside, Box{at(0, 0, 0), at(1, 2, 3)}));
  CHECK(scene.local_shape<Box>(inside) == Box{at(0, 0, 0), at(1, 2, 3)});
  CHECK(scene.shape<Box>(inside) == Box{at(4, 0, 0), at(10, 3, 9)});
  CHECK(scene.replace(outside, Box{at(0, 0, 0), at(1, 2, 3)}));
  CHECK(scene.shape<Box>(outside) == Box{at(0, 0, 0), at(1, 2, 3)});
}

TEST_CASE("scene: an object is visited as its shape in world space") {
  Toys scene;
  const auto arm = scene.add_frame({.translation = at(10, 0, 0)}).value();
  const auto ball = scene.add(Ball{at(1, 0, 0), S(2)}, {.frame = arm}).value();
  const auto box = scene.add(Box{at(0, 0, 0), at(1, 2, 3)}).value();
  std::vector<Box> seen;
  const auto look = [&](const auto& shape) {
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(shape)>, Ball>) {
      CHECK(shape == Ball{at(11, 0, 0), S(2)});
    } else {
      CHECK(shape == Box{at(0, 0, 0), at(1, 2, 3)});
    }
    seen.push_back(bounding_box(shape));
  };
  CHECK(scene.visit(ball, look));
  CHECK(scene.visit(box, look));
  CHECK(seen == std::vector<Box>{{at(9, -2, -2), at(13, 2, 2)}, {at(0, 0, 0), at(1, 2, 3)}});
  CHECK(scene.remove(box));
  CHECK_FALSE(scene.visit(box, look));
  CHECK(seen.size() == 2);
}

TEST_CASE("scene: no query finds an empty object, however near") {
  Scene<S, 3, Sphere, Aabb, Obb, Capsule> scene;
  const Ball ball{at(0, 0, 0), S(-1)};
  const Box box{at(1, 0, 0), at(0, 1, 1)};
  scene.add(ball);
  scene.add(box);
  scene.add(Obb<S, 3>{at(0, 0, 0), {S(1), S(1), S(-1)}, {}});
  scene.add(Capsule<S, 3>{at(0, 0, 0), at(1, 0, 0), S(-1)});
  CHECK(distance(ball, at(0, 0, 0)) == S::max());
  CHECK(distance(box, at(0, 0, 0)) == S::max());
  CHECK_FALSE(scene.nearest(at(0, 0, 0)));
  CHECK_FALSE(scene.any(Ball{at(0, 0, 0), S(5)}));
  CHECK_FALSE(scene.nearest(Ray<S, 3>{at(-5, 0, 0), Direction<S, 3>::along(0)}));
  const auto far = scene.add(Ball{{S::max(), S::max(), S::max()}, S(0)}).value();
  CHECK(scene.nearest(at(-9999, -9999, -9999)) == Found<S>{S::max(), far});
}

TEST_CASE("scene: changing a fixed object invalidates earlier snapshots") {
  Toys scene;
  scene.add(Ball{at(0, 0, 0), S(1)});
  const auto wall =
      scene.add(Box{at(0, 0, 0), at(1, 9, 9)}, {.motion = Motion::fixed}).value_or(no_object);
  const auto bytes = snapshot(scene);
  const auto restored_after = [&](const auto& change) {
    Toys other = scene;
    CHECK(change(other));
    const auto before = digest(other);
    const auto result = restore(other, bytes);
    if (result != Restored::yes) CHECK(digest(other) == before);
    return result;
  };
  CHECK(restored_after([](Toys& t) { return t.move({0, 1}, at(1, 0, 0)); }) == Restored::yes);
  constexpr auto refused = Restored::other_fixed_part;
  CHECK(restored_after([&](Toys& t) { return t.move(wall, at(1, 0, 0)); }) == refused);
  CHECK(restored_after([&](Toys& t) { return t.replace(wall, Ball{}); }) == refused);
  CHECK(restored_after([&](Toys& t) { return t.set_layers(wall, 2); }) == refused);
  CHECK(restored_after([&](Toys& t) { return t.set_user(wall, 2); }) == refused);
  CHECK(restored_after([&](Toys& t) { return t.remove(wall); }) == refused);
  CHECK(restored_after([](Toys& t) {
          return t.add(Ball{}, {.motion = Motion::fixed}).has_value();
        }) == refused);
  CHECK(restored_after([&](Toys& t) {
          return t.move(wall, at(1, 0, 0)) && t.move(wall, at(-1, 0, 0));
        }) == Restored::yes);
  CHECK(describe(refused) ==
        "fixed objects have been added, changed, moved or removed since the snapshot was taken");
}
