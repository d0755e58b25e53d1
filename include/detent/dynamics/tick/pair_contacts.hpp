// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "detent/dynamics/hold.hpp"
#include "detent/dynamics/manifold/pair.hpp"
#include "detent/dynamics/manifold/terrain.hpp"
#include "detent/dynamics/pairs.hpp"
#include "detent/dynamics/relative.hpp"
#include "detent/dynamics/tick/contact_parts.hpp"
#include "detent/number/next_up.hpp"

namespace detent::detail {

/// A pair's manifold, kept from the search for contacts until they are prepared.
template <Scalar S, int N>
struct FoundManifold {
  Manifold<S, N> manifold{};
  Vec<typename Formats<S>::Lever, N> offset{};
};

/// The contacts of some pairs, in order, and their manifolds.
template <class Types, std::size_t Room = Types::contacts_room>
struct FoundContacts {
  using S = typename Types::S;
  static constexpr std::size_t room = Room;

  typename Types::template List<typename Types::ContactState, Room> contacts;
  typename Types::template List<FoundManifold<S, Types::N>, Room> manifolds;
  typename Types::template List<FacetContact<S>, Types::has_surfaces ? Room : 0> facets;

  [[nodiscard]] constexpr bool is_full() const noexcept { return contacts.size() >= Room; }
};

/// The supports of two bodies, by their indices.
template <Scalar S, int N>
struct PairSupports {
  std::uint32_t index_of_a;
  const Support<S, N>&a, &b;

  [[nodiscard]] constexpr const Support<S, N>& operator[](std::uint32_t index) const noexcept {
    return index == index_of_a ? a : b;
  }
};

/// The contacts of one pair of bodies.
template <class Types>
class PairContacts {
  using S = typename Types::S;
  static constexpr int N = Types::N;
  using F = typename Types::F;
  using Body = typename Types::Body;
  using Bodies = typename Types::Bodies;
  using Contacts = typename Types::Contacts;
  using ContactState = typename Types::ContactState;
  using Parts = ContactParts<Types>;
  using Found = FoundManifold<S, N>;
  using Supports = PairSupports<S, N>;
  /// Of the same type as those of all pairs if it allocates, otherwise small enough for a stack.
  using Few =
      FoundContacts<Types, Types::is_growing ? Types::contacts_room
                                             : (std::min)(Types::contacts_room, std::size_t{64})>;

 public:
  /// The contacts of a pair of bodies whose supports are in `held`. `before` has the contacts of the
  /// last tick; those of this pair begin at `old`.
  template <class Slack, class Out>
  static constexpr void find(const Bodies& bodies, const Supports& held, const BodyPair& pair,
                             const Slack& slack, const Contacts& before, std::size_t old, S reach,
                             typename F::Lever margin, Out& out) {
    if (slack != 0) {
      reach = wider(reach, slack);
      margin = saturate_to<typename F::Lever>(margin + slack);
    }
    bodies[pair.a].shape.visit([&]<class A>(const A& first) {
      bodies[pair.b].shape.visit([&]<class B>(const B& second) {
        if constexpr (is_surface_body<A> && is_surface_body<B>) {
          return;  // none of them can move
        } else if constexpr (is_compound_body<A> || is_compound_body<B>) {
          touch_parts(bodies, pair, held, first, second, before, old, reach, margin, out);
        } else if constexpr (is_surface_body<A>) {
          touch_terrain(bodies, {pair}, held, first,
                        Placed<B>{second, held[pair.b], bodies[pair.b].reach}, true, before, old,
                        reach, margin, out);
        } else if constexpr (is_surface_body<B>) {
          touch_terrain(bodies, {pair}, held, second,
                        Placed<A>{first, held[pair.a], bodies[pair.a].reach}, false, before, old,
                        reach, margin, out);
        } else {
          const auto& a = held[pair.a];
          const auto& b = held[pair.b];
          const auto offset = offset_between(a, b);
          if constexpr (Round<A> && Round<B>) {
            const auto &reach_a = bodies[pair.a].reach, &reach_b = bodies[pair.b].reach;
            if (centers_are_apart(reach_a, reach_b, offset, margin)) return;
          }
          RelativePose<S, N> pose;
          if constexpr (std::is_same_v<B, Sphere<S, N>>) {
            pose.translation = relative_place(a, offset);  // a ball has no axes
          } else {
            if (is_surely_beyond(a, offset, first, second, margin)) return;
            pose = relative_pose(a, b, offset);
          }
          const bool known = old < before.size() && pair_of(before[old]) == pair;
          add_contact(bodies, {pair}, {manifold(first, second, pose, margin), offset},
                      known ? &before[old] : nullptr, out);
        }
      });
    });
  }

  /// Calls f for each contact of a pair that touches and pushes, as the next run would find it: with
  /// the contact, the support of a, the manifold, and the position of b relative to a. Those of the
  /// pair in `contacts` begin at `first`.
  template <class Visit>
  static constexpr void visit_touching(const Bodies& bodies, const Contacts& contacts,
                                       std::size_t first, const S& reach,
                                       const typename F::Lever& margin, const Visit& f) {
    const auto pair = pair_of(contacts[first]);
    const Body &a = bodies[pair.a], &b = bodies[pair.b];
    const auto held_a = held_support(a), held_b = held_support(b);
    Few search;
    find(bodies, {pair.a, held_a, held_b}, pair, slack_of(a, lean_of(a)) + slack_of(b, lean_of(b)),
         contacts, first, reach, margin, search);
    for (std::size_t i = 0; i < search.contacts.size(); ++i) {
      const auto& contact = search.contacts[i];
      if (!contact.touches || Parts::is_sensed(bodies, contact)) continue;
      f(contact, held_a, search.manifolds[i].manifold, search.manifolds[i].offset);
    }
  }

 private:
  /// The margin plus the slack, rounded up.
  template <class Slack>
  static constexpr S wider(const S& margin, const Slack& slack) noexcept {
    if constexpr (is_fixed<S>) {
      return saturate_to<S>(margin + slack + half(next_up(S(0))));
    } else {
      return margin + slack;
    }
  }

  /// A shape in the world: a whole body, or a part of a compound.
  template <class Shape>
  struct Placed {
    const Shape& shape;
    const Support<S, N>& support;
    const BodyExtent<S, N>& reach;
    const RelativePose<S, N>* in_body = nullptr;  // the frame of a part in that of its body
    std::uint32_t part = 0;
  };

  /// Where a part of a compound is.
  struct PlacedPart {
    RelativePose<S, N> pose;  // in its body
    Support<S, N> support;

    constexpr PlacedPart(const SolidCompound<S, N>& asset, const BodyPart<S, N>& part,
                         const Support<S, N>& held) noexcept
        : pose(pose_in(asset, part)) {
      const auto at = part_at(Standing<S, N>{held.place, held.axes}, pose);
      support.place = at.place;
      support.axes = at.axes;
    }
  };

  /// Calls f for each part of a compound in order, or once for a body with a single shape.
  template <class Shape, class Visit>
  static constexpr void for_each_placed(const Bodies& bodies, std::uint32_t body,
                                        const Supports& held, const Shape& shape, const Visit& f) {
    if constexpr (is_compound_body<Shape>) {
      if (shape.asset == nullptr) return;
      const auto parts = shape.asset->parts();
      for (std::size_t k = 0; k < parts.size(); ++k) {
        const PlacedPart at(*shape.asset, parts[k], held[body]);
        Types::visit_part(parts[k], [&]<class Part>(const Part& part) {
          f(Placed<Part>{part, at.support, parts[k].reach(), &at.pose,
                         static_cast<std::uint32_t>(k)});
        });
      }
    } else {
      f(Placed<Shape>{shape, held[body], bodies[body].reach});
    }
  }

  /// The contacts of two bodies, at least one of which is a compound.
  template <class A, class B, class Out>
  static constexpr void touch_parts(const Bodies& bodies, const BodyPair& pair,
                                    const Supports& held, const A& first, const B& second,
                                    const Contacts& before, std::size_t old, const S& reach,
                                    const typename F::Lever& margin, Out& out) {
    const auto known = [&](const ContactKey& key) {
      while (old < before.size() && key_of(before[old]) < key) ++old;
      return old < before.size() && key_of(before[old]) == key ? &before[old] : nullptr;
    };
    const auto numbered = [&](std::uint32_t part) {
      return ContactKey{pair, static_cast<std::uint16_t>(part)};
    };
    if constexpr (is_surface_body<A>) {
      for_each_placed(bodies, pair.b, held, second, [&](const auto& b) {
        const auto key = numbered(b.part);
        known(key);
        touch_terrain(bodies, key, held, first, b, true, before, old, reach, margin, out);
      });
    } else if constexpr (is_surface_body<B>) {
      for_each_placed(bodies, pair.a, held, first, [&](const auto& a) {
        const auto key = numbered(a.part);
        known(key);
        touch_terrain(bodies, key, held, second, a, false, before, old, reach, margin, out);
      });
    } else {
      const auto offset = offset_between(held[pair.a], held[pair.b]);
      for_each_placed(bodies, pair.a, held, first, [&](const auto& a) {
        const auto box_a = bounds_of<S, N>(a.support.place, a.support.axes, a.reach, reach);
        for_each_placed(bodies, pair.b, held, second, [&](const auto& b) {
          if (out.is_full()) return;
          const auto box_b = bounds_of<S, N>(b.support.place, b.support.axes, b.reach, reach);
          if (!meet(box_a, box_b)) return;
          const auto pose =
              relative_pose(a.support, b.support, offset_between(a.support, b.support));
          auto found = manifold(a.shape, b.shape, pose, margin);
          if (found.count == 0) return;
          auto key = numbered(is_compound_body<A> ? a.part : b.part);
          if constexpr (is_compound_body<A>) {
            found = in_body(*a.in_body, found);
            key.part = b.part;
          }
          add_contact(bodies, key, {found, offset}, known(key), out);
        });
      });
    }
  }
  static constexpr bool meet(const BodyBox<S, N>& a, const BodyBox<S, N>& b) noexcept {
    for (int k = 0; k < N; ++k) {
      if (a.most[k] < b.least[k] || b.most[k] < a.least[k]) return false;
    }
    return true;
  }

  /// The contacts of a surface, which is the first or the second of the pair, and a solid. `before`
  /// has the contacts of the last tick; those of these bodies are at `old` or later.
  template <class Terrain, class Solid, class Out>
  static constexpr void touch_terrain(const Bodies& bodies, ContactKey key, const Supports& held,
                                      const Terrain& terrain, const Placed<Solid>& solid,
                                      bool is_first, const Contacts& before, std::size_t old,
                                      const S& reach, const typename F::Lever& margin, Out& out) {
    const auto& ground = held[is_first ? key.pair.a : key.pair.b];
    const auto& support = solid.support;
    const auto pose = relative_pose(ground, support, offset_between(ground, support));
    const auto offset = offset_between(held[key.pair.a], held[key.pair.b]);
    const auto back = relative_pose(held[key.pair.a], held[key.pair.b], offset);
    FacetContacts<decltype(out.facets), S> contacts(out.facets, Out::room);
    contacts.find(terrain, solid.shape, pose, solid.reach, reach, margin);
    std::size_t end = old;
    while (end < before.size() && pair_of(before[end]) == key.pair &&
           before[end].member == key.member) {
      ++end;
    }
    for (std::size_t i = 0; i < out.facets.size() && !out.is_full(); ++i) {
      const auto& found = out.facets[i].manifold;
      if (found.count == 0) continue;
      const auto last = contacts.last_of(i, before, old, end);
      key.part = out.facets[i].part.index;
      add_contact(bodies, key, {is_first ? found : swapped(back, found), offset},
                  last < end ? &before[last] : nullptr, out);
    }
  }

  template <class Out>
  static constexpr void add_contact(const Bodies& bodies, const ContactKey& key, const Found& found,
                                    const ContactState* before, Out& out) {
    if (found.manifold.count == 0) return;
    auto contact = continued(key, found.manifold, before);
    if (Parts::is_sensed(bodies, contact)) contact = sensed(key, found.manifold);
    out.contacts.push_back(contact);
    out.manifolds.push_back(found);
  }

  /// A contact with a sensor: it records only whether they overlap.
  static constexpr ContactState sensed(const ContactKey& key,
                                       const Manifold<S, N>& manifold) noexcept {
    auto contact = continued(key, manifold, nullptr);
    for (std::size_t i = 0; i < contact.count; ++i) {
      contact.touches = contact.touches || manifold.points[i].separation <= 0;
    }
    return contact;
  }

  static constexpr ContactState continued(const ContactKey& key, const Manifold<S, N>& manifold,
                                          const ContactState* before) noexcept {
    ContactState contact;
    contact.a = key.pair.a;
    contact.b = key.pair.b;
    contact.member = key.member;
    contact.part = key.part;
    contact.count = static_cast<std::uint8_t>(manifold.count);
    for (std::size_t i = 0; i < contact.count; ++i) {
      contact.feature[i] = manifold.points[i].feature;
    }
    if (before == nullptr) return contact;
    contact.touches = before->touches;
    contact.friction = before->friction;
    if constexpr (Types::has_round) contact.rolling = before->rolling;
    for (std::size_t i = 0; i < contact.count; ++i) {
      for (std::size_t j = 0; j < before->count; ++j) {
        if (before->feature[j] == contact.feature[i]) contact.pressure[i] = before->pressure[j];
      }
    }
    return contact;
  }
};

}  // namespace detent::detail
