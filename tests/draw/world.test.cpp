// SPDX-License-Identifier: MIT
#include "detent/draw/world.hpp"

#include <cstddef>
#include <vector>

#include "draw/sheet.hpp"
#include "dynamics/zoo.hpp"
#include "support/catch.hpp"

namespace detent::test {
namespace {

using S = q16_16;

template <class Lines>
bool are_equal(const Lines& a, const Lines& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!(a[i].a == b[i].a && a[i].b == b[i].b && a[i].colour == b[i].colour)) return false;
  }
  return true;
}

}  // namespace

TEMPLATE_TEST_CASE("draw: draws every body of a world, and leaves the world unchanged", "[draw]",
                   Dim<2>, Dim<3>) {
  constexpr int N = TestType::value;
  Zoo<S, N> zoo(5);
  for (int round = 0; round < 8; ++round) zoo.live();
  const auto& world = zoo.world;
  const auto before = digest(world);
  const ColourByState colours{.awake = {1, 1, 1}};
  Sheet<S, N> sheet, expected;
  draw(sheet, world, colours);
  world.for_each([&](const BodyInfo& body, const auto& shape) {
    draw(expected, shape, colours(body, shape));
  });
  CHECK(sheet.lines.size() > 100);
  CHECK(are_equal(sheet.lines, expected.lines));
  CHECK(digest(world) == before);
  if constexpr (N == 3) {
    draw_solid(sheet, world, colours);
    world.for_each([&](const BodyInfo& body, const auto& shape) {
      draw_solid(expected, shape, colours(body, shape));
    });
    CHECK(sheet.faces.size() > 100);
    CHECK(are_equal(sheet.faces, expected.faces));
  }
}

TEST_CASE("draw: colours bodies by their state, or as the objects of a scene", "[draw]") {
  World<S, 2, Obb> world;
  const Obb<S, 2> box{{}, {S(1), S(1)}, {}};
  world.add(box, {.motion = BodyMotion::fixed});
  world.add(Obb<S, 2>{{S(0), S(2)}, {S(1), S(1)}, {}});
  world.add(Obb<S, 2>{{S(50), S(2)}, {S(1), S(1)}, {}});
  world.add(box, {.motion = BodyMotion::kinematic});
  world.add(box, {.motion = BodyMotion::fixed, .is_sensor = true});
  for (int tick = 0; tick < 60; ++tick) world.step();
  REQUIRE(world.is_asleep({1, 2}));
  const ColourByState by_state;
  Sheet<S, 2> sheet;
  draw(sheet, world);
  REQUIRE(sheet.lines.size() == 20);
  CHECK(sheet.lines[0].colour == by_state.fixed);
  CHECK(sheet.lines[4].colour == by_state.asleep);
  CHECK(sheet.lines[8].colour == by_state.awake);
  CHECK(sheet.lines[12].colour == by_state.kinematic);
  CHECK(sheet.lines[16].colour == by_state.sensor);

  draw(sheet, world, ColourByMotion{});
  CHECK(sheet.lines[20].colour == ColourByMotion().fixed);
  CHECK(sheet.lines[24].colour == ColourByMotion().moving);
  draw(sheet, world, ColourByKind());
  CHECK(sheet.lines[40].colour == palette_colour(detail::shape_tag<Obb<S, 2>>));
  draw(sheet, world, [](const BodyInfo& body, const auto&) {
    return Colour{static_cast<std::uint8_t>(body.id.index), 0, 0};
  });
  CHECK(sheet.lines[79].colour == Colour{4, 0, 0});
}

TEST_CASE("draw: draws no hull without points", "[draw]") {
  World<S, 3, BodyHull, BodyCompound, BodyMesh, BodyHeightField> world;
  world.add(BodyHull<S, 3>{});
  world.add(BodyCompound<S, 3>{});
  world.add(BodyMesh<S, 3>{});
  world.add(BodyHeightField<S, 3>{});
  Sheet<S, 3> sheet;
  draw(sheet, world);
  draw_solid(sheet, world);
  CHECK(sheet.is_blank());
}

}  // namespace detent::test
