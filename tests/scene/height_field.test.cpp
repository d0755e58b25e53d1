// SPDX-License-Identifier: MIT
#include "detent/scene/height_field.hpp"

#include <algorithm>
#include <vector>

#include "detent/scene/mesh.hpp"
#include "query/raycast/helpers.hpp"
#include "scene/mesh_helpers.hpp"

namespace detent::test {
namespace {

/// A field with its samples: flat, rough or of random bits.
template <Scalar S>
struct Terrain {
  std::vector<S> heights;
  std::uint32_t columns, rows;
  S cell;
  Vec<S, 2> corner;
  std::int64_t
      reach;  // the field's extent from its center, which is the origin if it fits the scalar

  explicit Terrain(oracle::Draw<S, 3>& draw) {
    auto& random = draw.random;
    columns = static_cast<std::uint32_t>(random.between(2, random.coin() ? 4 : 20));
    rows = static_cast<std::uint32_t>(random.between(2, random.coin() ? 4 : 20));
    const auto side = std::int64_t{std::max(columns, rows)};
    const auto step = random.between(1, std::int64_t{1} << random.between(1, S::bits - 6));
    cell = draw.scalar(step);
    corner = {draw.scalar(-step * columns / 2), draw.scalar(-step * rows / 2)};
    reach = step * side / 2 + 1;
    const auto rough = random.below(4);
    const auto height = random.between(-reach, reach) / 4;
    for (std::uint32_t i = 0; i < columns * rows; ++i) {
      heights.push_back(rough == 0   ? draw.scalar(height)
                        : rough == 1 ? draw.scalar(random.between(-step, step) / 2)
                        : rough == 2 ? draw.scalar(random.between(-reach, reach) / 2)
                                     : draw.scalar(draw.extreme()));
    }
  }
  [[nodiscard]] HeightField<S> field() const {
    return *height_field<S>(corner, cell, columns, rows, heights);
  }
};

template <Scalar S>
std::vector<Triangle<S, 3>> triangles_of(const HeightField<S>& field) {
  std::vector<Triangle<S, 3>> triangles;
  for (std::uint32_t row = 0; row + 1 < field.rows; ++row) {
    for (std::uint32_t column = 0; column + 1 < field.columns; ++column) {
      for (const auto& part : cell_triangles(field, column, row)) {
        REQUIRE(part.index == triangles.size());
        triangles.push_back(part.triangle);
      }
    }
  }
  return triangles;
}

TEMPLATE_TEST_CASE("height field: results equal those of the mesh of its triangles",
                   "[height_field]", q16_16, q8_8) {
  using S = TestType;
  oracle::Draw<S, 3> draw(0x7e44a);
  auto& random = draw.random;
  HitRate rays, shapes;
  INFO("seed " << random.seed());
  for (int i = 0; i < 150; ++i) {
    const Terrain<S> terrain(draw);
    const auto field = terrain.field();
    const auto triangles = triangles_of(field);
    const OwnedMesh<S> owned{std::span<const Triangle<S, 3>>(triangles)};
    const auto mesh = owned.view();
    REQUIRE(bounding_box(field) == bounding_box(mesh));
    for (int k = 0; k < 20; ++k) {
      auto ray = draw_mesh_ray(draw, triangles, MeshKind::soup, terrain.reach);
      if (random.one_in(4)) ray.direction = toward<S, 3>(0, random.coin() ? 1 : -1, 0);
      const auto hit = raycast_nearest(ray, field);
      rays.count(hit.has_value());
      REQUIRE(hit == raycast_nearest(ray, mesh));
      REQUIRE(raycast_any(ray, field) == hit.has_value());
      REQUIRE(raycast_hit(ray, field) == raycast_hit(ray, mesh));
      std::array<MeshHit<S>, 3> few{}, same{};
      REQUIRE(raycast_all(ray, field, std::span<MeshHit<S>>(few)) ==
              raycast_all(ray, mesh, std::span<MeshHit<S>>(same)));
      REQUIRE(few == same);
    }
    for (int k = 0; k < 5; ++k) {
      const auto target = draw_target(draw, triangles, terrain.reach);
      const auto center = draw.vec(target);
      const auto other = draw.vec(draw.near(target, terrain.reach / 4));
      const Sphere sphere{center, draw.scalar(random.between(-2, terrain.reach / 3))};
      shapes.count(overlaps(field, sphere));
      REQUIRE(overlaps(sphere, field) == overlaps(sphere, mesh));
      const Aabb box{center, other};
      REQUIRE(overlaps(field, box) == overlaps(mesh, box));
      std::array<std::uint32_t, 4> few{}, same{};
      REQUIRE(overlaps_all(field, box, std::span<std::uint32_t>(few)) ==
              overlaps_all(mesh, box, std::span<std::uint32_t>(same)));
      REQUIRE(few == same);
      const Segment segment{center, other};
      REQUIRE(intersects(segment, field) == intersects(segment, mesh));
      REQUIRE(nearest_triangle(field, other) == nearest_triangle(mesh, other));
      REQUIRE(contains(field, center) == contains(mesh, center));
      const auto normal = draw.any_direction();
      const Plane<S, 3> plane{normal, nearest_to<S>(dot(normal, other))};
      REQUIRE(overlaps(field, plane) == overlaps(mesh, plane));
      const std::array part{Triangle{center, other, other}};
      const OwnedMesh<S> small{std::span<const Triangle<S, 3>>(part)};
      REQUIRE(overlaps(field, small.view()) == overlaps(mesh, small.view()));
      REQUIRE(overlaps(small.view(), field) == overlaps(small.view(), mesh));
    }
    REQUIRE(overlaps(field, field));
    REQUIRE(overlaps(field, mesh));
  }
  INFO(rays << ", " << shapes);
  CHECK(rays.is_balanced());
  CHECK(shapes.is_balanced());
}

TEMPLATE_TEST_CASE("height field: its triangles face up and meet at the samples", "[height_field]",
                   q16_16, q8_8, float, double) {
  using S = TestType;
  const std::array heights{num<S>(0), num<S>(1), num<S>(2), num<S>(0), num<S>(1), num<S>(5)};
  const auto field =
      *height_field<S>({num<S>(10), num<S>(-4)}, num<S>(2), 3, 2, std::span(heights));
  CHECK(field_point(field, 2, 1) == at<S, 3>(14, 5, -2));
  const auto cell = cell_triangles(field, 1, 0);
  CHECK(cell[0].index == 2);
  CHECK(cell[1].triangle ==
        Triangle{at<S, 3>(14, 2, -4), at<S, 3>(12, 1, -2), at<S, 3>(14, 5, -2)});
  const Ray down{at<S, 3>(13, 20, -4), toward<S, 3>(0, -1, 0)};
  const auto hit = raycast_hit(down, field);
  REQUIRE(hit);
  CHECK(hit->point == at<S, 3>(13, 1.5, -4));
  CHECK(hit->normal.vec().y > 0);
  CHECK(raycast(down, cell[0].triangle, Facing::front));
}

TEMPLATE_TEST_CASE("height field: samples without a cell are refused", "[height_field]", q16_16,
                   q24_8) {
  using S = TestType;
  const std::array<S, 6> heights{};
  const auto make = [&](S cell, std::uint32_t columns, std::uint32_t rows, S start) {
    return height_field<S>({start, num<S>(0)}, cell, columns, rows, std::span(heights)).has_value();
  };
  const auto one = num<S>(1), origin = num<S>(0);
  CHECK(make(one, 3, 2, origin));
  CHECK(make(one, 2, 3, origin));
  CHECK_FALSE(make(one, 6, 1, origin));
  CHECK_FALSE(make(one, 1, 6, origin));
  CHECK_FALSE(make(one, 2, 2, origin));
  CHECK_FALSE(make(origin, 3, 2, origin));
  CHECK_FALSE(make(num<S>(-1), 3, 2, origin));
  CHECK_FALSE(make(one, 0x80000001, 0x80000006, origin));
  // The last column may be at the end of the range, but not one step beyond.
  const auto step = S::from_raw(1);
  CHECK(make(step, 3, 2, moved(S::max(), -2)));
  CHECK_FALSE(make(step, 3, 2, moved(S::max(), -1)));
  CHECK_FALSE(raycast_any(Ray<S, 3>{Vec<S, 3>(), toward<S, 3>(1)}, HeightField<S>()));
  CHECK_FALSE(overlaps(HeightField<S>(), Sphere{Vec<S, 3>(), one}));
}

}  // namespace
}  // namespace detent::test
