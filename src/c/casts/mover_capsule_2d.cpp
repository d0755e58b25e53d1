// SPDX-License-Identifier: MIT
#include "c/casts/mover_of.hpp"

namespace detent::c {
template struct MoverOf<2, Capsule>;
template struct SceneCastOf<2, Capsule>;
}  // namespace detent::c
