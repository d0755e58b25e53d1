// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "detent/dynamics/tick/contact_parts.hpp"

namespace detent::detail {

/// The order in which awake contacts are solved: by colours. Except for the last colour, contacts of
/// a colour share no body that can move, so they may be solved at once, and those that seem idle can
/// come last in their colour.
template <class Types>
class Colours {
  using Bodies = typename Types::Bodies;
  using Contacts = typename Types::Contacts;

 public:
  static constexpr std::size_t count = 64;

  /// Assigns a colour to each awake contact: the greatest, up to 47 for two moving bodies and up to
  /// 62 for others, that no earlier contact of its bodies has, or the last colour if there is none.
  /// So contacts with bodies that cannot move are solved last, and no later contact of the pass
  /// disturbs them.
  template <class SeemsIdle>
  constexpr void assign(const Bodies& bodies, const Contacts& contacts,
                        const SeemsIdle& seems_idle) {
    used_.clear();
    used_.resize(bodies.size());
    colour_.resize(contacts.size());
    std::array<std::uint32_t, count> busy{}, idle{};
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      const auto& contact = contacts[i];
      const bool moves_a = is_awake(bodies[contact.a]), moves_b = is_awake(bodies[contact.b]);
      if ((!moves_a && !moves_b) || ContactParts<Types>::is_sensed(bodies, contact)) {
        colour_[i] = asleep;
        continue;
      }
      const auto taken = (moves_a ? used_[contact.a] : 0) | (moves_b ? used_[contact.b] : 0);
      const int first = (moves_a && moves_b ? pair_colours : colours - 1) - 1;
      const int free = first - std::countl_one(taken << (colours - 1 - first));
      const int colour = free < 0 ? colours - 1 : free;
      colour_[i] = static_cast<std::uint8_t>(colour);
      if (moves_a) used_[contact.a] |= std::uint64_t{1} << colour;
      if (moves_b) used_[contact.b] |= std::uint64_t{1} << colour;
      if (colour < colours - 1 && seems_idle(i)) {
        colour_[i] |= idle_bit;
        ++idle[static_cast<std::size_t>(colour)];
      } else {
        ++busy[static_cast<std::size_t>(colour)];
      }
    }
    std::uint32_t end = 0;
    for (std::size_t c = 0; c < count; ++c) {
      busy_ends_[c] = end + busy[c];
      ends_[c] = end = busy_ends_[c] + idle[c];
    }
  }

  /// Calls f(place, i) with the place of each awake contact i in this order.
  template <class Visit>
  constexpr void for_each(const Visit& f) const {
    std::array<std::uint32_t, count> busy{}, idle = busy_ends_;
    for (std::size_t c = 0; c < count; ++c) busy[c] = begin(c);
    for (std::size_t i = 0; i < colour_.size(); ++i) {
      if (colour_[i] == asleep) continue;
      const std::size_t colour = colour_[i] & (count - 1);
      f((colour_[i] & idle_bit) != 0 ? idle[colour]++ : busy[colour]++, i);
    }
  }

  /// The number of awake contacts.
  [[nodiscard]] constexpr std::uint32_t size() const noexcept { return ends_[count - 1]; }
  /// Where a colour begins, where its contacts begin that seem idle, and where it ends.
  [[nodiscard]] constexpr std::uint32_t begin(std::size_t colour) const noexcept {
    return colour == 0 ? 0 : ends_[colour - 1];
  }
  [[nodiscard]] constexpr std::uint32_t busy_end(std::size_t colour) const noexcept {
    return busy_ends_[colour];
  }
  [[nodiscard]] constexpr std::uint32_t end(std::size_t colour) const noexcept {
    return ends_[colour];
  }

  /// Whether a body has an awake contact.
  [[nodiscard]] constexpr bool has_contact(std::size_t body) const noexcept {
    return used_[body] != 0;
  }

 private:
  static constexpr int colours = count, pair_colours = 48;
  static constexpr std::uint8_t asleep = 0xff;
  static constexpr std::uint8_t idle_bit = count;  // added to a colour

  typename Types::template List<std::uint8_t, Types::contacts_room> colour_;  // of contacts
  typename Types::template List<std::uint64_t, Types::bodies_room> used_;     // by each body
  std::array<std::uint32_t, count> ends_{}, busy_ends_{};
};

}  // namespace detent::detail
