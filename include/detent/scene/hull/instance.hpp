// SPDX-License-Identifier: MIT
#pragma once

#include "detent/scene/assets.hpp"
#include "detent/scene/hull/placed.hpp"

namespace detent {

/// Listed by scenes that hold convex hulls: `Scene<q16_16, 3, Sphere, HullInstance>` holds
/// `PlacedHull<q16_16, 3>`. Snapshots refer to hulls by id and digest.
template <Scalar S, int N>
using HullInstance = PlacedHull<S, N>;

namespace detail {

/// Reads a hull whose id and digest are those of one of `assets`.
template <Scalar S, int N, class Assets>
[[nodiscard]] constexpr Restored read_shape(Reader& in, PlacedHull<S, N>& shape,
                                            const Assets& assets) noexcept {
  return read_reference(in, assets, shape.asset, shape.transform);
}

}  // namespace detail

}  // namespace detent
