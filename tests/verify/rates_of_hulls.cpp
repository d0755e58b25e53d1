// SPDX-License-Identifier: MIT
#include "rates.hpp"

std::size_t detent::verify::rates_of_hulls() {
  return check_rates<Hulls, HullOverlaps, HullMeetings>();
}
