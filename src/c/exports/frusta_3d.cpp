// SPDX-License-Identifier: MIT
// Written by bindings/generate from bindings/detent.h.in: change that file instead.
#include "c/frusta.hpp"

// clang-format off
detent_status detent_camera3_look_at(const detent_vec3* eye, const detent_vec3* target, const detent_vec3* up, detent_transform3* pose) {
  return detent::c::Cameras<3>::look_at(eye, target, up, pose);
}
detent_status detent_camera3_frustum(const detent_camera3* camera, detent_frustum3* frustum) {
  return detent::c::Cameras<3>::frustum(camera, frustum);
}
detent_status detent_camera3_pick_ray(const detent_camera3* camera, int32_t width, int32_t height, int32_t column, int32_t row, detent_ray3* ray) {
  return detent::c::Cameras<3>::pick_ray(camera, width, height, column, row, ray);
}
detent_status detent_camera3_project(const detent_camera3* camera, int32_t width, int32_t height, const detent_vec3* point, detent_screen_point3* seen) {
  return detent::c::Cameras<3>::project(camera, width, height, point, seen);
}
detent_status detent_camera3_unproject(const detent_camera3* camera, int32_t width, int32_t height, int32_t column, int32_t row, int32_t depth, detent_vec3* point) {
  return detent::c::Cameras<3>::unproject(camera, width, height, column, row, depth, point);
}
detent_status detent_frustum3_raycast(const detent_ray3* ray, const detent_frustum3* frustum, detent_hit3* hit) {
  return detent::c::Frusta<3>::raycast(ray, frustum, hit);
}
detent_status detent_frustum3_contains(const detent_frustum3* frustum, const detent_vec3* point) {
  return detent::c::Frusta<3>::contains(frustum, point);
}
detent_status detent_frustum3_overlaps(const detent_context* context, const detent_frustum3* frustum, const detent_shape3* shapes, uint32_t count) {
  return detent::c::Frusta<3>::overlaps(context, frustum, shapes, count);
}
detent_status detent_frustum3_overlaps_frustum(const detent_frustum3* a, const detent_frustum3* b) {
  return detent::c::Frusta<3>::overlaps_frustum(a, b);
}
detent_status detent_frustum3_closest_point(const detent_frustum3* frustum, const detent_vec3* point, detent_vec3* closest) {
  return detent::c::Frusta<3>::closest_point(frustum, point, closest);
}
detent_status detent_frustum3_distance_to_point(const detent_frustum3* frustum, const detent_vec3* point, int32_t* distance) {
  return detent::c::Frusta<3>::distance_to_point(frustum, point, distance);
}
detent_status detent_scene3_frustum_nearest(const detent_context* context, detent_handle scene, const detent_frustum3* frustum, uint32_t layers, detent_found* found) {
  return detent::c::Frusta<3>::scene_nearest(context, scene, frustum, layers, found);
}
detent_status detent_scene3_frustum_any(const detent_context* context, detent_handle scene, const detent_frustum3* frustum, uint32_t layers) {
  return detent::c::Frusta<3>::scene_any(context, scene, frustum, layers);
}
detent_status detent_scene3_frustum_all(const detent_context* context, detent_handle scene, const detent_frustum3* frustum, uint32_t layers, detent_found* found, uint32_t room, uint32_t* count) {
  return detent::c::Frusta<3>::scene_all(context, scene, frustum, layers, found, room, count);
}
// clang-format on
