// SPDX-License-Identifier: MIT
#pragma once

#include "detent.h"

namespace detent::c {

/// The functions of the interface for one shape or two, in one dimension. Code that needs their
/// results calls these instead of compiling the templates again.
template <int N>
struct Single;
#define DETENT_C_SINGLE(N)                                                 \
  template <>                                                              \
  struct Single<N> {                                                       \
    static constexpr auto raycast = detent_raycast##N;                     \
    static constexpr auto contains = detent_contains##N;                   \
    static constexpr auto overlaps = detent_overlaps##N;                   \
    static constexpr auto closest_point = detent_closest_point##N;         \
    static constexpr auto distance_to_point = detent_distance_to_point##N; \
    static constexpr auto distance = detent_distance##N;                   \
  };
DETENT_C_SINGLE(2)
DETENT_C_SINGLE(3)
#undef DETENT_C_SINGLE

}  // namespace detent::c
