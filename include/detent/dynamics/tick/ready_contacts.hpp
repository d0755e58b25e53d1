// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "detent/dynamics/flight.hpp"
#include "detent/dynamics/rolling.hpp"
#include "detent/dynamics/solve.hpp"
#include "detent/dynamics/tick/contact_parts.hpp"
#include "detent/dynamics/tick/flights.hpp"
#include "detent/dynamics/tick/pair_contacts.hpp"

namespace detent::detail {

/// What contacts are solved with: they change the velocities in `flights` and the impulses in
/// `found`.
template <class Types>
struct ContactWork {
  const typename Types::Bodies& bodies;
  Flights<Types>& flights;
  FoundContacts<Types>& found;
};

/// The awake contacts in the order in which they are solved, with their rows.
template <class Types>
class ReadyContacts {
  using S = typename Types::S;
  static constexpr int N = Types::N;
  using Body = typename Types::Body;
  using Work = ContactWork<Types>;
  template <class T, std::size_t Room>
  using List = typename Types::template List<T, Room>;

 public:
  using Ready = ReadyContact<S, N>;
  using Rows = ContactRows<S, N>;

  constexpr void resize(std::size_t size, bool has_rolling) {
    ready_.resize(size);
    rows_.resize(size);
    rolling_.clear();
    if (has_rolling) rolling_.resize(size);
  }
  [[nodiscard]] constexpr std::size_t size() const noexcept { return ready_.size(); }
  [[nodiscard]] constexpr Ready& operator[](std::size_t i) noexcept { return ready_[i]; }
  /// Those of grouped contacts are unset, until they are needed.
  [[nodiscard]] constexpr Rows& rows(std::size_t i) noexcept { return rows_[i]; }

  /// Prepares a contact that is in no group.
  constexpr void prepare(const Work& work, std::size_t i) {
    set_surface(work, ready_[i]);
    prepare_rows(work, i);
    note_closing(work, ready_[i], rows_[i]);
  }
  /// The rows of a contact.
  constexpr void prepare_rows(const Work& work, std::size_t i) {
    auto& contact = ready_[i];
    const Body &a = work.bodies[contact.a], &b = work.bodies[contact.b];
    const auto& held = work.flights.held();
    const auto& found = work.found.manifolds[contact.contact];
    const auto [share_a, share_b] = mass_shares<S>(a, b);
    detail::prepare(contact, rows_[i], found.manifold, held[contact.a], held[contact.b],
                    found.offset, share_a, share_b);
    if (Types::has_round && rolling_.size() != 0) {
      const auto limit = rolling_limit<S, N>(a, b, work.found.contacts[contact.contact]);
      if (limit.is_any()) {
        rolling_[i] = prepare_rolling<S, N>(limit, share_of<S, N>(held[contact.a].spread, share_a),
                                            share_of<S, N>(held[contact.b].spread, share_b));
        rows_[i].rolling = &rolling_[i];
      }
    }
  }
  /// Friction and restitution of a contact.
  static constexpr void set_surface(const Work& work, Ready& contact) noexcept {
    using Ratio = typename Types::F::Ratio;
    const Body &a = work.bodies[contact.a], &b = work.bodies[contact.b];
    auto friction = std::array{a.friction, b.friction};
    auto restitution = std::array{a.restitution, b.restitution};
    if constexpr (Types::has_compounds) {
      const auto parts = ContactParts<Types>::of(work.bodies, work.found.contacts[contact.contact]);
      for (std::size_t k = 0; k < 2; ++k) {
        if (parts[k] == nullptr) continue;
        friction[k] = parts[k]->options().friction;
        restitution[k] = parts[k]->options().restitution;
      }
    }
    if (is_fixed<S> && friction[0] == friction[1] && friction[0] >= 0) {
      contact.grip = saturate_to<Ratio>(friction[0]);  // from a finer grid
    } else {
      contact.grip = sqrt_floor<Ratio>(friction[0] * friction[1]);
    }
    contact.bounce = saturate_to<Ratio>((max)(restitution[0], restitution[1]));
  }
  /// Records the rates of a contact that bounces, at the start of the tick.
  static constexpr void note_closing(const Work& work, const Ready& contact, Rows& row) noexcept {
    if (contact.bounce == 0) return;
    const auto a = Flights<Types>::at_start(work.bodies[contact.a]),
               b = Flights<Types>::at_start(work.bodies[contact.b]);
    for (std::size_t k = 0; k < contact.count; ++k) {
      row.closing[k] = rate_along<S, N>(row.normal.along, row.pressure[k], a.velocity, a.spin,
                                        b.velocity, b.spin);
    }
  }
  /// The gaps of a contact whose bodies have moved since they were held.
  static constexpr void measure_gaps(const Work& work, Ready& contact, const Rows& row) noexcept {
    const auto& moving = work.flights.moving();
    detail::measure_gaps(contact, row, moving[contact.a], moving[contact.b]);
  }

 private:
  List<Ready, Types::contacts_room> ready_;
  List<Rows, Types::contacts_room> rows_;
  List<Rolling<S, N>, Types::has_round ? Types::contacts_room : 0>
      rolling_;  // empty if no body resists it
};

}  // namespace detent::detail
