// SPDX-License-Identifier: MIT
#include "rates.hpp"

std::size_t detent::verify::rates_of_rays_and_points() {
  return check_rates<SolidRays, FlatRays, RoundRays, RoundPoints, BoxPoints, FlatPoints,
                     LinePoints>();
}
