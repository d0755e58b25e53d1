// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

#include "detent/scene/height_field.hpp"
#include "detent/scene/hull.hpp"
#include "detent/scene/mesh.hpp"
#include "detent/scene/mesh/owned.hpp"
#include "detent/scene/mover.hpp"
#include "support/catch.hpp"

namespace detent::test {

/// Random shapes, a mesh and terrain around the origin, in raw units.
template <Scalar S>
class Arena {
 public:
  static constexpr std::int64_t unit = std::int64_t{1} << S::frac;
  using World = Scene<S, 3, Sphere, Aabb, Obb, Plane, HullInstance, MeshInstance, FieldInstance>;

  explicit Arena(std::uint64_t seed) : random(seed) {
    const std::uint32_t side = 12;
    const auto rough = random.between(0, unit);
    for (std::uint32_t i = 0; i < side * side; ++i) {
      heights_.push_back(number(random.between(-rough, rough) - 3 * unit));
    }
    const auto view = height_field<S>({number(-11 * unit), number(-11 * unit)}, number(2 * unit),
                                      side, side, heights_);
    REQUIRE(view.has_value());
    field_ = FieldAsset<S>(1, *view);
    std::vector<Triangle<S, 3>> triangles;
    for (int i = 0; i < 12; ++i) {
      const auto a = point(5 * unit);
      triangles.push_back({a, beside(a), beside(a)});
    }
    owned_ = OwnedMesh<S>(triangles);
    mesh_ = MeshAsset<S>(2, owned_.view());
    for (int i = 0; i < 8; ++i) points_.push_back(point(unit));
    hull_ = hull_asset<S, 3>(3, ConvexHull<S, 3>{points_}).value_or(HullAsset<S, 3>());
    world.add(PlacedField<S>{&field_});
    world.add(PlacedMesh<S>{&mesh_});
    const auto count = random.between(5, 30);
    for (int i = 0; i < count; ++i) add_shape();
  }

  S number(std::int64_t raw) const { return S::from_raw(static_cast<typename S::raw_type>(raw)); }
  Vec<S, 3> vec(std::int64_t x, std::int64_t y, std::int64_t z) const {
    return {number(x), number(y), number(z)};
  }
  Vec<S, 3> point(std::int64_t reach) {
    return vec(random.between(-reach, reach), random.between(-reach, reach),
               random.between(-reach, reach));
  }
  Vec<S, 3> beside(const Vec<S, 3>& a) { return nearest_to<S>(a + point(2 * unit)); }
  S length() { return number(random.between(unit / 20, 3 * unit / 2)); }
  Direction<S, 3> direction() {
    return direction_of<S>(point(unit)).value_or(Direction<S, 3>::along(0));
  }
  /// A move of any length, sometimes many times the size of the arena.
  Vec<S, 3> move() {
    return random.one_in(8)    ? point(20)
           : random.one_in(10) ? point(15 * unit)
                               : point(random.coin() ? unit / 8 : unit / 3);
  }
  /// A move towards somewhere in the middle, falling or not.
  Vec<S, 3> move_from(const Vec<S, 3>& at) {
    auto by = random.one_in(3)
                  ? move()
                  : nearest_to<S>((point(4 * unit) - at) * number(unit >> random.below(5)));
    if (random.coin()) by.y = nearest_to<S>(by.y - number(unit / 8));
    return by;
  }

  template <template <class, int> class Shape>
  Shape<S, 3> character() {
    const auto at = point(6 * unit);
    const auto radius = number(random.between(unit / 8, unit / 2));
    if constexpr (std::is_same_v<Shape<S, 3>, Sphere<S, 3>>) {
      return {at, radius};
    } else if constexpr (std::is_same_v<Shape<S, 3>, Capsule<S, 3>>) {
      const auto end = random.coin() ? nearest_to<S>(at + vec(0, unit, 0)) : beside(at);
      return {at, end, radius};
    } else {
      return {at, nearest_to<S>(at + Vec<S, 3>{length(), length(), length()})};
    }
  }

  Random random;
  World world;

 private:
  void add_shape() {
    const auto at = point(6 * unit);
    switch (random.below(4)) {
      case 0:
        world.add(Sphere<S, 3>{at, length()});
        break;
      case 1:
        world.add(Aabb<S, 3>{at, nearest_to<S>(at + Vec<S, 3>{length(), length(), length()})});
        break;
      case 2:
        world.add(Obb<S, 3>{
            at,
            {length(), length(), length()},
            Rotation<S, 3>::from_axis_angle(
                direction(), Angle<S>::from_raw(static_cast<std::uint32_t>(random.next())))});
        break;
      default:
        world.add(PlacedHull<S, 3>{&hull_, {.translation = at}});
    }
  }

  std::vector<S> heights_;
  std::vector<Vec<S, 3>> points_;
  HullAsset<S, 3> hull_;
  FieldAsset<S> field_;
  OwnedMesh<S> owned_;
  MeshAsset<S> mesh_;
};

struct Tally {
  HitRate touched, grounded;
  long pushed = 0, stuck = 0;
};

/// Moves characters through random arenas. Checks that none ends in a new overlap, and that
/// repeating a move gives the same result.
template <Scalar S, template <class, int> class Shape>
void explore(std::uint64_t seed, int moves, Tally& tally) {
  Arena<S> arena(seed);
  auto& random = arena.random;
  Mover<S, 3, Shape> mover{};
  MoverSettings<S, 3> settings;
  Vec<S, 3> by;
  bool touched = false;
  for (int i = 0; i < moves; ++i) {
    CAPTURE(seed, i);
    if (i % 20 == 0) {
      mover = {arena.template character<Shape>()};
      settings.step_height = random.coin() ? S(0) : arena.number(random.between(0, arena.unit));
      settings.snap_distance = random.coin() ? S(0) : arena.number(random.between(0, arena.unit));
    }
    if (random.one_in(6)) by = arena.move_from(bounding_box(mover.shape).min);
    const auto before = mover;
    const auto result = mover.move(arena.world, by, settings);
    bool was_free = true;
    arena.world.for_each([&](const ObjectInfo& object, const auto& shape) {
      if (overlaps(before.shape, shape)) {
        was_free = false;
      } else if (overlaps(mover.shape, shape)) {
        CAPTURE(object.id.index);
        FAIL("the character overlaps what it did not overlap before");
      }
    });
    if (was_free && result.is_stuck) FAIL("a free character is stuck");
    auto again = before;
    if (again.move(arena.world, by, settings) != result || again != mover) {
      FAIL("the same move again has another result");
    }
    touched = touched || result.count > 0;
    if (i % 4 == 3) tally.touched.count(std::exchange(touched, false));
    tally.grounded.count(mover.ground.is_grounded);
    tally.pushed += result.pushed == Vec<S, 3>{} ? 0 : 1;
    tally.stuck += result.is_stuck ? 1 : 0;
  }
}

template <Scalar S, template <class, int> class Shape>
void explore_all(int scenes, int moves) {
  Tally tally;
  for (int i = 0; i < scenes; ++i) explore<S, Shape>(static_cast<std::uint64_t>(i), moves, tally);
  INFO("touched " << tally.touched << ", grounded " << tally.grounded << ", pushed " << tally.pushed
                  << ", stuck " << tally.stuck);
  CHECK(tally.touched.is_balanced());
  CHECK(tally.grounded.percent() >= 5);
  CHECK(tally.pushed > 0);
}

}  // namespace detent::test
