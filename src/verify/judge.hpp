// SPDX-License-Identifier: MIT
#pragma once

/// The expected results of the corpus, computed from the queries' definitions in exact integers and
/// 100-digit decimals. When a digest differs, this finds the question that went wrong.

#include "verify/judge/casts.hpp"
#include "verify/judge/meshes.hpp"
#include "verify/judge/motions.hpp"
#include "verify/judge/numbers.hpp"
#include "verify/judge/pairs.hpp"
#include "verify/judge/points.hpp"
#include "verify/judge/rays.hpp"
#include "verify/judge/rotations.hpp"
#include "verify/judge/scene_casts.hpp"
#include "verify/judge/scene_views.hpp"
#include "verify/judge/scenes.hpp"
#include "verify/judge/sizes.hpp"
#include "verify/judge/targets.hpp"
#include "verify/judge/views.hpp"
#include "verify/judge/walks.hpp"
#include "verify/judge/worlds.hpp"
