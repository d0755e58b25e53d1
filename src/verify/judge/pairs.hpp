// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "verify/judge/exact.hpp"

namespace detent::verify::judge {

template <int Row, Scalar S, int N, class First, class Second>
std::optional<Wrong> judge(const PairCase<S, N, First, Second>& c, bool got) {
  const auto a = in_raw_units<S>(c.a);
  const auto b = in_raw_units<S>(c.b);
  return compare(oracle::meet(as_shape(a), as_shape(b)), got);
}

}  // namespace detent::verify::judge
