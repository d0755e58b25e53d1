// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/kernel/argument.hpp"

namespace detent {

namespace detail {

template <class Point>
struct SpaceOfPoint;
template <Scalar S, int N>
struct SpaceOfPoint<Vec<S, N>> {
  using scalar = S;
  using direction = Direction<S, N>;
};

}  // namespace detail

/// The query of what `shape` touches first if it moves along `direction` by at most `max_distance`.
template <class Shape>
struct Cast {
  using S = typename detail::SpaceOfPoint<typename detail::PointOf<Shape>::type>::scalar;

  Shape shape;
  typename detail::SpaceOfPoint<typename detail::PointOf<Shape>::type>::direction direction;
  S max_distance = largest<S>;

  [[nodiscard]] friend constexpr bool operator==(const Cast&, const Cast&) noexcept = default;
};

template <class Shape, Scalar S, int N>
Cast(Shape, Direction<S, N>, S) -> Cast<Shape>;
template <class Shape, Scalar S, int N>
Cast(Shape, Direction<S, N>) -> Cast<Shape>;

/// Appends to a digest: the fields in order.
template <class D, class Shape>
constexpr void append(D& digest, const Cast<Shape>& cast) noexcept {
  digest.add(cast.shape, cast.direction, cast.max_distance);
}

}  // namespace detent
