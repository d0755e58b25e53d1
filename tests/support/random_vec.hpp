// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "detent/math/vec.hpp"
#include "support/random.hpp"

namespace detent::test {

/// A vector whose coordinates have raw bits uniform in [low, high].
template <Scalar S, int N>
Vec<S, N> random_vec(Random& random, std::int64_t low, std::int64_t high) {
  return make_vec<N>([&](int) { return random.number<S>(low, high); });
}

}  // namespace detent::test
