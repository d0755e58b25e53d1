// SPDX-License-Identifier: MIT
#define DETENT_C_MOVERS_OF
#include "c/box_casts.hpp"
#include "c/movers.hpp"

namespace detent::c {
template struct MoverOf<2, Aabb>;
template struct SceneCastOf<2, Aabb>;
template struct SceneCastOf<2, Obb>;
}  // namespace detent::c
