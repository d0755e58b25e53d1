// SPDX-License-Identifier: MIT
#pragma once

#include "detent/number/require_cxx20.hpp"

// All headers, layer by layer: each layer may use those above it. Without an operating system, all
// except those that need a heap.

#include "detent/number/number.hpp"

#include "detent/math/math.hpp"

#include "detent/shape/shape.hpp"

#include "detent/query/query.hpp"

#include "detent/scene/events.hpp"
#include "detent/scene/height_field.hpp"
#include "detent/scene/hull.hpp"
#include "detent/scene/mesh.hpp"
#include "detent/scene/mover.hpp"
#include "detent/scene/snapshot.hpp"
#include "detent/scene/sync_test.hpp"
#if __STDC_HOSTED__  // needs a heap
#include "detent/scene/mesh/owned.hpp"
#endif

#include "detent/dynamics/dynamics.hpp"

#include "detent/draw/draw.hpp"

#include "detent/lockstep/lockstep.hpp"

#include "detent/version.hpp"

// For the headers alone.
#undef DETENT_CONSTEVAL
#undef DETENT_INLINE_TINY
#undef DETENT_INLINE_WHEN_SHORT
#undef DETENT_INLINE_FILTER
#undef DETENT_OUTLINE
