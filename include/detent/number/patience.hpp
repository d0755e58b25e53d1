// SPDX-License-Identifier: MIT
#pragma once

#include "detent/number/scalar.hpp"

namespace detent {

/// Limits the steps of a search. With exact numbers it provably ends, so there is no limit; with
/// numbers that round it might not, so the limit is 100 steps.
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
