// SPDX-License-Identifier: MIT
// Written by bindings/generate from bindings/detent.h.in: change that file instead.
#include "c/queries.hpp"

// clang-format off
detent_status detent_raycast2(const detent_ray2* ray, const detent_shape2* shape, detent_hit2* hit) {
  return detent::c::Queries<2>::raycast(ray, shape, hit);
}
detent_status detent_raycast2_many(const detent_ray2* rays, uint32_t count, const detent_shape2* shape, int32_t* distances) {
  return detent::c::Queries<2>::raycast_many(rays, count, shape, distances);
}
detent_status detent_contains2(const detent_shape2* shape, const detent_vec2* point) {
  return detent::c::Queries<2>::contains(shape, point);
}
detent_status detent_overlaps2(const detent_shape2* a, const detent_shape2* b) {
  return detent::c::Queries<2>::overlaps(a, b);
}
detent_status detent_closest_point2(const detent_shape2* shape, const detent_vec2* point, detent_vec2* closest) {
  return detent::c::Queries<2>::closest_point(shape, point, closest);
}
detent_status detent_distance_to_point2(const detent_shape2* shape, const detent_vec2* point, int32_t* distance) {
  return detent::c::Queries<2>::distance_to_point(shape, point, distance);
}
detent_status detent_distance2(const detent_shape2* a, const detent_shape2* b, int32_t* distance) {
  return detent::c::Queries<2>::distance(a, b, distance);
}
// clang-format on
