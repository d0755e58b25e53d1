// SPDX-License-Identifier: MIT
#pragma once

// Bodies that move: worlds, their snapshots and digests, mass properties.

#include "detent/dynamics/fields.hpp"
#include "detent/dynamics/mass.hpp"
#include "detent/dynamics/snapshot.hpp"
#include "detent/dynamics/world.hpp"
