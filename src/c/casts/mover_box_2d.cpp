// SPDX-License-Identifier: MIT
#include "c/box_casts.hpp"
#include "c/casts/mover_of.hpp"

namespace detent::c {
template struct MoverOf<2, Aabb>;
template struct SceneCastOf<2, Aabb>;
template struct SceneCastOf<2, Obb>;
}  // namespace detent::c
