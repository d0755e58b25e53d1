// SPDX-License-Identifier: MIT
//
// The corners of what a `Scalar` may be, at the ends of their ranges: every query compiles, and the
// number of bits after the point shows in no answer.

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

TEST_CASE("small worlds: 31 bits, none after the point", "[small]") {
  ask_all<Fixed<31, 0>, 2>(0, 0, 0);
}

TEST_CASE("small worlds: 30 bits, one before the point", "[small]") {
  ask_all<Fixed<30, 29>, 3>(0, 0, 0);
}

TEST_CASE("small worlds: 14 bits, one before the point", "[small]") {
  ask_all<Fixed<14, 13>, 2>(0, 0, 0);
}
