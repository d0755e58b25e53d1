// SPDX-License-Identifier: MIT
#define DETENT_C_MOVERS_OF
#include "c/movers.hpp"

namespace detent::c {
template struct MoverOf<3, Capsule>;
template struct SceneCastOf<3, Capsule>;
}  // namespace detent::c
