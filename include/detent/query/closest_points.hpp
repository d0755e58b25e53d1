// SPDX-License-Identifier: MIT
#pragma once

// The closest points of two shapes, a pair:
//   closest_points(a, b) -> std::pair<Vec, Vec>   the point of a and that of b, rounded to nearest
// For a shape and a point see query/closest_point.hpp, for the distance query/distance.hpp.

#include "detent/query/closest_points/compound.hpp"
#include "detent/query/closest_points/pair.hpp"
#include "detent/query/wrong_call.hpp"
