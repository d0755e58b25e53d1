// SPDX-License-Identifier: MIT
#include "unions.hpp"

namespace detent::test_c {

TEST_CASE("C lists of shapes: the bits are those of C++, in 3D") { check_unions<3>(32, 200); }

TEST_CASE("C lists of shapes: wrong handles, contexts and kinds are errors in any position") {
  detent_context context{}, closed{};
  REQUIRE(detent_open(&context, nullptr) == DETENT_OK);
  const detent_vec3 points[4] = {{0, 0, 0}, {65536, 0, 0}, {0, 65536, 0}, {0, 0, 65536}};
  detent_handle hull = 0, scene = 0;
  REQUIRE(detent_hull3_create(&context, 1, points, 4, &hull) == DETENT_OK);
  REQUIRE(detent_scene3_create(&context, &scene) == DETENT_OK);
  const detent_ray3 ray{{-65536, 0, 0}, {1 << 30, 0, 0}, 65536 * 9};
  detent_shape3 list[2]{};
  list[0].kind = DETENT_SPHERE;
  list[1].kind = DETENT_HULL;
  list[1].asset = hull;
  list[1].as.placed.scale = 65536;
  for (int i = 0; i < 3; ++i) {
    auto& axis = list[1].as.placed.rotation.axis[i];
    (i == 0 ? axis.x : i == 1 ? axis.y : axis.z) = 1 << 30;
  }
  const detent_vec3 inside{1000, 1000, 1000};
  const detent_sweep3 still{{}, {}, list[1].as.placed.rotation, list[1].as.placed.rotation};
  detent_vec3 a{}, b{};
  std::int32_t distance = 0;
  // Every function that takes this list, in each position.
  const auto check = [&](const detent_context* with, detent_status status) {
    const auto& last = list[1];
    CHECK(detent_shapes3_raycast(with, &ray, list, 2, nullptr) == status);
    CHECK(detent_shapes3_contains(with, list, 2, &inside) == status);
    CHECK(detent_shapes3_overlaps(with, list, 1, list, 2) == status);
    CHECK(detent_shapes3_overlaps(with, list, 2, list, 1) == status);
    CHECK(detent_shapes3_closest_point(with, list, 2, &inside, &a) == status);
    CHECK(detent_shapes3_distance_to_point(with, list, 2, &inside, &distance) == status);
    CHECK(detent_shapes3_distance(with, list, 2, list, 2, &distance) == status);
    CHECK(detent_shapes3_closest_points(with, list, 2, list, 2, &a, &b) == status);
    CHECK(detent_shapes3_cast(with, &last, &ray.direction, 1, list, 2, nullptr) == status);
    CHECK(detent_shapes3_cast(with, list, &ray.direction, 1, list, 2, nullptr) == status);
    CHECK(detent_shapes3_contact(with, &last, list, nullptr) == status);
    CHECK(detent_shapes3_contact(with, list, &last, nullptr) == status);
    CHECK(detent_shapes3_time_of_impact(with, &last, &still, list, nullptr, 8, nullptr) == status);
  };
  check(&context, DETENT_OK);
  check(nullptr, DETENT_BAD_CONTEXT);
  check(&closed, DETENT_BAD_CONTEXT);
  for (const detent_handle wrong : {detent_handle{0}, scene, hull + 32}) {
    list[1].asset = wrong;
    check(&context, DETENT_BAD_HANDLE);
  }
  list[1].asset = hull;
  list[1].as.placed.rotation.axis[0].x = 1;
  check(&context, DETENT_NOT_UNIT);
  list[1].kind = DETENT_MESH;
  check(&context, DETENT_NO_QUERY);
  list[1].kind = 77;
  check(&context, DETENT_BAD_ARGUMENT);
  CHECK(detent_shapes3_raycast(&context, &ray, nullptr, 1, nullptr) == DETENT_BAD_ARGUMENT);
  CHECK(detent_shapes3_raycast(nullptr, nullptr, list, 1, nullptr) == DETENT_BAD_ARGUMENT);
  CHECK(detent_shapes3_raycast(nullptr, &ray, list, 1, nullptr) == DETENT_OK);
  CHECK(detent_shapes3_contains(nullptr, nullptr, 0, nullptr) == DETENT_BAD_ARGUMENT);
  CHECK(detent_shapes3_contains(nullptr, nullptr, 0, &inside) == DETENT_NO);
  CHECK(detent_shapes3_closest_points(nullptr, list, 1, list, 1, nullptr, &b) ==
        DETENT_BAD_ARGUMENT);
  list[1].kind = DETENT_PLANE;  // a plane cannot move
  list[1].as.plane.normal = {0, 1 << 30, 0};
  CHECK(detent_shapes3_cast(nullptr, &list[1], &ray.direction, 1, list, 1, nullptr) ==
        DETENT_NO_QUERY);
  const detent_ray3 bent{};
  CHECK(detent_ray3_contains(&bent, &inside) == DETENT_NOT_UNIT);
  CHECK(detent_ray3_closest_point(&ray, &inside, nullptr) == DETENT_BAD_ARGUMENT);
  CHECK(detent_ray3_distance_to_point(nullptr, &inside, &distance) == DETENT_BAD_ARGUMENT);
  REQUIRE(detent_close(&context) == DETENT_OK);
}

}  // namespace detent::test_c
