// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "detent/dynamics/flight.hpp"
#include "detent/dynamics/four_flight.hpp"
#include "detent/dynamics/hold.hpp"
#include "detent/dynamics/tick/types.hpp"

namespace detent::detail {

/// Where the bodies of a world are during a tick, how they move, and where they are held.
template <class Types>
class Flights {
  using S = typename Types::S;
  static constexpr int N = Types::N;
  using F = typename Types::F;
  using Body = typename Types::Body;
  using Bodies = typename Types::Bodies;
  static constexpr bool has_groups = Types::has_groups;

 public:
  /// Sets the supports of all bodies.
  template <class Threads>
  constexpr void place(const Bodies& bodies, const Threads& threads) {
    supports_.resize(bodies.size());
    moving_.resize(bodies.size());
    half_way_.resize(bodies.size());
    each_block(bodies, threads, [&](std::size_t begin, std::size_t end) {
      SupportQueue<has_groups, S, N, Bodies, decltype(supports_)> queue(bodies, supports_);
      for (std::size_t i = begin; i < end; ++i) {
        if (bodies[i].generation != 0) queue.add(i, false);
      }
      queue.flush();
    });
  }
  [[nodiscard]] constexpr const auto& supports() const noexcept { return supports_; }
  [[nodiscard]] constexpr auto& supports() noexcept { return supports_; }

  /// Finds all slacks, and the poses at which bodies that move little are held, if any may be.
  constexpr void hold_back(const Bodies& bodies, bool may_hold) {
    are_held_ = may_hold;
    if constexpr (has_groups) {
      held_ = supports_;
      hold_back(bodies, held_);
    } else {
      hold_back(bodies, supports_);
    }
  }
  /// Whether bodies that move little are held.
  [[nodiscard]] constexpr bool are_held() const noexcept { return are_held_; }
  /// The supports of contacts: where held bodies are held. Worlds that process four contacts at once
  /// keep them for the whole tick; others replace them by the bodies' own poses in `let_go`.
  [[nodiscard]] constexpr const auto& held() const noexcept {
    if constexpr (has_groups) {
      return held_;
    } else {
      return supports_;
    }
  }
  /// By how much two bodies may have come closer since they were held.
  [[nodiscard]] constexpr auto slack(const BodyPair& pair) const noexcept {
    auto slack = typename F::Lever() + typename F::Lever();
    if (are_held_) slack = slacks_[pair.a] + slacks_[pair.b];
    return slack;
  }
  /// Sets the supports of contacts to the current poses.
  constexpr void let_go(const Bodies& bodies) noexcept {
    if constexpr (!has_groups) {
      for (std::size_t i = 0; i < bodies.size(); ++i) {
        if (bodies[i].is_held()) detail::let_go(supports_[i], bodies[i]);
      }
    }
  }

  /// Sets how bodies move at the start of the tick.
  constexpr void start(const Bodies& bodies) {
    for (std::size_t i = 0; i < moving_.size(); ++i) {
      moving_[i] = at_start(bodies[i]);
      if (!are_held_) continue;
      moving_[i].shift = bodies[i].drift;
      moving_[i].turn = leans_[i];
    }
  }
  /// The velocities of a body at the start of the tick.
  [[nodiscard]] static constexpr Moving<S, N> at_start(const Body& body) noexcept {
    Moving<S, N> moving;
    if (body.generation == 0 || body.motion == BodyMotion::fixed) return moving;
    moving.velocity = body.state.velocity;
    moving.spin = body.state.spin;
    return moving;
  }
  [[nodiscard]] constexpr const auto& moving() const noexcept { return moving_; }
  [[nodiscard]] constexpr auto& moving() noexcept { return moving_; }

  /// The first half of a substep.
  template <class Threads>
  constexpr void accelerate(Bodies& bodies, const Pace<S, N>& pace, const Threads& threads) {
    each_block(bodies, threads, [&](std::size_t begin, std::size_t end) {
      Turner<1> turner{*this, bodies};
      for (std::size_t i = begin; i < end; ++i) {
        if (!is_awake(bodies[i])) continue;
        detail::accelerate(bodies[i], moving_[i], pace);
        if (tumbles(bodies[i])) turner.add(i);
      }
      turner.flush();
    });
  }
  /// The second half of a substep.
  template <class Threads>
  constexpr void move(Bodies& bodies, const Threads& threads) {
    each_block(bodies, threads, [&](std::size_t begin, std::size_t end) {
      Turner<0> turner{*this, bodies};
      for (std::size_t i = begin; i < end; ++i) {
        if (!is_awake(bodies[i]) && !is_driven(bodies[i])) continue;
        detail::move(bodies[i], moving_[i]);
        turner.add(i);
      }
      turner.flush();
    });
  }

 private:
  template <class Supports>
  constexpr void hold_back(const Bodies& bodies, Supports& held) {
    if (!are_held_) return;
    slacks_.resize(bodies.size());
    leans_.resize(bodies.size());
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      leans_[i] = {};
      if (bodies[i].is_held()) leans_[i] = detail::hold_back(held[i], bodies[i]);
      slacks_[i] = slack_of(bodies[i], leans_[i]);
    }
  }

  /// Calls f(begin, end) for ranges of bodies: of one body, or of 32 where four are processed at
  /// once.
  template <class Threads, class Visit>
  static constexpr void each_block(const Bodies& bodies, const Threads& threads, const Visit& f) {
    constexpr std::size_t size = 32;
    if constexpr (has_groups) {
      threads.each(0, (bodies.size() + size - 1) / size, bodies_a_call / size,
                   [&](std::size_t k) { f(k * size, (std::min)((k + 1) * size, bodies.size())); });
    } else {
      threads.each(0, bodies.size(), bodies_a_call, [&](std::size_t i) { f(i, i + 1); });
    }
  }

  /// Turns bodies by their spins, half-way or to their new orientation, and carries the spins of
  /// those that tumble, four at once where this machine has vectors.
  template <int Halvings>
  struct Turner {
    struct Nothing {};
    struct Fours {
      std::size_t size = 0;
      Quad<std::uint32_t> waiting{};
      FourTurns<S> turns{};
    };
    Flights& flights;
    Bodies& bodies;
    std::conditional_t<has_groups, Fours, Nothing> fours{};

    constexpr void add(std::size_t i) {
      if constexpr (has_groups) {
        if (runs_vectors()) {
          fours.waiting[fours.size++] = static_cast<std::uint32_t>(i);
          if (fours.size == long_lane_count) turn();
          return;
        }
      }
      turned_to(i, turned<S, N, Halvings>(bodies[i].state.orientation, flights.moving_[i].spin));
    }
    constexpr void flush() {
      if constexpr (has_groups) {
        if (fours.size != 0) turn();
        if (fours.turns.size != 0) carry_on();
      }
    }

   private:
    /// Continues once a body's new orientation is known.
    constexpr void turned_to(std::size_t i, const auto& orientation) {
      Body& body = bodies[i];
      if constexpr (Halvings == 0) body.state.orientation = orientation;
      if constexpr (N == 3) {
        if (!tumbles(body)) return;
        auto &axes = flights.supports_[i].axes, &half_way = flights.half_way_[i];
        const auto& from = Halvings == 0 ? half_way : axes;
        auto& to = Halvings == 0 ? axes : half_way;
        if constexpr (has_groups) {
          if (runs_vectors()) {
            fours.turns.add(static_cast<std::uint32_t>(i), orientation, body.inertia, from, to);
            if (fours.turns.size == long_lane_count) carry_on();
            return;
          }
        }
        carry(body, flights.moving_[i], orientation, from, to);
      }
    }
    constexpr void turn() {
      Quad<const BodyState<S, N>*> states{};
      Quad<Vec<typename F::Ratio, 4>> result{};
      for (std::size_t k = fours.size; k < long_lane_count; ++k)
        fours.waiting[k] = fours.waiting[0];
      for (std::size_t k = 0; k < long_lane_count; ++k) states[k] = &bodies[fours.waiting[k]].state;
      const bool is_done = turn_four<FastLongLanes, Halvings, S>(states, flights.moving_.data(),
                                                                 fours.waiting, result);
      for (std::size_t k = 0; k < fours.size; ++k) {
        const auto i = fours.waiting[k];
        turned_to(i, is_done ? result[k]
                             : turned<S, N, Halvings>(bodies[i].state.orientation,
                                                      flights.moving_[i].spin));
      }
      fours.size = 0;
    }
    constexpr void carry_on() {
      const bool is_done = carry_four<FastLongLanes>(fours.turns, flights.moving_.data());
      for (std::size_t k = 0; k < fours.turns.size; ++k) {
        const auto i = fours.turns.body[k];
        auto& moving = flights.moving_[i];
        if (is_done) {
          lock<S, N>(bodies[i].locked, moving.velocity, moving.spin);
        } else {
          carry(bodies[i], moving, fours.turns.orientation[k], *fours.turns.from[k],
                *fours.turns.to[k]);
        }
      }
      fours.turns.size = 0;
    }
  };

  // The work of one call on a thread: some microseconds, so that waiting for other threads costs
  // less.
  static constexpr std::size_t bodies_a_call = 64;

  template <class T, std::size_t Room>
  using List = typename Types::template List<T, Room>;

  List<Support<S, N>, Types::bodies_room> supports_;
  List<Support<S, N>, 0> held_;  // for worlds that process four contacts at once
  List<typename F::Lever, Types::bodies_room> slacks_;          // of bodies, if they may be held
  List<Axial<typename F::Spin, N>, Types::bodies_room> leans_;  // how far these have turned since
  List<Moving<S, N>, Types::bodies_room> moving_;
  List<Axes<S, N>, Types::bodies_room> half_way_;  // the axes at the middle of the substep
  bool are_held_ = false;
};

}  // namespace detent::detail
