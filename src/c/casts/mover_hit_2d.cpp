// SPDX-License-Identifier: MIT
#define DETENT_C_MOVER_CASTS template
#define DETENT_C_ANSWER 21
#include "c/mover_casts.hpp"
