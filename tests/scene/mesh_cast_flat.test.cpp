// SPDX-License-Identifier: MIT
#include "scene/mesh_casts.hpp"

namespace detent::test {
namespace {

TEST_CASE("mesh: a polytope first touches the triangle found by a loop over all", "[mesh]") {
  compare_casts_at_meshes<false, q16_16>(0xca59, 6);
}

TEST_CASE("mesh: the far end of a box that starts beyond the range counts", "[mesh]") {
  using S = q16_16;
  // From (29000, 0) it extends to (49500, 20500) and moves to the left.
  const auto turn =
      Rotation<S, 3>::from_axis_angle(toward<S, 3>(0, 0, 1), Angle<S>::from_degrees(num<S>(45)));
  const Obb<S, 3> rod{at<S, 3>(29000), at<S, 3>(29000, 100, 100), turn};
  const std::array post{
      Triangle{at<S, 3>(26000, 16000), at<S, 3>(26001, 16000), at<S, 3>(26000, 16001)}};
  const OwnedMesh<S> owned{std::span<const Triangle<S, 3>>(post)};
  const auto left = toward<S, 3>(-1);
  const auto distance = detail::cast_distance(rod, left, num<S>(32000), post[0]);
  REQUIRE(distance);
  CHECK(*distance > num<S>(18000));
  CHECK(cast_nearest(rod, left, num<S>(32000), owned.view()) == MeshHit<S>{*distance, 0});
}

}  // namespace
}  // namespace detent::test
