// SPDX-License-Identifier: MIT
#pragma once

#include "detent/number/scalar.hpp"

namespace detent {

/// Limits the steps of a search that provably ends with exact numbers: no limit for those, 100
/// steps for numbers that round, with which it may not end.
template <Number T>
class Patience {
 public:
  /// Whether there is another step.
  [[nodiscard]] constexpr bool step() noexcept {
    if constexpr (is_fixed<T>) {
      return true;
    } else {
      return left_-- > 0;
    }
  }

 private:
  int left_ = 100;
};

}  // namespace detent
