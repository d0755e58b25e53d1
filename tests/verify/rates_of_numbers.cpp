// SPDX-License-Identifier: MIT
#include "rates.hpp"

std::size_t detent::verify::rates_of_numbers() {
  return check_rates<Turns, Arithmetic, Moves, Extents, Sights>();
}
