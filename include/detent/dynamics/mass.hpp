// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "detent/dynamics/mass/box.hpp"
#include "detent/dynamics/mass/hull.hpp"
#include "detent/dynamics/mass/round.hpp"
#include "detent/dynamics/mass/sum.hpp"

namespace detent {

/// Mass, center of mass and resistance to turning of a solid `shape` of this `density`.
///
/// units:  density in mass per area (2D) or volume (3D)
/// domain: every shape and density; a shape without volume and a density that is not positive give
///         mass 0 and all fields 0. An oriented box counts as one with orthonormal axes, a capsule's
///         axis as long as the root rounded down to 2^-(Frac + 24), pi as `detail::pi`. The points
///         of a hull may be in any order, and may lie inside it; the time is proportional to the
///         cube of their number: call this when you make bodies, not every tick
/// exact:  each field rounded once to nearest, ties to even     (tests/dynamics/mass.test.cpp)
/// source: moments of simplices, Tonon, Explicit exact formulas for the 3-D tetrahedron inertia
///         tensor, 2004
template <template <Scalar, int> class Shape, Scalar S, int N>
requires requires(const Shape<S, N>& shape, S density) { detail::solid_properties(shape, density); }
[[nodiscard]] constexpr MassProperties<S, N> mass_properties(const Shape<S, N>& shape,
                                                             S density) noexcept {
  return detail::solid_properties(shape, density);
}

/// The properties of several parts that move as one body, given in one frame. Where parts overlap,
/// masses add.
///
/// domain: up to 2^20 parts; those without mass are ignored
/// result: independent of the order of the parts
/// exact:  from the parts' rounded properties, each field rounded once (tests/dynamics/mass.test.cpp)
/// source: the parallel axis theorem
template <Scalar S, int N>
[[nodiscard]] constexpr MassProperties<S, N> mass_properties(
    std::span<const MassProperties<S, N>> parts) noexcept {
  return detail::sum_of<S, N>([&](const auto& add) {
    for (const auto& part : parts) add(part);
  });
}

/// The properties of a compound whose parts all have this density.
template <class... Shapes, Scalar S>
[[nodiscard]] constexpr auto mass_properties(const Compound<Shapes...>& compound,
                                             S density) noexcept {
  return detail::sum_of<S, detail::dimension_of_parts<Shapes...>>([&](const auto& add) {
    for_each_part(compound, [&](const auto& part) { add(mass_properties(part, density)); });
  });
}

}  // namespace detent
