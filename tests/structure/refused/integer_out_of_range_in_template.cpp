// SPDX-License-Identifier: MIT
#include "detent/math/math.hpp"
#include "detent/number/number.hpp"

using namespace detent;
using namespace detent::literals;

template <Scalar S>
S far_away() {
  const int distance = -200;
  return S(distance);
}
q8_8 away = far_away<q8_8>();
