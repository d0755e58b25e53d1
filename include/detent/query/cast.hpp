// SPDX-License-Identifier: MIT
#pragma once

// A moving shape against a shape:
//   cast(shape, direction, max_distance, target) -> std::optional<CastHit<S, N>>
//                                                   distance, point, normal
//   cast(Cast{shape, direction, max_distance}, target)

#include "detent/query/cast/compound.hpp"
#include "detent/query/cast/hit.hpp"
#include "detent/query/cast/pair.hpp"
#include "detent/query/cast/question.hpp"
#include "detent/query/wrong_call.hpp"
