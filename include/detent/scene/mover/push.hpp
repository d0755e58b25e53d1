// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/contact/pair.hpp"
#include "detent/scene/height_field/placed.hpp"
#include "detent/scene/hull/placed.hpp"
#include "detent/scene/mesh/contact.hpp"
#include "detent/scene/mover/half_spaces.hpp"
#include "detent/scene/mover/step.hpp"

namespace detent::detail {

/// Adds the half-spaces of translations that bring a shape out of a target that it overlaps.
template <Scalar S, int N, class Target, class Shape>
constexpr void add_way_out(HalfSpaces<S, N>& spaces, const Target& target, const Shape& shape) {
  if constexpr (is_surface_type<Target>) {
    const SurfaceContacts<Target, Shape, S> contacts(target, shape, usual_facing<Target>);
    contacts.visit(
        [&](const auto& found) { spaces.add_sorted(found.contact.normal, found.contact.depth); });
  } else if constexpr (requires { HullPoints(target); }) {
    const HullPoints points(target);
    add_way_out(spaces, points.hull(), shape);
  } else if (const auto found = contact(target, shape)) {
    spaces.add_sorted(found->normal, found->depth);
  }
}

/// The half-spaces of translations that separate a shape from everything it overlaps.
template <Scalar S, int N, class World, class Shape, class Filter>
[[nodiscard]] constexpr HalfSpaces<S, N> ways_out(const World& world, const Shape& shape,
                                                  const Filter& filter) {
  HalfSpaces<S, N> spaces;
  (void)world.any(shape, [&](const ObjectInfo& object) {
    if (!filter(object)) return false;
    world.visit(object.id, [&](const auto& target) { add_way_out(spaces, target, shape); });
    return false;
  });
  return spaces;
}

/// Pushes a character out of objects that it overlaps or that are within its skin, at most four
/// times and never into another object. Between two surfaces that nearly face each other it stays:
/// the way out may lead anywhere.
template <class Steps, class World, class Filter, Scalar S>
constexpr void push_apart(Steps& steps, const World& world, const Filter& filter, const S& skin) {
  for (int i = 0; i < 4; ++i) {
    const auto spaces = ways_out<S, Steps::dimension>(world, grown(steps.shape(), skin), filter);
    const auto by = spaces.closest({}, quotient_floor<S>(skin, as_operand<S>(8)));
    if (!by || *by == Vec<S, Steps::dimension>{}) return;
    if (squared_length(*by) > square(spaces.greatest_offset() * as_operand<S>(4))) return;
    steps.escape(*by);
    steps.prepare();
    if (steps.has_room()) return;
  }
}

}  // namespace detent::detail
