// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "verify/judge/casts.hpp"
#include "verify/judge/meshes.hpp"

namespace detent::verify::judge {

/// From the distance to each box: no tree.
template <int Row, Scalar S, int N, class Answer>
std::optional<Wrong> judge(const SceneCastCase<S, N>& c, const Answer& got) {
  std::vector<Found<S>> all;
  for (std::uint32_t i = 0; i < c.size; ++i) {
    if ((c.layers[i] & c.mask) == 0) continue;
    if (const auto distance = distance_along(c.moving, c.boxes[i])) {
      all.push_back({*distance, ObjectId{i, i + 1}});
    }
  }
  std::sort(all.begin(), all.end());
  return compare_results(all, got);
}

}  // namespace detent::verify::judge
