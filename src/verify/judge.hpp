// SPDX-License-Identifier: MIT
#pragma once

/// What the answers of the corpus should be, from the definitions of the queries in exact integers
/// and a hundred digits. Wherever a digest differs, this names the question that went wrong.

#include "verify/judge/meshes.hpp"
#include "verify/judge/motions.hpp"
#include "verify/judge/numbers.hpp"
#include "verify/judge/pairs.hpp"
#include "verify/judge/points.hpp"
#include "verify/judge/rays.hpp"
#include "verify/judge/rotations.hpp"
#include "verify/judge/scenes.hpp"
#include "verify/judge/sizes.hpp"
