// SPDX-License-Identifier: MIT
// Bodies that roll and slide over terrain: each contact of a triangle, judged by the oracle.
#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "detent/scene/height_field.hpp"
#include "detent/scene/mesh.hpp"
#include "detent/scene/mesh/contact.hpp"
#include "oracle/contact_answer.hpp"
#include "oracle/describe.hpp"
#include "oracle/draw.hpp"
#include "query/raycast/helpers.hpp"
#include "scene/mesh_helpers.hpp"

namespace detent::test {
namespace {

using oracle::Integer;
using S = q16_16;
using Ground = std::vector<Triangle<S, 3>>;

S raw_number(std::int64_t raw) { return S::from_raw(static_cast<S::raw_type>(raw)); }

/// All triangles of a surface, in the order of their indices.
template <class Surface>
Ground triangles_of(const Surface& surface) {
  std::map<std::uint32_t, Triangle<S, 3>> sorted;
  const Aabb<S, 3> all{filled<S, 3>(S::lowest()), filled<S, 3>(S::max())};
  visit_within(surface, all, [&](auto parts) {
    for (const auto& part : parts) sorted.emplace(part.index, part.triangle);
    return Walk::go_on;
  });
  Ground result;
  for (const auto& [index, triangle] : sorted) result.push_back(triangle);
  return result;
}

oracle::Vector<3> normal_of(const Triangle<S, 3>& t) {
  const auto a = oracle::raw(t.a);
  return oracle::cross(oracle::difference(oracle::raw(t.b), a),
                       oracle::difference(oracle::raw(t.c), a));
}

/// The length of the translation along `normal` that lifts a shape above the plane of a triangle,
/// rounded up.
template <class Shape>
Integer lift(const Triangle<S, 3>& t, const oracle::Vector<3>& normal, const Shape& shape) {
  const auto& core = detail::core_of(shape);
  using Core = std::remove_cvref_t<decltype(core)>;
  // A box in the grid of its axes.
  Integer depth, under = 1;
  if constexpr (detail::is_kind<Core, Obb>) {
    under = oracle::one_of<S>();
    depth =
        oracle::dot(normal, oracle::difference(oracle::raw(t.a), oracle::raw(core.center))) * under;
    for (int i = 0; i < 3; ++i) {
      const Integer along = oracle::dot(normal, oracle::widen(oracle::raw(core.rotation.axis(i))));
      depth += abs(Integer(along * oracle::raw(core.half_extents[i])));
    }
  } else if constexpr (detail::is_kind<Core, Segment>) {
    depth =
        std::max(oracle::dot(normal, oracle::difference(oracle::raw(t.a), oracle::raw(core.start))),
                 oracle::dot(normal, oracle::difference(oracle::raw(t.a), oracle::raw(core.end))));
  } else {
    depth = oracle::dot(normal, oracle::difference(oracle::raw(t.a), oracle::raw(core)));
  }
  // The root of depth^2 / (normal^2 under^2), rounded toward plus infinity.
  const Integer squared = depth * depth, whole = oracle::dot(normal, normal) * under * under;
  Integer length = sqrt(Integer(squared / whole));
  if (depth > 0 && length * length * whole < squared) ++length;
  return oracle::raw(S(detail::radius_of(shape))) + (depth < 0 ? Integer(-length) : length);
}

struct Counts {
  int least = 0, lifted = 0, deferred = 0, places = 0;
};

/// Each triangle that the shape touches has either the least translation off it, or the least one
/// along its own normal, or another triangle counts instead.
template <class Surface, class Shape>
void check_contacts(const Surface& surface, const Ground& ground, const Shape& shape, Facing facing,
                    Counts& counts) {
  std::array<MeshContact<S>, 64> room;
  const auto count = contacts(surface, shape, std::span(room), facing);
  REQUIRE(count <= room.size());
  const auto found = std::span(room).first(count);
  const auto box = bounding_box(shape);
  std::size_t touched = 0, next = 0;
  INFO((facing == Facing::front ? "front " : "both ") << oracle::describe(shape));
  for (std::size_t i = 0; i < ground.size(); ++i) {
    const bool is_found = next < count && found[next].triangle == i;
    const auto& triangle = ground[i];
    if (!is_found && !overlaps(box, bounding_box(triangle))) continue;
    const auto truth = oracle::least_push(oracle::exact(triangle), oracle::exact(shape));
    touched += truth.has_value();
    if (!is_found) {
      counts.deferred += truth.has_value();
      continue;
    }
    const auto& contact = found[next++].contact;
    INFO(oracle::describe(triangle));
    REQUIRE(truth);
    const auto up = normal_of(triangle);
    const auto given = oracle::widen(oracle::raw(contact.normal));
    if (facing == Facing::front) CHECK(oracle::dot(given, up) > 0);
    CHECK(contact.count > 0);
    if (oracle::is_contact<S, 3>(contact, truth)) {
      ++counts.least;
      continue;
    }
    ++counts.lifted;
    const auto down = oracle::negated(up);
    const bool is_up = oracle::is_unit_along(contact.normal, up);
    REQUIRE((is_up || (facing == Facing::both && oracle::is_unit_along(contact.normal, down))));
    CHECK(oracle::raw(contact.depth) == lift(triangle, is_up ? up : down, shape));
    CHECK(oracle::raw(contact.depth) >= truth->depth);
  }
  CHECK(next == count);
  CHECK((count > 0) == (touched > 0));
  counts.places += count > 0;
}

/// Visits a ball, a capsule and a box as they roll along a line, `depth` raw units below touching
/// flat ground at the height of the line.
template <class Visit>
void roll(oracle::Draw<S, 3>& draw, const Vec<S, 3>& from, const Vec<S, 3>& step, int count,
          std::int64_t size, const Visit& visit) {
  auto at = from;
  for (int k = 0; k < count; ++k) {
    const auto rotation = draw.rotation();
    visit(Sphere<S, 3>{at, raw_number(size)});
    const auto half = rotation.axis(0).vec() * raw_number(size);
    visit(Capsule<S, 3>{nearest_to<S>(at - half), nearest_to<S>(at + half), raw_number(size / 2)});
    visit(Obb<S, 3>{at, {raw_number(size), raw_number(size / 2), raw_number(size)}, rotation});
    at = nearest_to<S>(at + step);
  }
}

constexpr std::uint32_t side = 7;  // vertices
constexpr std::int64_t cell = 2 << 16;

/// Flat ground is exact on the grid, whatever its slope.
template <class Height>
std::vector<S> heights_of(const Height& height) {
  std::vector<S> heights;
  for (std::uint32_t j = 0; j < side; ++j) {
    for (std::uint32_t i = 0; i < side; ++i) heights.push_back(raw_number(height(i, j)));
  }
  return heights;
}

/// Calls check(surface, triangles, facing) for a height field and for a mesh of its triangles, with
/// one side and with both.
template <class Check>
void with_surfaces(const Vec<S, 2>& corner, const std::vector<S>& heights, const Check& check) {
  const auto field =
      height_field(corner, raw_number(cell), side, side, std::span<const S>(heights));
  REQUIRE(field);
  const auto ground = triangles_of(*field);
  REQUIRE(ground.size() == 2 * (side - 1) * (side - 1));
  check(*field, ground, Facing::front);
  const auto owned = mesh_of(ground);
  const auto mesh = owned.view();
  check(mesh, triangles_of(mesh), Facing::front);
  check(mesh, triangles_of(mesh), Facing::both);
}

TEST_CASE("terrain contacts: bodies that roll over tessellated planes meet only their normals",
          "[mesh][oracle]") {
  oracle::Draw<S, 3> draw(0x7e44);
  CAPTURE(draw.random.seed());
  constexpr std::int64_t far = (std::int64_t{1} << 31) - 8 * cell;
  int met = 0;
  for (const std::int64_t corner : {std::int64_t{-6} << 16, -far, far - 8 * cell}) {
    for (const auto& slope : {std::array<std::int64_t, 2>{0, 0}, {3 << 13, -5 << 12}}) {
      const auto x = slope[0], z = slope[1];
      const auto height = [&](std::int64_t i, std::int64_t j) { return i * x + j * z; };
      const auto heights = heights_of(height);
      const Vec<S, 2> at{raw_number(corner), raw_number(corner)};
      with_surfaces(at, heights, [&](const auto& surface, const Ground& ground, Facing facing) {
        const auto up = normal_of(ground.front());
        // From one inner vertex to another, across cells and along their diagonals.
        const std::int64_t above = 3 << 14;
        const Vec<S, 3> from{raw_number(corner + cell), raw_number(height(1, 1) + above),
                             raw_number(corner + 2 * cell)};
        const Vec<S, 3> step{raw_number(cell / 4), raw_number((x + z / 2) / 4),
                             raw_number(cell / 8)};
        roll(draw, from, step, 12, 1 << 16, [&](const auto& shape) {
          std::array<MeshContact<S>, 64> found;
          const auto count = contacts(surface, shape, std::span(found), facing);
          REQUIRE(count <= found.size());
          INFO((facing == Facing::front ? "front " : "both ") << oracle::describe(shape));
          for (std::size_t k = 0; k < count; ++k) {
            INFO("normal " << oracle::describe(found[k].contact.normal) << " depth "
                           << found[k].contact.depth.raw() << " of "
                           << oracle::describe(ground[found[k].triangle]));
            // A face with two sides may push down what is partly below it.
            const bool may_sink =
                facing == Facing::both &&
                lift(ground.front(), up, shape) > oracle::raw(S(detail::radius_of(shape)));
            const auto& normal = found[k].contact.normal;
            CHECK((oracle::is_unit_along(normal, up) ||
                   (may_sink && oracle::is_unit_along(normal, oracle::negated(up)))));
          }
          met += count > 0;
        });
      });
    }
  }
  CHECK(met > 400);
}

TEST_CASE("terrain contacts: bodies on rough ground get the least translation off each triangle",
          "[mesh][oracle]") {
  oracle::Draw<S, 3> draw(0x7e45);
  CAPTURE(draw.random.seed());
  Counts counts;
  const auto heights =
      heights_of([&](auto...) { return draw.random.between(-cell / 2, cell / 2); });
  const Vec<S, 2> corner{raw_number(-6 << 16), raw_number(-6 << 16)};
  with_surfaces(corner, heights, [&](const auto& surface, const Ground& ground, Facing facing) {
    // Above the ground, in it, and mostly below it.
    for (const std::int64_t height : {3 << 15, 1 << 14, -(1 << 15)}) {
      const Vec<S, 3> from{raw_number(-4 << 16), raw_number(height), raw_number(-3 << 16)};
      const Vec<S, 3> step{raw_number(5 << 15), S(0), raw_number(3 << 14)};
      roll(draw, from, step, 4, 1 << 16,
           [&](const auto& shape) { check_contacts(surface, ground, shape, facing, counts); });
    }
  });
  CAPTURE(counts.least, counts.lifted, counts.deferred, counts.places);
  CHECK(counts.least > 50);
  CHECK(counts.lifted > 50);
  CHECK(counts.deferred > 20);
  CHECK(counts.places > 60);
}

TEST_CASE("terrain contacts: a shape that is entirely below the ground has no contact", "[mesh]") {
  oracle::Draw<S, 3> draw(0x7e46);
  const auto heights = heights_of([&](auto...) { return draw.random.between(0, cell); });
  const Vec<S, 2> corner{raw_number(-6 << 16), raw_number(-6 << 16)};
  with_surfaces(corner, heights, [&](const auto& surface, const Ground&, Facing facing) {
    const Vec<S, 3> from{raw_number(-4 << 16), raw_number(-2 << 16), raw_number(-3 << 16)};
    roll(draw, from, {raw_number(1 << 16), S(0), S(0)}, 8, 1 << 16, [&](const auto& shape) {
      std::array<MeshContact<S>, 4> found;
      CHECK(contacts(surface, shape, std::span(found), facing) == 0);
    });
  });
}

}  // namespace
}  // namespace detent::test
