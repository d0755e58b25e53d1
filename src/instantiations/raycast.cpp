// SPDX-License-Identifier: MIT
#define DETENT_INSTANTIATION template
#include "detent/instantiations.hpp"
