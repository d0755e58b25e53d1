// SPDX-License-Identifier: MIT
// Four contacts side by side have the bits of four one after another, or are refused.
#include "detent/dynamics/contact_group.hpp"

#include <vector>

#include "dynamics/draw.hpp"
#include "support/catch.hpp"

namespace detent::test {
namespace {

using S = q16_16;
using F = detail::Formats<S>;
using Ready = detail::ReadyContact<S, 3>;
using Rows = detail::ContactRows<S, 3>;
using State = detail::BodyContact<S, 3>;
using Bodies = std::vector<detail::Moving<S, 3>>;

template <class T>
void draw(Random& random, int bits, Vec<T, 3>& v) {
  for (int i = 0; i < 3; ++i) v[i] = draw<T>(random, bits);
}
template <class T>
void draw(Random& random, int bits, std::array<T, 3>& v) {
  for (auto& x : v) x = draw<T>(random, bits);
}

struct Contacts {
  std::vector<Ready> ready;
  std::vector<Rows> rows;
  std::vector<State> state;
  Bodies bodies;
};

/// Contacts of bodies of their own. `bits` are those of velocities and impulses: with all that they
/// have, much is clamped. If `are_even`, impulses change both velocities of each contact equally.
Contacts contacts_of(Random& random, std::size_t size, int bits, bool are_even) {
  Contacts all;
  all.bodies.resize(2 * size + 1);
  for (auto& body : all.bodies) {
    draw(random, bits, body.velocity);
    draw(random, bits, body.spin);
    draw(random, bits, body.shift);
    draw(random, bits, body.turn);
  }
  const int share = 29, moment = 25, response = random.coin() ? 22 : 24;
  for (std::size_t k = 0; k < size; ++k) {
    Ready ready;
    Rows rows;
    State state;
    ready.contact = static_cast<std::uint32_t>(k);
    ready.a = static_cast<std::uint32_t>(2 * k + 1);
    const bool is_fixed = !are_even && random.coin();
    ready.b = static_cast<std::uint32_t>(is_fixed ? 0 : 2 * k + 2);  // 0: of several contacts
    ready.count = static_cast<std::uint8_t>(random.between(1, 4));
    ready.pushed = {true, ready.b != 0};
    ready.is_wall = random.coin();
    const auto draw_push = [&](detail::Thrust<S, 3>& push) {
      draw(random, share, push.along);
      draw(random, share, push.on_a);
      if (ready.b != 0) draw(random, share, push.on_b);
      if (are_even) push.on_b = push.on_a;
    };
    const auto draw_row = [&](detail::Row<S, 3>& row) {
      draw(random, moment, row.moment_a);
      draw(random, response, row.response_a);
      if (ready.b != 0) {
        draw(random, moment, row.moment_b);
        draw(random, response, row.response_b);
      }
      row.mass = F::Ratio::assume_raw(static_cast<std::int32_t>(random.between(0, 1 << 30)));
    };
    draw_push(rows.normal);
    for (auto& push : rows.tangent) draw_push(push);
    for (auto& row : rows.friction) draw_row(row);
    draw_row(rows.twist);
    for (std::size_t i = 0; i < ready.count; ++i) {
      draw_row(rows.pressure[i]);
      ready.gap[i] = draw<F::Speed>(random, bits);
      ready.gap_now[i] = draw<F::Speed>(random, bits);
      rows.reach[i] = narrow_abs(draw<F::Ratio>(random, 29));
      state.pressure[i] = random.coin() ? F::Impulse() : narrow_abs(draw<F::Impulse>(random, bits));
    }
    for (auto& x : state.friction) x = draw<F::Impulse>(random, bits);
    ready.grip = narrow_abs(draw<F::Ratio>(random, 29));
    all.ready.push_back(ready);
    all.rows.push_back(rows);
    all.state.push_back(state);
  }
  return all;
}

bool are_equal(const Bodies& a, const Bodies& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!(a[i].velocity == b[i].velocity && a[i].spin == b[i].spin)) return false;
  }
  return true;
}

/// Runs `together` on a group of the contacts and `alone` on each of a copy. Returns whether the group
/// was solved.
template <class Solver, class Together, class Alone>
bool run(const Contacts& start, const Together& together, const Alone& alone) {
  auto expected = start, found = start;
  detail::ContactGroup<S> group;
  group.size = static_cast<std::uint8_t>(start.ready.size());
  detail::gather(group, found.ready.data(), found.rows.data(), found.state.data());
  Solver solver(group, found.bodies.data());
  if (!together(solver)) {
    detail::scatter(group, found.ready.data(), found.state.data());
    REQUIRE(are_equal(found.bodies, start.bodies));
    REQUIRE(found.state == start.state);
    return false;
  }
  detail::scatter(group, found.ready.data(), found.state.data());
  for (std::size_t k = 0; k < start.ready.size(); ++k) {
    auto& ready = expected.ready[k];
    alone(ready, expected.rows[k], expected.state[ready.contact], expected.bodies[ready.a],
          expected.bodies[ready.b]);
  }
  REQUIRE(are_equal(found.bodies, expected.bodies));
  REQUIRE(found.state == expected.state);
  for (std::size_t k = 0; k < start.ready.size(); ++k) {
    REQUIRE(found.ready[k].gap_now == expected.ready[k].gap_now);
    REQUIRE(found.ready[k].was_pushed == expected.ready[k].was_pushed);
  }
  return true;
}

/// Compares a solver with contacts one after another, in each of its passes.
template <class Solver>
void compare(bool are_even) {
  Random random(0x9106);
  constexpr int rounds = 6000;
  int solved = 0;
  for (int i = 0; i < rounds; ++i) {
    const int bits = i % 2 == 0 ? 24 : static_cast<int>(random.between(20, 30));
    const auto start = contacts_of(random, 1 + random.below(4), bits, are_even);
    const auto fastest = F::Speed::assume_raw(1 << random.between(15, 24));
    const std::size_t substep = random.below(8);
    using detail::Pass;
    solved += run<Solver>(
        start, [](auto& solver) { return solver.warm_start(); },
        [](auto& ready, auto& rows, auto& state, auto& a, auto& b) {
          detail::warm_start(ready, rows, state, a, b);
        });
    solved += run<Solver>(
        start, [&](auto& solver) { return solver.template solve<Pass::biased>(fastest, substep); },
        [&](auto& ready, auto& rows, auto& state, auto& a, auto& b) {
          detail::solve_pressure<Pass::biased>(ready, rows, state, a, b, fastest, substep);
        });
    solved += run<Solver>(
        start, [&](auto& solver) { return solver.template solve<Pass::relaxed>(fastest, substep); },
        [&](auto& ready, auto& rows, auto& state, auto& a, auto& b) {
          detail::solve_pressure<Pass::relaxed>(ready, rows, state, a, b, fastest, substep);
          detail::solve_friction(ready, rows, state, a, b);
        });
  }
  CAPTURE(solved);
  CHECK(solved > rounds * 3 * 0.3);
  CHECK(solved < rounds * 3 * 0.9);
}

}  // namespace

TEMPLATE_TEST_CASE("contact groups: four contacts at once have the bits of one after another", "",
                   detail::ArrayLongLanes, detail::FastLongLanes) {
  if (detail::may_run_vectors && !detail::runs_vectors()) return;  // compiled for AVX2
  compare<detail::GroupSolver<TestType, S>>(false);
}

TEMPLATE_TEST_CASE("contact groups: the same of bodies with equal shares, by fewer products", "",
                   detail::ArrayLongLanes, detail::FastLongLanes) {
  if (detail::may_run_vectors && !detail::runs_vectors()) return;  // compiled for AVX2
  compare<detail::GroupSolver<TestType, S, true>>(true);
}

}  // namespace detent::test
