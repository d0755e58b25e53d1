// SPDX-License-Identifier: MIT
#include "detent/scene/scene.hpp"
using namespace detent;

using Level = BoundedScene<Bounded<8>, q16_16, 3, Sphere>;
auto all(const Level& level) { return level.all(Sphere<q16_16, 3>{}); }
