// SPDX-License-Identifier: MIT
#pragma once

#include "c/points.hpp"
#include "detent/query/closest_points.hpp"

// Closest points of two shapes.
namespace detent::c {

template <int N>
struct Closest {
  using T = Types<N>;

  static detent_status closest_points(const typename T::Shape* a, const typename T::Shape* b,
                                      typename T::Vec* point_a, typename T::Vec* point_b) {
    if (a == nullptr || b == nullptr || point_a == nullptr || point_b == nullptr) {
      return DETENT_BAD_ARGUMENT;
    }
    return with_points<N>(*a, [&](const auto& one) {
      return with_points<N>(*b, [&](const auto& other) -> detent_status {
        const auto points = detent::closest_points(one, other);
        *point_a = Output<N>::vec(points.first);
        *point_b = Output<N>::vec(points.second);
        return DETENT_OK;
      });
    });
  }
};

}  // namespace detent::c
