// SPDX-License-Identifier: MIT
// Written by bindings/generate from bindings/detent.h.in: change that file instead.
#include "c/movers.hpp"

// clang-format off
detent_status detent_scene2_cast(const detent_context* context, detent_handle scene, const detent_shape2* shape, const detent_direction2* direction, int32_t max_distance, uint32_t layers, detent_object_hit2* hit) {
  return detent::c::Movers<2>::cast(context, scene, shape, direction, max_distance, layers, hit);
}
detent_status detent_scene2_cast_any(const detent_context* context, detent_handle scene, const detent_shape2* shape, const detent_direction2* direction, int32_t max_distance, uint32_t layers) {
  return detent::c::Movers<2>::cast_any(context, scene, shape, direction, max_distance, layers);
}
detent_status detent_scene2_cast_all(const detent_context* context, detent_handle scene, const detent_shape2* shape, const detent_direction2* direction, int32_t max_distance, uint32_t layers, detent_object_hit2* hits, uint32_t room, uint32_t* count) {
  return detent::c::Movers<2>::cast_all(context, scene, shape, direction, max_distance, layers, hits, room, count);
}
detent_status detent_mover2_default_settings(detent_mover2_settings* settings) {
  return detent::c::Movers<2>::default_settings(settings);
}
detent_status detent_mover2_move(const detent_context* context, detent_handle scene, detent_mover2* mover, const detent_vec2* by, const detent_mover2_settings* settings, uint32_t layers, detent_id ignored, detent_move2* result) {
  return detent::c::Movers<2>::move(context, scene, mover, by, settings, layers, ignored, result);
}
detent_status detent_mover2_clip_velocity(const detent_vec2* velocity, const detent_move2* result, detent_vec2* clipped) {
  return detent::c::Movers<2>::clip_velocity(velocity, result, clipped);
}
// clang-format on
