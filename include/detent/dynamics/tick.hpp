// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>

#include "detent/dynamics/tick/broad_phase.hpp"
#include "detent/dynamics/tick/contact_search.hpp"
#include "detent/dynamics/tick/contact_solver.hpp"
#include "detent/dynamics/tick/fast_bodies.hpp"
#include "detent/dynamics/tick/flights.hpp"
#include "detent/dynamics/tick/sleeping.hpp"
#include "detent/dynamics/tick/types.hpp"

namespace detent::detail {

/// One step of a world with its scratch data, which do not outlive the step, so copies of a world,
/// which a rollback makes in every frame, omit them.
template <class Types>
class Tick {
  using S = typename Types::S;
  static constexpr int N = Types::N;
  using F = typename Types::F;
  using Body = typename Types::Body;
  using Bodies = typename Types::Bodies;
  using Contacts = typename Types::Contacts;
  using Joints = typename Types::Joints;
  using Lever = typename F::Lever;
  using Work = ContactWork<Types>;

 public:
  constexpr Tick() noexcept = default;
  constexpr Tick(const Tick&) noexcept {}
  constexpr Tick& operator=(const Tick&) noexcept { return *this; }

  /// One step. Returns whether it changed nothing, in which case the next one would not either.
  template <class Threads>
  constexpr bool run(Bodies& bodies, Contacts& contacts, Joints& joints, const Pace<S, N>& pace,
                     int substeps, const S& margin, const Threads& threads) {
    flights_.place(bodies, threads);
    const bool has_fast = fast_.start(bodies, flights_.supports());
    group_.part(joints);
    pairs_.find(bodies, flights_.supports(), group_, margin);
    flights_.hold_back(bodies, pace.hold > 0);
    search_.find(bodies, pairs_.pairs(), flights_, contacts, margin, pace.margin, threads);
    wake(bodies, joints);
    const bool is_still = !has_fast && stands_still(bodies) && have_stayed(contacts);
    flights_.start(bodies);
    const Work work{bodies, flights_, search_.found()};
    solver_.prepare(work, threads);
    flights_.let_go(bodies);
    group_.prepare(joints, bodies, flights_.supports(), pace.rate);
    for (int i = 0; i < substeps; ++i) {
      substep(static_cast<std::size_t>(i), bodies, joints, pace, work, threads);
    }
    group_.finish(joints);
    solver_.finish(work, pace.bounce, threads);
    finish(bodies, pace);
    if (has_fast) {
      fast_.stop_all(bodies, group_, margin);
      find_passes(bodies, contacts, margin, pace.margin, threads);
    }
    std::swap(contacts, search_.found().contacts);
    return is_still;
  }

  /// The pairs with a sensor of which a fast body passed the other one in the last run, in order.
  /// They touched neither at its start nor at its end.
  [[nodiscard]] constexpr const auto& passes() const noexcept { return fast_.passes(); }

  /// The contacts before the last run.
  [[nodiscard]] constexpr const Contacts& contacts_before() const noexcept {
    return search_.found().contacts;
  }

  /// Calls f(index) for each joint that broke in the last run, in order.
  template <class Broken>
  constexpr void for_each_broken(const Broken& f) const {
    group_.for_each_broken(f);
  }

 private:
  constexpr void wake(Bodies& bodies, const Joints& joints) {
    const auto& contacts = search_.found().contacts;
    sleeping_.wake(bodies, [&](const auto& f) {
      for (std::size_t i = 0; i < contacts.size(); ++i) {
        if (!ContactParts<Types>::is_sensed(bodies, contacts[i])) f(contacts[i].a, contacts[i].b);
      }
      group_.for_each_pair(joints, f);
    });
  }

  template <class Threads>
  constexpr void substep(std::size_t index, Bodies& bodies, Joints& joints, const Pace<S, N>& pace,
                         const Work& work, const Threads& threads) {
    auto& moving = flights_.moving();
    auto& supports = flights_.supports();
    flights_.accelerate(bodies, pace, threads);
    group_.warm_start(joints, moving, supports);
    solver_.warm_start(work, threads);
    group_.template solve_all<Pass::biased>(joints, moving, supports);
    solver_.template solve<Pass::biased>(work, pace.push, index, threads);
    flights_.move(bodies, threads);
    group_.follow(joints, bodies, supports);
    group_.template solve_all<Pass::relaxed>(joints, moving, supports);
    solver_.template solve<Pass::relaxed>(work, pace.push, index, threads);
  }

  /// Writes velocities back, and lets quiet islands sleep.
  constexpr void finish(Bodies& bodies, const Pace<S, N>& pace) {
    const auto& moving = flights_.moving();
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      Body& body = bodies[i];
      if (!is_awake(body)) continue;
      body.state.velocity = moving[i].velocity;
      body.state.spin = moving[i].spin;
      if (flights_.are_held()) {
        if (solver_.has_contact(i)) {
          note_hold(body, moving[i], pace);
        } else {
          body.let_go();
        }
      }
      body.push = {};
      body.twist = {};
    }
    sleeping_.rest(bodies, pace);
  }

  /// Finds the sensors that fast bodies passed in this tick. What touches at the end is left to the
  /// next one, which finds these contacts again.
  template <class Threads>
  constexpr void find_passes(Bodies& bodies, const Contacts& before, const S& reach,
                             const Lever& margin, const Threads& threads) {
    auto& contacts = search_.found().contacts;
    fast_.find_passes(bodies, group_, contacts);
    if (fast_.passes().size() == 0) return;
    const auto now = contacts.size();
    fast_.list_pairs(pairs_.pairs());
    flights_.place(bodies, threads);
    flights_.hold_back(bodies, flights_.are_held());
    search_.add(bodies, pairs_.pairs(), flights_, before, reach, margin);
    fast_.remove_touching(bodies, contacts, now);
    contacts.resize(now);
  }

  /// Whether no body moves on its own.
  static constexpr bool stands_still(const Bodies& bodies) noexcept {
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      if (is_awake(bodies[i]) || is_driven(bodies[i])) return false;
    }
    return true;
  }
  /// Whether the contacts are those of the last tick.
  constexpr bool have_stayed(const Contacts& before) const noexcept {
    const auto& now = search_.found().contacts;
    if (before.size() != now.size()) return false;
    for (std::size_t i = 0; i < before.size(); ++i) {
      if (!(before[i] == now[i])) return false;
    }
    return true;
  }

  Flights<Types> flights_;
  FastBodies<Types> fast_;
  BroadPhase<Types> pairs_;
  ContactSearch<Types> search_;
  Sleeping<Types> sleeping_;
  ContactSolver<Types> solver_;
  typename Types::Group group_;
};

}  // namespace detent::detail

// All headers that use them are included above.
#undef DETENT_BEGIN_LONG_LANES
#undef DETENT_END_LONG_LANES
