// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>

#include "detent/shape/segment.hpp"

namespace detent {

namespace detail {

template <class Shape, class Segment>
concept MeetsSegments =
    !std::same_as<Shape, Segment> && requires(const Segment& segment, const Shape& shape) {
  { intersects(segment, shape) } -> std::same_as<bool>;
};

}  // namespace detail

/// `intersects` with the arguments swapped, for every shape.
template <class Shape, Scalar S, int N>
requires detail::MeetsSegments<Shape, Segment<S, N>>
[[nodiscard]] constexpr bool intersects(const Shape& shape, const Segment<S, N>& segment) noexcept {
  return intersects(segment, shape);
}

}  // namespace detent
