// SPDX-License-Identifier: MIT
#include "c/casts/mover_of.hpp"

namespace detent::c {
template struct MoverOf<3, Capsule>;
template struct SceneCastOf<3, Capsule>;
}  // namespace detent::c
