// SPDX-License-Identifier: MIT
// Written by bindings/generate from bindings/detent.h.in: change that file instead.
#include "c/scenes.hpp"

// clang-format off
detent_status detent_hull2_create(detent_context* context, uint32_t id, const detent_vec2* points, uint32_t count, detent_handle* hull) {
  return detent::c::Hulls<2>::create(context, id, points, count, hull);
}
detent_status detent_scene2_create(detent_context* context, detent_handle* scene) {
  return detent::c::Scenes<2>::create(context, scene);
}
detent_status detent_scene2_destroy(detent_context* context, detent_handle scene) {
  return detent::c::Scenes<2>::destroy(context, scene);
}
detent_status detent_scene2_add(detent_context* context, detent_handle scene, const detent_shape2* shape, const detent_traits* traits, detent_id* id) {
  return detent::c::Scenes<2>::add(context, scene, shape, traits, id);
}
detent_status detent_scene2_add_as(detent_context* context, detent_handle scene, detent_id id, const detent_shape2* shape, const detent_traits* traits) {
  return detent::c::Scenes<2>::add_as(context, scene, id, shape, traits);
}
detent_status detent_scene2_remove(detent_context* context, detent_handle scene, detent_id id) {
  return detent::c::Scenes<2>::remove(context, scene, id);
}
detent_status detent_scene2_replace(detent_context* context, detent_handle scene, detent_id id, const detent_shape2* shape) {
  return detent::c::Scenes<2>::replace(context, scene, id, shape);
}
detent_status detent_scene2_move(detent_context* context, detent_handle scene, detent_id id, const detent_vec2* by) {
  return detent::c::Scenes<2>::move(context, scene, id, by);
}
detent_status detent_scene2_object(const detent_context* context, detent_handle scene, detent_id id, detent_shape2* shape, detent_traits* traits) {
  return detent::c::Scenes<2>::object(context, scene, id, shape, traits);
}
detent_status detent_scene2_set_traits(detent_context* context, detent_handle scene, detent_id id, const detent_traits* traits) {
  return detent::c::Scenes<2>::set_traits(context, scene, id, traits);
}
detent_status detent_scene2_add_frame(detent_context* context, detent_handle scene, const detent_transform2* transform, detent_id parent, detent_id* frame) {
  return detent::c::Scenes<2>::add_frame(context, scene, transform, parent, frame);
}
detent_status detent_scene2_move_frame(detent_context* context, detent_handle scene, detent_id frame, const detent_transform2* transform) {
  return detent::c::Scenes<2>::move_frame(context, scene, frame, transform);
}
detent_status detent_scene2_remove_frame(detent_context* context, detent_handle scene, detent_id frame) {
  return detent::c::Scenes<2>::remove_frame(context, scene, frame);
}
detent_status detent_scene2_frame(const detent_context* context, detent_handle scene, detent_id frame, detent_transform2* local, detent_transform2* world) {
  return detent::c::Scenes<2>::frame(context, scene, frame, local, world);
}
detent_status detent_scene2_size(const detent_context* context, detent_handle scene, uint32_t* size) {
  return detent::c::Scenes<2>::size(context, scene, size);
}
detent_status detent_scene2_optimize(detent_context* context, detent_handle scene) {
  return detent::c::Scenes<2>::optimize(context, scene);
}
detent_status detent_scene2_raycast(const detent_context* context, detent_handle scene, const detent_ray2* ray, uint32_t layers, detent_object_hit2* hit) {
  return detent::c::Scenes<2>::raycast(context, scene, ray, layers, hit);
}
detent_status detent_scene2_raycast_any(const detent_context* context, detent_handle scene, const detent_ray2* ray, uint32_t layers) {
  return detent::c::Scenes<2>::raycast_any(context, scene, ray, layers);
}
detent_status detent_scene2_raycast_all(const detent_context* context, detent_handle scene, const detent_ray2* ray, uint32_t layers, detent_object_hit2* hits, uint32_t room, uint32_t* count) {
  return detent::c::Scenes<2>::raycast_all(context, scene, ray, layers, hits, room, count);
}
detent_status detent_scene2_raycast_many(const detent_context* context, detent_handle scene, const detent_ray2* rays, uint32_t count, uint32_t layers, detent_object_hit2* hits) {
  return detent::c::Scenes<2>::raycast_many(context, scene, rays, count, layers, hits);
}
detent_status detent_scene2_nearest(const detent_context* context, detent_handle scene, const detent_shape2* question, uint32_t layers, detent_found* found) {
  return detent::c::Scenes<2>::nearest(context, scene, question, layers, found);
}
detent_status detent_scene2_any(const detent_context* context, detent_handle scene, const detent_shape2* question, uint32_t layers) {
  return detent::c::Scenes<2>::any(context, scene, question, layers);
}
detent_status detent_scene2_all(const detent_context* context, detent_handle scene, const detent_shape2* question, uint32_t layers, detent_found* found, uint32_t room, uint32_t* count) {
  return detent::c::Scenes<2>::all(context, scene, question, layers, found, room, count);
}
detent_status detent_scene2_overlaps(const detent_context* context, detent_handle scene, detent_pair* pairs, uint32_t room, uint32_t* count) {
  return detent::c::Scenes<2>::overlaps(context, scene, pairs, room, count);
}
detent_status detent_scene2_digest(const detent_context* context, detent_handle scene, uint64_t* digest) {
  return detent::c::Scenes<2>::digest(context, scene, digest);
}
detent_status detent_scene2_snapshot(const detent_context* context, detent_handle scene, void* bytes, uint32_t room, uint32_t* size) {
  return detent::c::Scenes<2>::snapshot(context, scene, bytes, room, size);
}
detent_status detent_scene2_restore(detent_context* context, detent_handle scene, const void* bytes, uint32_t size) {
  return detent::c::Scenes<2>::restore(context, scene, bytes, size);
}
// clang-format on
