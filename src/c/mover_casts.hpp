// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "c/convert.hpp"
#include "detent/scene/scene.hpp"

// Casts of a capsule against the shapes of scenes, for characters: compiled in src/c/casts/, a
// source for each dimension and result.

#ifndef DETENT_C_MOVER_CASTS
#define DETENT_C_MOVER_CASTS extern template
#endif

#define DETENT_C_CAST_DISTANCE(N, KIND, Shape, name)                                        \
  DETENT_C_MOVER_CASTS std::optional<S> call_separate<job::CastDistance, std::optional<S>>( \
      const Cast<Capsule<S, N>>&, const Shape<S, N>&);
#define DETENT_C_CAST_HIT(N, KIND, Shape, name)                                                 \
  DETENT_C_MOVER_CASTS std::optional<detent::CastHit<S, N>>                                     \
  call_separate<job::CastHit, std::optional<detent::CastHit<S, N>>>(const Cast<Capsule<S, N>>&, \
                                                                    const Shape<S, N>&);

namespace detent::detail {

using c::S;

#if !defined(DETENT_C_ANSWER) || DETENT_C_ANSWER == 20
DETENT_C_SCENE_SHAPES(DETENT_C_CAST_DISTANCE, 2)
#endif
#if !defined(DETENT_C_ANSWER) || DETENT_C_ANSWER == 21
DETENT_C_SCENE_SHAPES(DETENT_C_CAST_HIT, 2)
#endif
#if !defined(DETENT_C_ANSWER) || DETENT_C_ANSWER == 30
DETENT_C_SCENE_SHAPES(DETENT_C_CAST_DISTANCE, 3)
#endif
#if !defined(DETENT_C_ANSWER) || DETENT_C_ANSWER == 31
DETENT_C_SCENE_SHAPES(DETENT_C_CAST_HIT, 3)
#endif

}  // namespace detent::detail
