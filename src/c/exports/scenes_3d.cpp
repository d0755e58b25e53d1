// SPDX-License-Identifier: MIT
// Written by bindings/generate from bindings/detent.h.in: change that file instead.
#include "c/scenes.hpp"

// clang-format off
detent_status detent_hull3_create(detent_context* context, uint32_t id, const detent_vec3* points, uint32_t count, detent_handle* hull) {
  return detent::c::Hulls<3>::create(context, id, points, count, hull);
}
detent_status detent_scene3_create(detent_context* context, detent_handle* scene) {
  return detent::c::Scenes<3>::create(context, scene);
}
detent_status detent_scene3_destroy(detent_context* context, detent_handle scene) {
  return detent::c::Scenes<3>::destroy(context, scene);
}
detent_status detent_scene3_add(detent_context* context, detent_handle scene, const detent_shape3* shape, const detent_traits* traits, detent_id* id) {
  return detent::c::Scenes<3>::add(context, scene, shape, traits, id);
}
detent_status detent_scene3_add_as(detent_context* context, detent_handle scene, detent_id id, const detent_shape3* shape, const detent_traits* traits) {
  return detent::c::Scenes<3>::add_as(context, scene, id, shape, traits);
}
detent_status detent_scene3_remove(detent_context* context, detent_handle scene, detent_id id) {
  return detent::c::Scenes<3>::remove(context, scene, id);
}
detent_status detent_scene3_replace(detent_context* context, detent_handle scene, detent_id id, const detent_shape3* shape) {
  return detent::c::Scenes<3>::replace(context, scene, id, shape);
}
detent_status detent_scene3_move(detent_context* context, detent_handle scene, detent_id id, const detent_vec3* by) {
  return detent::c::Scenes<3>::move(context, scene, id, by);
}
detent_status detent_scene3_object(const detent_context* context, detent_handle scene, detent_id id, detent_shape3* shape, detent_traits* traits) {
  return detent::c::Scenes<3>::object(context, scene, id, shape, traits);
}
detent_status detent_scene3_set_traits(detent_context* context, detent_handle scene, detent_id id, const detent_traits* traits) {
  return detent::c::Scenes<3>::set_traits(context, scene, id, traits);
}
detent_status detent_scene3_add_frame(detent_context* context, detent_handle scene, const detent_transform3* transform, detent_id parent, detent_id* frame) {
  return detent::c::Scenes<3>::add_frame(context, scene, transform, parent, frame);
}
detent_status detent_scene3_move_frame(detent_context* context, detent_handle scene, detent_id frame, const detent_transform3* transform) {
  return detent::c::Scenes<3>::move_frame(context, scene, frame, transform);
}
detent_status detent_scene3_remove_frame(detent_context* context, detent_handle scene, detent_id frame) {
  return detent::c::Scenes<3>::remove_frame(context, scene, frame);
}
detent_status detent_scene3_frame(const detent_context* context, detent_handle scene, detent_id frame, detent_transform3* local, detent_transform3* world) {
  return detent::c::Scenes<3>::frame(context, scene, frame, local, world);
}
detent_status detent_scene3_size(const detent_context* context, detent_handle scene, uint32_t* size) {
  return detent::c::Scenes<3>::size(context, scene, size);
}
detent_status detent_scene3_optimize(detent_context* context, detent_handle scene) {
  return detent::c::Scenes<3>::optimize(context, scene);
}
detent_status detent_scene3_raycast(const detent_context* context, detent_handle scene, const detent_ray3* ray, uint32_t layers, detent_object_hit3* hit) {
  return detent::c::Scenes<3>::raycast(context, scene, ray, layers, hit);
}
detent_status detent_scene3_raycast_any(const detent_context* context, detent_handle scene, const detent_ray3* ray, uint32_t layers) {
  return detent::c::Scenes<3>::raycast_any(context, scene, ray, layers);
}
detent_status detent_scene3_raycast_all(const detent_context* context, detent_handle scene, const detent_ray3* ray, uint32_t layers, detent_object_hit3* hits, uint32_t room, uint32_t* count) {
  return detent::c::Scenes<3>::raycast_all(context, scene, ray, layers, hits, room, count);
}
detent_status detent_scene3_raycast_many(const detent_context* context, detent_handle scene, const detent_ray3* rays, uint32_t count, uint32_t layers, detent_object_hit3* hits) {
  return detent::c::Scenes<3>::raycast_many(context, scene, rays, count, layers, hits);
}
detent_status detent_scene3_nearest(const detent_context* context, detent_handle scene, const detent_shape3* question, uint32_t layers, detent_found* found) {
  return detent::c::Scenes<3>::nearest(context, scene, question, layers, found);
}
detent_status detent_scene3_any(const detent_context* context, detent_handle scene, const detent_shape3* question, uint32_t layers) {
  return detent::c::Scenes<3>::any(context, scene, question, layers);
}
detent_status detent_scene3_all(const detent_context* context, detent_handle scene, const detent_shape3* question, uint32_t layers, detent_found* found, uint32_t room, uint32_t* count) {
  return detent::c::Scenes<3>::all(context, scene, question, layers, found, room, count);
}
detent_status detent_scene3_overlaps(const detent_context* context, detent_handle scene, detent_pair* pairs, uint32_t room, uint32_t* count) {
  return detent::c::Scenes<3>::overlaps(context, scene, pairs, room, count);
}
detent_status detent_scene3_digest(const detent_context* context, detent_handle scene, uint64_t* digest) {
  return detent::c::Scenes<3>::digest(context, scene, digest);
}
detent_status detent_scene3_snapshot(const detent_context* context, detent_handle scene, void* bytes, uint32_t room, uint32_t* size) {
  return detent::c::Scenes<3>::snapshot(context, scene, bytes, room, size);
}
detent_status detent_scene3_restore(detent_context* context, detent_handle scene, const void* bytes, uint32_t size) {
  return detent::c::Scenes<3>::restore(context, scene, bytes, size);
}
// clang-format on
