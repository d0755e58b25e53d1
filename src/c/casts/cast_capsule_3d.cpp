// SPDX-License-Identifier: MIT
#define DETENT_C_CASTS_OF Capsule
#include "c/casts.hpp"

namespace detent::c {
DETENT_C_CASTS(3)
}  // namespace detent::c
