// SPDX-License-Identifier: MIT
// A group that stays idle is one whose contacts the solver would leave alone.
#include "detent/dynamics/idle.hpp"

#include <vector>

#include "detent/dynamics/dynamics.hpp"
#include "detent/dynamics/flight.hpp"
#include "dynamics/draw.hpp"
#include "support/catch.hpp"
#include "support/num.hpp"

namespace detent::test {
namespace {

using S = q16_16;
using F = detail::Formats<S>;
using Bodies = std::vector<detail::Moving<S, 3>>;

struct Contact {
  detail::Manifold<S, 3> manifold;
  Vec<F::Lever, 3> offset;
  detail::Support<S, 3> a, b;
};

detail::Support<S, 3> draw_support(Random& random, bool is_fixed) {
  detail::Support<S, 3> support;
  support.axes = detail::axes_of<S, 3>(draw_unit<F::Ratio, 4>(random));
  support.is_fixed = is_fixed;
  for (std::size_t i = 0; i < 3 && !is_fixed; ++i) {
    support.spread[i] = F::Gyration::assume_raw(random.between(0, std::int64_t{1} << 36));
  }
  return support;
}

/// Contacts with gaps of up to `gap` bits and bodies that move by up to `bits` bits.
void draw_contacts(Random& random, std::size_t size, int gap, int bits,
                   std::vector<Contact>& contacts, Bodies& bodies) {
  bodies.resize(2 * size);
  const int spins = random.coin() ? bits : 1;
  for (auto& body : bodies) {
    for (int i = 0; i < 3; ++i) {
      body.velocity[i] = draw<F::Speed>(random, bits);
      body.shift[i] = draw<F::Speed>(random, bits);
      body.spin[static_cast<std::size_t>(i)] = draw<F::Spin>(random, spins);
      body.turn[static_cast<std::size_t>(i)] = draw<F::Spin>(random, spins);
    }
  }
  for (std::size_t k = 0; k < size; ++k) {
    Contact contact;
    const bool is_fixed = random.one_in(4);
    contact.a = draw_support(random, is_fixed);
    contact.b = draw_support(random, false);
    if (is_fixed) bodies[2 * k] = {};
    contact.manifold.normal = draw_unit<F::Ratio, 3>(random);
    contact.manifold.count = static_cast<int>(random.between(1, 4));
    for (auto& point : contact.manifold.points) {
      for (int c = 0; c < 3; ++c) point.point[c] = draw<F::Lever>(random, 22);
      point.separation =
          F::Gap::assume_raw(static_cast<std::int32_t>(random.between(1, std::int64_t{1} << gap)));
    }
    for (int c = 0; c < 3; ++c) contact.offset[c] = draw<F::Lever>(random, 22);
    contacts.push_back(contact);
  }
}

/// Whether the passes of the solver leave a contact without impulses and its bodies alone, and whether
/// its gaps stay positive.
bool is_left_alone(const Contact& contact, const Bodies& bodies, std::size_t k) {
  auto a = bodies[2 * k], b = bodies[2 * k + 1];
  const auto va = a.velocity, vb = b.velocity;
  const auto wa = a.spin, wb = b.spin;
  const auto half = F::Ratio::assume_raw(1 << 29);
  const bool is_fixed = contact.a.is_fixed;
  detail::ReadyContact<S, 3> ready;
  detail::ContactRows<S, 3> rows;
  detail::BodyContact<S, 3> state;
  detail::prepare<S, 3>(ready, rows, contact.manifold, contact.a, contact.b, contact.offset,
                        is_fixed ? F::Ratio(0) : half, is_fixed ? F::Ratio(1) : half);
  ready.grip = F::Ratio(1);
  detail::measure_gaps(ready, rows, a, b);
  const auto fastest = F::Speed::assume_raw(1 << 20);
  detail::solve_pressure<detail::Pass::biased>(ready, rows, state, a, b, fastest, 0);
  detail::solve_pressure<detail::Pass::relaxed>(ready, rows, state, a, b, fastest, 0);
  detail::solve_friction(ready, rows, state, a, b);
  bool is_alone = state == detail::BodyContact<S, 3>() && a.velocity == va && b.velocity == vb &&
                  a.spin == wa && b.spin == wb;
  for (std::size_t i = 0; i < ready.count; ++i) is_alone = is_alone && ready.gap_now[i] > 0;
  return is_alone;
}

}  // namespace

TEMPLATE_TEST_CASE("idle contacts: the solver leaves those alone that stay idle", "",
                   detail::ArrayLongLanes, detail::FastLongLanes) {
  if (detail::may_run_vectors && !detail::runs_vectors()) return;  // compiled for AVX2
  Random random(0x1d1e);
  constexpr int rounds = 12'000;
  int idle = 0, alone = 0;
  for (int i = 0; i < rounds; ++i) {
    const auto size = static_cast<std::size_t>(random.between(1, 4));
    const int gap = static_cast<int>(random.between(8, 26));
    const int bits = (std::min)(gap + static_cast<int>(random.between(0, 8)), 30);
    std::vector<Contact> contacts;
    Bodies bodies;
    draw_contacts(random, size, gap, bits, contacts, bodies);
    detail::IdleGroup<S> group;
    bool are_alone = true;
    for (std::size_t k = 0; k < detail::long_lane_count; ++k) {
      const auto from = k < size ? k : 0;
      const auto& contact = contacts[from];
      group.a[k] = static_cast<std::uint32_t>(2 * from);
      group.b[k] = static_cast<std::uint32_t>(2 * from + 1);
      detail::place_idle<S>(group, k, contact.manifold, contact.a, contact.b, contact.offset);
      are_alone = are_alone && is_left_alone(contact, bodies, from);
    }
    const bool stays = detail::stay_idle<TestType, S>(group, bodies.data());
    INFO("round " << i);
    REQUIRE((!stays || are_alone));
    idle += stays ? 1 : 0;
    alone += are_alone ? 1 : 0;
  }
  INFO(idle << " of " << alone << " of " << rounds);
  CHECK((idle > rounds / 5 && idle > alone / 2 && alone < rounds * 4 / 5));
}

TEST_CASE("idle contacts: a world restored midway has the bits of one that was not") {
  using Physics = World<S, 3, Sphere, Obb>;
  WorldSettings<S, 3> settings;
  settings.sleep_speed = S(0);
  Physics world(settings);
  const auto box = [&](double x, double y) {
    world.add(Obb<S, 3>{{num<S>(x), num<S>(y), S(0)}, {num<S>(0.5), num<S>(0.5), num<S>(0.5)}, {}});
  };
  world.add(Obb<S, 3>{{S(0), S(-1), S(0)}, {S(20), S(1), S(20)}, {}},
            {.motion = BodyMotion::fixed});
  constexpr int base = 6;
  for (int row = 0; row < base; ++row) {
    for (int i = 0; i < base - row; ++i) box((i - (base - row - 1) / 2.0) * 1.03, 0.5 + row);
  }
  for (int tick = 0; tick < 40; ++tick) world.step();
  // A ball that pushes boxes against their neighbours.
  const auto ball = world.add(Sphere<S, 3>{{S(-6), num<S>(0.6), S(0)}, num<S>(0.5)},
                              {.density = S(4), .velocity = {S(12), S(0), S(0)}});
  REQUIRE(ball.has_value());
  for (int tick = 0; tick < 60; ++tick) {
    Physics restored(settings);
    restored.add(Obb<S, 3>{{S(0), S(-1), S(0)}, {S(20), S(1), S(20)}, {}},
                 {.motion = BodyMotion::fixed});
    REQUIRE(restore(restored, snapshot(world)) == Restored::yes);
    world.step();
    restored.step();
    REQUIRE(digest(restored) == digest(world));
  }
}

}  // namespace detent::test
