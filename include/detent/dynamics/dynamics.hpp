// SPDX-License-Identifier: MIT
#pragma once

// Rigid bodies: worlds, their snapshots and digests, scenes that follow them, mass properties;
// particles, ropes and cloth.

#include "detent/dynamics/fields.hpp"
#include "detent/dynamics/follow.hpp"
#include "detent/dynamics/joint_at.hpp"
#include "detent/dynamics/mass.hpp"
#include "detent/dynamics/particle/cloth.hpp"
#include "detent/dynamics/particle/snapshot.hpp"
#include "detent/dynamics/particle/world.hpp"
#include "detent/dynamics/snapshot.hpp"
#include "detent/dynamics/world.hpp"
