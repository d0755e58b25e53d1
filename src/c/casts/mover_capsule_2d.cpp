// SPDX-License-Identifier: MIT
#define DETENT_C_MOVERS_OF
#include "c/movers.hpp"

namespace detent::c {
template struct MoverOf<2, Capsule>;
template struct SceneCastOf<2, Capsule>;
}  // namespace detent::c
