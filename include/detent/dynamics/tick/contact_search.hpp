// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>

#include "detent/dynamics/tick/flights.hpp"
#include "detent/dynamics/tick/pair_contacts.hpp"

namespace detent::detail {

/// The search for the contacts of all pairs of a tick.
template <class Types>
class ContactSearch {
  using S = typename Types::S;
  using Lever = typename Types::F::Lever;
  using Bodies = typename Types::Bodies;
  using Contacts = typename Types::Contacts;
  using ContactState = typename Types::ContactState;

 public:
  using Found = FoundContacts<Types>;

  /// The contacts of `pairs`, in order of their bodies, with the impulses of those of the last tick,
  /// `before`. On several threads each block of pairs has its own list, and the lists are
  /// concatenated in order.
  template <class Pairs, class Threads>
  constexpr void find(const Bodies& bodies, const Pairs& pairs, const Flights<Types>& flights,
                      const Contacts& before, const S& reach, const Lever& margin,
                      const Threads& threads) {
    found_.contacts.clear();
    found_.manifolds.clear();
    if constexpr (Threads::are_many && Types::is_growing) {
      searches_.resize((pairs.size() + pairs_a_call - 1) / pairs_a_call);
      threads.each(0, searches_.size(), 1, [&](std::size_t k) {
        auto mine = std::move(searches_[k]);
        mine.contacts.clear();
        mine.manifolds.clear();
        const auto begin = k * pairs_a_call;
        find_in(bodies, pairs, flights, before, reach, margin, begin,
                (std::min)(begin + pairs_a_call, pairs.size()), mine);
        searches_[k] = std::move(mine);
      });
      for (const auto& part : searches_) {
        for (std::size_t i = 0; i < part.contacts.size(); ++i) {
          if (found_.contacts.size() == Types::contacts_room) return;
          found_.contacts.push_back(part.contacts[i]);
          found_.manifolds.push_back(part.manifolds[i]);
        }
      }
    } else {
      add(bodies, pairs, flights, before, reach, margin);
    }
  }
  /// Adds the contacts of more pairs to those found.
  template <class Pairs>
  constexpr void add(const Bodies& bodies, const Pairs& pairs, const Flights<Types>& flights,
                     const Contacts& before, const S& reach, const Lever& margin) {
    find_in(bodies, pairs, flights, before, reach, margin, 0, pairs.size(), found_);
  }

  [[nodiscard]] constexpr const Found& found() const noexcept { return found_; }
  [[nodiscard]] constexpr Found& found() noexcept { return found_; }

 private:
  /// The contacts of the pairs from `begin` to before `end`.
  template <class Pairs>
  static constexpr void find_in(const Bodies& bodies, const Pairs& pairs,
                                const Flights<Types>& flights, const Contacts& before,
                                const S& reach, const Lever& margin, std::size_t begin,
                                std::size_t end, Found& out) {
    std::size_t old = 0;
    if (begin != 0) {
      old = static_cast<std::size_t>(
          std::partition_point(
              before.data(), before.data() + before.size(),
              [&](const ContactState& contact) { return pair_of(contact) < pairs[begin]; }) -
          before.data());
    }
    const auto& held = flights.held();
    for (std::size_t p = begin; p < end && !out.is_full(); ++p) {
      const BodyPair pair = pairs[p];
      while (old < before.size() && pair_of(before[old]) < pair) ++old;
      PairContacts<Types>::find(bodies, {pair.a, held[pair.a], held[pair.b]}, pair,
                                flights.slack(pair), before, old, reach, margin, out);
    }
  }

  /// The work of one call on a thread: some microseconds, so that waiting for other threads costs
  /// less.
  static constexpr std::size_t pairs_a_call = 32;

  Found found_;
  typename Types::template List<Found, 0> searches_;  // for growing worlds, on several threads
};

}  // namespace detent::detail
