// SPDX-License-Identifier: MIT
// Written by bindings/generate from bindings/detent.h.in: change that file instead.
#include "c/casts.hpp"

// clang-format off
detent_status detent_cast2(const detent_shape2* shape, const detent_direction2* direction, int32_t max_distance, const detent_shape2* target, detent_hit2* hit) {
  return detent::c::Casts<2>::cast(shape, direction, max_distance, target, hit);
}
detent_status detent_shapes2_cast(const detent_context* context, const detent_shape2* shape, const detent_direction2* direction, int32_t max_distance, const detent_shape2* targets, uint32_t count, detent_hit2* hit) {
  return detent::c::Casts<2>::cast_of_shapes(context, shape, direction, max_distance, targets, count, hit);
}
// clang-format on
