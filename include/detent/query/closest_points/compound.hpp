// SPDX-License-Identifier: MIT
#pragma once

#include <utility>

#include "detent/query/kernel/argument.hpp"
#include "detent/query/kernel/nearest_part.hpp"

namespace detent {

/// The closest points of the part of `compound` nearest to `shape`, which may be a compound itself:
/// first on the part, then on `shape`. If the compound comes second, those of `shape` and the part.
/// Also include `query/closest_points/pair.hpp`, `query/distance/pair.hpp` and
/// `query/distance/compound.hpp`.
///
/// units:  world units
/// domain: every input; a compound without parts gives the origin twice
/// result: of parts with equal `distance`s, even if equal only by rounding or clamping, the first
///         that is not empty counts
/// exact:  the part is the nearest within 1 ULP of the scalar; each coordinate is rounded as by
///         `closest_points` of the part              (tests/query/closest_points/compound.test.cpp)
template <class First, class... Rest, class Shape>
requires(!detail::IsPoint<Shape>)
    [[nodiscard]] constexpr auto closest_points(const Compound<First, Rest...>& compound,
                                                const Shape& shape) noexcept {
  using Points = decltype(closest_points(std::declval<const First&>(), shape));
  using S = decltype(distance(std::declval<const First&>(), shape));
  Points points;
  detail::visit_nearer_parts<S>(compound, shape,
                                [&](const auto& part) { points = closest_points(part, shape); });
  return points;
}
template <class Shape, class... Shapes>
requires(!is_compound<Shape> && !detail::IsPoint<Shape>)
    [[nodiscard]] constexpr auto closest_points(const Shape& shape,
                                                const Compound<Shapes...>& compound) noexcept {
  using Points = decltype(closest_points(compound, shape));
  using S = decltype(distance(compound, shape));
  Points points;
  detail::visit_nearer_parts<S>(compound, shape,
                                [&](const auto& part) { points = closest_points(shape, part); });
  return points;
}

}  // namespace detent
