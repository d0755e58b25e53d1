// SPDX-License-Identifier: MIT
#pragma once

#include "detent/number/scalar.hpp"

namespace detent {

/// For how many steps a search goes on whose end is proved for exact numbers: as many as it takes,
/// and 100 in numbers that round, with which it need not end.
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
