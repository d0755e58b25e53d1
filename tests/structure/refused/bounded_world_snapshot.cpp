// SPDX-License-Identifier: MIT
#include "detent/dynamics/snapshot.hpp"
using namespace detent;

void save(const BoundedWorld<Bounded<4>, q16_16, 3, Sphere>& world) { snapshot(world); }
