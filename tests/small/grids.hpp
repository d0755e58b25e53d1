// SPDX-License-Identifier: MIT
#pragma once

#include "small/pairs.hpp"
#include "small/points.hpp"
#include "small/rays.hpp"

/// Corner cases of `Scalar`: every query compiles and is correct at the ends of the range and near
/// 0, for any number of fraction bits.
namespace detent::small {

template <Scalar S, int N>
void ask_all(long points, long rays, long pairs) {
  ask_every_point<S, N>(200, points);
  ask_every_ray<S, N>(100, 60, rays);
  ask_every_pair<S, N>(50, pairs);
}

}  // namespace detent::small
