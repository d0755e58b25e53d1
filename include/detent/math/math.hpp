// SPDX-License-Identifier: MIT
#pragma once

// The math layer: vectors, directions, rotations, matrices, transforms.

#include "detent/math/angle_between.hpp"
#include "detent/math/decompose.hpp"
#include "detent/math/direction.hpp"
#include "detent/math/inverse.hpp"
#include "detent/math/lens.hpp"
#include "detent/math/mat.hpp"
#include "detent/math/project.hpp"
#include "detent/math/projection.hpp"
#include "detent/math/quat.hpp"
#include "detent/math/rotation.hpp"
#include "detent/math/slerp.hpp"
#include "detent/math/sweep.hpp"
#include "detent/math/transform.hpp"
#include "detent/math/vec.hpp"
#include "detent/math/width.hpp"
