// SPDX-License-Identifier: MIT
//
// A moving shape touches a target at the exact distance rounded down, with a normal and a point of
// the target.

#include "cast.hpp"

namespace detent::fuzz {

void property(Bytes input) {
  check_casts<true>(input);
  check_casts_of_polytopes(input);
}

}  // namespace detent::fuzz
