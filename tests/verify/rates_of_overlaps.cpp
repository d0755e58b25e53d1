// SPDX-License-Identifier: MIT
#include "rates.hpp"

std::size_t detent::verify::rates_of_overlaps() {
  return check_rates<SphereOverlaps, AabbOverlaps, ObbOverlaps, FlatOverlaps, Intersections>();
}
