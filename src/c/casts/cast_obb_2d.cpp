// SPDX-License-Identifier: MIT
#include "c/casts/cast_at.hpp"

namespace detent::c {
DETENT_C_CASTS(2, Obb)
}  // namespace detent::c
