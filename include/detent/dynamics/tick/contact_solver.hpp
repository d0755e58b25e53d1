// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "detent/dynamics/rolling.hpp"
#include "detent/dynamics/solve.hpp"
#include "detent/dynamics/threads.hpp"
#include "detent/dynamics/tick/colours.hpp"
#include "detent/dynamics/tick/contact_groups.hpp"
#include "detent/dynamics/tick/ready_contacts.hpp"

namespace detent::detail {

/// Solves the contacts of awake bodies, in order of their colours, four at once where this machine
/// has vectors.
///
/// Parallel calls write only to their own elements: contacts of one colour share no body that can
/// move.
template <class Types>
class ContactSolver {
  using S = typename Types::S;
  static constexpr int N = Types::N;
  using F = typename Types::F;
  using Body = typename Types::Body;
  using Bodies = typename Types::Bodies;
  using AllReady = ReadyContacts<Types>;
  using Ready = typename AllReady::Ready;
  using Rows = typename AllReady::Rows;
  using Work = ContactWork<Types>;
  static constexpr bool has_groups = Types::has_groups;
  static constexpr bool has_round = Types::has_round;
  static constexpr std::size_t colours = Colours<Types>::count;

 public:
  /// Orders the contacts and computes their rows.
  template <class Threads>
  constexpr void prepare(const Work& work, const Threads& threads) {
    const bool has_rolling = has_round && resist_rolling(work.bodies);
    are_grouped_ = has_groups && runs_vectors() && !has_rolling;  // groups have no rows for rolling
    order(work, has_rolling);
    prepare_all(work, threads);
    if (work.flights.are_held()) measure_gaps(work, threads);
  }

  /// Applies the impulses of the last substep.
  template <class Threads>
  constexpr void warm_start(const Work& work, const Threads& threads) {
    auto& moving = work.flights.moving();
    solve_each<OfIdle::skipped>(
        work, threads, [](auto& solver) { return solver.warm_start(); },
        [&](const Ready& ready, const Rows& rows) {
          const auto& contact = work.found.contacts[ready.contact];
          detail::warm_start(ready, rows, contact, moving[ready.a], moving[ready.b]);
          if constexpr (has_round) {
            warm_start_rolling(ready, rows, contact, moving[ready.a], moving[ready.b]);
          }
        });
  }
  /// One pass of a substep; only the relaxed one has friction.
  template <Pass P, class Threads>
  constexpr void solve(const Work& work, const typename F::Speed& push, std::size_t substep,
                       const Threads& threads) {
    auto& moving = work.flights.moving();
    solve_each<OfIdle::checked>(
        work, threads, [&](auto& solver) { return solver.template solve<P>(push, substep); },
        [&](Ready& ready, const Rows& rows) {
          auto& contact = work.found.contacts[ready.contact];
          solve_pressure<P>(ready, rows, contact, moving[ready.a], moving[ready.b], push, substep);
          if constexpr (P == Pass::relaxed) {
            if constexpr (has_round) {
              solve_rolling(ready, rows, contact, moving[ready.a], moving[ready.b]);
            }
            solve_friction(ready, rows, contact, moving[ready.a], moving[ready.b]);
          }
        });
  }

  /// After the last substep: writes the impulses back, lets contacts bounce, and notes which touch.
  template <class Threads>
  constexpr void finish(const Work& work, const typename F::Speed& bounce_threshold,
                        const Threads& threads) {
    if constexpr (has_groups) {
      if (are_grouped_) groups_.scatter_all(work, contacts_, threads);
    }
    auto& moving = work.flights.moving();
    for_each_ready(threads, [&](Ready& ready, const Rows& rows) {
      bounce(ready, rows, work.found.contacts[ready.contact], moving[ready.a], moving[ready.b],
             bounce_threshold);
    });
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
      const auto& ready = contacts_[i];
      bool touches = false;
      for (std::size_t k = 0; k < ready.count; ++k) {
        const auto& gap = work.flights.are_held() ? ready.gap_now[k] : ready.gap[k];
        touches = touches || ready.was_pushed[k] || gap <= 0;
      }
      work.found.contacts[ready.contact].touches = touches;
    }
  }

  /// Whether a body has an awake contact.
  [[nodiscard]] constexpr bool has_contact(std::size_t body) const noexcept {
    return colours_.has_contact(body);
  }

 private:
  [[nodiscard]] static constexpr bool resist_rolling(const Bodies& bodies) noexcept {
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      if (resists_rolling(bodies[i])) return true;
    }
    return false;
  }

  constexpr void order(const Work& work, bool has_rolling) {
    const auto& contacts = work.found.contacts;
    colours_.assign(work.bodies, contacts, [&](std::size_t i) { return seems_idle(work, i); });
    contacts_.resize(colours_.size(), has_rolling);
    colours_.for_each([&](std::uint32_t place, std::size_t i) {
      auto& ready = contacts_[place];
      ready.contact = static_cast<std::uint32_t>(i);
      ready.a = contacts[i].a;
      ready.b = contacts[i].b;
      ready.was_pushed = {};
    });
  }
  /// Whether a contact probably stays idle in this tick. A wrong guess costs only time.
  constexpr bool seems_idle(const Work& work, std::size_t i) const noexcept {
    if constexpr (has_groups) {
      if (!are_grouped_) return false;
      using Speed = typename F::Speed;
      const auto& contact = work.found.contacts[i];
      const auto& [manifold, offset] = work.found.manifolds[i];
      for (const auto& impulse : contact.pressure) {
        if (impulse != 0) return false;
      }
      for (const auto& impulse : contact.friction) {
        if (impulse != 0) return false;
      }
      auto least = manifold.points[0].separation;
      for (std::size_t k = 1; k < contact.count; ++k) {
        least = (min)(least, manifold.points[k].separation);
      }
      if (least <= 0) return false;
      const auto n = out_of_axes<S, N>(work.flights.held()[contact.a].axes, manifold.normal);
      const auto& moving = work.flights.moving();
      const auto &a = moving[contact.a], &b = moving[contact.b];
      const auto along = [&](const auto& of_a, const auto& of_b) {
        return nearest_to<Speed>(narrow_dot<62>(n, of_b - of_a));
      };
      const auto gap = saturate_to<Speed>(least) + along(a.shift, b.shift);
      const auto way = along(a.velocity, b.velocity);
      return gap > 0 && gap + ((way + way) + (way + way)) > 0;
    } else {
      return false;
    }
  }

  /// Calls f for each awake contact in order of colours, in parallel for those of one colour.
  template <class Threads, class Visit>
  constexpr void for_each_ready(const Threads& threads, const Visit& f) {
    const auto visit = [&](std::size_t i) { f(contacts_[i], contacts_.rows(i)); };
    std::size_t first = 0;
    if constexpr (Threads::are_many) {
      for (std::size_t c = 0; c + 1 < colours; ++c) {
        threads.each(first, colours_.end(c), contacts_a_call, visit);
        first = colours_.end(c);
      }
    }
    OneThread().each(first, contacts_.size(), 1, visit);
  }

  /// Solves awake contacts in order of colours: `together` solves a group, `alone` a single
  /// contact, and each contact of a group that `together` refuses.
  template <OfIdle Idle, class Threads, class Together, class Alone>
  constexpr void solve_each(const Work& work, const Threads& threads, const Together& together,
                            const Alone& alone) {
    if constexpr (has_groups) {
      if (are_grouped_) {
        groups_.template solve_each<Idle>(work, contacts_, threads, together, alone);
        OneThread().each(colours_.end(colours - 2), contacts_.size(), 1,
                         [&](std::size_t i) { alone(contacts_[i], contacts_.rows(i)); });
        return;
      }
    }
    for_each_ready(threads, alone);
  }
  template <class Threads>
  constexpr void prepare_all(const Work& work, const Threads& threads) {
    std::size_t first = 0;
    if constexpr (has_groups) {
      if (are_grouped_) {
        groups_.prepare(work, contacts_, colours_, threads);
        first = colours_.end(colours - 2);
      }
    }
    threads.each(first, contacts_.size(), contacts_a_call,
                 [&](std::size_t i) { contacts_.prepare(work, i); });
  }
  /// The gaps of contacts whose bodies have moved since they were held.
  template <class Threads>
  constexpr void measure_gaps(const Work& work, const Threads& threads) {
    solve_each<OfIdle::skipped>(
        work, threads, [](auto& solver) { return solver.measure_gaps(); },
        [&](Ready& ready, const Rows& rows) { AllReady::measure_gaps(work, ready, rows); });
  }
  // The work of one call on a thread: some microseconds, so that waiting for other threads costs
  // less.
  static constexpr std::size_t contacts_a_call = 32;

  struct Nothing {};

  Colours<Types> colours_;
  AllReady contacts_;
  std::conditional_t<has_groups, ContactGroups<Types>, Nothing> groups_;
  bool are_grouped_ = false;
};

}  // namespace detent::detail
