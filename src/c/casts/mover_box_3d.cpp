// SPDX-License-Identifier: MIT
#define DETENT_C_MOVERS_OF
#include "c/box_casts.hpp"
#include "c/movers.hpp"

namespace detent::c {
template struct MoverOf<3, Aabb>;
template struct SceneCastOf<3, Aabb>;
template struct SceneCastOf<3, Obb>;
}  // namespace detent::c
