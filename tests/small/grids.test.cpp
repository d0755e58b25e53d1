// SPDX-License-Identifier: MIT
//
// Corner cases of `Scalar`: every query compiles and is right at the ends of the range and near 0,
// however many fraction bits there are.

#include "small/pairs.hpp"
#include "small/points.hpp"
#include "small/rays.hpp"

using namespace detent;
using namespace detent::small;

namespace {

template <Scalar S, int N>
void ask_all(long points, long rays, long pairs) {
  ask_every_point<S, N>(200, points);
  ask_every_ray<S, N>(100, 60, rays);
  ask_every_pair<S, N>(50, pairs);
}

}  // namespace

TEST_CASE("small worlds: 31 bits, one before the point", "[small]") {
  ask_all<Fixed<31, 30>, 3>(225'000, 48'000, 90'000);
}

TEST_CASE("small worlds: 31 bits, none after the point", "[small]") {
  ask_all<Fixed<31, 0>, 2>(40'625, 48'000, 90'000);
}
