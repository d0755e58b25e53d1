// SPDX-License-Identifier: MIT
// Written by bindings/generate from bindings/detent.h.in: change that file instead.
#include "c/closest.hpp"

// clang-format off
detent_status detent_closest_points3(const detent_shape3* a, const detent_shape3* b, detent_vec3* point_a, detent_vec3* point_b) {
  return detent::c::Closest<3>::closest_points(a, b, point_a, point_b);
}
// clang-format on
