// SPDX-License-Identifier: MIT
// Written by bindings/generate from bindings/detent.h.in: change that file instead.
#include "c/unions.hpp"

// clang-format off
detent_status detent_ray3_contains(const detent_ray3* ray, const detent_vec3* point) {
  return detent::c::Rays<3>::contains(ray, point);
}
detent_status detent_ray3_closest_point(const detent_ray3* ray, const detent_vec3* point, detent_vec3* closest) {
  return detent::c::Rays<3>::closest_point(ray, point, closest);
}
detent_status detent_ray3_distance_to_point(const detent_ray3* ray, const detent_vec3* point, int32_t* distance) {
  return detent::c::Rays<3>::distance_to_point(ray, point, distance);
}
detent_status detent_shapes3_raycast(const detent_context* context, const detent_ray3* ray, const detent_shape3* shapes, uint32_t count, detent_hit3* hit) {
  return detent::c::Unions<3>::raycast(context, ray, shapes, count, hit);
}
detent_status detent_shapes3_contains(const detent_context* context, const detent_shape3* shapes, uint32_t count, const detent_vec3* point) {
  return detent::c::Unions<3>::contains(context, shapes, count, point);
}
detent_status detent_shapes3_overlaps(const detent_context* context, const detent_shape3* a, uint32_t a_count, const detent_shape3* b, uint32_t b_count) {
  return detent::c::Unions<3>::overlaps(context, a, a_count, b, b_count);
}
detent_status detent_shapes3_closest_point(const detent_context* context, const detent_shape3* shapes, uint32_t count, const detent_vec3* point, detent_vec3* closest) {
  return detent::c::Unions<3>::closest_point(context, shapes, count, point, closest);
}
detent_status detent_shapes3_distance_to_point(const detent_context* context, const detent_shape3* shapes, uint32_t count, const detent_vec3* point, int32_t* distance) {
  return detent::c::Unions<3>::distance_to_point(context, shapes, count, point, distance);
}
detent_status detent_shapes3_distance(const detent_context* context, const detent_shape3* a, uint32_t a_count, const detent_shape3* b, uint32_t b_count, int32_t* distance) {
  return detent::c::Unions<3>::distance(context, a, a_count, b, b_count, distance);
}
// clang-format on
