// SPDX-License-Identifier: MIT
// Written by bindings/generate from bindings/detent.h.in: change that file instead.
#include "c/unions.hpp"

// clang-format off
detent_status detent_ray2_contains(const detent_ray2* ray, const detent_vec2* point) {
  return detent::c::Rays<2>::contains(ray, point);
}
detent_status detent_ray2_closest_point(const detent_ray2* ray, const detent_vec2* point, detent_vec2* closest) {
  return detent::c::Rays<2>::closest_point(ray, point, closest);
}
detent_status detent_ray2_distance_to_point(const detent_ray2* ray, const detent_vec2* point, int32_t* distance) {
  return detent::c::Rays<2>::distance_to_point(ray, point, distance);
}
detent_status detent_shapes2_raycast(const detent_context* context, const detent_ray2* ray, const detent_shape2* shapes, uint32_t count, detent_hit2* hit) {
  return detent::c::Unions<2>::raycast(context, ray, shapes, count, hit);
}
detent_status detent_shapes2_contains(const detent_context* context, const detent_shape2* shapes, uint32_t count, const detent_vec2* point) {
  return detent::c::Unions<2>::contains(context, shapes, count, point);
}
detent_status detent_shapes2_overlaps(const detent_context* context, const detent_shape2* a, uint32_t a_count, const detent_shape2* b, uint32_t b_count) {
  return detent::c::Unions<2>::overlaps(context, a, a_count, b, b_count);
}
detent_status detent_shapes2_closest_point(const detent_context* context, const detent_shape2* shapes, uint32_t count, const detent_vec2* point, detent_vec2* closest) {
  return detent::c::Unions<2>::closest_point(context, shapes, count, point, closest);
}
detent_status detent_shapes2_distance_to_point(const detent_context* context, const detent_shape2* shapes, uint32_t count, const detent_vec2* point, int32_t* distance) {
  return detent::c::Unions<2>::distance_to_point(context, shapes, count, point, distance);
}
detent_status detent_shapes2_distance(const detent_context* context, const detent_shape2* a, uint32_t a_count, const detent_shape2* b, uint32_t b_count, int32_t* distance) {
  return detent::c::Unions<2>::distance(context, a, a_count, b, b_count, distance);
}
// clang-format on
