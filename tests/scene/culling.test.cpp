// SPDX-License-Identifier: MIT
#include <vector>

#include "detent/number/text.hpp"
#include "detent/scene/scene.hpp"
#include "support/catch.hpp"

using namespace detent;

namespace {

using S = q16_16;
using V = Vec<S, 2>;

/// Axes with a cosine just below 2^-10: as skewed as an `Obb` can be without counting as unbounded.
Rotation<S, 2> skewed() {
  return Rotation<S, 2>::from_axes({Direction<S, 2>::along(0), *normalize(V{S(1), S(1100)})});
}

}  // namespace

TEST_CASE("scene: a skewed box extends beyond its edges by a fraction of its longest side") {
  Scene<S, 2, Obb> scene;
  // |x| <= 1000 and |y + x / 1100| <= 1: at x = -999 up to y = 1.9.
  const Obb<S, 2> plank{{}, {S(1000), S(1)}, skewed()};
  const V point{S(-999), *S::parse("1.8")};
  REQUIRE(contains(plank, point));
  REQUIRE(scene.add(plank));
  CHECK(scene.any(point));
}

TEST_CASE("scene: the distance of a skewed box is less in its own frame") {
  Scene<S, 2, Obb, Sphere> scene;
  const Obb<S, 2> speck{{}, {}, skewed()};
  const V point{S(700), S(-700)};
  // 989.95 away; 989.63 in the frame of the box.
  const Sphere<S, 2> ball{{S(700), *S::parse("289.8")}, S(0)};
  REQUIRE(distance(speck, point) < distance(ball, point));
  REQUIRE(distance(ball, point) < distance(V{}, point));
  REQUIRE(scene.add(ball));
  const auto id = scene.add(speck);
  const auto nearest = scene.nearest(point);
  REQUIRE(nearest);
  CHECK(nearest->id == *id);
}

TEST_CASE("scene: an object that moves slightly beyond its neighbours is found there") {
  using Ball = Sphere<S, 2>;
  Scene<S, 2, Sphere> scene;
  std::vector<ObjectId> ids;
  std::vector<V> centers;
  for (int i = 0; i < 40; ++i) {
    centers.push_back({S(i % 8 * 4), S(i / 8 * 4)});
    ids.push_back(scene.add(Ball{centers.back(), S(1)}).value());
  }
  for (std::size_t i = 0; i < ids.size(); ++i) {
    for (int axis = 0; axis < 2; ++axis) {
      for (const int sign : {-1, 1}) {
        V there = centers[i], tip = centers[i];
        there[axis] += 2 * sign;
        tip[axis] += 3 * sign;
        REQUIRE(scene.replace(ids[i], Ball{there, S(1)}));
        CHECK(scene.any(tip));
        REQUIRE(scene.replace(ids[i], Ball{centers[i], S(1)}));
      }
    }
  }
}

TEST_CASE("scene: a removed frame differs from the next one at its index") {
  Scene<S, 2, Sphere> scene;
  const auto gone = scene.add_frame({}).value();
  REQUIRE(scene.remove_frame(gone));
  const auto next = scene.add_frame({}).value();
  REQUIRE(next.index == gone.index);
  CHECK(scene.move_frame(next, {}));
  CHECK_FALSE(scene.move_frame(gone, {}));
  CHECK_FALSE(scene.add_frame({}, gone));
}
