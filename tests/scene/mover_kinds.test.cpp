// SPDX-License-Identifier: MIT
//
// Movers of shapes other than a capsule, and at the ends of the range.

#include "scene/mover_level.hpp"

using namespace detent;
using test::Level;

TEMPLATE_TEST_CASE("mover: a box and a sphere climb stairs and stop at walls", "", q16_16) {
  using S = TestType;
  Level<S> level;
  level.floor();
  for (int i = 0; i < 4; ++i) {
    level.box(level.at(100 + 40 * i, 0, -200), level.at(1000, 25 * (i + 1), 200));
  }
  level.box(level.at(400, 0, -500), level.at(500, 500, 500));
  Mover<S, 3, Aabb> box{{level.at(-30, 2, -30), level.at(30, 170, 30)}};
  Mover<S, 3, Sphere> ball{{level.at(0, 42, 0), level.number(40)}};
  for (int i = 0; i < 120; ++i) {
    box.move(level.world, level.at(5, -4, 1));
    ball.move(level.world, level.at(5, -4, 1));
    CHECK_FALSE(level.world.any(box.shape));
    CHECK_FALSE(level.world.any(ball.shape));
  }
  CHECK(double(box.shape.min.y) == Approx(1 + 1.0 / 64).margin(1e-3));
  CHECK(double(box.shape.max.x) == Approx(4 - 1.0 / 64).margin(1e-3));
  CHECK(double(box.shape.max.z) == Approx(0.3 + 1.2).margin(0.01));
  CHECK(double(ball.shape.center.y) == Approx(1.4 + 0.75 / 64).margin(0.3 / 64));
  CHECK(double(ball.shape.center.x) == Approx(3.6 - 1.0 / 64).margin(1e-3));
  CHECK(ball.ground.is_grounded);
}

TEST_CASE("mover: an empty shape passes everything, and a move stops at the end of the range") {
  using S = q16_16;
  Level<S> level;
  level.floor();
  Mover<S, 3, Sphere> nothing{{level.at(0, 100, 0), S(-1)}};
  const auto result = nothing.move(level.world, level.at(0, -300, 0));
  CHECK(result.moved == level.at(0, -300, 0));
  CHECK(result.count == 0);
  Mover<S, 3, Sphere> ball{{Vec<S, 3>{S(32000), S(100), S(0)}, S(1)}};
  for (int i = 0; i < 10; ++i) ball.move(level.world, Vec<S, 3>{S(300), S(0), S(0)});
  CHECK(ball.shape.center.x >= 32300);
  CHECK(ball.shape.center.x <= 32767);
  CHECK(ball.shape.center.y == 100);
  ball.move(level.world, Vec<S, 3>{S(-300), S(0), S(0)});
  CHECK(ball.shape.center.x <= 32300);
}
