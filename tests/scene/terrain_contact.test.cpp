// SPDX-License-Identifier: MIT
// Bodies that roll and slide over terrain: each contact of a triangle, judged by the oracle.
#include <array>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <vector>

#include "detent/scene/height_field.hpp"
#include "detent/scene/mesh.hpp"
#include "scene/contact_exam.hpp"
#include "scene/mesh_helpers.hpp"

namespace detent::test {
namespace {

using S = q16_16;
using Draw = oracle::Draw<S, 3>;

constexpr std::uint32_t side = 7;  // vertices
constexpr std::int64_t cell = 2 << 16;

/// Visits make(at) for a shape of every kind about `at`, of up to a size and in any orientation.
template <class Visit>
void visit_bodies(Draw& draw, std::int64_t size, const Visit& visit) {
  const auto length = [&] { return draw.scalar(draw.random.between(size / 8, size)); };
  const auto away = [&] { return draw.vec(draw.point(size)); };
  const auto plus = [](const Vec<S, 3>& a, const Vec<S, 3>& b) { return nearest_to<S>(a + b); };
  const auto radius = length();
  const Vec half{length(), length(), length()};
  const auto rotation = draw.rotation();
  const std::array corners{away(), away(), away(), away(), away()};
  visit([&](const auto& at) { return Sphere<S, 3>{at, radius}; });
  visit([&](const auto& at) {
    return Capsule<S, 3>{plus(at, corners[0]), plus(at, corners[1]), radius};
  });
  visit([&](const auto& at) { return Aabb<S, 3>{nearest_to<S>(at - half), plus(at, half)}; });
  visit([&](const auto& at) { return Obb<S, 3>{at, half, rotation}; });
  visit([&](const auto& at) {
    return Triangle<S, 3>{plus(at, corners[0]), plus(at, corners[1]), plus(at, corners[2])};
  });
  std::array<Vec<S, 3>, corners.size()> points;
  visit([&](const auto& at) {
    for (std::size_t i = 0; i < points.size(); ++i) points[i] = plus(at, corners[i]);
    return ConvexHull<S, 3>{points};
  });
}

template <class Height>
std::vector<S> heights_of(const Height& height) {
  std::vector<S> heights;
  for (std::uint32_t j = 0; j < side; ++j) {
    for (std::uint32_t i = 0; i < side; ++i) heights.push_back(Draw::scalar(height(i, j)));
  }
  return heights;
}

/// Calls check(surface, facing) for a height field and for a mesh of its triangles, with one side
/// and with both.
template <class Check>
void with_surfaces(std::int64_t corner, const std::vector<S>& heights, const Check& check) {
  const auto field = height_field(Vec<S, 2>{Draw::scalar(corner), Draw::scalar(corner)},
                                  Draw::scalar(cell), side, side, std::span<const S>(heights));
  REQUIRE(field);
  check(*field, Facing::front);
  std::vector<Triangle<S, 3>> triangles;
  visit_within(*field, bounding_box(*field), [&](auto parts) {
    for (const auto& part : parts) triangles.push_back(part.triangle);
    return Walk::go_on;
  });
  REQUIRE(triangles.size() == 2 * (side - 1) * (side - 1));
  const auto owned = mesh_of(triangles);
  const auto mesh = owned.view();
  check(mesh, Facing::front);
  check(mesh, Facing::both);
}

/// Ground with a slope, whose heights are exact on the grid.
struct Slope {
  std::int64_t corner, x, z;

  [[nodiscard]] std::int64_t height(std::int64_t i, std::int64_t j) const { return i * x + j * z; }
  /// A point of the ground, in steps of 1 / 16 of a cell.
  [[nodiscard]] oracle::Raw<3> at(std::int64_t i, std::int64_t j) const {
    return {corner + i * cell / 16, height(i, j) / 16, corner + j * cell / 16};
  }
  [[nodiscard]] oracle::Raw<3> up() const { return {-x, cell, -z}; }
  /// Whether edges of cells rise along a normal by no more than twice its rounding.
  [[nodiscard]] bool is_level_along(const Direction<S, 3>& normal) const {
    for (const auto& edge : {oracle::Raw<3>{cell, x, 0}, {0, z, cell}}) {
      const auto rise = oracle::dot(oracle::widen(oracle::raw(normal)), oracle::widen(edge));
      if (abs(rise) > std::abs(edge[0]) + std::abs(edge[1]) + std::abs(edge[2])) return false;
    }
    return normal[1] > 0;
  }
};

/// How deep a shape is behind the plane of a slope.
template <class Shape>
std::int64_t depth_behind(const Slope& slope, const Shape& shape) {
  return static_cast<std::int64_t>(oracle::lift_above(
      oracle::widen(slope.up()), oracle::widen(slope.at(0, 0)), oracle::exact(shape)));
}

TEST_CASE("terrain contacts: bodies that roll over tessellated planes meet only their normals",
          "[mesh][oracle]") {
  Draw draw(0x7e44);
  CAPTURE(draw.random.seed());
  int met = 0;
  for (const std::int64_t corner : {std::int64_t{-6} << 16, -Draw::limit, Draw::limit - 6 * cell}) {
    for (const auto& slope : {Slope{corner, 0, 0}, {corner, 3 << 13, -5 << 12}}) {
      const auto heights = heights_of([&](auto i, auto j) { return slope.height(i, j); });
      const auto down = oracle::negated(oracle::widen(slope.up()));
      const auto upward = draw.towards({}, slope.up());
      with_surfaces(corner, heights, [&](const auto& surface, Facing facing) {
        const auto check = [&]<class Shape>(const Shape& shape, bool is_shallow) {
          std::array<MeshContact<S>, 64> found;
          const auto count = contacts(surface, shape, std::span(found), facing);
          REQUIRE(count <= found.size());
          INFO((facing == Facing::front ? "front " : "both ") << oracle::describe(shape));
          // A face with two sides may push down what is deep in it.
          const bool may_sink = facing == Facing::both && !is_shallow;
          for (std::size_t k = 0; k < count; ++k) {
            const auto& normal = found[k].contact.normal;
            INFO("normal " << oracle::describe(normal) << " of triangle " << found[k].triangle);
            CHECK((slope.is_level_along(normal) ||
                   (may_sink && oracle::is_unit_along(normal, down))));
          }
          met += count > 0;
        };
        for (int k = 0; k < 8; ++k) {
          const bool is_shallow = k % 2 == 0;
          const auto depth = draw.random.between(0, cell / (is_shallow ? 64 : 4));
          const auto spot = slope.at(draw.random.between(32, 64), draw.random.between(32, 64));
          visit_bodies(draw, cell * 3 / 4, [&](const auto& make) {
            const auto lift = depth_behind(slope, make(draw.vec(spot))) - depth;
            check(make(draw.vec(draw.moved(spot, upward, lift))), is_shallow);
          });
        }
      });
    }
  }
  CAPTURE(met);
  CHECK(met > 400);
}

TEST_CASE("terrain contacts: bodies on rough ground get those of the rule", "[mesh][oracle]") {
  Draw draw(0x7e45);
  CAPTURE(draw.random.seed());
  ContactCounts counts;
  constexpr std::int64_t corner = -6 << 16;
  const auto heights =
      heights_of([&](auto...) { return draw.random.between(-cell / 2, cell / 2); });
  with_surfaces(corner, heights, [&](const auto& surface, Facing facing) {
    const auto faces = faces_of(surface);
    // Above the ground, in it, and mostly below it.
    for (const std::int64_t height : {3 << 15, 1 << 14, -(1 << 15)}) {
      for (int k = 0; k < 4; ++k) {
        const auto along = [&] { return draw.random.between(-cell * 2, cell * 2); };
        const oracle::Raw<3> at{along(), height, along()};
        visit_bodies(draw, 1 << 16, [&](const auto& make) {
          examine_contacts(surface, faces, make(draw.vec(at)), facing, counts);
        });
      }
    }
  });
  CAPTURE(counts.least, counts.face, counts.deferred, counts.places);
  CHECK(counts.least > 50);
  CHECK(counts.face > 50);
  CHECK(counts.deferred > 20);
  CHECK(counts.places > 60);
}

TEST_CASE("terrain contacts: a shape that is entirely below the ground has no contact", "[mesh]") {
  Draw draw(0x7e46);
  CAPTURE(draw.random.seed());
  const auto heights = heights_of([&](auto...) { return draw.random.between(0, cell); });
  with_surfaces(-6 << 16, heights, [&](const auto& surface, Facing facing) {
    for (int k = 0; k < 8; ++k) {
      const auto along = [&] { return draw.random.between(-cell * 2, cell * 2); };
      const oracle::Raw<3> at{along(), -5 << 15, along()};
      visit_bodies(draw, 1 << 16, [&](const auto& make) {
        std::array<MeshContact<S>, 4> found;
        CHECK(contacts(surface, make(draw.vec(at)), std::span(found), facing) == 0);
      });
    }
  });
}

}  // namespace
}  // namespace detent::test
