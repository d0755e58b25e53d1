// SPDX-License-Identifier: MIT
#include "c/casts/cast_at.hpp"

namespace detent::c {
DETENT_C_CASTS(3, ConvexHull)
}  // namespace detent::c
