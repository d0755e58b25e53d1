// SPDX-License-Identifier: MIT
// Written by bindings/generate from bindings/detent.h.in: change that file instead.
#include "c/worlds.hpp"

// clang-format off
detent_status detent_solid2_create(detent_context* context, uint32_t id, const detent_vec2* points, uint32_t count, detent_handle* solid) {
  return detent::c::Solids<2>::create(context, id, points, count, solid);
}
detent_status detent_part2_defaults(detent_part2* part) {
  return detent::c::Compounds<2>::defaults(part);
}
detent_status detent_compound2_create(detent_context* context, uint32_t id, const detent_part2* parts, uint32_t count, detent_handle* compound) {
  return detent::c::Compounds<2>::create(context, id, parts, count, compound);
}
detent_status detent_world2_default_settings(detent_world2_settings* settings) {
  return detent::c::Worlds<2>::default_settings(settings);
}
detent_status detent_body2_default_options(detent_body2_options* options) {
  return detent::c::Worlds<2>::default_options(options);
}
detent_status detent_world2_create(detent_context* context, const detent_world2_settings* settings, detent_handle* world) {
  return detent::c::Worlds<2>::create(context, settings, world);
}
detent_status detent_world2_destroy(detent_context* context, detent_handle world) {
  return detent::c::Worlds<2>::destroy(context, world);
}
detent_status detent_world2_add(detent_context* context, detent_handle world, const detent_shape2* shape, const detent_body2_options* options, detent_id* id) {
  return detent::c::Worlds<2>::add(context, world, shape, options, id);
}
detent_status detent_world2_add_as(detent_context* context, detent_handle world, detent_id id, const detent_shape2* shape, const detent_body2_options* options) {
  return detent::c::Worlds<2>::add_as(context, world, id, shape, options);
}
detent_status detent_world2_remove(detent_context* context, detent_handle world, detent_id id) {
  return detent::c::Worlds<2>::remove(context, world, id);
}
detent_status detent_world2_step(detent_context* context, detent_handle world) {
  return detent::c::Worlds<2>::step(context, world);
}
detent_status detent_scene2_follow(detent_context* context, detent_handle scene, detent_handle world, uint32_t sensors) {
  return detent::c::Worlds<2>::follow(context, scene, world, sensors);
}
detent_status detent_world2_part_of(const detent_context* context, detent_handle world, detent_id object, detent_id* body, uint32_t* part) {
  return detent::c::Worlds<2>::part_of(context, world, object, body, part);
}
detent_status detent_world2_body(const detent_context* context, detent_handle world, detent_id id, detent_body2* body) {
  return detent::c::Worlds<2>::body(context, world, id, body);
}
detent_status detent_world2_bodies(const detent_context* context, detent_handle world, const detent_id* ids, uint32_t count, detent_body2* bodies) {
  return detent::c::Worlds<2>::bodies(context, world, ids, count, bodies);
}
detent_status detent_world2_frame(const detent_context* context, detent_handle world, detent_id id, detent_transform2* frame) {
  return detent::c::Worlds<2>::frame(context, world, id, frame);
}
detent_status detent_world2_info(const detent_context* context, detent_handle world, detent_id id, detent_body_info* info) {
  return detent::c::Worlds<2>::info(context, world, id, info);
}
detent_status detent_world2_set_position(detent_context* context, detent_handle world, detent_id id, const detent_vec2* position) {
  return detent::c::Worlds<2>::set_position(context, world, id, position);
}
detent_status detent_world2_set_rotation(detent_context* context, detent_handle world, detent_id id, const detent_rotation2* rotation) {
  return detent::c::Worlds<2>::set_rotation(context, world, id, rotation);
}
detent_status detent_world2_set_filter(detent_context* context, detent_handle world, detent_id id, uint32_t layers, uint32_t collides_with) {
  return detent::c::Worlds<2>::set_filter(context, world, id, layers, collides_with);
}
detent_status detent_world2_set_friction(detent_context* context, detent_handle world, detent_id id, int32_t friction) {
  return detent::c::Worlds<2>::set_friction(context, world, id, friction);
}
detent_status detent_world2_set_restitution(detent_context* context, detent_handle world, detent_id id, int32_t restitution) {
  return detent::c::Worlds<2>::set_restitution(context, world, id, restitution);
}
detent_status detent_world2_set_sensor(detent_context* context, detent_handle world, detent_id id, uint32_t is_sensor) {
  return detent::c::Worlds<2>::set_sensor(context, world, id, is_sensor);
}
detent_status detent_world2_set_gravity_scale(detent_context* context, detent_handle world, detent_id id, int32_t scale) {
  return detent::c::Worlds<2>::set_gravity_scale(context, world, id, scale);
}
detent_status detent_world2_set_damping(detent_context* context, detent_handle world, detent_id id, int32_t linear, int32_t angular) {
  return detent::c::Worlds<2>::set_damping(context, world, id, linear, angular);
}
detent_status detent_world2_set_locked(detent_context* context, detent_handle world, detent_id id, uint32_t locked) {
  return detent::c::Worlds<2>::set_locked(context, world, id, locked);
}
detent_status detent_world2_set_fast(detent_context* context, detent_handle world, detent_id id, uint32_t is_fast) {
  return detent::c::Worlds<2>::set_fast(context, world, id, is_fast);
}
detent_status detent_world2_set_user(detent_context* context, detent_handle world, detent_id id, uint64_t user) {
  return detent::c::Worlds<2>::set_user(context, world, id, user);
}
detent_status detent_world2_set_gravity(detent_context* context, detent_handle world, const detent_vec2* gravity) {
  return detent::c::Worlds<2>::set_gravity(context, world, gravity);
}
detent_status detent_world2_set_velocity(detent_context* context, detent_handle world, detent_id id, const detent_vec2* velocity) {
  return detent::c::Worlds<2>::set_velocity(context, world, id, velocity);
}
detent_status detent_world2_set_angular_velocity(detent_context* context, detent_handle world, detent_id id, const int32_t* velocity) {
  return detent::c::Worlds<2>::set_angular_velocity(context, world, id, velocity);
}
detent_status detent_world2_apply_impulse(detent_context* context, detent_handle world, detent_id id, const detent_vec2* impulse, const detent_vec2* at) {
  return detent::c::Worlds<2>::apply_impulse(context, world, id, impulse, at);
}
detent_status detent_world2_apply_force(detent_context* context, detent_handle world, detent_id id, const detent_vec2* force, const detent_vec2* at) {
  return detent::c::Worlds<2>::apply_force(context, world, id, force, at);
}
detent_status detent_world2_apply_torque(detent_context* context, detent_handle world, detent_id id, const int32_t* torque) {
  return detent::c::Worlds<2>::apply_torque(context, world, id, torque);
}
detent_status detent_joint2_defaults(uint32_t kind, detent_joint2* joint) {
  return detent::c::Worlds<2>::defaults(kind, joint);
}
detent_status detent_world2_add_joint(detent_context* context, detent_handle world, const detent_joint2* joint, detent_id* id) {
  return detent::c::Worlds<2>::add_joint(context, world, joint, id);
}
detent_status detent_world2_change_joint(detent_context* context, detent_handle world, detent_id id, const detent_joint2* joint) {
  return detent::c::Worlds<2>::change_joint(context, world, id, joint);
}
detent_status detent_world2_remove_joint(detent_context* context, detent_handle world, detent_id id) {
  return detent::c::Worlds<2>::remove_joint(context, world, id);
}
detent_status detent_world2_joint(const detent_context* context, detent_handle world, detent_id id, detent_joint2* joint) {
  return detent::c::Worlds<2>::joint(context, world, id, joint);
}
detent_status detent_world2_joint_force(const detent_context* context, detent_handle world, detent_id id, detent_vec2* force) {
  return detent::c::Worlds<2>::joint_force(context, world, id, force);
}
detent_status detent_world2_joint_torque(const detent_context* context, detent_handle world, detent_id id, int32_t* torque) {
  return detent::c::Worlds<2>::joint_torque(context, world, id, torque);
}
detent_status detent_world2_joint_count(const detent_context* context, detent_handle world, uint32_t* count) {
  return detent::c::Worlds<2>::joint_count(context, world, count);
}
detent_status detent_world2_joint_ids(const detent_context* context, detent_handle world, detent_id* joints, uint32_t room, uint32_t* count) {
  return detent::c::Worlds<2>::joint_ids(context, world, joints, room, count);
}
detent_status detent_world2_broken(const detent_context* context, detent_handle world, detent_id* joints, uint32_t room, uint32_t* count) {
  return detent::c::Worlds<2>::broken(context, world, joints, room, count);
}
detent_status detent_world2_local_point(const detent_context* context, detent_handle world, detent_id id, const detent_vec2* point, detent_vec2* local) {
  return detent::c::Worlds<2>::local_point(context, world, id, point, local);
}
detent_status detent_world2_local_frame(const detent_context* context, detent_handle world, detent_id id, const detent_rotation2* frame, detent_rotation2* local) {
  return detent::c::Worlds<2>::local_frame(context, world, id, frame, local);
}
detent_status detent_world2_size(const detent_context* context, detent_handle world, uint32_t* size) {
  return detent::c::Worlds<2>::size(context, world, size);
}
detent_status detent_world2_body_ids(const detent_context* context, detent_handle world, detent_id* ids, uint32_t room, uint32_t* count) {
  return detent::c::Worlds<2>::body_ids(context, world, ids, room, count);
}
detent_status detent_world2_touching(const detent_context* context, detent_handle world, detent_id body, detent_touch* touches, uint32_t room, uint32_t* count) {
  return detent::c::Worlds<2>::touching(context, world, body, touches, room, count);
}
detent_status detent_world2_contacts(const detent_context* context, detent_handle world, detent_id body, detent_world2_contact* contacts, uint32_t room, uint32_t* count) {
  return detent::c::Worlds<2>::contacts(context, world, body, contacts, room, count);
}
detent_status detent_world2_events(const detent_context* context, detent_handle world, detent_touch* events, uint32_t room, uint32_t* count) {
  return detent::c::Worlds<2>::events(context, world, events, room, count);
}
detent_status detent_world2_digest(const detent_context* context, detent_handle world, uint64_t* digest) {
  return detent::c::Worlds<2>::digest(context, world, digest);
}
detent_status detent_world2_digest_of(const detent_context* context, detent_handle world, detent_id id, uint64_t* digest) {
  return detent::c::Worlds<2>::digest_of(context, world, id, digest);
}
detent_status detent_world2_snapshot(const detent_context* context, detent_handle world, void* bytes, uint32_t room, uint32_t* size) {
  return detent::c::Worlds<2>::snapshot(context, world, bytes, room, size);
}
detent_status detent_world2_restore(detent_context* context, detent_handle world, const void* bytes, uint32_t size) {
  return detent::c::Worlds<2>::restore(context, world, bytes, size);
}
detent_status detent_world2_words(const detent_context* context, detent_handle world, uint32_t* words) {
  return detent::c::Worlds<2>::words(context, world, words);
}
detent_status detent_world2_set_words(detent_context* context, detent_handle world, const uint32_t* words) {
  return detent::c::Worlds<2>::set_words(context, world, words);
}
// clang-format on
