// SPDX-License-Identifier: MIT
#include "detent/scene/mesh/cast.hpp"

#include "scene/mesh_casts.hpp"

namespace detent::test {
namespace {

TEST_CASE("mesh: a round shape first touches the triangle found by a loop over all", "[mesh]") {
  compare_casts_at_meshes<true, q16_16>(0xca57, 8);
  compare_casts_at_meshes<true, q8_8>(0xca58, 8);
}

TEST_CASE("height field: a moving ball first touches the triangle found by a loop over all",
          "[mesh]") {
  using S = q16_16;
  oracle::Draw<S, 3> draw(0xf1e1d);
  HitRate rate;
  for (int i = 0; i < 40; ++i) {
    const auto step = std::max<std::int64_t>(draw.scale() / 32, 2);
    std::vector<S> heights;
    for (int k = 0; k < 9 * 6; ++k)
      heights.push_back(draw.scalar(draw.random.between(-step, step)));
    const auto field = *height_field<S>({draw.scalar(-4 * step), draw.scalar(-3 * step)},
                                        draw.scalar(step), 9, 6, heights);
    std::vector<Triangle<S, 3>> triangles;
    for (std::uint32_t row = 0; row < 5; ++row) {
      for (std::uint32_t column = 0; column < 8; ++column) {
        for (const auto& part : cell_triangles(field, column, row)) {
          triangles.push_back(part.triangle);
        }
      }
    }
    compare_shapes<true>(field, triangles, MeshKind::soup, 4 * step, draw, rate);
    const FieldAsset<S> asset(1, field);
    const PlacedField<S> placed_field{&asset, draw.vec(draw.point(step))};
    for (auto& triangle : triangles) triangle = translated(triangle, placed_field.translation);
    compare_shapes<true>(placed_field, triangles, MeshKind::soup, 4 * step, draw, rate);
  }
  INFO(rate);
  CHECK(rate.is_balanced());
}

TEST_CASE("mesh: an empty shape touches nothing, and an empty mesh is never touched", "[mesh]") {
  using S = q16_16;
  const Mesh<S> nothing;
  const auto along = toward<S, 3>(1);
  const Sphere ball{Vec<S, 3>(), num<S>(1)};
  CHECK_FALSE(cast_nearest(ball, along, num<S>(9), nothing));
  CHECK_FALSE(cast(ball, along, num<S>(9), nothing));
  const std::array wall{Triangle{at<S, 3>(5, -9, -9), at<S, 3>(5, 9, -9), at<S, 3>(5, 0, 9)}};
  const OwnedMesh<S> owned{std::span<const Triangle<S, 3>>(wall)};
  CHECK(cast_nearest(ball, along, num<S>(9), owned.view()) == MeshHit<S>{num<S>(4), 0});
  CHECK(cast_nearest(ball, along, num<S>(4), owned.view()));
  CHECK_FALSE(cast_nearest(ball, along, num<S>(3.99), owned.view()));
  CHECK_FALSE(cast_nearest(ball, along, num<S>(-1), owned.view()));
  CHECK_FALSE(cast_nearest(Sphere{ball.center, num<S>(-1)}, along, num<S>(9), owned.view()));
}

TEST_CASE("mesh: a ball that passes over a triangle skips it, and one that touches it does not",
          "[mesh]") {
  using S = q16_16;
  const Triangle ground{at<S, 3>(0, 1, 0), at<S, 3>(0, 1, 9), at<S, 3>(9, 1, 0)};
  const auto beside = [&](double height, const Direction<S, 3>& direction) {
    const Sphere ball{at<S, 3>(0, height, 0), num<S>(2)};
    return detail::stays_beside(ball, direction, num<S>(4), ground);
  };
  const auto along = toward<S, 3>(1), up = toward<S, 3>(0, 1), down = toward<S, 3>(0, -1);
  CHECK(beside(3.01, along));
  CHECK_FALSE(beside(3, along));
  CHECK(beside(3.01, up));
  CHECK_FALSE(beside(3.01, down));
  CHECK_FALSE(beside(7, down));
  CHECK(beside(7.01, down));
  CHECK(beside(-1.01, along));
  CHECK_FALSE(beside(-1, along));
  CHECK_FALSE(beside(-1.01, up));
  CHECK(beside(-1.01, down));
  const Triangle line{at<S, 3>(0, 1, 0), at<S, 3>(0, 1, 9), at<S, 3>(0, 1, 18)};
  CHECK_FALSE(detail::stays_beside(Sphere{at<S, 3>(0, 9, 0), num<S>(1)}, along, num<S>(4), line));
}

}  // namespace
}  // namespace detent::test
