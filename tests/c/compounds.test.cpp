// SPDX-License-Identifier: MIT
//
// Compounds, meshes and height fields as bodies: the C interface gives the bits of C++.

#include <array>
#include <cstdint>
#include <vector>

#include "world_twins.hpp"

namespace detent::test_c {
namespace {

template <int N>
Vec<S, N> vec(std::int64_t x, std::int64_t y) {
  return make_vec<N>([&](int i) { return raw(i == 0 ? x : i == 1 ? y : 0); });
}

/// One world in C and in C++: a floor, or terrain, on which compounds of a ball, a box and a hull
/// fall.
template <int N>
struct Pair : WorldTwins<N> {
  using C = Calls<N>;
  using T = c::Types<N>;
  using Out = c::Output<N>;
  using typename WorldTwins<N>::W;
  using WorldTwins<N>::context, WorldTwins<N>::world, WorldTwins<N>::twin;

  Pair() {
    std::vector<typename T::Vec> theirs;
    for (int k = 0; k < 1 << N; ++k) {
      points.push_back(make_vec<N>([&](int i) { return raw((k >> i & 1) != 0 ? one / 2 : 0); }));
      theirs.push_back(Out::vec(points.back()));
    }
    solid = *solid_hull(3, ConvexHull<S, N>{{points.data(), points.size()}});
    REQUIRE(C::solid_create(&context, 3, theirs.data(), 1 << N, &solid_handle) == DETENT_OK);

    PartOptions<S> heavy, sensor;
    heavy.density = raw(3 * one);
    heavy.friction = raw(one / 4);
    heavy.restitution = raw(one / 3);
    heavy.rolling_resistance = raw(one / 10);
    sensor.is_sensor = true;
    parts = {BodyPart(Sphere{vec<N>(-one, 0), raw(one / 2)}, heavy),
             BodyPart(Obb{vec<N>(one / 4, 0), make_vec<N>([](int) { return raw(one / 4); }),
                          Rotation<S, N>()}),
             BodyPart(BodyHull<S, N>{&solid, vec<N>(one, one / 8), {}}),
             BodyPart(Capsule{vec<N>(0, one), vec<N>(one, one), raw(one / 4)}, sensor)};
    asset = *solid_compound(9, parts);
    std::array<typename T::Part, 4> given{};
    for (auto& part : given) REQUIRE(C::part_defaults(&part) == DETENT_OK);
    Out::shape(given[0].shape, Sphere{vec<N>(-one, 0), raw(one / 2)});
    given[0].density = 3 * one;
    given[0].friction = one / 4;
    given[0].restitution = one / 3;
    given[0].rolling_resistance = one / 10;
    Out::shape(
        given[1].shape,
        Obb{vec<N>(one / 4, 0), make_vec<N>([](int) { return raw(one / 4); }), Rotation<S, N>()});
    given[2].shape = this->placed(DETENT_HULL, solid_handle, vec<N>(one, one / 8));
    Out::shape(given[3].shape, Capsule{vec<N>(0, one), vec<N>(one, one), raw(one / 4)});
    given[3].is_sensor = 1;
    REQUIRE(C::compound_create(&context, 9, given.data(), 4, &handle) == DETENT_OK);
    CHECK(detent_asset_destroy(&context, solid_handle) == DETENT_IN_USE);
  }
  detent_id add_compound(const Vec<S, N>& at, const Rotation<S, N>& rotation,
                         const typename W::Options& own = {}) {
    return this->add(this->placed(DETENT_COMPOUND, handle, at, rotation),
                     BodyCompound<S, N>{&asset, at, rotation}, own);
  }
  void check_frame(detent_id id) {
    typename T::Transform frame{};
    REQUIRE(C::world_frame(&context, world, id, &frame) == DETENT_OK);
    CHECK(c::Input<N>().transform(frame) == twin.frame(id_of(id)));
  }

  detent_handle solid_handle = 0, handle = 0;
  std::vector<Vec<S, N>> points;
  SolidHull<S, N> solid;
  std::vector<BodyPart<S, N>> parts;
  SolidCompound<S, N> asset;
};

template <int N>
void check_fall() {
  using C = Calls<N>;
  Pair<N> pair;
  test::Random random(70 + N);
  typename Pair<N>::W::Options fixed, fast;
  fixed.motion = BodyMotion::fixed;
  const auto floor = make_vec<N>([](int i) { return raw(i == 1 ? one : 8 * one); });
  const Obb<S, N> ground{vec<N>(0, -one), floor, {}};
  pair.add(ground, fixed);
  const auto wall = pair.add_compound(vec<N>(0, one / 2), {}, fixed);
  pair.check_frame(wall);
  std::vector<detent_id> ids;
  for (int i = 0; i < 4; ++i) {
    ids.push_back(pair.add_compound(vec<N>(random.between(-2 * one, 2 * one), (3 + 3 * i) * one),
                                    Rotation<S, N>()));
  }
  fast.is_fast = true;
  fast.velocity = vec<N>(-one, -300 * one);
  const Sphere<S, N> bullet{vec<N>(one, 20 * one), raw(one / 16)};
  const auto shot = pair.add(bullet, fast);
  std::vector<std::byte> saved;
  for (int tick = 0; tick < 90; ++tick) {
    CAPTURE(N, tick);
    pair.step();
    for (const auto& id : ids) pair.check_frame(id);
    const auto at = pair.twin.position(id_of(shot));  // off the floor's edge, but not through it
    CHECK((at.y > raw(-one) || abs(at.x) > raw(8 * one)));
    if (tick == 40) saved = pair.saved();
  }
  CHECK(pair.of_parts > 4);
  CHECK((pair.saved() == snapshot(pair.twin)));
  REQUIRE(pair.restore(saved) == DETENT_OK);
  const auto saved_by_cpp = std::span<const std::byte>(saved);
  REQUIRE(restore(pair.twin, saved_by_cpp, std::span<const SolidHull<S, N>>(&pair.solid, 1),
                  std::span<const SolidCompound<S, N>>(&pair.asset, 1)) == Restored::yes);
  for (int tick = 0; tick < 10; ++tick) pair.step();

  CHECK(detent_asset_destroy(&pair.context, pair.handle) == DETENT_IN_USE);
  const detent_id own{40, 7};
  typename c::Types<N>::Shape theirs{};
  c::Output<N>::shape(theirs, bullet);
  CHECK(C::world_add_as(&pair.context, pair.world, own, &theirs, nullptr) == DETENT_OK);
  CHECK(C::world_add_as(&pair.context, pair.world, own, &theirs, nullptr) == DETENT_NO);
  CHECK(pair.twin.put(id_of(own), bullet));
  pair.step();
  CHECK(C::world_destroy(&pair.context, pair.world) == DETENT_OK);
  CHECK(detent_asset_destroy(&pair.context, pair.solid_handle) == DETENT_IN_USE);
  CHECK(detent_asset_destroy(&pair.context, pair.handle) == DETENT_OK);
  CHECK(detent_asset_destroy(&pair.context, pair.handle) == DETENT_BAD_HANDLE);
  CHECK(detent_asset_destroy(&pair.context, pair.solid_handle) == DETENT_OK);
}

TEST_CASE("C compounds: compound bodies give the bits of C++, in 2D") { check_fall<2>(); }
TEST_CASE("C compounds: compound bodies give the bits of C++, in 3D") { check_fall<3>(); }

TEST_CASE("C worlds: mesh and height field bodies give the bits of C++") {
  Pair<3> pair;
  const std::array<detent_vec3, 4> corners{{{-8 * one, 0, -8 * one},
                                            {8 * one, 0, -8 * one},
                                            {8 * one, one, 8 * one},
                                            {-8 * one, 0, 8 * one}}};
  const std::array<std::uint32_t, 6> faces{0, 2, 1, 0, 3, 2};
  const std::array<std::int32_t, 9> heights{0, one, 0, one / 2, 0, one, 0, 0, one};
  const detent_vec2 corner{-8 * one, -8 * one};
  detent_handle mesh = 0, field = 0;
  REQUIRE(detent_mesh_create(&pair.context, 5, corners.data(), 4, faces.data(), 2, &mesh) ==
          DETENT_OK);
  REQUIRE(detent_height_field_create(&pair.context, 6, &corner, 8 * one, 3, 3, heights.data(),
                                     &field) == DETENT_OK);
  std::array<MeshTriangle<S>, 2> triangles{};
  for (std::uint32_t i = 0; i < 2; ++i) {
    const auto at = [&](std::size_t k) { return c::Input<3>::vec(corners[faces[3 * i + k]]); };
    triangles[i] = {{at(0), at(1), at(2)}, i};
  }
  std::array<MeshNode<S>, tree_capacity(2)> nodes{};
  const MeshAsset<S> own_mesh(5, *build_mesh<S>(std::span(triangles), std::span(nodes)));
  std::array<S, 9> own_heights{};
  for (std::size_t i = 0; i < 9; ++i) own_heights[i] = raw(heights[i]);
  const FieldAsset<S> own_field(6, *height_field<S>({raw(corner.x), raw(corner.y)}, raw(8 * one), 3,
                                                    3, std::span<const S>(own_heights)));
  // Half of the bodies fall on the mesh, half on the field; the mesh rises.
  typename Pair<3>::W::Options fixed, rising;
  fixed.motion = BodyMotion::fixed;
  rising.motion = BodyMotion::kinematic;
  rising.velocity = vec<3>(0, one / 8);
  const auto left = vec<3>(-10 * one, 0), right = vec<3>(10 * one, 0);
  pair.add(pair.placed(DETENT_MESH, mesh, left), BodyMesh<S, 3>{&own_mesh, left, {}}, rising);
  detent_shape3 shape{};
  shape.kind = DETENT_HEIGHT_FIELD;
  shape.asset = field;
  shape.as.point = {10 * one, 0, 0};
  pair.add(shape, BodyHeightField<S, 3>{&own_field, right}, fixed);
  for (int i = 0; i < 4; ++i) {
    pair.add_compound(vec<3>((i % 2 == 0 ? -10 : 10) * one, (2 + i) * one), {});
    const Sphere<S, 3> ball{vec<3>((i % 2 == 0 ? -12 : 12) * one, 3 * one + i), raw(one / 2)};
    pair.add(ball);
  }
  for (int tick = 0; tick < 90; ++tick) {
    CAPTURE(tick);
    pair.step();
  }
  CHECK(pair.of_parts > 3);
  const auto saved = pair.saved();
  CHECK((saved == snapshot(pair.twin)));
  pair.step();
  REQUIRE(pair.restore(saved) == DETENT_OK);
  CHECK((pair.saved() == saved));
  CHECK(detent_asset_destroy(&pair.context, mesh) == DETENT_IN_USE);
  CHECK(detent_asset_destroy(&pair.context, field) == DETENT_IN_USE);
  shape = pair.placed(DETENT_MESH, mesh, left);
  shape.as.placed.scale = 2 * one;
  detent_id id{};
  CHECK(detent_world3_add(&pair.context, pair.world, &shape, nullptr, &id) == DETENT_BAD_ARGUMENT);
}

TEST_CASE(
    "C compounds: wrong parts and handles are errors, and sessions keep possible assets alive") {
  Pair<2> pair;
  detent_part2 part{};
  detent_handle made = 1;
  const auto create = [&](const detent_part2* parts, std::uint32_t count, std::uint32_t id = 20) {
    return detent_compound2_create(&pair.context, id, parts, count, &made);
  };
  CHECK(detent_part2_defaults(nullptr) == DETENT_BAD_ARGUMENT);
  REQUIRE(detent_part2_defaults(&part) == DETENT_OK);
  CHECK(part.density == one);
  CHECK(create(&part, 0) == DETENT_BAD_ARGUMENT);
  CHECK(create(&part, 65537) == DETENT_BAD_ARGUMENT);
  CHECK(create(nullptr, 1) == DETENT_BAD_ARGUMENT);
  CHECK(create(&part, 1, 0) == DETENT_BAD_ARGUMENT);
  CHECK(create(&part, 1, 9) == DETENT_IN_USE);
  auto wrong = part;
  wrong.friction = -1;
  CHECK(create(&wrong, 1) == DETENT_BAD_ARGUMENT);
  wrong = part;
  wrong.rolling_resistance = -1;
  CHECK(create(&wrong, 1) == DETENT_BAD_ARGUMENT);
  wrong = part;
  wrong.is_sensor = 2;
  CHECK(create(&wrong, 1) == DETENT_BAD_ARGUMENT);
  for (const unsigned kind : {DETENT_PLANE, DETENT_TRIANGLE, DETENT_SEGMENT, DETENT_POINT,
                              DETENT_MESH, DETENT_HEIGHT_FIELD, DETENT_COMPOUND}) {
    CAPTURE(kind);
    wrong = part;
    wrong.shape.kind = kind;
    wrong.shape.as.plane.normal = {1 << 30, 0};
    CHECK(create(&wrong, 1) == DETENT_NO_QUERY);
    detent_id id{};
    const auto status = detent_world2_add(&pair.context, pair.world, &wrong.shape, nullptr, &id);
    CHECK(status == (kind == DETENT_COMPOUND ? DETENT_BAD_HANDLE : DETENT_NO_QUERY));
  }
  wrong.shape.kind = 99;
  CHECK(create(&wrong, 1) == DETENT_BAD_ARGUMENT);
  wrong.shape.kind = DETENT_HULL;
  wrong.shape.asset = pair.handle;  // a compound is not a hull
  CHECK(create(&wrong, 1) == DETENT_BAD_HANDLE);
  wrong = part;
  wrong.shape.kind = DETENT_OBB;
  CHECK(create(&wrong, 1) == DETENT_NOT_UNIT);
  CHECK(made == 0);
  std::uint32_t count = 0;
  CHECK(detent_count(&pair.context, &count) == DETENT_OK);
  CHECK(count == 3);
  detent_transform2 frame{};
  CHECK(detent_world2_frame(&pair.context, pair.world, {0, 1}, &frame) == DETENT_NO);

  detent_handle session = 0;
  detent_session_settings settings{};
  REQUIRE(detent_session_default_settings(&settings) == DETENT_OK);
  REQUIRE(create(&part, 1) == DETENT_OK);
  REQUIRE(detent_session2_create(&pair.context, &settings, pair.world, &session) == DETENT_OK);
  CHECK(detent_asset_destroy(&pair.context, made) == DETENT_IN_USE);
  CHECK(detent_session2_destroy(&pair.context, session) == DETENT_OK);
  CHECK(detent_asset_destroy(&pair.context, made) == DETENT_OK);
}

}  // namespace
}  // namespace detent::test_c
