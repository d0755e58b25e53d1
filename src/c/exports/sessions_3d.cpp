// SPDX-License-Identifier: MIT
// Written by bindings/generate from bindings/detent.h.in: change that file instead.
#include "c/sessions.hpp"

// clang-format off
detent_status detent_world3_diff(const detent_context* context, detent_handle a, detent_handle b, uint32_t most, void* names, uint32_t room, uint32_t* size) {
  return detent::c::Differences<3>::of_worlds(context, a, b, most, names, room, size);
}
detent_status detent_scene3_diff(const detent_context* context, detent_handle a, detent_handle b, uint32_t most, void* names, uint32_t room, uint32_t* size) {
  return detent::c::Differences<3>::of_scenes(context, a, b, most, names, room, size);
}
detent_status detent_session3_create(detent_context* context, const detent_session_settings* settings, detent_handle world, detent_handle* session) {
  return detent::c::Sessions<3>::create(context, settings, world, session);
}
detent_status detent_session3_destroy(detent_context* context, detent_handle session) {
  return detent::c::Sessions<3>::destroy(context, session);
}
detent_status detent_session3_world(const detent_context* context, detent_handle session, detent_handle* world) {
  return detent::c::Sessions<3>::world(context, session, world);
}
detent_status detent_session3_receive(detent_context* context, detent_handle session, uint32_t peer, const void* bytes, uint32_t size, uint64_t now) {
  return detent::c::Sessions<3>::receive(context, session, peer, bytes, size, now);
}
detent_status detent_session3_begin_frame(detent_context* context, detent_handle session, const void* input, detent_frame* frame, void* inputs) {
  return detent::c::Sessions<3>::begin_frame(context, session, input, frame, inputs);
}
detent_status detent_session3_end_frame(detent_context* context, detent_handle session) {
  return detent::c::Sessions<3>::end_frame(context, session);
}
detent_status detent_session3_packet(detent_context* context, detent_handle session, uint64_t now, uint32_t* peer, void* bytes, uint32_t room, uint32_t* size) {
  return detent::c::Sessions<3>::packet(context, session, now, peer, bytes, room, size);
}
detent_status detent_session3_event(detent_context* context, detent_handle session, detent_session_event* event, void* name, uint32_t room) {
  return detent::c::Sessions<3>::event(context, session, event, name, room);
}
detent_status detent_session3_status(const detent_context* context, detent_handle session, detent_session_status* status) {
  return detent::c::Sessions<3>::status(context, session, status);
}
detent_status detent_session3_matched(const detent_context* context, detent_handle session, uint32_t peer, uint32_t* frame) {
  return detent::c::Sessions<3>::matched(context, session, peer, frame);
}
detent_status detent_session3_is_awaited(const detent_context* context, detent_handle session, uint32_t player) {
  return detent::c::Sessions<3>::is_awaited(context, session, player);
}
detent_status detent_session3_drop(detent_context* context, detent_handle session, uint32_t peer) {
  return detent::c::Sessions<3>::drop(context, session, peer);
}
detent_status detent_session3_pause(detent_context* context, detent_handle session, uint32_t is_paused) {
  return detent::c::Sessions<3>::pause(context, session, is_paused);
}
detent_status detent_session3_replay(const detent_context* context, detent_handle session, void* bytes, uint32_t room, uint32_t* size) {
  return detent::c::Sessions<3>::replay(context, session, bytes, room, size);
}
detent_status detent_replay3_create(detent_context* context, const void* bytes, uint32_t size, detent_handle world, uint32_t input_size, uint32_t words, detent_handle* replay) {
  return detent::c::Replays<3>::create(context, bytes, size, world, input_size, words, replay);
}
detent_status detent_replay3_destroy(detent_context* context, detent_handle replay) {
  return detent::c::Replays<3>::destroy(context, replay);
}
detent_status detent_replay3_world(const detent_context* context, detent_handle replay, detent_handle* world) {
  return detent::c::Replays<3>::world(context, replay, world);
}
detent_status detent_replay3_begin_frame(detent_context* context, detent_handle replay, detent_frame* frame, void* inputs) {
  return detent::c::Replays<3>::begin_frame(context, replay, frame, inputs);
}
detent_status detent_replay3_end_frame(detent_context* context, detent_handle replay) {
  return detent::c::Replays<3>::end_frame(context, replay);
}
detent_status detent_replay3_check(const detent_context* context, detent_handle replay, detent_replay_check* check) {
  return detent::c::Replays<3>::check(context, replay, check);
}
// clang-format on
