// SPDX-License-Identifier: MIT
#pragma once

// Two shapes, both closed sets, in either order:
//   overlaps(a, b) -> bool

#include "detent/query/overlaps/compound.hpp"
