// SPDX-License-Identifier: MIT
#include "detent/number/patience.hpp"

#include "detent/number/floating.hpp"
#include "support/catch.hpp"

namespace detent::test {
namespace {

template <Number T>
int steps(int most) {
  int count = 0;
  for (Patience<T> patience; count < most && patience.step();) ++count;
  return count;
}

TEST_CASE("patience: unlimited for exact numbers, 100 steps for rounded ones", "[patience]") {
  CHECK(steps<q16_16>(10'000) == 10'000);
  CHECK(steps<Fixed<92, 48>>(10'000) == 10'000);
  CHECK(steps<float>(10'000) == 100);
  CHECK(steps<double>(10'000) == 100);
}

}  // namespace
}  // namespace detent::test
