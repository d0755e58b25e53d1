// SPDX-License-Identifier: MIT
#pragma once

#include "c/casts.hpp"

namespace detent::c {

template <class Moving, class Target, int N>
std::optional<CastHit<S, N>> cast_at(const Moving& moving, const Direction<S, N>& direction,
                                     S max_distance, const Target& target) {
  return detent::cast(moving, direction, max_distance, target);
}

}  // namespace detent::c

#define DETENT_C_CAST_AT(N, Moving, Target)                                                     \
  template std::optional<CastHit<S, N>> cast_at(const Moving<S, N>&, const Direction<S, N>&, S, \
                                                const Target<S, N>&);
#define DETENT_C_CASTS(N, Moving)      \
  DETENT_C_CAST_AT(N, Moving, Capsule) \
  DETENT_C_CAST_AT(N, Moving, Obb)     \
  DETENT_C_CAST_AT(N, Moving, Plane)   \
  DETENT_C_CAST_AT(N, Moving, ConvexHull)
