// SPDX-License-Identifier: MIT
#pragma once

#include "detent/math/vec.hpp"

namespace detent {

/// The points within `radius` of the segment from `a` to `b`; a stadium in 2D.
///
/// Equal ends make it a sphere, a radius of 0 a segment; a negative radius makes it empty.
template <Scalar S, int N>
struct Capsule {
  Vec<S, N> a;
  Vec<S, N> b;
  S radius{};

  [[nodiscard]] friend constexpr bool operator==(const Capsule&, const Capsule&) noexcept = default;
};

/// Appends to a digest: the fields in order.
template <class D, Scalar S, int N>
constexpr void append(D& digest, const Capsule<S, N>& capsule) noexcept {
  digest.add(capsule.a, capsule.b, capsule.radius);
}

template <Scalar S, int N>
Capsule(Vec<S, N>, Vec<S, N>, S) -> Capsule<S, N>;

}  // namespace detent
