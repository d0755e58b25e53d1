// SPDX-License-Identifier: MIT
// Which triangles of a surface have contacts, and which defer to others: judged by the oracle.
#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "detent/scene/height_field.hpp"
#include "detent/scene/mesh.hpp"
#include "detent/scene/mesh/placed.hpp"
#include "oracle/seeds.hpp"
#include "scene/contact_exam.hpp"
#include "scene/mesh_helpers.hpp"
#include "support/shapes.hpp"

namespace detent::test {
namespace {

using S = q16_16;
using Draw = oracle::Draw<S, 3>;
using Raw = oracle::Raw<3>;
using Triangles = std::vector<Triangle<S, 3>>;

/// A setting for shapes around `target` that touch several triangles of a surface of this reach.
oracle::Setting<3> setting_at(Draw& draw, const Raw& target, std::int64_t reach) {
  auto setting = oracle::draw_setting(draw, oracle::Kind::general, 1);
  setting.center = target;
  setting.size = std::max<std::int64_t>(reach / 4, 2);
  setting.spread = std::max<std::int64_t>(reach / 16, 1);
  return setting;
}

/// Examines a shape of every kind, at settings made by draw_setting().
template <class Surface, class DrawSetting>
void examine_shapes(Draw& draw, const Surface& surface, Facing facing,
                    const DrawSetting& draw_setting, ContactCounts& counts) {
  const auto faces = faces_of(surface);
  support::MovingShapes<S, 3>::for_each([&]<class Shape>(const Shape&) {
    const auto shape = oracle::draw_shape<Shape>(draw, draw_setting());
    examine_contacts(surface, faces, shape, facing, counts);
  });
}

/// Runs sweep(seed, counts), which has to see contacts of every kind.
template <class Sweep>
void check_sweep(std::uint64_t seed, const Sweep& sweep) {
  CAPTURE(seed);
  ContactCounts counts;
  sweep(seed, counts);
  CAPTURE(counts.least, counts.face, counts.deferred, counts.places);
  CHECK(counts.least > 10);
  CHECK(counts.face > 10);
  CHECK(counts.deferred > 10);
  CHECK(counts.places > 10);
}

/// A closed solid with the front outside: an octahedron, each face of which is split into n * n
/// triangles. Its corners are moved by up to `rough`.
Triangles solid(Draw& draw, const Raw& center, std::int64_t radius, std::int64_t n,
                std::int64_t rough) {
  std::map<Raw, Vec<S, 3>> corners;
  const auto corner = [&](const Raw& steps) {
    const auto [place, is_new] = corners.try_emplace(steps);
    if (is_new) place->second = draw.vec(draw.near(Draw::plus(center, steps, radius / n), rough));
    return place->second;
  };
  Triangles triangles;
  for (unsigned octant = 0; octant < 8; ++octant) {
    const auto at = [&](std::int64_t i, std::int64_t j) {
      const std::array<std::int64_t, 3> k{i, j, n - i - j};
      Raw steps{};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        steps[axis] = (octant >> axis & 1) != 0 ? k[axis] : -k[axis];
      }
      return corner(steps);
    };
    // The front is outside.
    const bool is_mirrored = octant == 0 || octant == 3 || octant == 5 || octant == 6;
    const auto add = [&](const Vec<S, 3>& a, const Vec<S, 3>& b, const Vec<S, 3>& c) {
      triangles.push_back(is_mirrored ? Triangle{a, c, b} : Triangle{a, b, c});
    };
    for (std::int64_t i = 0; i < n; ++i) {
      for (std::int64_t j = 0; i + j < n; ++j) {
        add(at(i, j), at(i + 1, j), at(i, j + 1));
        if (i + j + 2 <= n) add(at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
      }
    }
  }
  return triangles;
}

void sweep_meshes(std::uint64_t seed, ContactCounts& counts) {
  for_meshes<S>(seed, 2, 5, [&](auto kind, const auto& triangles, auto reach, auto& draw) {
    const auto owned = mesh_of(triangles);
    const auto mesh = owned.view();
    const auto setting = [&] {
      return kind == MeshKind::extreme
                 ? oracle::draw_setting(draw, oracle::Kind::extreme, 1)
                 : setting_at(draw, draw_target(draw, triangles, reach), reach);
    };
    for (const auto facing : {Facing::both, Facing::front}) {
      examine_shapes(draw, mesh, facing, setting, counts);
    }
  });
}

void sweep_solids(std::uint64_t seed, ContactCounts& counts) {
  Draw draw(seed);
  for (const std::int64_t n : {1, 3}) {
    for (const std::int64_t radius : {std::int64_t{24}, std::int64_t{3} << 16, Draw::limit / 2}) {
      const auto rough = draw.random.coin() ? 0 : radius / n / 3;
      const auto away = Draw::limit - radius - rough;
      const auto triangles =
          solid(draw, draw.random.coin() ? Raw{} : Raw{away, -away, away}, radius, n, rough);
      const auto owned = mesh_of(triangles);
      const auto mesh = owned.view();
      const auto setting = [&] {
        return setting_at(draw, draw_target(draw, triangles, radius), radius);
      };
      for (const auto facing : {Facing::both, Facing::front}) {
        examine_shapes(draw, mesh, facing, setting, counts);
      }
    }
  }
}

void sweep_fields(std::uint64_t seed, ContactCounts& counts) {
  Draw draw(seed);
  constexpr std::uint32_t side = 5;  // samples
  for (int round = 0; round < 5; ++round) {
    const auto cell = std::int64_t{1} << draw.random.between(4, 28);
    // Few heights, so that some triangles are coplanar.
    const auto step = draw.random.between(0, cell / 4);
    std::vector<S> heights;
    for (std::uint32_t i = 0; i < side * side; ++i) {
      heights.push_back(draw.scalar(step * draw.random.between(-1, 1)));
    }
    const auto at_an_end = [&] {
      return draw.random.coin() ? -cell * 2 : Draw::limit - cell * (side - 1);
    };
    const auto x = at_an_end(), z = at_an_end();
    const auto field = height_field(Vec<S, 2>{draw.scalar(x), draw.scalar(z)}, draw.scalar(cell),
                                    side, side, std::span<const S>(heights));
    REQUIRE(field);
    const auto setting = [&] {
      const auto along = [&] { return draw.random.between(cell, cell * 3); };
      return setting_at(draw, {x + along(), draw.random.between(0, cell / 2), z + along()},
                        4 * cell);
    };
    examine_shapes(draw, *field, Facing::front, setting, counts);
  }
}

void sweep_placed_meshes(std::uint64_t seed, ContactCounts& counts) {
  Draw draw(seed);
  constexpr std::int64_t radius = 3 << 16;
  const auto triangles = solid(draw, {}, radius, 2, 1 << 14);
  const auto owned = mesh_of(triangles);
  const MeshAsset<S> asset(1, owned.view());
  for (int round = 0; round < 30; ++round) {
    Transform<S, 3> transform;
    transform.translation = draw.vec(draw.point(Draw::limit - 2 * radius));
    transform.rotation = draw.rotation();
    const PlacedMesh<S> mesh{&asset, transform};
    auto world = triangles;
    for (auto& triangle : world) triangle = placed(transform, triangle);
    const auto setting = setting_at(draw, draw_target(draw, world, radius), radius);
    const auto facing = draw.random.coin() ? Facing::both : Facing::front;
    examine_contacts(mesh, faces_of(mesh), oracle::draw_shape<Capsule<S, 3>>(draw, setting), facing,
                     counts);
  }
}

TEST_CASE("inner edges: triangles of every kind of mesh defer to those of the rule",
          "[mesh][oracle]") {
  check_sweep(0xed6e, sweep_meshes);
}

TEST_CASE("inner edges: triangles of closed solids defer to those of the rule", "[mesh][oracle]") {
  check_sweep(0xed6f, sweep_solids);
}

TEST_CASE("inner edges: triangles of height fields defer to those of the rule", "[mesh][oracle]") {
  check_sweep(0xed70, sweep_fields);
}

TEST_CASE("inner edges: triangles of placed meshes defer to those of the rule", "[mesh][oracle]") {
  check_sweep(0xed71, sweep_placed_meshes);
}

TEST_CASE("inner edges: a collapsed triangle does not rise", "[mesh][oracle]") {
  const auto at = [](int x, int y, int z) { return Vec<S, 3>{S(x), S(y), S(z)}; };
  const Triangle<S, 3> flat{at(0, 0, 0), at(-4, 0, -2), at(-4, 0, 2)};
  const auto owned = mesh_of<S>({flat, {at(0, 0, 0), at(4, 2, 0), at(4, 2, 0)}});
  const auto mesh = owned.view();
  const Sphere<S, 3> ball{at(2, 1, 0), S(3)};
  for (const auto facing : {Facing::both, Facing::front}) {
    std::array<MeshContact<S>, 2> found;
    REQUIRE(contacts(mesh, ball, std::span(found), facing) == 2);
    CHECK(found[0].contact == contact(flat, ball));
    ContactCounts counts;
    examine_contacts(mesh, faces_of(mesh), ball, facing, counts);
  }
}

TEST_CASE("inner edges: a collapsed triangle on an inner edge gives way", "[mesh][oracle]") {
  const auto at = [](int x, int y, int z) { return Vec<S, 3>{S(x), S(y), S(z)}; };
  const Triangles floor{{at(0, 0, -8), at(-8, 0, 0), at(0, 0, 8)},
                        {at(0, 0, 8), at(8, 0, 0), at(0, 0, -8)}};
  // A segment, and three points in a row.
  for (const auto& middle : {at(0, 0, 8), at(0, 0, 2)}) {
    auto triangles = floor;
    triangles.push_back({at(0, 0, -8), middle, at(0, 0, 8)});
    const auto owned = mesh_of(triangles);
    const auto mesh = owned.view();
    const Sphere<S, 3> ball{{S::from_raw(1 << 14), S::from_raw(15 << 12), S(0)}, S(1)};
    for (const auto facing : {Facing::both, Facing::front}) {
      std::array<MeshContact<S>, 3> found;
      REQUIRE(contacts(mesh, ball, std::span(found), facing) == 1);
      CHECK(found[0].contact.normal == Direction<S, 3>::along(1));
      ContactCounts counts;
      examine_contacts(mesh, faces_of(mesh), ball, facing, counts);
    }
    // Alone, it pushes.
    const auto wire = mesh_of<S>({triangles.back()});
    std::array<MeshContact<S>, 1> found;
    REQUIRE(contacts(wire.view(), ball, std::span(found), Facing::front) == 1);
    CHECK(found[0].contact == contact(triangles.back(), ball));
  }
}

TEST_CASE("inner edges: what is level with a face of two sides leaves it to the nearer one",
          "[mesh]") {
  const auto at = [](int x, int y, int z) { return Vec<S, 3>{S(x), S(y), S(z)}; };
  const auto owned = mesh_of<S>(
      {{at(0, 0, -4), at(0, 0, 4), at(-4, 0, 0)}, {at(0, 0, 4), at(0, 0, -4), at(4, 0, 0)}});
  const auto mesh = owned.view();
  // Each triangle would push such a post sideways over their edge. Their front is below.
  for (const int up : {-8, 0, 8}) {
    const Aabb<S, 3> post{{S(-1), S(std::min(0, up) - 2), S(-1)},
                          {S(1), S(std::max(0, up) + 2), S(1)}};
    std::array<MeshContact<S>, 2> found;
    REQUIRE(contacts(mesh, post, std::span(found), Facing::both) == 1);
    CHECK(found[0].triangle == 0);
    CHECK(found[0].contact.depth == S(2));
    CHECK(found[0].contact.normal[1] == (up > 0 ? 1 : -1));
  }
}

TEST_CASE("inner edges: what stands on its tip in ground of two sides is lifted", "[mesh]") {
  Triangles ground;
  for (int i = -4; i < 4; ++i) {
    for (int j = -4; j < 4; ++j) {
      const auto at = [&](int x, int z) { return Vec<S, 3>{S(i + x), S(0), S(j + z)}; };
      ground.push_back({at(0, 0), at(0, 1), at(1, 0)});
      ground.push_back({at(1, 0), at(0, 1), at(1, 1)});
    }
  }
  const auto owned = mesh_of(ground);
  const auto mesh = owned.view();
  // It would leave the face under its tip sideways and slightly down.
  const S depth = S::from_raw(1 << 10);
  const Triangle<S, 3> blade{
      {S::from_raw(13 << 11), S::from_raw(-(1 << 10)), S::from_raw(-(27 << 10))},
      {S::from_raw(1 << 12), S(1), S(0)},
      {S(1), S::from_raw(1 << 14), S::from_raw(1 << 13)}};
  std::array<MeshContact<S>, 8> found;
  REQUIRE(contacts(mesh, blade, std::span(found), Facing::both) == 1);
  CHECK(found[0].contact.depth == depth);
  CHECK(found[0].contact.normal[1] == 1);
}

TEST_CASE("inner edges: many more triangles defer to those of the rule",
          "[mesh][oracle][.demand]") {
  for (const auto seed : oracle::demanded_seeds()) {
    for (std::uint64_t k = 0; k < 20; ++k) {
      check_sweep(seed + k, sweep_meshes);
      check_sweep(seed + k, sweep_solids);
      check_sweep(seed + k, sweep_fields);
      check_sweep(seed + k, sweep_placed_meshes);
    }
  }
}

}  // namespace
}  // namespace detent::test
