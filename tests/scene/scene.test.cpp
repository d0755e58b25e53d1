// SPDX-License-Identifier: MIT
#include "detent/scene/scene.hpp"

#include <array>

#include "support/catch.hpp"

using namespace detent;
using S = q16_16;
using Vec3 = Vec<S, 3>;
using Ball = Sphere<S, 3>;
using Box = Aabb<S, 3>;
using List = std::vector<Found<S>>;

namespace {

Vec3 at(int x, int y, int z) { return {S(x), S(y), S(z)}; }
const Ray<S, 3> along_x{at(-10, 0, 0), Direction<S, 3>::along(0)};

}  // namespace

TEST_CASE("scene: results are sorted by distance, then id") {
  Scene<S, 3, Sphere, Aabb> scene;
  const auto far = *scene.add(Ball{at(9, 0, 0), S(1)});
  const auto second = *scene.add(Ball{at(5, 0, 0), S(1)});
  const auto third = *scene.add(Box{at(4, -1, -1), at(6, 1, 1)});
  CHECK(scene.all(along_x) == List{{S(14), second}, {S(14), third}, {S(18), far}});
  CHECK(scene.nearest(along_x) == Found<S>{S(14), second});
  CHECK(scene.nearest(along_x, [&](const ObjectInfo& object) { return object.id != second; }) ==
        Found<S>{S(14), third});
  CHECK(scene.all(Ball{at(7, 0, 0), S(2)}) == List{{S(1), far}, {S(1), second}, {S(1), third}});
  CHECK(scene.all(at(5, 0, 0)) == List{{S(0), second}, {S(0), third}});
  CHECK(scene.nearest(at(0, 0, 0)) == Found<S>{S(4), second});
  CHECK(scene.overlaps() == std::vector<Overlap>{{second, third}});
  CHECK(scene.overlaps([](const auto&, const auto&) { return false; }).empty());
  std::array<Found<S>, 2> room;
  CHECK(scene.all(along_x, std::span(room)) == 3);
  CHECK(room == std::array{Found<S>{S(14), second}, Found<S>{S(14), third}});
}

TEST_CASE("scene: layers, user words and ids") {
  Scene<S, 3, Sphere> scene;
  const auto a = *scene.add(Ball{at(0, 0, 0), S(1)}, {.layers = 1, .user = 42});
  const auto b = *scene.add(Ball{at(4, 0, 0), S(1)}, {.layers = 6});
  CHECK(scene.nearest(along_x, InLayers{4})->id == b);
  CHECK_FALSE(scene.any(along_x, InLayers{8}));
  CHECK(scene.info(a)->user == 42);
  CHECK(scene.set_layers(a, 8));
  CHECK(scene.nearest(along_x, InLayers{8})->id == a);
  CHECK(scene.shape<Ball>(b) == Ball{at(4, 0, 0), S(1)});

  CHECK(scene.remove(a));
  CHECK_FALSE(scene.contains(a));
  CHECK_FALSE(scene.remove(a));
  CHECK_FALSE(scene.move(a, at(1, 0, 0)));
  CHECK_FALSE(scene.set_user(a, 1));
  const auto c = *scene.add(Ball{at(8, 0, 0), S(1)});
  CHECK(c.index == a.index);  // the lowest free index
  CHECK(c != a);
  CHECK_FALSE(scene.add_as({a.index, 9}, Ball{}));
  CHECK(scene.add_as({7, 9}, Ball{at(1, 1, 1), S(0)}));
  CHECK(scene.add(Ball{}) == ObjectId{2, 10});
  CHECK_FALSE(scene.contains(ObjectId{}));
}

TEST_CASE("scene: a bounded scene reports when it is full, and accepts objects after a removal") {
  BoundedScene<Bounded<40>, S, 3, Sphere> scene;
  for (int round = 0; round < 20; ++round) {
    for (int i = 0; i < 40; ++i) CHECK(scene.add(Ball{at(i * 7 % 40, round, i), S(1)}));
    CHECK_FALSE(scene.add(Ball{}));
    CHECK_FALSE(scene.add_as({40, 1}, Ball{}));
    CHECK(scene.size() == 40);
    std::vector<ObjectId> ids;
    scene.for_each([&](const ObjectInfo& object, const auto&) { ids.push_back(object.id); });
    CHECK(std::is_sorted(ids.begin(), ids.end()));
    for (std::size_t i = 0; i < 40; ++i) CHECK(scene.remove(ids[i * 11 % 40]));
    CHECK_FALSE(scene.any(Ball{at(0, 0, 0), S(1000)}));
  }
  CHECK_FALSE(scene.add_frame({}));
}

TEST_CASE("scene: fixed objects overlap moving ones, not each other") {
  Scene<S, 3, Sphere> scene;
  const auto a = *scene.add(Ball{at(0, 0, 0), S(2)}, {.motion = Motion::fixed});
  const auto b = *scene.add(Ball{at(1, 0, 0), S(2)}, {.motion = Motion::fixed});
  const auto c = *scene.add(Ball{at(2, 0, 0), S(2)});
  CHECK(scene.overlaps() == std::vector<Overlap>{{a, c}, {b, c}});
  CHECK(scene.all(at(1, 0, 0)).size() == 3);
}

TEST_CASE("scene: objects move with their frames, and frames with their parents") {
  Scene<S, 3, Sphere, Aabb> scene;
  const auto arm = *scene.add_frame({.translation = at(10, 0, 0)});
  const auto hand = *scene.add_frame({.translation = at(5, 0, 0)}, arm);
  const auto ball = *scene.add(Ball{at(1, 0, 0), S(1)}, {.frame = hand});
  CHECK(scene.shape<Ball>(ball)->center == at(16, 0, 0));
  const auto quarter = Rotation<S, 3>::from_euler({}, {}, Angle<S>::turn(1, 4));
  CHECK(scene.move_frame(arm, {.rotation = quarter, .scale = S(2)}));
  CHECK(scene.shape<Ball>(ball) == Ball{at(0, 12, 0), S(2)});
  CHECK(scene.nearest(at(0, 0, 0)) == Found<S>{S(10), ball});
  CHECK(scene.move(ball, at(1, 0, 0)));
  CHECK(scene.shape<Ball>(ball)->center == at(0, 14, 0));
  const auto box = *scene.add(Box{at(0, 0, 0), at(1, 2, 3)}, {.frame = arm});
  CHECK(scene.shape<Box>(box) == Box{at(-4, 0, 0), at(0, 2, 6)});

  CHECK_FALSE(scene.remove_frame(arm));
  CHECK_FALSE(scene.remove_frame(hand));
  CHECK(scene.remove(ball));
  CHECK(scene.remove_frame(hand));
  CHECK_FALSE(scene.add(Ball{}, {.frame = hand}));
  CHECK_FALSE(scene.add(Ball{}, {.motion = Motion::fixed, .frame = arm}));
  CHECK_FALSE(scene.add_frame({}, hand));
  CHECK_FALSE(scene.move_frame(hand, {}));
}

TEST_CASE("scene: stores its only type of shape without a tag") {
  STATIC_REQUIRE(sizeof(detail::OneOf<Ball>) == sizeof(Ball));
  STATIC_REQUIRE(sizeof(detail::OneOf<Ball, Box>) == sizeof(Box) + 4);
}

TEST_CASE("scene: finds objects that touch at the ends of the world") {
  Scene<S, 3, Sphere, Obb> scene;
  const auto ball = *scene.add(Ball{{S::max(), S(5000), S(0)}, S(3000)});
  // The ray leaves the range of coordinates before it reaches the ball.
  const Ray<S, 3> ray{at(30000, -10, 0), *normalize(at(5, 9, 0))};
  REQUIRE(raycast(ray, *scene.shape<Ball>(ball)));
  CHECK(scene.nearest(ray)->id == ball);
  CHECK(scene.nearest(at(-32768, -32768, -32768)) == Found<S>{S::max(), ball});
}
