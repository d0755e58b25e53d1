// SPDX-License-Identifier: MIT
#include "detent/dynamics/particle/snapshot.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "detent/dynamics/particle/cloth.hpp"
#include "detent/number/literals.hpp"
#include "detent/scene/difference.hpp"
#include "dynamics/stage.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"
#include "support/seal.hpp"

namespace detent::test {

using namespace literals;

namespace {

using Bytes = std::vector<std::byte>;

template <Scalar S, int N>
ParticleSystem<S, N> curtain() {
  ParticleSystem<S, N> system;
  FabricOptions<S, N> linen;
  linen.bend = S(3);
  const auto cloth =
      add_cloth(system, at<S, N>(0, 0), at<S, N>(0.25, 0), at<S, N>(0.05, -0.25), 5, 4, linen);
  REQUIRE(cloth);
  system.set_pinned(cloth->at(0, 0), true);
  system.set_pinned(cloth->at(4, 0), true);
  REQUIRE(system.add(DistanceConstraint<S>{0, 19, S(1), S(0), true}));
  return system;
}

}  // namespace

TEMPLATE_TEST_CASE("particle snapshot: a restore at any tick continues with the same bits", "",
                   q16_16, q8_8, double) {
  using S = TestType;
  const auto exam = [](auto dimension) {
    constexpr int N = decltype(dimension)::value;
    auto system = curtain<S, N>();
    ParticleSystem<S, N> fresh;
    REQUIRE(fresh.add(at<S, N>(3, 3)));
    for (int t = 0; t < 60; ++t) {
      if (t == 20) system.set_pinned(0, false);
      if (t == 30) REQUIRE(system.remove(1, 2));
      if (t == 40) system.move_to(4, at<S, N>(2, 1));
      const auto bytes = snapshot(system);
      REQUIRE(restore(fresh, bytes) == Restored::yes);
      REQUIRE(snapshot(fresh) == bytes);
      system.step();
      fresh.step();
      REQUIRE(digest(fresh) == digest(system));
    }
  };
  exam(std::integral_constant<int, 2>());
  exam(std::integral_constant<int, 3>());
}

TEST_CASE("particle snapshot: the status says why it does not fit") {
  const auto system = curtain<q16_16, 2>();
  auto bytes = snapshot(system);
  ParticleSystem<q16_16, 3> solid;
  CHECK(restore(solid, bytes) == Restored::other_scene);
  ParticleSystem<q14_16, 2> shorter;
  CHECK(restore(shorter, bytes) == Restored::other_scene);
  ParticleSettings<q16_16, 2> settings;
  settings.friction = 1_q16_16;
  ParticleSystem<q16_16, 2> rough(settings);
  CHECK(restore(rough, bytes) == Restored::other_scene);
  BoundedParticleSystem<Bounded<19>, q16_16, 2> small;
  CHECK(restore(small, bytes) == Restored::no_room);
  BoundedParticleSystem<Bounded<20>, q16_16, 2> exact;
  CHECK(restore(exact, bytes) == Restored::yes);
  CHECK(digest(exact) == digest(system));
  std::vector<std::byte> room(bytes.size());
  CHECK(snapshot(exact, room) == bytes.size());
  CHECK(room == bytes);
  CHECK(bytes.size() == 48 + 20 * (2 * 12 + 4 + 4 + 1) + 17 * system.constraint_count());
  CHECK(restore(exact, std::span<const std::byte>(bytes).first(3)) == Restored::truncated);
  CHECK(restore(exact, std::span<const std::byte>(bytes).first(60)) == Restored::truncated);
  bytes[4] = std::byte{9};
  CHECK(restore(exact, bytes) == Restored::other_version);
  bytes[0] = std::byte{0};
  CHECK(restore(exact, bytes) == Restored::no_snapshot);
}

TEST_CASE("particle snapshot: constraints that no system could have are refused") {
  auto system = curtain<q16_16, 2>();
  const auto bytes = snapshot(system);
  const std::size_t particle = 2 * 12 + 4 + 4 + 1, constraint = 17;
  const auto begin = 40 + 20 * particle;
  const auto after = [&](const auto& change) {
    auto changed = bytes;
    change(changed);
    seal(changed);
    return restore(system, changed);
  };
  CHECK(after([](Bytes&) {}) == Restored::yes);
  const auto first = [&](std::uint32_t a, std::uint32_t b) {
    return after([&](Bytes& changed) {
      detail::store_word(changed.data() + begin, a);
      detail::store_word(changed.data() + begin + 4, b);
    });
  };
  CHECK(first(0, 1) == Restored::yes);
  CHECK(first(0, 0) == Restored::corrupted);
  CHECK(first(1, 0) == Restored::corrupted);
  CHECK(first(0, 2) == Restored::corrupted);  // that of the second one
  CHECK(first(0, 20) == Restored::corrupted);
  CHECK(after([&](Bytes& changed) { changed[begin - 1] = std::byte{2}; }) == Restored::corrupted);
  CHECK(after([&](Bytes& changed) { changed[begin + constraint - 1] = std::byte{2}; }) ==
        Restored::corrupted);
  CHECK(after([&](Bytes& changed) { changed[10] = std::byte{1}; }) == Restored::corrupted);
  CHECK(digest(system) == digest(curtain<q16_16, 2>()));
}

TEST_CASE("particle snapshot: hostile bytes are refused or give a valid system") {
  auto system = curtain<q16_16, 3>();
  for (int t = 0; t < 10; ++t) system.step();
  const auto bytes = snapshot(system);
  Random random(3);
  int taken = 0;
  for (int i = 0; i < 4000; ++i) {
    auto changed = bytes;
    for (auto k = random.below(3) + 1; k > 0; --k) {
      changed[random.below(changed.size())] = static_cast<std::byte>(random.next());
    }
    if (random.one_in(8)) changed.resize(random.below(changed.size() + 1));
    if (changed.size() >= 8 && !random.one_in(8)) seal(changed);
    auto target = system;
    if (restore(target, changed) == Restored::yes) {
      ++taken;
      REQUIRE(snapshot(target) == changed);
      target.step();
    } else {
      REQUIRE(digest(target) == digest(system));
    }
  }
  CAPTURE(taken);
  CHECK(taken > 800);
  CHECK(taken < 3200);
}

TEST_CASE("particle snapshot: diff names what differs") {
  const auto system = curtain<q16_16, 2>();
  auto other = system;
  CHECK(digest(other) == digest(system));
  other.set_velocity(3, at<q16_16, 2>(0, 1));
  const auto first = diff(system, other);
  REQUIRE(first);
  CHECK(first->field.view() == "particle 3 velocity.y");
  other = system;
  CHECK(other.remove(1, 2));
  REQUIRE(diff(system, other));
  CHECK(diff(system, other)->field.view() == "constraint 1 2");
}

}  // namespace detent::test
