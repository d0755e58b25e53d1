// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <utility>

#include "detent/math/vec.hpp"
#include "detent/query/kernel/argument.hpp"
#include "detent/shape/compound.hpp"

namespace detent {

/// The distance from `point` to the nearest part of `compound`, 0 inside. Also include the headers
/// of its parts' own queries.
///
/// units:  world units
/// domain: every input; clamped to the greatest scalar, which is the result for a compound without
///         parts
/// exact:  rounded down, error in [0, 1) ULP             (tests/query/compound.test.cpp)
template <class... Shapes, Scalar S, int N>
[[nodiscard]] constexpr S distance(const Compound<Shapes...>& compound,
                                   const Vec<S, N>& point) noexcept {
  S least = largest<S>;
  for_each_part(compound,
                [&](const auto& part) { least = (std::min)(least, distance(part, point)); });
  return least;
}

/// The distance between `shape`, which may be a compound itself, and the nearest part of
/// `compound`; 0 if they share a point. Also include `query/distance/pair.hpp`.
///
/// units:  world units
/// domain: every input; clamped to the greatest scalar, which is the result for a compound without
///         parts
/// exact:  rounded down, error in [0, 1) ULP             (tests/query/compound.test.cpp)
template <class First, class... Rest, class Shape>
requires(!detail::IsPoint<Shape>)
    [[nodiscard]] constexpr auto distance(const Compound<First, Rest...>& compound,
                                          const Shape& shape) noexcept {
  auto least = largest<decltype(distance(std::declval<const First&>(), shape))>;
  for_each_part(compound,
                [&](const auto& part) { least = (std::min)(least, distance(part, shape)); });
  return least;
}
template <class Shape, class... Shapes>
requires(!is_compound<Shape> && !detail::IsPoint<Shape>)
    [[nodiscard]] constexpr auto distance(const Shape& shape,
                                          const Compound<Shapes...>& compound) noexcept {
  return distance(compound, shape);
}

}  // namespace detent
