// SPDX-License-Identifier: MIT
#include "detent/scene/snapshot.hpp"
using namespace detent;

void save(const BoundedScene<Bounded<4>, q16_16, 3, Sphere>& scene) { snapshot(scene); }
