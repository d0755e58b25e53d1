// SPDX-License-Identifier: MIT
//
// Compares scenes of the C interface with C++: equal calls give equal bits.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "c/scenes.hpp"
#include "detent/scene/mesh/owned.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace detent {
namespace {

using S = q16_16;
using c::id_of;
using Out = c::Output<3>;
using V = Vec<S, 3>;
constexpr int one = 65536;

V at(std::int64_t x, std::int64_t y, std::int64_t z) {
  const auto raw = [](std::int64_t n) { return S::from_raw(static_cast<std::int32_t>(n)); };
  return {raw(x), raw(y), raw(z)};
}

/// A scene in C and in C++ with the same assets.
struct Twins {
  detent_context context{};
  detent_handle scene = 0, hull = 0, mesh = 0, field = 0;

  std::vector<V> corners{at(0, 0, 0), at(2 * one, 0, 0), at(0, 2 * one, 0), at(0, 0, 2 * one)};
  OwnedMesh<S> triangles{*OwnedMesh<S>::from_faces(corners, faces())};
  std::vector<S> heights = std::vector<S>(9);
  std::array<HullAsset<S, 3>, 1> hulls{*hull_asset(7, ConvexHull<S, 3>{corners})};
  std::array<MeshAsset<S>, 1> meshes{MeshAsset<S>(8, triangles.view())};
  std::vector<FieldAsset<S>> fields;
  c::SceneOf<3>::type twin;

  static std::span<const VertexIndices> faces() {
    static const std::array<VertexIndices, 4> list{VertexIndices{0, 2, 1}, VertexIndices{0, 1, 3},
                                                   VertexIndices{0, 3, 2}, VertexIndices{1, 2, 3}};
    return list;
  }

  Twins() {
    REQUIRE(detent_open(&context, nullptr) == DETENT_OK);
    REQUIRE(detent_scene3_create(&context, &scene) == DETENT_OK);
    std::vector<detent_vec3> points;
    for (const auto& corner : corners) points.push_back(Out::vec(corner));
    std::vector<std::uint32_t> indices;
    for (const auto& face : faces()) indices.insert(indices.end(), face.begin(), face.end());
    REQUIRE(detent_hull3_create(&context, 7, points.data(), 4, &hull) == DETENT_OK);
    REQUIRE(detent_mesh_create(&context, 8, points.data(), 4, indices.data(), 4, &mesh) ==
            DETENT_OK);
    std::vector<std::int32_t> raw;
    for (std::size_t i = 0; i < 9; ++i) {
      heights[i] = S::from_raw(static_cast<std::int32_t>(i * i) * 3000);
      raw.push_back(heights[i].raw());
    }
    const detent_vec2 corner{-one, -one};
    REQUIRE(detent_height_field_create(&context, 9, &corner, one, 3, 3, raw.data(), &field) ==
            DETENT_OK);
    fields.emplace_back(9, *height_field<S>({S(-1), S(-1)}, S(1), 3, 3, heights));
  }
  Twins(const Twins&) = delete;
  Twins& operator=(const Twins&) = delete;
  ~Twins() { detent_close(&context); }

  /// A shape of kind `kind` at a position, for both.
  template <class F>
  void with_shape(std::uint64_t kind, const V& place, const F& f) const {
    detent_shape3 shape{};
    const auto call = [&](const auto& own) {
      Out::shape(shape, own);
      f(shape, own);
    };
    const auto up = Direction<S, 3>::along(1);
    const Transform<S, 3> moved{place, {}, S(1)};
    switch (kind) {
      case 0:
        return call(Sphere{place, S(1)});
      case 1:
        return call(Aabb{place, Vec<S, 3>(nearest_to<S>(place + at(one, one, one)))});
      case 2:
        return call(Obb{place, at(one, one / 2, one), Rotation<S, 3>()});
      case 3:
        return call(Plane{up, S::from_raw(-20 * one)});
      case 4:
        return call(
            Triangle{place, nearest_to<S>(place + corners[1]), nearest_to<S>(place + corners[2])});
      case 5:
        return call(Capsule{place, nearest_to<S>(place + corners[1]), S::from_raw(one / 2)});
      case 6:
        shape.kind = DETENT_HULL;
        shape.asset = hull;
        shape.as.placed = Out::transform(moved);
        return f(shape, PlacedHull<S, 3>{&hulls[0], moved});
      case 7:
        shape.kind = DETENT_MESH;
        shape.asset = mesh;
        shape.as.placed = Out::transform(moved);
        return f(shape, PlacedMesh<S>{&meshes[0], moved});
      default:
        shape.kind = DETENT_HEIGHT_FIELD;
        shape.asset = field;
        shape.as.point = Out::vec(place);
        return f(shape, PlacedField<S>{&fields[0], place});
    }
  }

  [[nodiscard]] std::vector<std::byte> saved() const {
    std::uint32_t size = 0;
    REQUIRE(detent_scene3_snapshot(&context, scene, nullptr, 0, &size) == DETENT_NO);
    std::vector<std::byte> bytes(size);
    REQUIRE(detent_scene3_snapshot(&context, scene, bytes.data(), size, &size) == DETENT_OK);
    return bytes;
  }
  void check_digest() const {
    std::uint64_t sum = 0;
    REQUIRE(detent_scene3_digest(&context, scene, &sum) == DETENT_OK);
    REQUIRE(sum == digest(twin));
  }
};

template <class F, class G>
void check_lists(const std::vector<F>& theirs, std::uint32_t count, const std::vector<G>& own,
                 bool (*same)(const F&, const G&)) {
  REQUIRE(count == own.size());
  for (std::size_t i = 0; i < own.size(); ++i) REQUIRE(same(theirs[i], own[i]));
}

bool same_found(const detent_found& a, const Found<S>& b) {
  return a.distance == b.distance.raw() && id_of(a.id) == b.id;
}
bool same_pair(const detent_pair& a, const Overlap& b) {
  return id_of(a.first) == b.first && id_of(a.second) == b.second;
}
bool same_hit(const detent_object_hit3& a, const ObjectHit<S, 3>& b) {
  return a.distance == b.distance.raw() && id_of(a.id) == b.id &&
         c::Input<3>::vec(a.point) == b.point && a.normal.x == b.normal[0].raw() &&
         a.normal.y == b.normal[1].raw() && a.normal.z == b.normal[2].raw() &&
         (a.has_triangle == 1) == b.triangle.has_value() && a.triangle == b.triangle.value_or(0);
}

template <class Question>
void check_question(const Twins& twins, const detent_shape3& asked, const Question& question) {
  const InLayers layers{5};
  const auto all = twins.twin.all(question, layers);
  std::uint32_t count = 0;
  std::vector<detent_found> found(64);
  REQUIRE(detent_scene3_all(&twins.context, twins.scene, &asked, 5, found.data(), 64, &count) ==
          DETENT_OK);
  check_lists(found, count, all, same_found);
  std::uint32_t same_count = 0;
  std::vector<detent_found> two(3, detent_found{-77, {7, 7}});
  REQUIRE(detent_scene3_all(&twins.context, twins.scene, &asked, 5, two.data(), 2, &same_count) ==
          DETENT_OK);
  REQUIRE(same_count == count);
  for (std::size_t i = 0; i < 2 && i < all.size(); ++i) REQUIRE(same_found(two[i], all[i]));
  REQUIRE(two[2].distance == -77);
  REQUIRE(detent_scene3_any(&twins.context, twins.scene, &asked, 5) ==
          c::yes_or_no(twins.twin.any(question, layers)));
  const auto nearest = twins.twin.nearest(question, layers);
  detent_found first{};
  REQUIRE(detent_scene3_nearest(&twins.context, twins.scene, &asked, 5, &first) ==
          c::yes_or_no(nearest.has_value()));
  if (nearest) REQUIRE(same_found(first, *nearest));
}

TEST_CASE("C scenes: histories give the bits of C++") {
  test::Random random(7);
  Twins twins;
  std::vector<detent_id> ids;
  std::vector<std::byte> saved;
  int hits = 0, rays = 0;
  const auto place = [&] {
    const auto x = random.between(-6 * one, 6 * one), y = random.between(-6 * one, 6 * one);
    return at(x, y, random.between(-6 * one, 6 * one));
  };
  for (int i = 0; i < 400; ++i) {
    CAPTURE(i, random.seed());
    const auto where = place();
    const auto choice = random.below(12);
    if (choice < 5 || ids.empty()) {
      const detent_traits traits{random.next(),
                                 static_cast<std::uint32_t>(1 + random.below(7)),
                                 random.one_in(5) && i < 100 ? 1u : 0u,
                                 {}};
      const Traits own_traits{traits.layers, traits.user, static_cast<Motion>(traits.motion), {}};
      const bool has_own_id = random.one_in(8);
      twins.with_shape(random.below(9), where, [&](const auto& theirs, const auto& own) {
        detent_id id{static_cast<std::uint32_t>(1000 + random.below(20)), 3};
        bool is_added = true;
        if (has_own_id) {
          is_added = twins.twin.add_as(id_of(id), own, own_traits);
          REQUIRE(detent_scene3_add_as(&twins.context, twins.scene, id, &theirs, &traits) ==
                  c::yes_or_no(is_added));
        } else {
          REQUIRE(detent_scene3_add(&twins.context, twins.scene, &theirs, &traits, &id) ==
                  DETENT_OK);
          REQUIRE(twins.twin.add(own, own_traits) == id_of(id));
        }
        if (is_added && traits.motion == DETENT_MOVING) ids.push_back(id);
      });
    } else {
      const auto which = random.below(ids.size());
      const detent_id id = ids[which];
      if (choice < 7) {
        twins.with_shape(random.below(9), where, [&](const auto& theirs, const auto& own) {
          REQUIRE(detent_scene3_replace(&twins.context, twins.scene, id, &theirs) ==
                  c::yes_or_no(twins.twin.replace(id_of(id), own)));
        });
      } else if (choice < 9) {
        const detent_vec3 by = Out::vec(where);
        REQUIRE(detent_scene3_move(&twins.context, twins.scene, id, &by) ==
                c::yes_or_no(twins.twin.move(id_of(id), where)));
      } else if (choice < 10) {
        const detent_traits traits{
            random.next(), static_cast<std::uint32_t>(1 + random.below(7)), 0, {}};
        const bool is_there = twins.twin.set_layers(id_of(id), traits.layers) &&
                              twins.twin.set_user(id_of(id), traits.user);
        REQUIRE(detent_scene3_set_traits(&twins.context, twins.scene, id, &traits) ==
                c::yes_or_no(is_there));
      } else {
        REQUIRE(detent_scene3_remove(&twins.context, twins.scene, id) ==
                c::yes_or_no(twins.twin.remove(id_of(id))));
        if (random.coin()) ids.erase(ids.begin() + static_cast<std::ptrdiff_t>(which));
      }
    }
    if (i % 50 == 20) REQUIRE(detent_scene3_optimize(&twins.context, twins.scene) == DETENT_OK);
    twins.check_digest();
    if (i == 200) saved = twins.saved();

    const auto toward = normalize(place());
    if (!toward) continue;
    const Ray ray{place(), *toward, S(20)};
    const detent_ray3 asked{Out::vec(ray.origin), Out::direction(ray.direction), 20 * one};
    const auto all = twins.twin.all_hits(ray, InLayers{7});
    std::vector<detent_object_hit3> list(64);
    std::uint32_t count = 0;
    REQUIRE(detent_scene3_raycast_all(&twins.context, twins.scene, &asked, 7, list.data(), 64,
                                      &count) == DETENT_OK);
    check_lists(list, count, all, same_hit);
    detent_object_hit3 hit{};
    const auto expected = c::yes_or_no(!all.empty());
    REQUIRE(detent_scene3_raycast(&twins.context, twins.scene, &asked, 7, &hit) == expected);
    REQUIRE(detent_scene3_raycast_any(&twins.context, twins.scene, &asked, 7) == expected);
    if (!all.empty()) REQUIRE(same_hit(hit, all[0]));
    REQUIRE(detent_scene3_raycast_many(&twins.context, twins.scene, &asked, 1, 7, &hit) ==
            DETENT_OK);
    REQUIRE((all.empty() ? hit.distance == -1 : same_hit(hit, all[0])));
    hits += all.empty() ? 0 : 1;
    ++rays;

    detent_shape3 question{};
    question.kind = DETENT_POINT;
    question.as.point = Out::vec(where);
    check_question(twins, question, where);
    const Sphere ball{where, S(2)};
    Out::shape(question, ball);
    check_question(twins, question, ball);
    question = {};
    question.kind = DETENT_SEGMENT;
    question.as.segment = {Out::vec(where), Out::vec(ray.origin)};
    check_question(twins, question, Segment{where, ray.origin});
    std::vector<detent_pair> pairs(4096);
    REQUIRE(detent_scene3_overlaps(&twins.context, twins.scene, pairs.data(), 4096, &count) ==
            DETENT_OK);
    check_lists(pairs, count, twins.twin.overlaps(), same_pair);
  }
  CHECK(hits * 10 > 3 * rays);
  CHECK(hits * 10 < 9 * rays);
  const auto bytes = twins.saved();
  CHECK((bytes == snapshot(twins.twin)));

  const auto restored = c::status_of(restore(twins.twin, saved, twins.hulls, twins.meshes,
                                             std::span<const FieldAsset<S>>(twins.fields)));
  CHECK(restored == DETENT_OK);
  REQUIRE(detent_scene3_restore(&twins.context, twins.scene, saved.data(),
                                static_cast<std::uint32_t>(saved.size())) == restored);
  twins.check_digest();
  CHECK((twins.saved() == saved));
  saved[70] ^= std::byte{1};
  CHECK(detent_scene3_restore(&twins.context, twins.scene, saved.data(),
                              static_cast<std::uint32_t>(saved.size())) == DETENT_CORRUPTED);
  CHECK(detent_scene3_restore(&twins.context, twins.scene, saved.data(), 3) == DETENT_TRUNCATED);
}

TEST_CASE("C scenes: an object is returned as it was added, for every kind") {
  Twins twins;
  const detent_traits traits{77, 6, DETENT_FIXED, {}};
  for (std::uint64_t kind = 0; kind < 9; ++kind) {
    CAPTURE(kind);
    twins.with_shape(kind, at(3, 4, 5), [&](const detent_shape3& shape, const auto&) {
      detent_id id{};
      REQUIRE(detent_scene3_add(&twins.context, twins.scene, &shape, &traits, &id) == DETENT_OK);
      detent_shape3 same{};
      detent_traits with{};
      REQUIRE(detent_scene3_object(&twins.context, twins.scene, id, &same, &with) == DETENT_OK);
      CHECK(same.kind == shape.kind);
      CHECK(same.asset == shape.asset);
      const auto bytes = std::as_bytes(std::span(&shape, 1)),
                 read = std::as_bytes(std::span(&same, 1));
      CHECK(std::equal(bytes.begin(), bytes.end(), read.begin()));
      CHECK((with.user == 77 && with.layers == 6 && with.motion == DETENT_FIXED));
    });
  }
  std::uint32_t size = 0;
  CHECK(detent_scene3_size(&twins.context, twins.scene, &size) == DETENT_OK);
  CHECK(size == 9);
}

TEST_CASE("C scenes: frames move their contents") {
  Twins twins;
  const auto quarter =
      Rotation<S, 3>::from_axis_angle(Direction<S, 3>::along(1), Angle<S>::turn(1, 4));
  const Transform<S, 3> first{at(3 * one, 0, one), quarter, S(1)}, second{at(0, one, 0), {}, S(2)};
  const auto outer = Out::transform(first), inner = Out::transform(second);
  auto* const context = &twins.context;
  const auto scene = twins.scene;
  detent_id frame{}, child{}, id{};
  REQUIRE(detent_scene3_add_frame(context, scene, &outer, {}, &frame) == DETENT_OK);
  REQUIRE(detent_scene3_add_frame(context, scene, &inner, frame, &child) == DETENT_OK);
  const auto own = *twins.twin.add_frame(first);
  const auto own_child = *twins.twin.add_frame(second, own);
  CHECK((own.index == frame.index && own.generation == frame.generation));
  CHECK((own_child.index == child.index && own_child.generation == child.generation));
  for (std::uint64_t kind = 0; kind < 9; ++kind) {
    CAPTURE(kind);
    const detent_traits traits{kind, 1, DETENT_MOVING, child};
    twins.with_shape(kind, at(one, 0, 0), [&](const detent_shape3& shape, const auto& same) {
      REQUIRE(detent_scene3_add(context, scene, &shape, &traits, &id) == DETENT_OK);
      REQUIRE(twins.twin.add(same, {1, kind, Motion::moving, own_child}) == id_of(id));
    });
  }
  twins.check_digest();
  REQUIRE(detent_scene3_move_frame(context, scene, frame, &inner) == DETENT_OK);
  REQUIRE(twins.twin.move_frame(own, second));
  twins.check_digest();
  detent_transform3 world{}, local{};
  detent_traits with{};
  REQUIRE(detent_scene3_frame(context, scene, child, &local, &world) == DETENT_OK);
  CHECK(world.translation.y == 3 * one);
  CHECK(local.translation.y == one);
  REQUIRE(detent_scene3_object(context, scene, id, nullptr, &with) == DETENT_OK);
  CHECK((with.frame.index == child.index && with.frame.generation == child.generation));
  CHECK(detent_scene3_remove_frame(context, scene, child) == DETENT_NO);
  detent_shape3 ball{};
  ball.kind = DETENT_SPHERE;
  const detent_traits lost{0, 1, DETENT_MOVING, {9, 9}}, fixed{0, 1, DETENT_FIXED, frame};
  CHECK(detent_scene3_add(context, scene, &ball, &lost, &id) == DETENT_NO);
  CHECK(detent_scene3_add(context, scene, &ball, &fixed, &id) == DETENT_BAD_ARGUMENT);
  CHECK(detent_scene3_add_frame(context, scene, &outer, {9, 9}, &child) == DETENT_NO);
  world.rotation.axis[0].x = 0;
  CHECK(detent_scene3_move_frame(context, scene, frame, &world) == DETENT_NOT_UNIT);
}

TEST_CASE("C scenes: an asset in use stays, and is found again by a snapshot") {
  Twins twins;
  detent_id id{};
  twins.with_shape(7, at(0, 0, 0), [&](const detent_shape3& shape, const auto&) {
    REQUIRE(detent_scene3_add(&twins.context, twins.scene, &shape, nullptr, &id) == DETENT_OK);
  });
  CHECK(detent_asset_destroy(&twins.context, twins.mesh) == DETENT_IN_USE);
  CHECK(detent_asset_destroy(&twins.context, twins.hull) == DETENT_OK);
  CHECK(detent_asset_destroy(&twins.context, twins.hull) == DETENT_BAD_HANDLE);
  const auto saved = twins.saved();
  const auto size = static_cast<std::uint32_t>(saved.size());
  CHECK(detent_scene3_remove(&twins.context, twins.scene, id) == DETENT_OK);
  CHECK(detent_scene3_restore(&twins.context, twins.scene, saved.data(), size) == DETENT_OK);
  CHECK(detent_asset_destroy(&twins.context, twins.mesh) == DETENT_IN_USE);
  CHECK(detent_scene3_remove(&twins.context, twins.scene, id) == DETENT_OK);
  CHECK(detent_asset_destroy(&twins.context, twins.mesh) == DETENT_OK);
  CHECK(detent_scene3_restore(&twins.context, twins.scene, saved.data(), size) ==
        DETENT_UNKNOWN_ASSET);
  const detent_vec3 vertices[3] = {{0, 0, 0}, {one, 0, 0}, {0, one, 0}};
  const std::uint32_t face[3] = {0, 1, 2}, wrong[3] = {0, 1, 3};
  detent_handle other = 0;
  CHECK(detent_mesh_create(&twins.context, 8, vertices, 3, wrong, 1, &other) ==
        DETENT_BAD_ARGUMENT);
  CHECK(detent_mesh_create(&twins.context, 8, vertices, 3, face, 1, &other) == DETENT_OK);
  CHECK(detent_mesh_create(&twins.context, 8, vertices, 3, face, 1, &other) == DETENT_IN_USE);
  CHECK(detent_scene3_restore(&twins.context, twins.scene, saved.data(), size) ==
        DETENT_OTHER_ASSET);
}

}  // namespace
}  // namespace detent
