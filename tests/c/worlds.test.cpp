// SPDX-License-Identifier: MIT
//
// Compares worlds of the C interface with C++: equal calls give equal bits.

#include <cstdint>
#include <cstring>
#include <vector>

#include "c/worlds.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace detent {
namespace {

using S = q16_16;
using c::id_of;
constexpr int one = 65536;

/// The functions of one dimension.
template <int N>
struct Calls;
#define DETENT_TEST_CALLS(N)                                                  \
  template <>                                                                 \
  struct Calls<N> {                                                           \
    static constexpr auto create = detent_world##N##_create;                  \
    static constexpr auto default_options = detent_body##N##_default_options; \
    static constexpr auto add = detent_world##N##_add;                        \
    static constexpr auto remove = detent_world##N##_remove;                  \
    static constexpr auto step = detent_world##N##_step;                      \
    static constexpr auto body = detent_world##N##_body;                      \
    static constexpr auto bodies = detent_world##N##_bodies;                  \
    static constexpr auto set_velocity = detent_world##N##_set_velocity;      \
    static constexpr auto set_spin = detent_world##N##_set_angular_velocity;  \
    static constexpr auto apply_impulse = detent_world##N##_apply_impulse;    \
    static constexpr auto apply_force = detent_world##N##_apply_force;        \
    static constexpr auto apply_torque = detent_world##N##_apply_torque;      \
    static constexpr auto events = detent_world##N##_events;                  \
    static constexpr auto digest = detent_world##N##_digest;                  \
    static constexpr auto digest_of = detent_world##N##_digest_of;            \
    static constexpr auto snapshot = detent_world##N##_snapshot;              \
    static constexpr auto restore = detent_world##N##_restore;                \
  };
DETENT_TEST_CALLS(2)
DETENT_TEST_CALLS(3)

template <int N>
void check_history() {
  using C = Calls<N>;
  using T = c::Types<N>;
  using Out = c::Output<N>;
  using W = typename c::Worlds<N>::World;
  test::Random random(40 + N);
  detent_context context{};
  detent_handle world = 0;
  REQUIRE(detent_open(&context, nullptr) == DETENT_OK);
  REQUIRE(C::create(&context, nullptr, &world) == DETENT_OK);
  W twin;
  std::vector<detent_id> ids;
  std::vector<std::byte> saved;
  std::size_t began = 0;

  const auto vec = [&](int size) {
    return make_vec<N>(
        [&](int) { return S::from_raw(static_cast<std::int32_t>(random.between(-size, size))); });
  };
  const auto add = [&](const auto& shape, typename W::Options own) {
    typename T::Shape theirs{};
    Out::shape(theirs, shape);
    typename T::BodyOptions options{};
    REQUIRE(C::default_options(&options) == DETENT_OK);
    options.motion = static_cast<std::uint32_t>(own.motion);
    options.restitution = own.restitution.raw();
    options.rolling_resistance = own.rolling_resistance.raw();
    options.gravity_scale = own.gravity_scale.raw();
    options.velocity = Out::vec(own.velocity);
    options.angular_velocity[0] = own.angular_velocity[0].raw();
    options.locked = own.locked;
    options.is_sensor = own.is_sensor ? 1 : 0;
    options.user = own.user;
    detent_id id{};
    REQUIRE(C::add(&context, world, &theirs, &options, &id) == DETENT_OK);
    REQUIRE(twin.add(shape, own) == id_of(id));
    if (own.motion != BodyMotion::fixed) ids.push_back(id);
  };
  const auto save = [&] {
    std::uint32_t size = 0;
    REQUIRE(C::snapshot(&context, world, nullptr, 0, &size) == DETENT_NO);
    std::vector<std::byte> bytes(size);
    REQUIRE(C::snapshot(&context, world, bytes.data(), size, &size) == DETENT_OK);
    return bytes;
  };

  typename W::Options fixed;
  fixed.motion = BodyMotion::fixed;
  auto low = Vec<S, N>{}, high = Vec<S, N>{};
  for (int i = 0; i < N; ++i) {
    low[i] = i == 1 ? S(-1) : S(-9);
    high[i] = i == 1 ? S(0) : S(9);
  }
  add(Aabb{low, high}, fixed);

  for (int tick = 0; tick < 150; ++tick) {
    CAPTURE(N, tick);
    if (tick % 8 == 0) {
      typename W::Options own;
      own.restitution = S::from_raw(static_cast<std::int32_t>(random.below(one)));
      if (random.coin()) {
        own.rolling_resistance = S::from_raw(static_cast<std::int32_t>(random.below(one / 2)));
      }
      own.gravity_scale = S::from_raw(static_cast<std::int32_t>(random.below(2 * one)));
      own.velocity = vec(3 * one);
      own.angular_velocity[0] = S::from_raw(static_cast<std::int32_t>(random.below(one)));
      own.locked = static_cast<std::uint8_t>(random.one_in(3) ? random.below(64) : 0);
      own.is_sensor = random.one_in(6);
      own.motion = random.one_in(8) ? BodyMotion::kinematic : BodyMotion::dynamic;
      own.user = random.next();
      auto place = vec(2 * one);
      place.y = S(3);
      auto half = Vec<S, N>{};
      for (int i = 0; i < N; ++i) half[i] = S::from_raw(one / 2);
      auto end = place;
      end.x = nearest_to<S>(end.x + S(1));
      switch (random.below(3)) {
        case 0:
          add(Sphere{place, S::from_raw(one / 2)}, own);
          break;
        case 1:
          add(Obb{place, half, Rotation<S, N>()}, own);
          break;
        default:
          add(Capsule{place, end, S::from_raw(one / 3)}, own);
      }
    }
    const detent_id which = ids[random.below(ids.size())];
    const auto push = vec(2 * one), at = vec(2 * one);
    const auto theirs = Out::vec(push), point = Out::vec(at);
    const bool exists = twin.contains(id_of(which));
    const auto yes = c::yes_or_no(exists);
    auto spin = twin.angular_velocity(id_of(which));
    std::int32_t numbers[3] = {};
    for (std::size_t i = 0; i < spin.size(); ++i) {
      spin[i] = push[static_cast<int>(i) % N];
      numbers[i] = spin[i].raw();
    }
    switch (random.below(8)) {
      case 0:
        REQUIRE(C::set_velocity(&context, world, which, &theirs) == yes);
        twin.set_velocity(id_of(which), push);
        break;
      case 1:
        REQUIRE(C::set_spin(&context, world, which, numbers) == yes);
        twin.set_angular_velocity(id_of(which), spin);
        break;
      case 2:
        REQUIRE(C::apply_impulse(&context, world, which, &theirs, &point) == yes);
        twin.apply_impulse(id_of(which), push, at);
        break;
      case 3:
        REQUIRE(C::apply_impulse(&context, world, which, &theirs, nullptr) == yes);
        twin.apply_impulse(id_of(which), push);
        break;
      case 4:
        REQUIRE(C::apply_force(&context, world, which, &theirs, &point) == yes);
        twin.apply_force(id_of(which), push, at);
        break;
      case 5:
        REQUIRE(C::apply_force(&context, world, which, &theirs, nullptr) == yes);
        twin.apply_force(id_of(which), push);
        break;
      case 6:
        REQUIRE(C::apply_torque(&context, world, which, numbers) == yes);
        twin.apply_torque(id_of(which), spin);
        break;
      default:
        if (!random.one_in(4)) break;
        REQUIRE(C::remove(&context, world, which) == yes);
        REQUIRE(twin.remove(id_of(which)) == exists);
    }
    REQUIRE(C::step(&context, world) == DETENT_OK);
    twin.step();

    std::uint64_t sum = 0;
    REQUIRE(C::digest(&context, world, &sum) == DETENT_OK);
    REQUIRE(sum == digest(twin));
    std::vector<detent_touch> touches(64);
    std::uint32_t count = 0;
    REQUIRE(C::events(&context, world, touches.data(), 64, &count) == DETENT_OK);
    REQUIRE(count == twin.event_count());
    for (std::size_t i = 0; i < count; ++i) {
      const auto& own = twin.event(i);
      REQUIRE(id_of(touches[i].a) == own.a);
      REQUIRE(id_of(touches[i].b) == own.b);
      REQUIRE((touches[i].begins == 1) == own.begins);
      began += own.begins ? 1 : 0;
    }
    std::vector<typename T::Body> many(ids.size());
    REQUIRE(C::bodies(&context, world, ids.data(), static_cast<std::uint32_t>(ids.size()),
                      many.data()) == DETENT_OK);
    for (std::size_t i = 0; i < ids.size(); ++i) {
      typename T::Body body{};
      const auto id = id_of(ids[i]);
      REQUIRE(C::body(&context, world, ids[i], &body) == c::yes_or_no(twin.contains(id)));
      REQUIRE(std::memcmp(&body, &many[i], sizeof body) == 0);
      if (!twin.contains(id)) continue;
      REQUIRE(c::Input<N>::vec(body.position) == twin.position(id));
      REQUIRE(c::Input<N>::vec(body.velocity) == twin.velocity(id));
      REQUIRE(c::Input<N>().rotation(body.rotation) == twin.rotation(id));
      REQUIRE(body.angular_velocity[0] == twin.angular_velocity(id)[0].raw());
      REQUIRE((body.is_asleep == 1) == twin.is_asleep(id));
      REQUIRE(C::digest_of(&context, world, ids[i], &sum) == DETENT_OK);
      REQUIRE(sum == digest_of(twin, id));
    }
    if (tick == 75) saved = save();
  }
  CHECK(began > 10);
  CHECK((save() == snapshot(twin)));
  REQUIRE(C::restore(&context, world, saved.data(), static_cast<std::uint32_t>(saved.size())) ==
          DETENT_OK);
  REQUIRE(restore(twin, saved) == Restored::yes);
  for (int tick = 0; tick < 20; ++tick) {
    REQUIRE(C::step(&context, world) == DETENT_OK);
    twin.step();
  }
  CHECK((save() == snapshot(twin)));
  saved[80] ^= std::byte{1};
  CHECK(C::restore(&context, world, saved.data(), static_cast<std::uint32_t>(saved.size())) ==
        DETENT_CORRUPTED);
  CHECK(detent_close(&context) == DETENT_OK);
}

TEST_CASE("C worlds: histories give the bits of C++, in 2D") { check_history<2>(); }
TEST_CASE("C worlds: histories give the bits of C++, in 3D") { check_history<3>(); }

}  // namespace
}  // namespace detent
