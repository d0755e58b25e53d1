// SPDX-License-Identifier: MIT
// Written by bindings/generate from bindings/detent.h.in: change that file instead.
#include "c/closest.hpp"

// clang-format off
detent_status detent_closest_points2(const detent_shape2* a, const detent_shape2* b, detent_vec2* point_a, detent_vec2* point_b) {
  return detent::c::Closest<2>::closest_points(a, b, point_a, point_b);
}
detent_status detent_shapes2_closest_points(const detent_context* context, const detent_shape2* a, uint32_t a_count, const detent_shape2* b, uint32_t b_count, detent_vec2* point_a, detent_vec2* point_b) {
  return detent::c::Closest<2>::closest_points_of_shapes(context, a, a_count, b, b_count, point_a, point_b);
}
// clang-format on
