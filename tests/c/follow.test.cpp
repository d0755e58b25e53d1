// SPDX-License-Identifier: MIT
//
// Scenes that follow worlds, lists and properties of bodies, and teleports: C gives the bits of C++.

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "world_twins.hpp"

namespace detent::test_c {
namespace {

template <int N>
Vec<S, N> vec(std::int64_t x, std::int64_t y) {
  return make_vec<N>([&](int i) { return raw(i == 0 ? x : i == 1 ? y : 0); });
}

/// 0 for an element that was not written.
std::uint32_t generation_of(const detent_id& id) { return id.generation; }
std::uint32_t generation_of(const detent_touch& touch) { return touch.a.generation; }
std::uint32_t generation_of(const detent_world2_contact& contact) { return contact.a.generation; }
std::uint32_t generation_of(const detent_world3_contact& contact) { return contact.a.generation; }

/// A world in C and in C++ with a floor, a sensor, a hull, a ball and two compounds of a hull and a
/// sensor, and a scene in C and in C++.
template <int N>
struct Followed : WorldTwins<N> {
  using C = Calls<N>;
  using T = c::Types<N>;
  using Out = c::Output<N>;
  using Options = typename WorldTwins<N>::W::Options;
  using WorldTwins<N>::context, WorldTwins<N>::world, WorldTwins<N>::twin;

  detent_handle scene = 0, solid_handle = 0, compound_handle = 0;
  typename c::Scenes<N>::Scene own;
  std::vector<Vec<S, N>> points;
  SolidHull<S, N> solid;
  std::vector<BodyPart<S, N>> parts;
  SolidCompound<S, N> compound;
  detent_id floor{}, zone{}, hull{}, ball{};
  std::array<detent_id, 2> compounds{};

  Followed() {
    REQUIRE(C::scene_create(&context, &scene) == DETENT_OK);
    std::vector<typename T::Vec> theirs;
    for (int k = 0; k < 1 << N; ++k) {
      points.push_back(make_vec<N>([&](int i) { return raw((k >> i & 1) != 0 ? one : 0); }));
      theirs.push_back(Out::vec(points.back()));
    }
    solid = *solid_hull(3, ConvexHull<S, N>{points});
    REQUIRE(C::solid_create(&context, 3, theirs.data(), 1 << N, &solid_handle) == DETENT_OK);
    PartOptions<S> sensor;
    sensor.is_sensor = true;
    const Sphere eye{vec<N>(0, one), raw(2 * one)};
    parts = {BodyPart(BodyHull<S, N>{&solid, {}, {}}), BodyPart(eye, sensor)};
    compound = *solid_compound(9, parts);
    std::array<typename T::Part, 2> given{};
    for (auto& part : given) REQUIRE(C::part_defaults(&part) == DETENT_OK);
    given[0].shape = this->placed(DETENT_HULL, solid_handle, {});
    Out::shape(given[1].shape, eye);
    given[1].is_sensor = 1;
    REQUIRE(C::compound_create(&context, 9, given.data(), 2, &compound_handle) == DETENT_OK);

    Options fixed, plain, marked;
    fixed.motion = BodyMotion::fixed;
    const auto half = make_vec<N>([](int i) { return raw(i == 1 ? one : 20 * one); });
    floor = this->add(Obb<S, N>{vec<N>(0, -one), half, {}}, fixed);
    fixed.is_sensor = true;
    zone = this->add(Obb<S, N>{vec<N>(-4 * one, 2 * one), half, {}}, fixed);
    const auto at = vec<N>(5 * one, 4 * one);
    hull = this->add(this->placed(DETENT_HULL, solid_handle, at), BodyHull<S, N>{&solid, at, {}},
                     plain);
    marked.user = 77;
    ball = this->add(Sphere{vec<N>(9 * one, 2 * one), raw(one / 2)}, marked);
    for (std::size_t i = 0; i < 2; ++i) {
      const auto place = vec<N>(-4 * one + static_cast<int>(i) * 4 * one, 5 * one);
      compounds[i] = this->add(this->placed(DETENT_COMPOUND, compound_handle, place),
                               BodyCompound<S, N>{&compound, place, {}}, plain);
    }
  }

  /// Lets both scenes follow and compares their digests. Returns their number of objects.
  std::uint32_t follow(bool sensors) {
    REQUIRE(C::scene_follow(&context, scene, world, sensors ? 1 : 0) == DETENT_OK);
    REQUIRE(detent::follow(own, twin,
                           [&](const BodyInfo& body) { return sensors || !body.is_sensor; }));
    std::uint64_t sum = 0;
    std::uint32_t size = 0;
    REQUIRE(C::scene_digest(&context, scene, &sum) == DETENT_OK);
    REQUIRE(C::scene_size(&context, scene, &size) == DETENT_OK);
    CHECK(sum == digest(own));
    CHECK(size == own.size());
    return size;
  }
  /// The list that call(room, memory, count) writes; also into less memory.
  template <class Element, class Call>
  static std::vector<Element> list(const Call& call) {
    std::uint32_t count = 99;
    REQUIRE(call(0, static_cast<Element*>(nullptr), &count) == DETENT_OK);
    std::vector<Element> all(count + std::size_t{1}), some(all);
    REQUIRE(call(count, all.data(), &count) == DETENT_OK);
    if (count != 0) {
      REQUIRE(call(count - 1, some.data(), &count) == DETENT_OK);
      CHECK(generation_of(some[count - 1]) == 0);
    }
    all.resize(count);
    return all;
  }
};

template <int N>
void check_following() {
  using C = Calls<N>;
  using F = Followed<N>;
  F f;
  auto& context = f.context;
  for (int tick = 0; tick < 60; ++tick) {
    CAPTURE(N, tick);
    f.step();
    if (tick % 7 == 0) {
      CHECK(f.follow(false) == 5);
      CHECK(f.follow(true) == 8);
    }
  }
  f.follow(false);

  // A ray finds the ball, with the id and the user word of its body.
  typename c::Types<N>::Ray ray{};
  ray.origin = F::Out::vec(vec<N>(9 * one, 9 * one));
  ray.direction.y = -(1 << 30);
  ray.max_distance = 100 * one;
  typename c::Types<N>::ObjectHit hit{};
  REQUIRE(C::scene_raycast(&context, f.scene, &ray, ~0u, &hit) == DETENT_OK);
  CHECK(id_of(hit.id) == id_of(f.ball));
  detent_traits traits{};
  typename c::Types<N>::Shape shape{};
  REQUIRE(C::scene_object(&context, f.scene, f.ball, &shape, &traits) == DETENT_OK);
  CHECK(traits.user == 77);
  CHECK(shape.kind == DETENT_SPHERE);
  // Hulls name the solid hull, which the scene keeps alive after the world.
  REQUIRE(C::scene_object(&context, f.scene, f.hull, &shape, nullptr) == DETENT_OK);
  CHECK(shape.kind == DETENT_HULL);
  CHECK(shape.asset == f.solid_handle);

  // Parts of compounds.
  int parts = 0;
  for (std::uint32_t index = 0; index < 16; ++index) {
    for (const auto& id : f.compounds) {
      const detent_id object{index, id.generation};
      detent_id body{};
      std::uint32_t part = 9;
      const auto own = part_of(f.twin, id_of(object));
      REQUIRE(C::world_part_of(&context, f.world, object, &body, &part) ==
              c::yes_or_no(own.has_value()));
      if (!own) continue;
      CHECK(id_of(body) == own->body);
      CHECK(part == own->part);
      CHECK(C::world_part_of(&context, f.world, object, nullptr, nullptr) == DETENT_OK);
      ++parts;
    }
  }
  CHECK(parts >= 4);

  CHECK(C::scene_follow(&context, f.scene, f.scene, 0) == DETENT_BAD_HANDLE);
  CHECK(C::scene_follow(&context, f.world, f.world, 0) == DETENT_BAD_HANDLE);
  CHECK(C::scene_follow(&context, f.scene, f.world, 2) == DETENT_BAD_ARGUMENT);
  CHECK(C::world_destroy(&context, f.world) == DETENT_OK);
  CHECK(detent_asset_destroy(&context, f.compound_handle) == DETENT_OK);
  CHECK(detent_asset_destroy(&context, f.solid_handle) == DETENT_IN_USE);
  CHECK(C::scene_destroy(&context, f.scene) == DETENT_OK);
  CHECK(detent_asset_destroy(&context, f.solid_handle) == DETENT_OK);
}

template <int N>
void check_lists() {
  using C = Calls<N>;
  using F = Followed<N>;
  F f;
  auto& context = f.context;
  const auto ids_of = [&](auto call) {
    return F::template list<detent_id>(
        [&](std::uint32_t room, detent_id* out, std::uint32_t* count) {
          return call(&context, f.world, out, room, count);
        });
  };
  const auto touching = [&](detent_id body) {
    return F::template list<detent_touch>(
        [&](std::uint32_t room, detent_touch* out, std::uint32_t* count) {
          return C::world_touching(&context, f.world, body, out, room, count);
        });
  };
  CHECK(touching({}).empty());
  DistanceJoint<S, N> rope;
  rope.a = id_of(f.ball);
  rope.b = id_of(f.hull);
  rope.most = raw(8 * one);
  for (int i = 0; i < 3; ++i) {
    typename c::Types<N>::Joint given{};
    REQUIRE(C::joint_defaults(DETENT_DISTANCE_JOINT, &given) == DETENT_OK);
    given.a = f.ball;
    given.b = f.hull;
    given.upper = 8 * one;
    detent_id id{};
    REQUIRE(C::world_add_joint(&context, f.world, &given, &id) == DETENT_OK);
    REQUIRE(f.twin.add(rope));
    if (i == 1) {
      REQUIRE(C::world_remove_joint(&context, f.world, id) == DETENT_OK);
      REQUIRE(f.twin.remove(JointId{id.index, id.generation}));
    }
  }
  std::size_t seen = 0;
  for (int tick = 0; tick < 60; ++tick) {
    CAPTURE(N, tick);
    if (tick == 20 || tick == 40) {  // the ball is put into the sensor, and then above a compound
      const auto place = vec<N>(-one, (tick == 20 ? 9 : 8) * one);
      const auto theirs = F::Out::vec(place);
      REQUIRE(C::world_set_position(&context, f.world, f.ball, &theirs) == DETENT_OK);
      REQUIRE(f.twin.set_position(id_of(f.ball), place));
      auto axes = Rotation<S, N>();
      auto turned = F::Out::rotation(axes);
      std::swap(turned.axis[0], turned.axis[1]);
      turned.axis[1].x = -turned.axis[1].x;
      REQUIRE(C::world_set_rotation(&context, f.world, f.hull, &turned) == DETENT_OK);
      REQUIRE(f.twin.set_rotation(id_of(f.hull), c::Input<N>().rotation(turned)));
      turned.axis[0].x += 1 << 20;
      CHECK(C::world_set_rotation(&context, f.world, f.hull, &turned) == DETENT_NOT_UNIT);
    }
    f.step();
    const auto now = touching({});
    std::size_t i = 0;
    f.twin.for_each_touch([&](const TouchEvent& touch) {
      REQUIRE(i < now.size());
      CHECK(id_of(now[i].a) == touch.a);
      CHECK(id_of(now[i].b) == touch.b);
      CHECK(now[i].part_a == touch.part_a);
      CHECK(now[i].part_b == touch.part_b);
      CHECK(now[i].begins == 1);
      ++i;
    });
    CHECK(i == now.size());
    std::size_t of_zone = 0;
    for (const auto& touch : now) of_zone += id_of(touch.a) == id_of(f.zone) ? 1 : 0;
    CHECK(touching(f.zone).size() == of_zone);
    seen += of_zone;
  }
  CHECK(seen > 20);

  const auto bodies = ids_of(C::world_body_ids), joints = ids_of(C::world_joint_ids);
  REQUIRE(bodies.size() == f.twin.size());
  for (const auto& id : bodies) {
    detent_body_info info{};
    REQUIRE(C::world_info(&context, f.world, id, &info) == DETENT_OK);
    const auto own = f.twin.info(id_of(id));
    REQUIRE(own);
    CHECK(info.user == own->user);
    CHECK(info.layers == own->layers);
    CHECK(info.collides_with == own->collides_with);
    CHECK(info.motion == static_cast<std::uint32_t>(own->motion));
    CHECK((info.is_sensor == 1) == own->is_sensor);
    CHECK((info.is_asleep == 1) == own->is_asleep);
    const bool is_compound = id.index == f.compounds[0].index || id.index == f.compounds[1].index;
    CHECK(info.part_count == (is_compound ? 2 : 0));
  }
  std::size_t i = 0;
  f.twin.for_each_joint([&](const JointId& id) {
    REQUIRE(i < joints.size());
    CHECK(joints[i].index == id.index);
    CHECK(joints[i++].generation == id.generation);
  });
  CHECK(i == 2);
  CHECK(joints.size() == 2);
  const detent_id none{f.ball.index, f.ball.generation + 1};
  detent_body_info info{};
  const auto place = F::Out::vec({});
  CHECK(C::world_info(&context, f.world, none, &info) == DETENT_NO);
  CHECK(C::world_set_position(&context, f.world, none, &place) == DETENT_NO);
  CHECK((f.saved() == snapshot(f.twin)));
}

template <int N>
void check_contacts() {
  using C = Calls<N>;
  using F = Followed<N>;
  using Contact = typename c::Types<N>::WorldContact;
  F f;
  auto& context = f.context;
  const auto contacts = [&](detent_id body) {
    return F::template list<Contact>([&](std::uint32_t room, Contact* out, std::uint32_t* count) {
      return C::world_contacts(&context, f.world, body, out, room, count);
    });
  };
  CHECK(contacts({}).empty());
  std::size_t seen = 0, points = 0;
  for (int tick = 0; tick < 90; ++tick) {
    CAPTURE(N, tick);
    if (tick == 40) {
      REQUIRE(C::world_set_filter(&context, f.world, f.hull, 2, 5) == DETENT_OK);
      REQUIRE(f.twin.set_filter(id_of(f.hull), 2, 5));
      REQUIRE(C::world_set_friction(&context, f.world, f.ball, one / 8) == DETENT_OK);
      REQUIRE(f.twin.set_friction(id_of(f.ball), raw(one / 8)));
      REQUIRE(C::world_set_restitution(&context, f.world, f.ball, one / 2) == DETENT_OK);
      REQUIRE(f.twin.set_restitution(id_of(f.ball), raw(one / 2)));
      REQUIRE(C::world_set_sensor(&context, f.world, f.zone, 0) == DETENT_OK);
      REQUIRE(f.twin.set_sensor(id_of(f.zone), false));
      REQUIRE(C::world_set_gravity_scale(&context, f.world, f.hull, -one / 4) == DETENT_OK);
      REQUIRE(f.twin.set_gravity_scale(id_of(f.hull), raw(-one / 4)));
      REQUIRE(C::world_set_damping(&context, f.world, f.compounds[0], one / 2, 3) == DETENT_OK);
      REQUIRE(f.twin.set_damping(id_of(f.compounds[0]), raw(one / 2), raw(3)));
      REQUIRE(C::world_set_locked(&context, f.world, f.compounds[1], 63) == DETENT_OK);
      REQUIRE(f.twin.set_locked(id_of(f.compounds[1]), 63));
      REQUIRE(C::world_set_fast(&context, f.world, f.ball, 1) == DETENT_OK);
      REQUIRE(f.twin.set_fast(id_of(f.ball), true));
      REQUIRE(C::world_set_user(&context, f.world, f.ball, ~0ull - 5) == DETENT_OK);
      REQUIRE(f.twin.set_user(id_of(f.ball), ~0ull - 5));
      const Vec<S, N> gravity{raw(one / 4), raw(-9 * one)};
      const auto pull = F::Out::vec(gravity);
      REQUIRE(C::world_set_gravity(&context, f.world, &pull) == DETENT_OK);
      f.twin.set_gravity(gravity);
      CHECK((f.saved() == snapshot(f.twin)));
    }
    f.step();
    const auto now = contacts({});
    std::size_t i = 0;
    f.twin.for_each_contact([&](const WorldContact<S, N>& own) {
      REQUIRE(i < now.size());
      const auto& theirs = now[i++];
      CHECK(id_of(theirs.a) == own.a);
      CHECK(id_of(theirs.b) == own.b);
      CHECK(theirs.part_a == own.part_a);
      CHECK(theirs.part_b == own.part_b);
      CHECK(theirs.triangle == own.triangle);
      CHECK(theirs.normal.y == own.normal[1].raw());
      CHECK(theirs.impulse == own.impulse.raw());
      CHECK(theirs.friction.x == own.friction.x.raw());
      REQUIRE(theirs.count == own.count);
      for (std::size_t k = 0; k < own.count; ++k) {
        CHECK(theirs.points[k].point.x == own.points[k].point.x.raw());
        CHECK(theirs.points[k].separation == own.points[k].separation.raw());
        CHECK(theirs.points[k].impulse == own.points[k].impulse.raw());
        CHECK(theirs.points[k].feature == own.points[k].feature);
        ++points;
      }
    });
    CHECK(i == now.size());
    std::size_t of_floor = 0;
    for (const auto& contact : now) of_floor += id_of(contact.a) == id_of(f.floor) ? 1 : 0;
    CHECK(contacts(f.floor).size() == of_floor);
    seen += i;
  }
  CHECK(seen > 50);
  CHECK(points > seen);
  CHECK(C::world_set_friction(&context, f.world, f.ball, -1) == DETENT_BAD_ARGUMENT);
  CHECK(C::world_set_restitution(&context, f.world, f.ball, -1) == DETENT_BAD_ARGUMENT);
  CHECK(C::world_set_sensor(&context, f.world, f.ball, 2) == DETENT_BAD_ARGUMENT);
  CHECK(C::world_set_damping(&context, f.world, f.ball, -1, 0) == DETENT_BAD_ARGUMENT);
  CHECK(C::world_set_damping(&context, f.world, f.ball, 0, -1) == DETENT_BAD_ARGUMENT);
  CHECK(C::world_set_locked(&context, f.world, f.ball, 64) == DETENT_BAD_ARGUMENT);
  CHECK(C::world_set_locked(&context, f.world, f.ball, 256) == DETENT_BAD_ARGUMENT);
  CHECK(C::world_set_fast(&context, f.world, f.ball, 2) == DETENT_BAD_ARGUMENT);
  CHECK(C::world_set_gravity(&context, f.world, nullptr) == DETENT_BAD_ARGUMENT);
  const detent_id none{f.ball.index, f.ball.generation + 1};
  CHECK(C::world_set_filter(&context, f.world, none, 1, 1) == DETENT_NO);
  CHECK(C::world_set_friction(&context, f.world, none, 1) == DETENT_NO);
  CHECK(C::world_set_restitution(&context, f.world, none, 1) == DETENT_NO);
  CHECK(C::world_set_sensor(&context, f.world, none, 1) == DETENT_NO);
  CHECK(C::world_set_gravity_scale(&context, f.world, none, 1) == DETENT_NO);
  CHECK(C::world_set_damping(&context, f.world, none, 1, 1) == DETENT_NO);
  CHECK(C::world_set_locked(&context, f.world, none, 1) == DETENT_NO);
  CHECK(C::world_set_fast(&context, f.world, none, 1) == DETENT_NO);
  CHECK(C::world_set_user(&context, f.world, none, 1) == DETENT_NO);
  CHECK(contacts(none).empty());
  CHECK((f.saved() == snapshot(f.twin)));
}

TEST_CASE("C worlds: scenes follow them as in C++, in 2D") { check_following<2>(); }
TEST_CASE("C worlds: scenes follow them as in C++, in 3D") { check_following<3>(); }
TEST_CASE("C worlds: lists, properties and teleports are those of C++, in 2D") { check_lists<2>(); }
TEST_CASE("C worlds: lists, properties and teleports are those of C++, in 3D") { check_lists<3>(); }
TEST_CASE("C worlds: contacts and setters are those of C++, in 2D") { check_contacts<2>(); }
TEST_CASE("C worlds: contacts and setters are those of C++, in 3D") { check_contacts<3>(); }

}  // namespace
}  // namespace detent::test_c
