// SPDX-License-Identifier: MIT
//
// Compares worlds of the C interface with C++: equal calls give equal bits.

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#include "world_twins.hpp"

namespace detent::test_c {
namespace {

template <int N>
void check_history() {
  using C = Calls<N>;
  using T = c::Types<N>;
  using Out = c::Output<N>;
  test::Random random(40 + N);
  WorldTwins<N> twins;
  auto& context = twins.context;
  const auto world = twins.world;
  auto& twin = twins.twin;
  std::vector<detent_id> ids;
  std::vector<std::byte> saved;

  const auto vec = [&](int size) {
    return make_vec<N>([&](int) { return raw(random.between(-size, size)); });
  };
  const auto add = [&](const auto& shape, const BodyOptions<S, N>& own) {
    const auto id = twins.add(shape, own);
    if (own.motion != BodyMotion::fixed) ids.push_back(id);
  };

  BodyOptions<S, N> fixed;
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
      BodyOptions<S, N> own;
      own.restitution = raw(random.between(0, one));
      if (random.coin()) {
        own.rolling_resistance = raw(random.between(0, one / 2));
      }
      own.gravity_scale = raw(random.between(0, 2 * one));
      own.velocity = vec(3 * one);
      own.angular_velocity[0] = raw(random.between(0, one));
      own.locked = static_cast<std::uint8_t>(random.one_in(3) ? random.below(64) : 0);
      own.is_sensor = random.one_in(6);
      own.motion = random.one_in(8) ? BodyMotion::kinematic : BodyMotion::dynamic;
      own.user = random.next();
      auto place = vec(2 * one);
      place.y = S(3);
      auto half = Vec<S, N>{};
      for (int i = 0; i < N; ++i) half[i] = raw(one / 2);
      auto end = place;
      end.x = nearest_to<S>(end.x + S(1));
      switch (random.below(3)) {
        case 0:
          add(Sphere{place, raw(one / 2)}, own);
          break;
        case 1:
          add(Obb{place, half, Rotation<S, N>()}, own);
          break;
        default:
          add(Capsule{place, end, raw(one / 3)}, own);
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
        REQUIRE(C::world_set_velocity(&context, world, which, &theirs) == yes);
        twin.set_velocity(id_of(which), push);
        break;
      case 1:
        REQUIRE(C::world_set_angular_velocity(&context, world, which, numbers) == yes);
        twin.set_angular_velocity(id_of(which), spin);
        break;
      case 2:
        REQUIRE(C::world_apply_impulse(&context, world, which, &theirs, &point) == yes);
        twin.apply_impulse(id_of(which), push, at);
        break;
      case 3:
        REQUIRE(C::world_apply_impulse(&context, world, which, &theirs, nullptr) == yes);
        twin.apply_impulse(id_of(which), push);
        break;
      case 4:
        REQUIRE(C::world_apply_force(&context, world, which, &theirs, &point) == yes);
        twin.apply_force(id_of(which), push, at);
        break;
      case 5:
        REQUIRE(C::world_apply_force(&context, world, which, &theirs, nullptr) == yes);
        twin.apply_force(id_of(which), push);
        break;
      case 6:
        REQUIRE(C::world_apply_torque(&context, world, which, numbers) == yes);
        twin.apply_torque(id_of(which), spin);
        break;
      default:
        if (!random.one_in(4)) break;
        REQUIRE(C::world_remove(&context, world, which) == yes);
        REQUIRE(twin.remove(id_of(which)) == exists);
    }
    twins.step();

    std::vector<typename T::Body> many(ids.size());
    REQUIRE(C::world_bodies(&context, world, ids.data(), static_cast<std::uint32_t>(ids.size()),
                            many.data()) == DETENT_OK);
    for (std::size_t i = 0; i < ids.size(); ++i) {
      typename T::Body body{};
      const auto id = id_of(ids[i]);
      REQUIRE(C::world_body(&context, world, ids[i], &body) == c::yes_or_no(twin.contains(id)));
      REQUIRE(std::memcmp(&body, &many[i], sizeof body) == 0);
      if (!twin.contains(id)) continue;
      REQUIRE(c::Input<N>::vec(body.position) == twin.position(id));
      REQUIRE(c::Input<N>::vec(body.velocity) == twin.velocity(id));
      REQUIRE(c::Input<N>().rotation(body.rotation) == twin.rotation(id));
      REQUIRE(body.angular_velocity[0] == twin.angular_velocity(id)[0].raw());
      REQUIRE((body.is_asleep == 1) == twin.is_asleep(id));
      std::uint64_t sum = 0;
      REQUIRE(C::world_digest_of(&context, world, ids[i], &sum) == DETENT_OK);
      REQUIRE(sum == digest_of(twin, id));
    }
    if (tick == 75) saved = twins.saved();
  }
  CHECK(twins.began > 10);
  CHECK((twins.saved() == snapshot(twin)));
  REQUIRE(twins.restore(saved) == DETENT_OK);
  REQUIRE(restore(twin, saved) == Restored::yes);
  for (int tick = 0; tick < 20; ++tick) twins.step();
  CHECK((twins.saved() == snapshot(twin)));
  saved[80] ^= std::byte{1};
  CHECK(twins.restore(saved) == DETENT_CORRUPTED);
}

TEST_CASE("C worlds: histories give the bits of C++, in 2D") { check_history<2>(); }
TEST_CASE("C worlds: histories give the bits of C++, in 3D") { check_history<3>(); }

}  // namespace
}  // namespace detent::test_c
