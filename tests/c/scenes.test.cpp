// SPDX-License-Identifier: MIT
//
// Scenes of the C interface in 3D, and the lives of their assets.

#include <algorithm>
#include <span>

#include "scene_twins.hpp"

namespace detent::test_c {
namespace {

using Out = c::Output<3>;
using Twins = SceneTwins<3>;

TEST_CASE("C scenes: histories give the bits of C++") { check_history<3>(7, 4); }

TEST_CASE("C scenes: an object is returned as it was added, for every kind") {
  Twins twins;
  const detent_traits traits{77, 6, DETENT_FIXED, {}};
  for (std::uint64_t kind = 0; kind < twins.kinds; ++kind) {
    CAPTURE(kind);
    twins.with_shape(kind, at<3>(3, 4, 5), [&](const detent_shape3& shape, const auto&) {
      detent_id id{};
      REQUIRE(detent_scene3_add(&twins.context, twins.scene, &shape, &traits, &id) == DETENT_OK);
      detent_shape3 same{};
      detent_traits with{};
      REQUIRE(detent_scene3_object(&twins.context, twins.scene, id, &same, &with) == DETENT_OK);
      CHECK(same.kind == shape.kind);
      CHECK(same.asset == shape.asset);
      const auto bytes = std::as_bytes(std::span(&shape, 1)),
                 read = std::as_bytes(std::span(&same, 1));
      CHECK(std::equal(bytes.begin(), bytes.end(), read.begin()));
      CHECK((with.user == 77 && with.layers == 6 && with.motion == DETENT_FIXED));
    });
  }
  std::uint32_t size = 0;
  CHECK(detent_scene3_size(&twins.context, twins.scene, &size) == DETENT_OK);
  CHECK(size == twins.kinds);
}

TEST_CASE("C scenes: frames move their contents") {
  Twins twins;
  const auto quarter =
      Rotation<S, 3>::from_axis_angle(Direction<S, 3>::along(1), Angle<S>::turn(1, 4));
  const Transform<S, 3> first{at<3>(3 * one, 0, one), quarter, S(1)};
  const Transform<S, 3> second{at<3>(0, one), {}, S(2)};
  auto [frame, child, id] = check_frames(twins, first, second);
  auto* const context = &twins.context;
  const auto scene = twins.scene;
  detent_shape3 ball{};
  ball.kind = DETENT_SPHERE;
  const detent_traits lost{0, 1, DETENT_MOVING, {9, 9}}, fixed{0, 1, DETENT_FIXED, frame};
  CHECK(detent_scene3_add(context, scene, &ball, &lost, &id) == DETENT_NO);
  CHECK(detent_scene3_add(context, scene, &ball, &fixed, &id) == DETENT_BAD_ARGUMENT);
  auto outer = Out::transform(first);
  CHECK(detent_scene3_add_frame(context, scene, &outer, {9, 9}, &child) == DETENT_NO);
  outer.rotation.axis[1].y = 0;
  CHECK(detent_scene3_move_frame(context, scene, frame, &outer) == DETENT_NOT_UNIT);
}

TEST_CASE("C scenes: an asset in use stays, and is found again by a snapshot") {
  Twins twins;
  detent_id id{};
  twins.with_shape(7, at<3>(0, 0), [&](const detent_shape3& shape, const auto&) {
    REQUIRE(detent_scene3_add(&twins.context, twins.scene, &shape, nullptr, &id) == DETENT_OK);
  });
  CHECK(detent_asset_destroy(&twins.context, twins.surfaces.mesh) == DETENT_IN_USE);
  CHECK(detent_asset_destroy(&twins.context, twins.hull) == DETENT_OK);
  CHECK(detent_asset_destroy(&twins.context, twins.hull) == DETENT_BAD_HANDLE);
  const auto saved = twins.saved();
  CHECK(detent_scene3_remove(&twins.context, twins.scene, id) == DETENT_OK);
  CHECK(twins.restore(saved) == DETENT_OK);
  CHECK(detent_asset_destroy(&twins.context, twins.surfaces.mesh) == DETENT_IN_USE);
  CHECK(detent_scene3_remove(&twins.context, twins.scene, id) == DETENT_OK);
  CHECK(detent_asset_destroy(&twins.context, twins.surfaces.mesh) == DETENT_OK);
  CHECK(twins.restore(saved) == DETENT_UNKNOWN_ASSET);
  const detent_vec3 vertices[3] = {{0, 0, 0}, {one, 0, 0}, {0, one, 0}};
  const std::uint32_t face[3] = {0, 1, 2}, wrong[3] = {0, 1, 3};
  detent_handle other = 0;
  CHECK(detent_mesh_create(&twins.context, 8, vertices, 3, wrong, 1, &other) ==
        DETENT_BAD_ARGUMENT);
  CHECK(detent_mesh_create(&twins.context, 8, vertices, 3, face, 1, &other) == DETENT_OK);
  CHECK(detent_mesh_create(&twins.context, 8, vertices, 3, face, 1, &other) == DETENT_IN_USE);
  CHECK(twins.restore(saved) == DETENT_OTHER_ASSET);
}

}  // namespace
}  // namespace detent::test_c
