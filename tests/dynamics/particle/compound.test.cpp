// SPDX-License-Identifier: MIT
#include <array>
#include <vector>

#include "detent/dynamics/dynamics.hpp"
#include "detent/dynamics/particle/world.hpp"
#include "dynamics/stage.hpp"
#include "support/catch.hpp"

namespace detent::test {

TEST_CASE("particles: a compound is an obstacle part by part, except its sensors") {
  using S = q16_16;
  PartOptions<S> sensor;
  sensor.is_sensor = true;
  sensor.density = {};
  const std::array parts{BodyPart(Sphere<S, 2>{at<S, 2>(-2, 0), S(1)}),
                         BodyPart(box_of<S, 2>(2, 0, 1, 0.5)),
                         BodyPart(Sphere<S, 2>{at<S, 2>(0, 0), S(4)}, sensor)};
  const auto solid = solid_compound(1, parts).value();
  World<S, 2, Sphere, Obb, BodyCompound> world;
  BodyOptions<S, 2> fixed;
  fixed.motion = BodyMotion::fixed;
  const auto quarter = Rotation<S, 2>::from_angle(Angle<S>::turn(1, 4));
  const auto id = world.add(BodyCompound<S, 2>{&solid, at<S, 2>(5, 3), quarter}, fixed);
  REQUIRE(id);
  const auto obstacles = obstacles_of(world);
  const auto seen_in = [&](const Aabb<S, 2>& box) {
    std::vector<Aabb<S, 2>> boxes;
    obstacles(box, [&](const auto& shape) { boxes.push_back(bounding_box(shape)); });
    return boxes;
  };
  const auto close = [](const Vec<S, 2>& p, double x, double y) {
    return distance(p, at<S, 2>(x, y)) < num<S>(0.001);
  };
  const auto all = seen_in({at<S, 2>(0, -9), at<S, 2>(9, 9)});
  REQUIRE(all.size() == 2);
  CHECK(close(all[0].min, 4, 0));  // a quarter turn maps -2 along x to -2 along y
  CHECK(close(all[0].max, 6, 2));
  CHECK(close(all[1].min, 4.5, 4));
  CHECK(close(all[1].max, 5.5, 6));
  CHECK(seen_in({at<S, 2>(4, 5), at<S, 2>(6, 6)}).size() == 1);
  CHECK(seen_in({at<S, 2>(6.5, 0), at<S, 2>(9, 6)}).empty());
}

}  // namespace detent::test
