// SPDX-License-Identifier: MIT
#pragma once

#include "detent/math/direction.hpp"

namespace detent {

/// The points x with dot(normal, x) = offset; a line in 2D. It has two sides.
template <Scalar S, int N>
struct Plane {
  Direction<S, N> normal;
  S offset{};

  [[nodiscard]] friend constexpr bool operator==(const Plane&, const Plane&) noexcept = default;
};

/// Appends to a digest: the fields in order.
template <class D, Scalar S, int N>
constexpr void append(D& digest, const Plane<S, N>& plane) noexcept {
  digest.add(plane.normal, plane.offset);
}

template <Scalar S, int N>
Plane(Direction<S, N>, S) -> Plane<S, N>;

}  // namespace detent
