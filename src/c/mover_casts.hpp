// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "c/convert.hpp"
#include "detent/scene/scene.hpp"

// Casts of a capsule against the shapes of scenes, for characters: compiled in src/c/casts/, a
// source for each dimension and result.

#define DETENT_C_CAST_DISTANCE(N, KIND, Shape, name)                            \
  template std::optional<S> call_separate<job::CastDistance, std::optional<S>>( \
      const Cast<Capsule<S, N>>&, const Shape<S, N>&);
#define DETENT_C_CAST_HIT(N, KIND, Shape, name)                                                 \
  template std::optional<detent::CastHit<S, N>>                                                 \
  call_separate<job::CastHit, std::optional<detent::CastHit<S, N>>>(const Cast<Capsule<S, N>>&, \
                                                                    const Shape<S, N>&);
#define DETENT_C_CASTS_ELSEWHERE(N, KIND, Shape, name) \
  extern DETENT_C_CAST_DISTANCE(N, KIND, Shape, name) extern DETENT_C_CAST_HIT(N, KIND, Shape, name)

namespace detent::detail {

using c::S;

DETENT_C_SCENE_SHAPES(DETENT_C_CASTS_ELSEWHERE, 2)
DETENT_C_SCENE_SHAPES(DETENT_C_CASTS_ELSEWHERE, 3)

}  // namespace detent::detail
