// SPDX-License-Identifier: MIT
// Written by bindings/generate from bindings/detent.h.in: change that file instead.
#include "c/pairs.hpp"

// clang-format off
detent_status detent_contact2(const detent_shape2* a, const detent_shape2* b, detent_manifold2* contact) {
  return detent::c::Pairs<2>::contact(a, b, contact);
}
detent_status detent_time_of_impact2(const detent_shape2* a, const detent_sweep2* sweep_a, const detent_shape2* b, const detent_sweep2* sweep_b, int32_t target, detent_impact* impact) {
  return detent::c::Pairs<2>::time_of_impact(a, sweep_a, b, sweep_b, target, impact);
}
detent_status detent_shapes2_contact(const detent_context* context, const detent_shape2* a, const detent_shape2* b, detent_manifold2* contact) {
  return detent::c::Pairs<2>::contact_of_shapes(context, a, b, contact);
}
detent_status detent_shapes2_time_of_impact(const detent_context* context, const detent_shape2* a, const detent_sweep2* sweep_a, const detent_shape2* b, const detent_sweep2* sweep_b, int32_t target, detent_impact* impact) {
  return detent::c::Pairs<2>::time_of_impact_of_shapes(context, a, sweep_a, b, sweep_b, target, impact);
}
// clang-format on
