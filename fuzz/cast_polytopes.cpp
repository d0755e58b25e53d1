// SPDX-License-Identifier: MIT
#include "cast.hpp"

namespace detent::fuzz {

void check_casts_of_polytopes(Bytes input) { check_casts<false>(input); }

}  // namespace detent::fuzz
