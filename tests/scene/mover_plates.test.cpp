// SPDX-License-Identifier: MIT
#include "scene/mover_arena.hpp"

namespace detent::test {
namespace {

/// The subset of the arena's shapes needed here: without meshes a mover compiles faster.
using PlateWorld = Scene<q16_16, 3, Sphere, Aabb, Obb, Plane>;

/// A plate that no character may pass, without thickness or one unit thick.
template <Scalar S>
struct Plate {
  Direction<S, 3> normal;
  Vec<S, 3> through;

  template <class World>
  std::optional<ObjectId> add_to(World& world, Arena<S>& arena) const {
    if (arena.random.coin()) {
      return world.add(Plane<S, 3>{normal, nearest_to<S>(dot(normal, through))});
    } else {
      const auto wide = S(500);
      Rotation<S, 3> turn;
      const auto side = direction_of<S>(cross(
          normal.vec(), Direction<S, 3>::along(abs(normal[0]) < abs(normal[1]) ? 0 : 1).vec()));
      turn = Rotation<S, 3>::from_axes(
          {normal, *side, direction_of<S>(cross(normal.vec(), side->vec())).value_or(*side)});
      return world.add(
          Obb<S, 3>{through, {arena.number(arena.random.between(0, 1)), wide, wide}, turn});
    }
  }
  /// 1 or -1 if the whole segment is on one side, else 0.
  int side_of(const Vec<S, 3>& a, const Vec<S, 3>& b) const {
    const auto at_a = dot(normal, a - through), at_b = dot(normal, b - through);
    return at_a > 0 && at_b > 0 ? 1 : at_a < 0 && at_b < 0 ? -1 : 0;
  }
};

}  // namespace

TEST_CASE("mover property: never passes a plate as thin as the grid") {
  using S = q16_16;
  HitRate rate;
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    Arena<S> arena(seed);
    auto& random = arena.random;
    PlateWorld world;
    const Plate<S> plate{arena.direction(), arena.point(arena.unit)};
    plate.add_to(world, arena);
    Mover<S, 3, Capsule> mover{arena.character<Capsule>()};
    if (world.any(mover.shape)) continue;
    const int side = plate.side_of(mover.shape.a, mover.shape.b);
    REQUIRE(side != 0);
    for (int i = 0; i < 30; ++i) {
      CAPTURE(seed, i);
      auto by = random.coin() ? arena.point(60 * arena.unit) : arena.move();
      if (dot(by, plate.normal) * side > 0 && random.coin()) by = nearest_to<S>(-by);
      const auto result = mover.move(world, by);
      rate.count(result.count > 0);
      REQUIRE_FALSE(world.any(mover.shape));
      REQUIRE(plate.side_of(mover.shape.a, mover.shape.b) == side);
      if (distance(mover.shape.a, Vec<S, 3>{}) > 300) break;
    }
  }
  INFO(rate);
  CHECK(rate.is_balanced());
}

namespace {

/// Characters that start inside something, near a plate that they must not pass.
void pass_no_plate(int places, int moves) {
  using S = q16_16;
  long held = 0, stopped = 0;
  for (int seed = 0; seed < places; ++seed) {
    Arena<S> arena(static_cast<std::uint64_t>(seed));
    auto& random = arena.random;
    PlateWorld world;
    Mover<S, 3, Capsule> mover{arena.character<Capsule>()};
    const Plate<S> plate{arena.direction(), nearest_to<S>(mover.shape.a + arena.point(arena.unit))};
    const auto id = plate.add_to(world, arena);
    if (world.any(mover.shape)) continue;
    const int side = plate.side_of(mover.shape.a, mover.shape.b);
    REQUIRE(side != 0);
    for (int i = 0; i < moves; ++i) {
      CAPTURE(seed, i);
      if (i % 4 == 0) {  // something else to start in
        const auto at = nearest_to<S>(mover.shape.a + arena.point(arena.unit / 2));
        if (random.coin()) {
          world.add(Sphere<S, 3>{at, arena.length()});
        } else {
          world.add(Aabb<S, 3>{
              at, nearest_to<S>(at + Vec<S, 3>{arena.length(), arena.length(), arena.length()})});
        }
      }
      auto by = random.coin() ? arena.point(60 * arena.unit) : arena.move();
      if (dot(by, plate.normal) * side > 0 && random.one_in(3)) by = nearest_to<S>(-by);
      if (world.any(mover.shape)) ++held;
      const auto result = mover.move(world, by);
      for (std::size_t k = 0; k < result.count; ++k) stopped += result.touched[k].object == id;
      REQUIRE(plate.side_of(mover.shape.a, mover.shape.b) == side);
      REQUIRE_FALSE(world.any(mover.shape, [&](const ObjectInfo& o) { return o.id == id; }));
      if (distance(mover.shape.a, Vec<S, 3>{}) > 300) break;
    }
  }
  CAPTURE(held, stopped);
  CHECK(held > places);
  CHECK(stopped > places / 4);
}

}  // namespace

TEST_CASE("mover property: does not pass a plate when it starts inside something else") {
  pass_no_plate(150, 30);
}

TEST_CASE("mover property: does not pass a plate in a million moves from anywhere", "[.demand]") {
  pass_no_plate(40000, 100);
}

TEST_CASE("mover property: advances along a wall and along the crease of two walls") {
  using S = q16_16;
  int walls = 0, creases = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    Arena<S> arena(seed);
    auto& random = arena.random;
    PlateWorld world;
    const auto m = arena.direction(), n = arena.direction();
    const auto along = direction_of<S>(cross(m.vec(), n.vec()));
    if (!along || abs(dot(m, n)) > arena.number(arena.unit * 9 / 10)) continue;
    const bool is_crease = random.coin();
    world.add(Plane<S, 3>{m, S(0)});
    if (is_crease) world.add(Plane<S, 3>{n, S(0)});
    const auto radius = arena.number(random.between(arena.unit / 8, arena.unit));
    const S off = nearest_to<S>(radius + arena.length());
    const auto start = detail::closest_on(Vec<S, 3>{}, detail::HalfSpace<S, 3>{m, off},
                                          detail::HalfSpace<S, 3>{n, off});
    REQUIRE(start);
    Mover<S, 3, Capsule> mover{{*start, *start, radius}};
    // Upward, so that it flies: steep slopes do not count as walls then.
    const auto ahead = (*along)[1] < 0 ? -*along : *along;
    const auto speed = arena.number(random.between(arena.unit / 16, arena.unit));
    auto by = ahead * speed - m * arena.length();
    if (is_crease) by -= n * arena.length();
    const auto move = nearest_to<S>(by);
    if (move.y <= 0 || ahead[1] * 4 < 1) continue;
    ++(is_crease ? creases : walls);
    for (int i = 0; i < 40; ++i) mover.move(world, move);
    CAPTURE(seed, is_crease);
    const auto moved = mover.shape.a - *start;
    const auto expected = dot(move, ahead) * 40;
    CHECK(double(dot(moved, ahead)) > 0.95 * double(expected) - 0.1);
  }
  CHECK(walls > 20);
  CHECK(creases > 20);
}

}  // namespace detent::test
