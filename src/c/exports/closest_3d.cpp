// SPDX-License-Identifier: MIT
// Written by bindings/generate from bindings/detent.h.in: change that file instead.
#include "c/closest.hpp"

// clang-format off
detent_status detent_closest_points3(const detent_shape3* a, const detent_shape3* b, detent_vec3* point_a, detent_vec3* point_b) {
  return detent::c::Closest<3>::closest_points(a, b, point_a, point_b);
}
detent_status detent_shapes3_closest_points(const detent_context* context, const detent_shape3* a, uint32_t a_count, const detent_shape3* b, uint32_t b_count, detent_vec3* point_a, detent_vec3* point_b) {
  return detent::c::Closest<3>::closest_points_of_shapes(context, a, a_count, b, b_count, point_a, point_b);
}
// clang-format on
