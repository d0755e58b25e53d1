// SPDX-License-Identifier: MIT
#include "c/mover_casts.hpp"

namespace detent::detail {
DETENT_C_SCENE_SHAPES(DETENT_C_CAST_HIT, 3)
}  // namespace detent::detail
