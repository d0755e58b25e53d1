// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace detent::bench {

/// The number of hits among a query's inputs, in every fixed scalar, for the scenes of ordinary and
/// of small size. queries.hpp and pairs.hpp have those of each query. A benchmark with another count
/// would be fast by being wrong.
struct Golden {
  std::size_t ordinary;
  std::size_t small;
};

}  // namespace detent::bench
