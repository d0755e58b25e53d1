// SPDX-License-Identifier: MIT
// Written by bindings/generate from bindings/detent.h.in: change that file instead.
#include "c/casts.hpp"

// clang-format off
detent_status detent_cast3(const detent_shape3* shape, const detent_direction3* direction, int32_t max_distance, const detent_shape3* target, detent_hit3* hit) {
  return detent::c::Casts<3>::cast(shape, direction, max_distance, target, hit);
}
detent_status detent_shapes3_cast(const detent_context* context, const detent_shape3* shape, const detent_direction3* direction, int32_t max_distance, const detent_shape3* targets, uint32_t count, detent_hit3* hit) {
  return detent::c::Casts<3>::cast_of_shapes(context, shape, direction, max_distance, targets, count, hit);
}
// clang-format on
