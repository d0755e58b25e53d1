// SPDX-License-Identifier: MIT
#pragma once

#include "detent/math/vec.hpp"

namespace detent {

/// The points within `radius` of `center`; a disc in 2D.
///
/// A radius of 0 makes it a point; a negative radius makes it empty.
template <Scalar S, int N>
struct Sphere {
  Vec<S, N> center;
  S radius{};

  [[nodiscard]] friend constexpr bool operator==(const Sphere&, const Sphere&) noexcept = default;
};

/// Appends to a digest: the fields in order.
template <class D, Scalar S, int N>
constexpr void append(D& digest, const Sphere<S, N>& sphere) noexcept {
  digest.add(sphere.center, sphere.radius);
}

template <Scalar S, int N>
Sphere(Vec<S, N>, S) -> Sphere<S, N>;

}  // namespace detent
