// SPDX-License-Identifier: MIT
#include "c/box_casts.hpp"
#include "c/casts/mover_of.hpp"

namespace detent::c {
template struct MoverOf<3, Aabb>;
template struct SceneCastOf<3, Aabb>;
template struct SceneCastOf<3, Obb>;
}  // namespace detent::c
