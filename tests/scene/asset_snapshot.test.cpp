// SPDX-License-Identifier: MIT
#include <array>
#include <vector>

#include "detent/scene/height_field.hpp"
#include "detent/scene/hull.hpp"
#include "detent/scene/snapshot.hpp"
#include "detent/scene/sync_test.hpp"
#include "support/catch.hpp"
#include "support/seal.hpp"

using namespace detent;
using S = q16_16;
using Vec3 = Vec<S, 3>;
using Hull = PlacedHull<S, 3>;
using Field = PlacedField<S>;
using Hulls = std::vector<HullAsset<S, 3>>;
using Fields = std::vector<FieldAsset<S>>;
using Toys = Scene<S, 3, Sphere, HullInstance, FieldInstance>;

namespace {

Vec3 at(int x, int y, int z) { return {S(x), S(y), S(z)}; }

const std::array tetrahedron{at(0, 0, 0), at(2, 0, 0), at(0, 2, 0), at(0, 0, 2)};
const std::array needle{at(0, 0, 0), at(0, 9, 0)};
const Hulls hulls{*hull_asset(7, ConvexHull{tetrahedron}), *hull_asset(9, ConvexHull{needle})};

const std::array<S, 9> hills{S(0), S(1), S(0), S(2), S(3), S(1), S(0), S(0), S(0)};
const std::array<S, 9> plain{};
const HeightField<S> hilly = *height_field<S>({S(-4), S(-4)}, S(4), 3, 3, hills);
const HeightField<S> flat = *height_field<S>({S(-4), S(-4)}, S(4), 3, 3, plain);
const Fields fields{FieldAsset(7, hilly), FieldAsset(8, flat)};

/// A ball, a moving hull, fixed terrain, another hull and field in a frame, and objects without
/// assets.
Toys toys() {
  Toys scene;
  scene.add(Sphere{at(0, 20, 0), S(1)});
  scene.add(Hull{&hulls[0], {.translation = at(5, 0, 0)}});
  scene.add(Field{&fields[0]}, {.motion = Motion::fixed});
  const auto frame = *scene.add_frame({.translation = at(0, 0, 30)});
  scene.add(Hull{&hulls[1]}, {.frame = frame});
  scene.add(Field{&fields[1], at(1, 0, 0)}, {.frame = frame});
  scene.add(Hull{});
  scene.add(Field{});
  return scene;
}

}  // namespace

TEST_CASE("hull asset: more points than it can hold are refused", "[hull]") {
  std::vector<Vec3> points(65, at(1, 2, 3));
  CHECK_FALSE(hull_asset(1, ConvexHull<S, 3>{points}));
  points.pop_back();
  const auto most = hull_asset(1, ConvexHull<S, 3>{points});
  REQUIRE(most);
  CHECK(bounding_box(PlacedHull{&*most}) == Aabb{at(1, 2, 3), at(1, 2, 3)});
}

TEST_CASE("placed hull: its points are transformed and rounded once", "[hull]") {
  Transform<S, 3> turned{.translation = at(1, 1, 1)};
  turned.rotation = Rotation<S, 3>::from_axis_angle(*normalize(at(1, 2, 3)),
                                                    Angle<S>::from_raw(std::uint32_t{1} << 29));
  for (const auto& transform : {Transform<S, 3>{.translation = at(1, 1, 1)}, turned}) {
    const PlacedHull hull{hulls.data(), transform};
    std::array<Vec3, 4> points;
    for (std::size_t i = 0; i < 4; ++i) points[i] = transform_point(transform, tetrahedron[i]);
    const ConvexHull there{points};
    const Ray ray{at(9, 2, 2), -Direction<S, 3>::along(0), S(100)};
    CHECK(bounding_box(hull) == bounding_box(there));
    CHECK(contains(hull, points[2]));
    CHECK(closest_point(hull, at(7, 8, 9)) == closest_point(there, at(7, 8, 9)));
    CHECK(distance(hull, at(7, 8, 9)) == distance(there, at(7, 8, 9)));
    CHECK(raycast_hit(ray, hull) == raycast_hit(ray, there));
    CHECK(raycast_interval(ray, hull) == raycast_interval(ray, there));
    CHECK(overlaps(hull, hull));
    CHECK(overlaps(hull, Plane<S, 3>{Direction<S, 3>::along(1), S(2)}));
    CHECK_FALSE(overlaps(Sphere{at(9, 9, 9), S(1)}, hull));
  }
}

TEST_CASE("placed hull: 2D scenes and bounded scenes hold them as well", "[hull]") {
  using S2 = q8_8;
  const auto point = [](int x, int y) { return Vec<S2, 2>{S2(x), S2(y)}; };
  const std::array corners{point(0, 0), point(4, 0), point(0, 4)};
  const auto triangle = *hull_asset(1, ConvexHull{corners});
  BoundedScene<Bounded<4>, S2, 2, Sphere, HullInstance> scene;
  const auto one = *scene.add(PlacedHull{&triangle});
  const auto other = *scene.add(PlacedHull{&triangle, {.translation = point(2, 2)}});
  CHECK(scene.any(point(3, 3)));
  std::array<Overlap, 2> room;
  CHECK(scene.overlaps(std::span(room)) == 1);
  CHECK(scene.move(other, point(1, 0)));
  CHECK(scene.overlaps(std::span(room)) == 0);
  CHECK(scene.nearest(point(0, -1)) == Found<S2>{S2(1), one});
}

TEST_CASE("placed field: it moves and stays upright in a rotating frame", "[height_field]") {
  const Field field{&fields[0], at(1, 10, 2)};
  CHECK(bounding_box(field) == Aabb{at(-3, 10, -2), at(5, 13, 6)});
  const Ray down{at(1, 50, 2), -Direction<S, 3>::along(1), S(100)};
  CHECK(raycast(down, field) == S(37));
  CHECK(nearest_triangle(field, at(1, 20, 2))->distance == S(7));
  CHECK_FALSE(overlaps(field, Field{&fields[0], at(1, 20, 2)}));
  CHECK(overlaps(field, PlacedHull{&hulls[1], {.translation = at(1, 5, 2)}}));
  Transform<S, 3> turned{.translation = at(0, 5, 0), .scale = S(2)};
  turned.rotation = Rotation<S, 3>::from_axis_angle(Direction<S, 3>::along(1),
                                                    Angle<S>::from_raw(std::uint32_t{1} << 30));
  const auto there = placed(turned, field);
  CHECK(there.asset == field.asset);
  CHECK(there.translation == transform_point(turned, at(1, 10, 2)));
  CHECK(raycast_any(down, Field{}) == false);
  CHECK(distance(Field{}, at(0, 0, 0)) == largest<S>);
}

TEST_CASE("placed field: out of range it is clamped, and queries still work", "[height_field]") {
  const Field field{&fields[0], {S(32760), S(32766), S(0)}};
  const auto corner = nearest_to<S>(at(4, 0, 4) + field.translation);
  CHECK(bounding_box(field).max.y == largest<S>);
  CHECK(contains(field, corner));
  const Ray down{{corner.x, largest<S>, corner.z}, -Direction<S, 3>::along(1), S(100)};
  CHECK(raycast(down, field) == S::from_raw(131071));
  CHECK(intersects(Segment{down.origin, corner}, field));
  CHECK(overlaps(field, Sphere{corner, S(0)}));
  // Every sample is clamped to the end of the range. There, a query moved into the field's own frame
  // is at x = 0, where the field, which spans x from 4 to 8, has no sample.
  const FieldAsset flattened(1,
                             *height_field<S>({S(4), S(0)}, S(4), 2, 2, std::span(hills).first(4)));
  const Field wall{&flattened, {largest<S>, S(0), S(0)}};
  const Vec3 sample{largest<S>, S(0), S(0)};
  CHECK(contains(wall, sample));
  CHECK(distance(wall, sample) == S(0));
  CHECK(intersects(Segment{sample, at(0, 0, 0)}, wall));
  CHECK(raycast(Ray<S, 3>{at(32767, 0, 0), Direction<S, 3>::along(0), S(1)}, wall) ==
        S::from_raw(65535));
}

TEST_CASE("snapshot of assets: the scene is restored with any copy of its assets") {
  Toys scene = toys();
  const auto bytes = snapshot(scene);
  const auto before = digest(scene);
  CHECK(scene.move({1, 2}, at(1, 1, 1)));
  CHECK(scene.move({4, 6}, at(1, 1, 1)));
  CHECK(scene.remove({3, 5}));
  CHECK(digest(scene) != before);
  const Hulls some_hulls = hulls;
  const Fields some_fields = fields;
  REQUIRE(restore(scene, bytes, some_fields, some_hulls) == Restored::yes);
  CHECK(digest(scene) == before);
  CHECK(snapshot(scene) == bytes);
  CHECK(scene.shape<Hull>({1, 2})->asset == &some_hulls[0]);
  CHECK(scene.shape<Field>({4, 6})->asset == &some_fields[1]);
  CHECK(scene.shape<Field>({4, 6})->translation == at(1, 0, 30));
  CHECK(scene.nearest(Ray<S, 3>{at(5, 0, 9), -Direction<S, 3>::along(2), S(100)}) ==
        Found<S>{S(7), {1, 2}});
}

TEST_CASE("snapshot of assets: a hull takes 89 bytes and a field 49, and the bytes never change") {
  Toys scene;
  const auto none = snapshot(scene).size();
  scene.add(Hull{&hulls[0]});
  CHECK(snapshot(scene).size() == none + 89);
  scene.add(Field{&fields[0]});
  CHECK(snapshot(scene).size() == none + 89 + 49);
  CHECK(hulls[0].digest() == 0x68a7b5f588590fd9u);
  CHECK(fields[0].digest() == 0x622b70f641131bf9u);
  CHECK(digest(toys()) == 0x65c302f1bac31bf8u);
}

TEST_CASE(
    "restore of assets: an unknown id or other contents are refused, and the scene is unchanged") {
  Toys scene = toys();
  const auto bytes = snapshot(scene);
  CHECK(scene.move({1, 2}, at(1, 1, 1)));
  const auto before = snapshot(scene);
  const auto refused = [&](const Hulls& of_hulls, const Fields& of_fields) {
    const auto result = restore(scene, bytes, of_hulls, of_fields);
    CHECK(snapshot(scene) == before);
    return result;
  };
  CHECK(restore(scene, bytes) == Restored::unknown_asset);
  CHECK(restore(scene, bytes, hulls) == Restored::unknown_asset);
  CHECK(restore(scene, bytes, fields) == Restored::unknown_asset);
  CHECK(refused({}, {}) == Restored::unknown_asset);
  CHECK(refused({hulls[0]}, fields) == Restored::unknown_asset);
  CHECK(refused(hulls, {fields[0]}) == Restored::unknown_asset);
  CHECK(refused({*hull_asset(7, ConvexHull{needle}), hulls[1]}, fields) == Restored::other_asset);
  CHECK(refused(hulls, {fields[0], FieldAsset(8, hilly)}) == Restored::other_asset);
  REQUIRE(restore(scene, bytes, fields, hulls) == Restored::yes);
}

TEST_CASE("restore of assets: forged references are refused") {
  Toys scene = toys();
  const auto bytes = snapshot(scene);
  const auto before = digest(scene);
  // A hull in a frame follows the header, frame, ball and the hull's object header.
  constexpr std::size_t hull_at = 48 + 64 + 41 + 25, field_at = hull_at + 2 * 89;
  const auto forged = [&](std::size_t place, std::uint32_t word) {
    auto copy = bytes;
    detail::store_word(copy.data() + place, word);
    test::seal(copy);
    const auto result = restore(scene, copy, hulls, fields);
    if (result != Restored::yes) CHECK(digest(scene) == before);
    return result;
  };
  CHECK(forged(hull_at, 8) == Restored::unknown_asset);
  CHECK(forged(hull_at, 9) == Restored::other_asset);
  CHECK(forged(hull_at + 4, 1) == Restored::other_asset);
  CHECK(forged(hull_at + 12 + 12, 5) == Restored::corrupted);  // an axis that is not a direction
  CHECK(forged(field_at, 9) == Restored::unknown_asset);
  CHECK(forged(field_at, 7) == Restored::other_asset);
  CHECK(forged(field_at + 8, 1) == Restored::other_asset);
  CHECK(forged(field_at + 12, 5) == Restored::yes);  // another translation
  CHECK(scene.shape<Field>({4, 6})->translation.x == S::from_raw(5));
}

TEST_CASE("restore of assets: fixed ones are compared by digest, and need not be given") {
  Toys scene, other, same;
  scene.add(Field{&fields[0]}, {.motion = Motion::fixed});
  scene.add(Sphere{at(1, 2, 3), S(1)});
  const auto bytes = snapshot(scene);
  const Fields swapped{FieldAsset(7, flat)}, copies = fields;
  other.add(Field{swapped.data()}, {.motion = Motion::fixed});
  CHECK(restore(other, bytes) == Restored::other_fixed_part);
  same.add(Field{copies.data()}, {.motion = Motion::fixed});
  CHECK(restore(same, bytes) == Restored::yes);
  CHECK(digest(same) == digest(scene));
}

TEST_CASE("sync test of assets: it names the fields of hulls and height fields") {
  Toys scene = toys();
  SyncTest<Toys, int> test(3);
  int hidden = 0;
  const auto moving = [&](const ObjectId& id) {
    return [&hidden, id](Toys& world, int x) { CHECK(world.move(id, at(x + hidden, 0, 0))); };
  };
  for (int frame = 0; frame < 8; ++frame) CHECK_FALSE(test.step(scene, frame, moving({1, 2})));
  const auto hidden_too = [&](Toys& world, int x) { moving({1, 2})(world, x + ++hidden); };
  const auto desync = test.step(scene, 0, hidden_too);
  REQUIRE(desync);
  CHECK(desync->field.view() == "object 1:2 (hull) translation.x");
  SyncTest<Toys, int> other(3);
  const auto of_field = other.step(scene, 0, [&](Toys& world, int) {
    CHECK(world.move({4, 6}, at(++hidden, 0, 0)));
  });
  REQUIRE(of_field);
  CHECK(of_field->field.view() == "object 4:6 (height field) translation.x");
}
