// SPDX-License-Identifier: MIT
// Written by bindings/generate from bindings/detent.h.in: change that file instead.
#include "c/movers.hpp"

// clang-format off
detent_status detent_scene3_cast(const detent_context* context, detent_handle scene, const detent_shape3* shape, const detent_direction3* direction, int32_t max_distance, uint32_t layers, detent_object_hit3* hit) {
  return detent::c::Movers<3>::cast(context, scene, shape, direction, max_distance, layers, hit);
}
detent_status detent_scene3_cast_any(const detent_context* context, detent_handle scene, const detent_shape3* shape, const detent_direction3* direction, int32_t max_distance, uint32_t layers) {
  return detent::c::Movers<3>::cast_any(context, scene, shape, direction, max_distance, layers);
}
detent_status detent_scene3_cast_all(const detent_context* context, detent_handle scene, const detent_shape3* shape, const detent_direction3* direction, int32_t max_distance, uint32_t layers, detent_object_hit3* hits, uint32_t room, uint32_t* count) {
  return detent::c::Movers<3>::cast_all(context, scene, shape, direction, max_distance, layers, hits, room, count);
}
detent_status detent_mover3_default_settings(detent_mover3_settings* settings) {
  return detent::c::Movers<3>::default_settings(settings);
}
detent_status detent_mover3_move(const detent_context* context, detent_handle scene, detent_mover3* mover, const detent_vec3* by, const detent_mover3_settings* settings, uint32_t layers, detent_id ignored, detent_move3* result) {
  return detent::c::Movers<3>::move(context, scene, mover, by, settings, layers, ignored, result);
}
detent_status detent_mover3_clip_velocity(const detent_vec3* velocity, const detent_move3* result, detent_vec3* clipped) {
  return detent::c::Movers<3>::clip_velocity(velocity, result, clipped);
}
// clang-format on
