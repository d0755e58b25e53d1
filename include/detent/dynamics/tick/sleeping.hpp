// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "detent/dynamics/islands.hpp"
#include "detent/dynamics/tick/types.hpp"

namespace detent::detail {

/// Which islands of bodies sleep.
template <class Types>
class Sleeping {
  using S = typename Types::S;
  static constexpr int N = Types::N;
  using Body = typename Types::Body;
  using Bodies = typename Types::Bodies;

 public:
  /// Wakes islands: one is awake if one of its bodies is, or touches a moving kinematic body.
  /// `for_each_pair` calls its argument with the bodies of each contact that pushes and of each
  /// joint.
  template <class ForEachPair>
  constexpr void wake(Bodies& bodies, const ForEachPair& for_each_pair) {
    islands_.reset(bodies.size());
    for_each_pair([&](std::uint32_t a, std::uint32_t b) {
      if (bodies[a].can_move() && bodies[b].can_move()) islands_.join(a, b);
    });
    awake_.clear();
    awake_.resize(bodies.size());
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      if (bodies[i].can_move() && !bodies[i].sleeps) awake_[island(i)] = 1;
    }
    for_each_pair([&](std::uint32_t a, std::uint32_t b) {
      if (is_driven(bodies[a])) awake_[islands_.of(b)] = 1;
      if (is_driven(bodies[b])) awake_[islands_.of(a)] = 1;
    });
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      if (!bodies[i].can_move()) continue;
      const bool sleeps = awake_[island(i)] == 0;
      if (bodies[i].sleeps && !sleeps) bodies[i].quiet = 0;
      bodies[i].sleeps = sleeps;
    }
  }

  /// Counts the ticks in which awake bodies were slow, and lets quiet islands sleep.
  constexpr void rest(Bodies& bodies, const Pace<S, N>& pace) {
    for (std::size_t i = 0; i < bodies.size(); ++i) awake_[i] = 0;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      Body& body = bodies[i];
      if (!is_awake(body)) continue;
      const bool is_quiet = is_slow(body.state, pace);
      body.quiet = is_quiet ? static_cast<std::uint8_t>((std::min)(body.quiet + 1, 255)) : 0;
      if (body.quiet < (std::min)(pace.quiet_ticks, 255)) awake_[island(i)] = 1;
    }
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      Body& body = bodies[i];
      if (!is_awake(body) || awake_[island(i)] != 0 || pace.sleep <= 0) continue;
      body.sleeps = true;
      body.state.velocity = {};
      body.state.spin = {};
    }
  }

 private:
  [[nodiscard]] static constexpr bool is_slow(const BodyState<S, N>& state,
                                              const Pace<S, N>& pace) noexcept {
    for (int i = 0; i < N; ++i) {
      if (abs(state.velocity[i]) > pace.sleep) return false;
    }
    for (const auto& w : state.spin) {
      if (abs(w) > pace.sleep_spin) return false;
    }
    return true;
  }
  [[nodiscard]] constexpr std::uint32_t island(std::size_t body) noexcept {
    return islands_.of(static_cast<std::uint32_t>(body));
  }

  typename Types::template List<std::uint8_t, Types::bodies_room> awake_;
  Islands<typename Types::template List<std::uint32_t, Types::bodies_room>> islands_;
};

}  // namespace detent::detail
