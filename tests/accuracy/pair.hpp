// SPDX-License-Identifier: MIT
#pragma once

#include "accuracy/asking.hpp"

namespace detent::accuracy {

template <class Kind>
Query ray_query(std::string name, int cost, bool has_angles = true) {
  return {"raycast", std::move(name), cost,
          [has_angles](const Rung& rung) { return rung.angle <= 0 || has_angles; }, ask_all<Kind>};
}

template <class Kind>
Query pair_query(std::string kind, std::string name, int cost) {
  return {std::move(kind), std::move(name), cost,
          [](const Rung& rung) {
            return rung.ladder != Ladder::distance && (rung.angle <= 0 || Kind::has_angle);
          },
          ask_all<Kind>};
}

/// `cost` divides the number of test cases where the exact result is slow to compute.
template <class Kind>
Query overlap_query(std::string name, int cost) {
  return pair_query<Kind>("overlaps", std::move(name), cost);
}
template <class Kind>
Query segment_query(std::string name, int cost) {
  return pair_query<Kind>("intersects", std::move(name), cost);
}

}  // namespace detent::accuracy
