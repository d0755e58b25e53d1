/* SPDX-License-Identifier: MIT */
/* A GDNative library for Godot 3: the C interface of detent in 3D, as procedures that detent.gd
 * calls. All numbers are integers; a length of 1 is 65536. A procedure takes an array and returns
 * bytes or an integer, which is a negative status if it fails. */
#include <detent.h>
#include <string.h>

#include "gdnative.h"

#define EXPORT __attribute__((visibility("default")))

static const godot_core* core;
static detent_context context;

/* Calls a function of the engine's table by its index and type. */
#define CALL(place, type) ((type)core->functions[place])

static godot_variant integer(int64_t value) {
  godot_variant result;
  CALL(VARIANT_NEW_INT, void (*)(godot_variant*, int64_t))(&result, value);
  return result;
}

/* Argument `i`, or 0 if there are fewer. */
static godot_variant* argument(godot_array* arguments, int i) {
  if (i >= CALL(ARRAY_SIZE, int (*)(const godot_array*))(arguments)) return NULL;
  return CALL(ARRAY_OPERATOR_INDEX, godot_variant* (*)(godot_array*, int))(arguments, i);
}
static int64_t number(godot_array* arguments, int i) {
  const godot_variant* const given = argument(arguments, i);
  return given == NULL ? 0 : CALL(VARIANT_AS_INT, int64_t (*)(const godot_variant*))(given);
}
static detent_handle handle(godot_array* arguments, int i) {
  return (detent_handle)number(arguments, i);
}
static int32_t length(godot_array* arguments, int i) { return (int32_t)number(arguments, i); }
static detent_vec3 vector(godot_array* arguments, int i) {
  const detent_vec3 v = {length(arguments, i), length(arguments, i + 1), length(arguments, i + 2)};
  return v;
}
/* An id as one number: the index in the low 32 bits, the generation above. */
static detent_id id(godot_array* arguments, int i) {
  const uint64_t both = (uint64_t)number(arguments, i);
  const detent_id which = {(uint32_t)both, (uint32_t)(both >> 32)};
  return which;
}
static godot_variant id_or_status(detent_status status, detent_id which) {
  return integer(status == DETENT_OK ? (int64_t)((uint64_t)which.generation << 32 | which.index)
                                     : status == DETENT_NO ? -1000 : status);
}

/* Copies the bytes of an argument. Returns their number, or 0 if there is no room. */
static uint32_t bytes(godot_array* arguments, int i, uint8_t* to, uint32_t room) {
  const godot_variant* const given = argument(arguments, i);
  godot_pool_byte_array list;
  uint32_t size, k;
  if (given == NULL) return 0;
  list = CALL(VARIANT_AS_POOL_BYTE_ARRAY,
              godot_pool_byte_array (*)(const godot_variant*))(given);
  size = (uint32_t)CALL(POOL_BYTE_ARRAY_SIZE, int (*)(const godot_pool_byte_array*))(&list);
  for (k = 0; k < size && size <= room; ++k) {
    to[k] = CALL(POOL_BYTE_ARRAY_GET, uint8_t(*)(const godot_pool_byte_array*, int))(&list, (int)k);
  }
  CALL(POOL_BYTE_ARRAY_DESTROY, void (*)(godot_pool_byte_array*))(&list);
  return size <= room ? size : 0;
}
static godot_variant pool(const uint8_t* from, uint32_t size) {
  godot_pool_byte_array list;
  godot_variant result;
  uint32_t k;
  CALL(POOL_BYTE_ARRAY_NEW, void (*)(godot_pool_byte_array*))(&list);
  for (k = 0; k < size; ++k) {
    CALL(POOL_BYTE_ARRAY_APPEND, void (*)(godot_pool_byte_array*, uint8_t))(&list, from[k]);
  }
  CALL(VARIANT_NEW_POOL_BYTE_ARRAY, void (*)(godot_variant*, const godot_pool_byte_array*))(&result, &list);
  CALL(POOL_BYTE_ARRAY_DESTROY, void (*)(godot_pool_byte_array*))(&list);
  return result;
}

/* A sphere (kind, center, radius) or an unrotated box (kind, center, half extents). */
static detent_shape3 shape(godot_array* arguments, int i) {
  detent_shape3 made;
  int k;
  memset(&made, 0, sizeof made);
  made.kind = (uint32_t)number(arguments, i);
  if (made.kind == DETENT_SPHERE) {
    made.as.sphere.center = vector(arguments, i + 1);
    made.as.sphere.radius = length(arguments, i + 4);
  } else {
    made.as.obb.center = vector(arguments, i + 1);
    made.as.obb.half_extents = vector(arguments, i + 4);
    for (k = 0; k < 3; ++k) (&made.as.obb.rotation.axis[k].x)[k] = 1 << 30;
  }
  return made;
}

EXPORT void godot_gdnative_init(godot_options* options);
EXPORT void godot_gdnative_terminate(void* options);

void godot_gdnative_init(godot_options* options) {
  godot_variant probe;
  core = options->core;
  probe = integer(-47);
  if (core->major != 1 ||
      CALL(VARIANT_GET_TYPE, int (*)(const godot_variant*))(&probe) != VARIANT_INT ||
      CALL(VARIANT_AS_INT, int64_t (*)(const godot_variant*))(&probe) != -47) {
    options->report_loading_error(options->library, "not a GDNative interface of version 1");
    return;
  }
  detent_open(&context, NULL);
}
void godot_gdnative_terminate(void* options) {
  (void)options;
  detent_close(&context);
}

/* Each procedure receives its arguments as `a`; comments list them before the colon. */
#define PROCEDURE(name)                               \
  EXPORT godot_variant detent_godot_##name(godot_array* a); \
  godot_variant detent_godot_##name(godot_array* a)

PROCEDURE(world) {
  detent_handle world = 0;
  const detent_status status = detent_world3_create(&context, NULL, &world);
  (void)a;
  return integer(status == DETENT_OK ? (int64_t)world : status);
}
PROCEDURE(scene) {
  detent_handle scene = 0;
  const detent_status status = detent_scene3_create(&context, &scene);
  (void)a;
  return integer(status == DETENT_OK ? (int64_t)scene : status);
}
/* world, motion, shape. A fixed box is an AABB. */
PROCEDURE(add_body) {
  detent_body3_options options;
  detent_shape3 given = shape(a, 2);
  detent_id made = {0, 0};
  detent_body3_default_options(&options);
  options.motion = (uint32_t)number(a, 1);
  if (given.kind == DETENT_OBB && options.motion == DETENT_FIXED_BODY) {
    const detent_obb3 box = given.as.obb;
    memset(&given, 0, sizeof given);
    given.kind = DETENT_AABB;
    given.as.aabb.min.x = box.center.x - box.half_extents.x;
    given.as.aabb.min.y = box.center.y - box.half_extents.y;
    given.as.aabb.min.z = box.center.z - box.half_extents.z;
    given.as.aabb.max.x = box.center.x + box.half_extents.x;
    given.as.aabb.max.y = box.center.y + box.half_extents.y;
    given.as.aabb.max.z = box.center.z + box.half_extents.z;
  }
  return id_or_status(detent_world3_add(&context, handle(a, 0), &given, &options, &made), made);
}
PROCEDURE(set_velocity) {
  const detent_vec3 velocity = vector(a, 2);
  return integer(detent_world3_set_velocity(&context, handle(a, 0), id(a, 1), &velocity));
}
PROCEDURE(step) { return integer(detent_world3_step(&context, handle(a, 0))); }
/* world, body: its position and rotation, 12 little-endian numbers of four bytes. */
PROCEDURE(body) {
  detent_body3 body;
  uint8_t to[48];
  int32_t words[12];
  int i;
  if (detent_world3_body(&context, handle(a, 0), id(a, 1), &body) != DETENT_OK) return pool(to, 0);
  memcpy(words, &body.position, 12);
  memcpy(words + 3, &body.rotation, 36);
  for (i = 0; i < 48; ++i) to[i] = (uint8_t)((uint32_t)words[i / 4] >> 8 * (i % 4));
  return pool(to, 48);
}
PROCEDURE(world_digest) {
  uint64_t digest = 0;
  detent_world3_digest(&context, handle(a, 0), &digest);
  return integer((int64_t)digest);
}
PROCEDURE(world_snapshot) {
  static uint8_t room[1 << 20];
  uint32_t size = 0;
  const detent_status status =
      detent_world3_snapshot(&context, handle(a, 0), room, sizeof room, &size);
  return pool(room, status == DETENT_OK ? size : 0);
}
PROCEDURE(world_restore) {
  static uint8_t room[1 << 20];
  const uint32_t size = bytes(a, 1, room, sizeof room);
  return integer(detent_world3_restore(&context, handle(a, 0), room, size));
}
/* world, index of a word of a session's world. */
PROCEDURE(word) {
  uint32_t words[DETENT_WORDS] = {0};
  detent_world3_words(&context, handle(a, 0), words);
  return integer(words[(uint64_t)number(a, 1) % DETENT_WORDS]);
}
PROCEDURE(set_word) {
  uint32_t words[DETENT_WORDS] = {0};
  detent_world3_words(&context, handle(a, 0), words);
  words[(uint64_t)number(a, 1) % DETENT_WORDS] = (uint32_t)number(a, 2);
  return integer(detent_world3_set_words(&context, handle(a, 0), words));
}

/* scene, user word, shape. */
PROCEDURE(add_object) {
  detent_traits traits = {0, 1, DETENT_MOVING, {0, 0}};
  const detent_shape3 given = shape(a, 2);
  detent_id made = {0, 0};
  traits.user = (uint64_t)number(a, 1);
  return id_or_status(detent_scene3_add(&context, handle(a, 0), &given, &traits, &made), made);
}
PROCEDURE(replace_object) {
  const detent_shape3 given = shape(a, 2);
  return integer(detent_scene3_replace(&context, handle(a, 0), id(a, 1), &given));
}
/* scene, origin, direction in steps of 2^-30, max_distance: the id, the distance and the normal in
 * 24 bytes, or no bytes for a miss. */
PROCEDURE(raycast) {
  detent_ray3 ray;
  detent_object_hit3 hit;
  uint32_t words[6];
  uint8_t to[24];
  int i;
  ray.origin = vector(a, 1);
  ray.direction.x = length(a, 4);
  ray.direction.y = length(a, 5);
  ray.direction.z = length(a, 6);
  ray.max_distance = length(a, 7);
  if (detent_scene3_raycast(&context, handle(a, 0), &ray, 0xffffffffu, &hit) != DETENT_OK) {
    return pool(to, 0);
  }
  words[0] = hit.id.index;
  words[1] = hit.id.generation;
  words[2] = (uint32_t)hit.distance;
  words[3] = (uint32_t)hit.normal.x;
  words[4] = (uint32_t)hit.normal.y;
  words[5] = (uint32_t)hit.normal.z;
  for (i = 0; i < 24; ++i) to[i] = (uint8_t)(words[i / 4] >> 8 * (i % 4));
  return pool(to, 24);
}
PROCEDURE(scene_digest) {
  uint64_t digest = 0;
  detent_scene3_digest(&context, handle(a, 0), &digest);
  return integer((int64_t)digest);
}

/* world, match, self, players, bytes per input, words. */
PROCEDURE(session) {
  detent_session_settings settings;
  detent_handle session = 0;
  detent_status status = detent_session_default_settings(&settings);
  settings.match = (uint64_t)number(a, 1);
  settings.self = (uint32_t)number(a, 2);
  settings.players = (uint32_t)number(a, 3);
  settings.input_size = (uint32_t)number(a, 4);
  settings.words = (uint32_t)number(a, 5);
  status = detent_session3_create(&context, &settings, handle(a, 0), &session);
  return integer(status == DETENT_OK ? (int64_t)session : status);
}
PROCEDURE(session_world) {
  detent_handle world = 0;
  const detent_status status = detent_session3_world(&context, handle(a, 0), &world);
  return integer(status == DETENT_OK ? (int64_t)world : status);
}
/* session, this player's input: the concatenated inputs of all players, or nothing. */
PROCEDURE(begin_frame) {
  uint8_t pad[DETENT_INPUT] = {0}, inputs[DETENT_PLAYERS * DETENT_INPUT];
  detent_frame frame;
  const uint32_t size = bytes(a, 1, pad, sizeof pad);
  const detent_status status =
      detent_session3_begin_frame(&context, handle(a, 0), pad, &frame, inputs);
  return pool(inputs, status == DETENT_OK ? frame.players * size : 0);
}
PROCEDURE(end_frame) { return integer(detent_session3_end_frame(&context, handle(a, 0))); }
/* session, peer, packet, time in microseconds. */
PROCEDURE(receive) {
  uint8_t packet[DETENT_PACKET];
  const uint32_t size = bytes(a, 2, packet, sizeof packet);
  return integer(detent_session3_receive(&context, handle(a, 0), (uint32_t)number(a, 1), packet, size,
                                         (uint64_t)number(a, 3)));
}
/* session, time: one byte with the peer, then its next packet; or nothing. */
PROCEDURE(packet) {
  uint8_t packet[1 + DETENT_PACKET];
  uint32_t peer = 0, size = 0;
  const detent_status status = detent_session3_packet(
      &context, handle(a, 0), (uint64_t)number(a, 1), &peer, packet + 1, DETENT_PACKET, &size);
  packet[0] = (uint8_t)peer;
  return pool(packet, status == DETENT_OK ? size + 1 : 0);
}
/* session: kind, peer and frame (four bytes) of the next event, or nothing. */
PROCEDURE(event) {
  detent_session_event event;
  uint8_t to[6];
  int i;
  if (detent_session3_event(&context, handle(a, 0), &event, NULL, 0) != DETENT_OK) return pool(to, 0);
  to[0] = (uint8_t)event.kind;
  to[1] = (uint8_t)event.peer;
  for (i = 0; i < 4; ++i) to[2 + i] = (uint8_t)(event.frame >> 8 * i);
  return pool(to, 6);
}
/* session, which: 0 its frame, 1 its final frame, 2 the number of resimulated frames. */
PROCEDURE(session_status) {
  detent_session_status status;
  if (detent_session3_status(&context, handle(a, 0), &status) != DETENT_OK) return integer(-1);
  switch (number(a, 1)) {
    case 0:
      return integer(status.frame);
    case 1:
      return integer(status.final_frame);
    default:
      return integer((int64_t)status.resimulated);
  }
}
