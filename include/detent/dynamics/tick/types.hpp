// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <type_traits>

#include "detent/dynamics/contact_group.hpp"
#include "detent/dynamics/joint/group.hpp"
#include "detent/dynamics/record.hpp"
#include "detent/dynamics/rolling.hpp"
#include "detent/scene/one_of.hpp"

namespace detent::detail {

/// The types and capacities of a world; `Parts` are its shapes and joints.
template <class Store, Scalar T, int D, class... Parts>
struct WorldTypes {
  using Storage = Store;
  using S = T;
  static constexpr int N = D;
  using F = Formats<S>;

  static constexpr bool has_round = (Round<Parts> || ...);
  static constexpr bool has_compounds = (is_compound_body<Parts> || ...);
  static constexpr bool has_surfaces = (is_surface_body<Parts> || ...);
  static constexpr bool is_growing = requires { Storage::is_growing; };
  /// Whether four contacts or bodies are processed at once, on machines with long lanes.
  static constexpr bool has_groups = uses_long_lanes<Storage, S, N>;

 private:
  template <class... Shapes>
  using BodyOf = BodyRecord<S, N, OneOf<Shapes...>>;
  template <class... Kinds>
  using GroupOf = JointGroup<Storage, S, N, Kinds...>;

 public:
  using Body = typename Select<false, Parts...>::template In<BodyOf>;
  using Group = typename Select<true, Parts...>::template In<GroupOf>;
  using Joints = typename Group::List;
  using ContactState = std::conditional_t<has_round, RollingContact<S, N>, BodyContact<S, N>>;

  template <class Element, std::size_t Room>
  using List = typename Storage::template List<Element, Room>;
  static constexpr std::size_t bodies_room = Storage::capacity;
  static constexpr std::size_t contacts_room = Storage::contact_capacity;
  static constexpr std::size_t passes_room = Storage::capacity;
  using Bodies = List<Body, bodies_room>;
  using Contacts = List<ContactState, contacts_room>;

  /// Calls f with the shape of a part, as one of the types that the world names.
  template <class Visit>
  static constexpr void visit_part(const BodyPart<S, N>& part, const Visit& f) {
    part.shape().visit([&]<class Shape>(const Shape& shape) {
      if constexpr (Among<Shape, Parts...>) f(shape);
    });
  }
};

}  // namespace detent::detail
