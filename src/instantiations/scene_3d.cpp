// SPDX-License-Identifier: MIT
#define DETENT_INSTANTIATION template
#define DETENT_INSTANTIATED_DIMENSION 3
#include "detent/scene/instantiations.hpp"
