// SPDX-License-Identifier: MIT
#include "detent/dynamics/snapshot.hpp"

#include <algorithm>
#include <span>
#include <vector>

#include "dynamics/stage.hpp"
#include "dynamics/step_alike.hpp"
#include "oracle/space.hpp"
#include "support/catch.hpp"
#include "support/seal.hpp"

namespace detent::test {
namespace {

template <class S, int N>
using Balls = World<S, N, Sphere>;

/// The initial state of the balls of `heap`, by index.
template <Scalar S, int N>
void put_ball(Balls<S, N>& world, std::uint32_t index) {
  BodyOptions<S, N> options;
  if (index == 0) options.motion = BodyMotion::fixed;
  options.density = num<S>(1 + index % 3);
  options.restitution = num<S>(0.25 * (index % 2));
  auto at_start = at<S, N>(0.4 * (index % 5) - 0.8, 1.0 + 1.3 * index);
  at_start[N - 1] = N == 3 ? num<S>(0.3 * (index % 4)) : at_start[N - 1];
  const auto ball = index == 0 ? Sphere<S, N>{at<S, N>(0, -50), S(50)}
                               : Sphere<S, N>{at_start, num<S>(0.4 + 0.1 * (index % 3))};
  REQUIRE(world.put({index, 1 + index % 2}, ball, options));
}

constexpr std::uint32_t ball_count = 24;

template <Scalar S, int N>
Balls<S, N> heap() {
  Balls<S, N> world;
  for (std::uint32_t i = 0; i < ball_count; ++i) put_ball(world, i);
  return world;
}

TEMPLATE_TEST_CASE("snapshot: a restored world continues bit for bit", "", DETENT_FIXED_SCALARS,
                   double) {
  using S = TestType;
  const auto exam = [](auto dimension) {
    constexpr int N = decltype(dimension)::value;
    auto world = heap<S, N>();
    for (int t = 0; t < 240; ++t) {
      if (t % 40 == 7) {
        Balls<S, N> fresh;
        put_ball(fresh, 0);
        add_ball(fresh, 3, 3);  // not in the snapshot, so restore removes it
        const auto bytes = snapshot(world);
        REQUIRE(restore(fresh, bytes) == Restored::yes);
        CHECK(snapshot(fresh) == bytes);
        auto copy = world;
        step_alike(copy, fresh, 100);
      }
      world.step();
    }
  };
  exam(std::integral_constant<int, 2>());
  exam(std::integral_constant<int, 3>());
}

TEST_CASE("snapshot: bits do not depend on the order of additions and removals") {
  using S = q16_16;
  auto forward = heap<S, 3>();
  Balls<S, 3> backward;
  for (std::uint32_t i = ball_count; i-- > 0;) put_ball(backward, i);
  Balls<S, 3> changed;
  for (std::uint32_t i = 0; i < ball_count; i += 2) put_ball(changed, i);
  for (std::uint32_t i = 0; i < ball_count; i += 3) {
    (void)changed.remove({i, 1 + i % 2});
  }
  for (std::uint32_t i = ball_count; i-- > 0;) {
    if (!changed.contains({i, 1 + i % 2})) put_ball(changed, i);
  }
  for (int t = 0; t < 400; ++t) {
    REQUIRE(digest(forward) == digest(backward));
    REQUIRE(digest(forward) == digest(changed));
    if (t == 200) {
      for (auto* world : {&forward, &backward, &changed}) REQUIRE(world->remove({5, 2}));
      put_ball(forward, 5);
      put_ball(backward, 5);
      put_ball(changed, 5);
    }
    forward.step();
    backward.step();
    changed.step();
  }
}

TEST_CASE("snapshot: without its impulses a world diverges") {
  auto world = heap<q16_16, 2>();
  for (int t = 0; t < 120; ++t) world.step();
  auto other = world;
  auto& contacts = detail::WorldAccess::contacts(other);
  REQUIRE(contacts.size() > 10);
  for (auto& contact : contacts) contact.pressure = {};
  world.step();
  other.step();
  CHECK(digest(world) != digest(other));
}

TEST_CASE("snapshot: takes 72 bytes per body, held or not, and little for contacts") {
  const auto size_of = [](int count) {
    Balls<q16_16, 3> world;
    for (int i = 0; i < count; ++i) add_ball(world, 3.0 * i, 0);
    return snapshot(world).size();
  };
  CHECK(size_of(11) - size_of(10) == 72);
  Balls<q16_16, 3> world;
  add_round_ground(world);
  add_ball(world, 0, 1);
  const auto apart = snapshot(world).size();
  world.step();
  REQUIRE(detail::WorldAccess::contacts(world).size() == 1);
  REQUIRE(detail::WorldAccess::bodies(world)[1].is_held());
  CHECK(snapshot(world).size() - apart == 8 + 8 + 12);  // one contact point of four
}

TEST_CASE("snapshot: hostile bytes change nothing and do no harm") {
  auto world = heap<q16_16, 3>();
  for (int t = 0; t < 100; ++t) world.step();
  const auto good = snapshot(world);
  Balls<q16_16, 3> fresh;
  put_ball(fresh, 0);
  const auto before = digest(fresh);
  for (std::size_t length = 0; length < good.size(); ++length) {
    REQUIRE(restore(fresh, std::span(good).first(length)) != Restored::yes);
  }
  int refused = 0, accepted = 0;
  for (std::size_t i = 0; i + 8 < good.size(); ++i) {
    for (const int bit : {0, 5, 7}) {
      auto bytes = good;
      bytes[i] ^= static_cast<std::byte>(1 << bit);
      REQUIRE(restore(fresh, bytes) != Restored::yes);  // the checksum is wrong
      REQUIRE(digest(fresh) == before);
      seal(bytes);
      auto target = fresh;
      if (restore(target, bytes) == Restored::yes) {
        ++accepted;
        REQUIRE(snapshot(target) == bytes);  // every accepted snapshot is canonical
        if (i % 16 == 0) {
          for (int t = 0; t < 3; ++t) target.step();
        }
      } else {
        ++refused;
      }
    }
  }
  CHECK(refused > 500);
  CHECK(accepted > 500);
}

TEST_CASE("snapshot: other settings, levels, scalars and shapes are refused") {
  auto world = heap<q16_16, 2>();
  const auto bytes = snapshot(world);
  WorldSettings<q16_16, 2> slow;
  slow.substeps = 5;
  Balls<q16_16, 2> other_settings(slow);
  put_ball(other_settings, 0);
  CHECK(restore(other_settings, bytes) == Restored::other_scene);
  Balls<q16_16, 2> other_level;
  CHECK(restore(other_level, bytes) == Restored::other_fixed_part);
  Balls<q16_16, 3> other_dimension;
  CHECK(restore(other_dimension, bytes) == Restored::other_scene);
  World<q16_16, 2, Sphere, Obb> other_shapes;
  CHECK(restore(other_shapes, bytes) == Restored::other_scene);
  BoundedWorld<Bounded<8>, q16_16, 2, Sphere> small;
  BodyOptions<q16_16, 2> fixed;
  fixed.motion = BodyMotion::fixed;
  fixed.density = num<q16_16>(1);
  REQUIRE(small.put({0, 1}, Sphere<q16_16, 2>{at<q16_16, 2>(0, -50), q16_16(50)}, fixed));
  CHECK(restore(small, bytes) == Restored::no_room);
}

TEST_CASE("snapshot: the digest of a body is its own") {
  auto world = heap<q16_16, 2>();
  const BodyId id{3, 2};
  const auto before = digest_of(world, id);
  const auto other = digest_of(world, BodyId{4, 1});
  world.set_velocity(id, at<q16_16, 2>(1, 0));
  CHECK(digest_of(world, id) != before);
  CHECK(digest_of(world, BodyId{4, 1}) == other);
  CHECK(digest_of(world, BodyId{3, 1}) == 0);
}

}  // namespace
}  // namespace detent::test
