// SPDX-License-Identifier: MIT
#include "movers.hpp"

namespace detent::test_c {

TEST_CASE("C movers: a walk gives the bits of C++, in 2D") { check_walk(person<2>()); }
TEST_CASE("C movers: a walking box gives the bits of C++, in 2D") { check_walk(crate<2>()); }

TEST_CASE("C movers: wrong numbers and handles are errors") {
  detent_context context{};
  detent_handle scene = 0;
  REQUIRE(detent_open(&context, nullptr) == DETENT_OK);
  REQUIRE(detent_scene2_create(&context, &scene) == DETENT_OK);
  detent_mover2 mover{};
  mover.shape.kind = DETENT_CAPSULE;
  const detent_vec2 by{one, 0};
  CHECK(detent_mover2_move(&context, 7, &mover, &by, nullptr, 1, {}, nullptr) == DETENT_BAD_HANDLE);
  CHECK(detent_mover2_move(&context, scene, nullptr, &by, nullptr, 1, {}, nullptr) ==
        DETENT_BAD_ARGUMENT);
  CHECK(detent_mover2_move(&context, scene, &mover, &by, nullptr, 1, {}, nullptr) == DETENT_OK);
  CHECK(mover.shape.as.capsule.a.x == one);
  for (const unsigned shape : {DETENT_SPHERE, DETENT_OBB, DETENT_COMPOUND}) {
    mover.shape.kind = shape;
    CHECK(detent_mover2_move(&context, scene, &mover, &by, nullptr, 1, {}, nullptr) ==
          DETENT_NO_QUERY);
  }
  mover.shape.kind = 0;
  CHECK(detent_mover2_move(&context, scene, &mover, &by, nullptr, 1, {}, nullptr) ==
        DETENT_BAD_ARGUMENT);
  mover.shape.kind = DETENT_CAPSULE;
  mover.is_grounded = 1;
  mover.normal = {};
  CHECK(detent_mover2_move(&context, scene, &mover, &by, nullptr, 1, {}, nullptr) ==
        DETENT_NOT_UNIT);
  detent_move2 result{};
  result.count = 9;
  detent_vec2 clipped{};
  CHECK(detent_mover2_clip_velocity(&by, &result, &clipped) == DETENT_BAD_ARGUMENT);
  detent_shape2 box{};
  box.kind = DETENT_TRIANGLE;
  const detent_direction2 right{1 << 30, 0};
  CHECK(detent_scene2_cast(&context, scene, &box, &right, one, 1, nullptr) == DETENT_NO_QUERY);
  box.kind = DETENT_OBB;
  CHECK(detent_scene2_cast(&context, scene, &box, &right, one, 1, nullptr) == DETENT_NOT_UNIT);
  std::uint32_t count = 0;
  box.kind = DETENT_AABB;
  CHECK(detent_scene2_cast_all(&context, scene, &box, &right, one, 1, nullptr, 0, nullptr) ==
        DETENT_BAD_ARGUMENT);
  CHECK(detent_scene2_cast_all(&context, scene, &box, &right, one, 1, nullptr, 0, &count) ==
        DETENT_OK);
  CHECK(detent_scene2_cast_any(&context, scene, &box, nullptr, one, 1) == DETENT_BAD_ARGUMENT);
  CHECK(detent_scene2_cast_any(&context, scene, &box, &right, one, 1) == DETENT_NO);
  box.kind = 99;
  CHECK(detent_scene2_cast(&context, scene, &box, &right, one, 1, nullptr) == DETENT_BAD_ARGUMENT);
  CHECK(detent_close(&context) == DETENT_OK);
}

}  // namespace detent::test_c
