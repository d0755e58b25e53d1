// SPDX-License-Identifier: MIT
#include "detent/detent.hpp"
using namespace detent;

Scene<q16_16, 3, ConvexHull> scene;
