// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include "detent/query/kernel/common_point.hpp"
#include "detent/query/kernel/simplex.hpp"

// With scalars that round, corners of one face rarely have exactly the same height, so features are
// not found by comparing heights. The feature where GJK ends contains a face of both bodies.

namespace detent::detail {

/// The weights of the corners of `feature` in its point closest to the origin.
template <Number T, int N>
[[nodiscard]] constexpr auto weights_of(const Simplex<T, N>& feature) noexcept {
  std::array<T, 3> weights{T(1), T(0), T(0)};
  if (feature.count == 2) {
    const auto edge = feature[1] - feature[0];
    weights[1] = -dot(feature[0], edge) / squared_length(edge);
    weights[0] = 1 - weights[1];
  }
  if constexpr (N == 3) {
    if (feature.count == 3) {
      const auto normal = facet_normal(feature);
      for (int k = 0; k < 3; ++k) {
        const auto opposite = cross(feature[(k + 1) % 3], feature[(k + 2) % 3]);
        weights[static_cast<std::size_t>(k)] = dot(normal, opposite) / squared_length(normal);
      }
    }
  }
  return weights;
}

/// The closest points p and q of two bodies, given the feature of their closest difference.
template <class A, class B, Number T, int N>
constexpr void find_by_weights(const A& a, const B& b, const Simplex<T, N>& feature, Vec<T, N>& p,
                               Vec<T, N>& q) noexcept {
  const auto weights = weights_of(feature);
  for (int k = 0; k < feature.count; ++k) {
    const auto weight = weights[static_cast<std::size_t>(k)];
    any_corner(a, [&](const auto& corner) {
      return any_corner(b, [&](const auto& other) {
        if (corner - other != feature[k]) return false;
        p = p + corner * weight;
        q = q + other * weight;
        return true;
      });
    });
  }
}

}  // namespace detent::detail
