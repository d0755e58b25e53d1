// SPDX-License-Identifier: MIT
// Written by bindings/generate from bindings/detent.h.in: change that file instead.
#include "c/queries.hpp"

// clang-format off
detent_status detent_raycast3(const detent_ray3* ray, const detent_shape3* shape, detent_hit3* hit) {
  return detent::c::Queries<3>::raycast(ray, shape, hit);
}
detent_status detent_raycast3_many(const detent_ray3* rays, uint32_t count, const detent_shape3* shape, int32_t* distances) {
  return detent::c::Queries<3>::raycast_many(rays, count, shape, distances);
}
detent_status detent_contains3(const detent_shape3* shape, const detent_vec3* point) {
  return detent::c::Queries<3>::contains(shape, point);
}
detent_status detent_overlaps3(const detent_shape3* a, const detent_shape3* b) {
  return detent::c::Queries<3>::overlaps(a, b);
}
detent_status detent_closest_point3(const detent_shape3* shape, const detent_vec3* point, detent_vec3* closest) {
  return detent::c::Queries<3>::closest_point(shape, point, closest);
}
detent_status detent_distance_to_point3(const detent_shape3* shape, const detent_vec3* point, int32_t* distance) {
  return detent::c::Queries<3>::distance_to_point(shape, point, distance);
}
detent_status detent_distance3(const detent_shape3* a, const detent_shape3* b, int32_t* distance) {
  return detent::c::Queries<3>::distance(a, b, distance);
}
// clang-format on
