// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

#include "detent/dynamics/tick/types.hpp"

namespace detent::detail {

/// What the contacts of a world are of: whole bodies, or parts of compounds.
template <class Types>
class ContactParts {
  using S = typename Types::S;
  static constexpr int N = Types::N;
  using Bodies = typename Types::Bodies;
  using ContactState = typename Types::ContactState;

 public:
  /// The identity of a contact in events: bodies, and the parts of compounds, but no triangles.
  template <class Contact>
  [[nodiscard]] static constexpr ContactKey touching(const Bodies& bodies,
                                                     const Contact& contact) noexcept {
    auto key = key_of(contact);
    if (!are_compounds(bodies, key.pair)) key.part = 0;
    return key;
  }
  /// The same of a pair of parts.
  [[nodiscard]] static constexpr ContactKey touching(const Bodies& bodies, const BodyPair& pair,
                                                     std::uint32_t part_a,
                                                     std::uint32_t part_b) noexcept {
    if (compound_of<S, N>(bodies[pair.a].shape) == nullptr) {
      return {pair, static_cast<std::uint16_t>(part_b)};
    }
    return {pair, static_cast<std::uint16_t>(part_a), part_b};
  }
  /// The indices of the parts of compounds; 0 for other bodies.
  [[nodiscard]] static constexpr std::array<std::uint32_t, 2> indices(
      const Bodies& bodies, const ContactKey& key) noexcept {
    if (compound_of<S, N>(bodies[key.pair.a].shape) == nullptr) return {0, key.member};
    const bool are_two = compound_of<S, N>(bodies[key.pair.b].shape) != nullptr;
    return {key.member, are_two ? key.part : 0};
  }
  /// The triangle of a contact with a mesh or height field; 0 for others.
  [[nodiscard]] static constexpr std::uint32_t triangle_of(const Bodies& bodies,
                                                           const ContactState& contact) noexcept {
    return are_compounds(bodies, pair_of(contact)) ? 0 : contact.part;
  }

  /// The parts that touch; nullptr for bodies that are not compounds.
  [[nodiscard]] static constexpr std::array<const BodyPart<S, N>*, 2> of(
      const Bodies& bodies, const ContactState& contact) noexcept {
    const auto* a = compound_of<S, N>(bodies[contact.a].shape);
    const auto* b = compound_of<S, N>(bodies[contact.b].shape);
    return {a == nullptr ? nullptr : &a->parts()[contact.member],
            b == nullptr ? nullptr : &b->parts()[a == nullptr ? contact.member : contact.part]};
  }

  /// Whether one of two bodies is a sensor, so that neither is pushed.
  [[nodiscard]] static constexpr bool is_sensed(const Bodies& bodies, std::uint32_t a,
                                                std::uint32_t b) noexcept {
    return bodies[a].is_sensor || bodies[b].is_sensor;
  }
  /// The same for a contact, whose parts may be sensors.
  [[nodiscard]] static constexpr bool is_sensed(const Bodies& bodies,
                                                const ContactState& contact) noexcept {
    if (is_sensed(bodies, contact.a, contact.b)) return true;
    if constexpr (Types::has_compounds) {
      const auto [a, b] = of(bodies, contact);
      return (a != nullptr && a->options().is_sensor) || (b != nullptr && b->options().is_sensor);
    } else {
      return false;
    }
  }

 private:
  [[nodiscard]] static constexpr bool are_compounds(const Bodies& bodies,
                                                    const BodyPair& pair) noexcept {
    return Types::has_compounds && compound_of<S, N>(bodies[pair.a].shape) != nullptr &&
           compound_of<S, N>(bodies[pair.b].shape) != nullptr;
  }
};

}  // namespace detent::detail
