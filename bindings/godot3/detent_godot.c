/* SPDX-License-Identifier: MIT */
/* A GDNative library for Godot 3: the C interface of detent in 3D, as procedures that detent.gd
 * calls. All numbers are integers; a length of 1 is 65536. A procedure takes an array and returns
 * an integer, bytes or an array; if it fails, a negative status. Wrong arguments and handles also
 * print an error in the engine. */
#include <detent.h>
#include <string.h>

#include "gdnative.h"

#define EXPORT __attribute__((visibility("default")))

static const godot_core* core;
static detent_context context;

/* Calls a function of the engine's table by its index and type. */
#define CALL(place, type) ((type)core->functions[place])

/* What a procedure returns if there is no such body or joint. */
enum { NONE = -1000 };

/* The name of the procedure that was called last, for errors. */
static const char* called;

static void print_error(const char* what) {
  CALL(PRINT_ERROR, void (*)(const char*, const char*, const char*, int))
  (what, called, "detent_godot.c", 0);
}

static godot_variant integer(int64_t value) {
  godot_variant result;
  CALL(VARIANT_NEW_INT, void (*)(godot_variant*, int64_t))(&result, value);
  return result;
}

static int count(const godot_array* arguments) {
  return CALL(ARRAY_SIZE, int (*)(const godot_array*))(arguments);
}
/* Argument `i`, or 0 if there are fewer. */
static godot_variant* argument(godot_array* arguments, int i) {
  if (i >= count(arguments)) return NULL;
  return CALL(ARRAY_OPERATOR_INDEX, godot_variant* (*)(godot_array*, int))(arguments, i);
}
static int64_t number(godot_array* arguments, int i) {
  const godot_variant* const given = argument(arguments, i);
  return given == NULL ? 0 : CALL(VARIANT_AS_INT, int64_t (*)(const godot_variant*))(given);
}
static detent_handle handle(godot_array* arguments, int i) {
  return (detent_handle)number(arguments, i);
}
static uint32_t natural(godot_array* arguments, int i) { return (uint32_t)number(arguments, i); }
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
static int64_t id_number(detent_id which) {
  return (int64_t)((uint64_t)which.generation << 32 | which.index);
}

/* NONE if there is no such body or joint. Otherwise the status of the failed call, and an error. */
static godot_variant failure(detent_status status) {
  static const char* const reasons[] = {
      "",
      "a number is out of range",
      "the library is not open",
      "a handle of another type, or of something destroyed",
      "the length of a direction is not 1",
      "these shapes have no such query",
      "no memory",
      "no memory: destroy this scene or world",
      "no room",
      "in use",
      "the world of a session changes only in an open frame",
  };
  const int known = sizeof reasons / sizeof *reasons;
  if (status == DETENT_NO) return integer(NONE);
  print_error(-status < known ? reasons[-status] : "it failed: see the status in detent.h");
  return integer(status);
}
static godot_variant answer(detent_status status) {
  return status < 0 ? failure(status) : integer(status);
}
static godot_variant id_or_failure(detent_status status, detent_id which) {
  return status == DETENT_OK ? integer(id_number(which)) : failure(status);
}
static godot_variant handle_or_failure(detent_status status, detent_handle which) {
  return status == DETENT_OK ? integer(which) : failure(status);
}

/* `begin`, `append` and `end` build an array. */
static godot_array begin(void) {
  godot_array made;
  CALL(ARRAY_NEW, void (*)(godot_array*))(&made);
  return made;
}
static void append(godot_array* to, godot_variant value) {
  CALL(ARRAY_APPEND, void (*)(godot_array*, const godot_variant*))(to, &value);
  CALL(VARIANT_DESTROY, void (*)(godot_variant*))(&value);
}
static godot_variant end(godot_array* made) {
  godot_variant result;
  CALL(VARIANT_NEW_ARRAY, void (*)(godot_variant*, const godot_array*))(&result, made);
  CALL(ARRAY_DESTROY, void (*)(godot_array*))(made);
  return result;
}
static void append_all(godot_array* to, const int32_t* numbers, int size) {
  int i;
  for (i = 0; i < size; ++i) append(to, integer(numbers[i]));
}
static godot_variant numbers_or_failure(detent_status status, const int32_t* numbers, int size) {
  godot_array made;
  if (status != DETENT_OK) return failure(status);
  made = begin();
  append_all(&made, numbers, size);
  return end(&made);
}

/* What the library writes, before it goes to the engine. */
static union {
  uint8_t bytes[1 << 20];
  detent_id ids[(1 << 20) / sizeof(detent_id)];
  detent_touch touches[(1 << 20) / sizeof(detent_touch)];
} buffer;
enum {
  ROOM_BYTES = sizeof buffer.bytes,
  ROOM_IDS = sizeof buffer.ids / sizeof *buffer.ids,
  ROOM_TOUCHES = sizeof buffer.touches / sizeof *buffer.touches
};

static godot_variant ids_or_failure(detent_status status, uint32_t size) {
  godot_array made;
  uint32_t i;
  if (status == DETENT_OK && size > ROOM_IDS) status = DETENT_FULL;
  if (status != DETENT_OK) return failure(status);
  made = begin();
  for (i = 0; i < size; ++i) append(&made, integer(id_number(buffer.ids[i])));
  return end(&made);
}
/* [body, body, begins] for each pair. */
static godot_variant touches_or_failure(detent_status status, uint32_t size) {
  godot_array made, pair;
  uint32_t i;
  if (status == DETENT_OK && size > ROOM_TOUCHES) status = DETENT_FULL;
  if (status != DETENT_OK) return failure(status);
  made = begin();
  for (i = 0; i < size; ++i) {
    pair = begin();
    append(&pair, integer(id_number(buffer.touches[i].a)));
    append(&pair, integer(id_number(buffer.touches[i].b)));
    append(&pair, integer(buffer.touches[i].begins));
    append(&made, end(&pair));
  }
  return end(&made);
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
  made.kind = natural(arguments, i);
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

static detent_rotation3 rotation(godot_array* arguments, int i) {
  detent_rotation3 made;
  int32_t axes[9];
  int k;
  for (k = 0; k < 9; ++k) axes[k] = length(arguments, i + k);
  memcpy(&made, axes, sizeof made);
  return made;
}

/* A joint is 38 numbers: the fields of detent_joint3, an id as one number. */
enum { AFTER_IDS = 35 };
static detent_joint3 joint(godot_array* arguments, int i) {
  detent_joint3 made;
  int32_t numbers[AFTER_IDS];
  int k;
  made.kind = natural(arguments, i);
  made.a = id(arguments, i + 1);
  made.b = id(arguments, i + 2);
  for (k = 0; k < AFTER_IDS; ++k) numbers[k] = length(arguments, i + 3 + k);
  memcpy((uint8_t*)&made + offsetof(detent_joint3, anchor_a), numbers, sizeof numbers);
  return made;
}
static godot_variant joint_or_failure(detent_status status, const detent_joint3* given) {
  int32_t numbers[AFTER_IDS];
  godot_array made;
  if (status != DETENT_OK) return failure(status);
  memcpy(numbers, (const uint8_t*)given + offsetof(detent_joint3, anchor_a), sizeof numbers);
  made = begin();
  append(&made, integer(given->kind));
  append(&made, integer(id_number(given->a)));
  append(&made, integer(id_number(given->b)));
  append_all(&made, numbers, AFTER_IDS);
  return end(&made);
}

/* Whether an argument has the type of a letter:
 * h  a handle, bits, a kind or a flag: an integer in [0, 2^32 - 1], true or false
 * n  an integer of 32 bits
 * i  an id or another integer of 64 bits
 * b  bytes */
static int fits(const godot_variant* given, char letter) {
  const int type = CALL(VARIANT_GET_TYPE, int (*)(const godot_variant*))(given);
  int64_t value;
  if (letter == 'b') return type == VARIANT_POOL_BYTE_ARRAY;
  if (type != VARIANT_INT && (type != VARIANT_BOOL || letter != 'h')) return 0;
  value = CALL(VARIANT_AS_INT, int64_t (*)(const godot_variant*))(given);
  return letter == 'i' || (letter == 'h' && value >= 0 && value <= UINT32_MAX) ||
         (letter == 'n' && value >= INT32_MIN && value <= INT32_MAX);
}
/* Whether the arguments have the types of the letters. The last may be s, a shape. Those after |
 * may be left out, all of them. */
static int all_fit(godot_array* arguments, const char* letters) {
  const int size = count(arguments);
  int i = 0;
  for (; *letters != 0; ++letters) {
    if (*letters == '|') {
      if (i == size) return 1;
      continue;
    }
    if (*letters == 's') {
      const int64_t kind = number(arguments, i);
      letters = kind == DETENT_SPHERE ? "hnnnn" : kind == DETENT_OBB ? "hnnnnnn" : "?";
    }
    if (i == size || !fits(argument(arguments, i++), *letters)) return 0;
  }
  return i == size;
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

/* Each procedure receives its arguments as `a`, once they have the types of the letters. */
#define PROCEDURE(name, letters, names)                                         \
  static godot_variant do_##name(godot_array* a);                               \
  EXPORT godot_variant detent_godot_##name(godot_array* a);                     \
  godot_variant detent_godot_##name(godot_array* a) {                           \
    called = #name;                                                             \
    if (all_fit(a, letters)) return do_##name(a);                               \
    print_error("wrong arguments: it takes [" names "]; numbers are integers"); \
    return integer(DETENT_BAD_ARGUMENT);                                        \
  }                                                                             \
  static godot_variant do_##name(godot_array* a)

/* Letters and names of several arguments, and what the C interface takes. */
#define XYZ "nnn"
#define AXES XYZ XYZ XYZ
#define JOINT "hii" XYZ XYZ AXES AXES "hnhnnnnnnnn"
#define SHAPE_NAMES "1, x, y, z, radius] or [... 3, x, y, z, half width, half height, half depth"
#define VECTOR(i) (&(const detent_vec3){length(a, i), length(a, (i) + 1), length(a, (i) + 2)})
#define NUMBERS(i) ((const int32_t[]){length(a, i), length(a, (i) + 1), length(a, (i) + 2)})

PROCEDURE(world, "", "") {
  detent_handle world = 0;
  const detent_status status = detent_world3_create(&context, NULL, &world);
  (void)a;
  return handle_or_failure(status, world);
}
PROCEDURE(scene, "", "") {
  detent_handle scene = 0;
  const detent_status status = detent_scene3_create(&context, &scene);
  (void)a;
  return handle_or_failure(status, scene);
}
PROCEDURE(destroy_world, "h", "world") {
  return answer(detent_world3_destroy(&context, handle(a, 0)));
}
/* A fixed box is an AABB. */
PROCEDURE(add_body, "hhs", "world, motion, " SHAPE_NAMES) {
  detent_body3_options options;
  detent_shape3 given = shape(a, 2);
  detent_id made = {0, 0};
  detent_status status;
  detent_body3_default_options(&options);
  options.motion = natural(a, 1);
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
  status = detent_world3_add(&context, handle(a, 0), &given, &options, &made);
  return id_or_failure(status, made);
}
PROCEDURE(remove_body, "hi", "world, body") {
  return answer(detent_world3_remove(&context, handle(a, 0), id(a, 1)));
}
#define IDS(name)                                                                  \
  PROCEDURE(name, "h", "world") {                                                  \
    uint32_t size = 0;                                                             \
    const detent_status status =                                                   \
        detent_world3_##name(&context, handle(a, 0), buffer.ids, ROOM_IDS, &size); \
    return ids_or_failure(status, size);                                           \
  }
IDS(body_ids)
/* 12 little-endian numbers of four bytes: the position and rotation; no bytes if it is missing. */
PROCEDURE(body, "hi", "world, body") {
  detent_body3 body;
  uint8_t to[48];
  int32_t words[12];
  int i;
  const detent_status status = detent_world3_body(&context, handle(a, 0), id(a, 1), &body);
  if (status != DETENT_OK) return status < 0 ? failure(status) : pool(NULL, 0);
  memcpy(words, &body.position, 12);
  memcpy(words + 3, &body.rotation, 36);
  for (i = 0; i < 48; ++i) to[i] = (uint8_t)((uint32_t)words[i / 4] >> 8 * (i % 4));
  return pool(to, 48);
}
/* [x, y, z], then the angular velocity. */
PROCEDURE(velocity, "hi", "world, body") {
  detent_body3 body;
  int32_t numbers[6];
  const detent_status status = detent_world3_body(&context, handle(a, 0), id(a, 1), &body);
  if (status == DETENT_OK) {
    memcpy(numbers, &body.velocity, 12);
    memcpy(numbers + 3, body.angular_velocity, 12);
  }
  return numbers_or_failure(status, numbers, 6);
}
PROCEDURE(is_asleep, "hi", "world, body") {
  detent_body_info info;
  const detent_status status = detent_world3_info(&context, handle(a, 0), id(a, 1), &info);
  return status == DETENT_OK ? integer(info.is_asleep) : failure(status);
}
/* [user word, layers, layers it collides with, motion, is a sensor] */
PROCEDURE(info, "hi", "world, body") {
  detent_body_info info;
  godot_array made;
  const detent_status status = detent_world3_info(&context, handle(a, 0), id(a, 1), &info);
  if (status != DETENT_OK) return failure(status);
  made = begin();
  append(&made, integer((int64_t)info.user));
  append(&made, integer(info.layers));
  append(&made, integer(info.collides_with));
  append(&made, integer(info.motion));
  append(&made, integer(info.is_sensor));
  return end(&made);
}

/* The setters of bodies: 1, or 0 if there is no such body. */
#define SETTER(name, letters, names, ...)                                                   \
  PROCEDURE(set_##name, "hi" letters, "world, body, " names) {                              \
    return answer(detent_world3_set_##name(&context, handle(a, 0), id(a, 1), __VA_ARGS__)); \
  }
SETTER(position, XYZ, "x, y, z", VECTOR(2))
SETTER(velocity, XYZ, "x, y, z", VECTOR(2))
SETTER(angular_velocity, XYZ, "x, y, z", NUMBERS(2))
SETTER(filter, "hh", "layers, collides_with", natural(a, 2), natural(a, 3))
SETTER(friction, "n", "friction", length(a, 2))
SETTER(restitution, "n", "restitution", length(a, 2))
SETTER(sensor, "h", "is_sensor", natural(a, 2))
SETTER(gravity_scale, "n", "scale", length(a, 2))
SETTER(damping, "nn", "linear, angular", length(a, 2), length(a, 3))
SETTER(locked, "h", "locks", natural(a, 2))
SETTER(fast, "h", "is_fast", natural(a, 2))
SETTER(user, "i", "user", (uint64_t)number(a, 2))

PROCEDURE(set_gravity, "h" XYZ, "world, x, y, z") {
  return answer(detent_world3_set_gravity(&context, handle(a, 0), VECTOR(1)));
}
/* At the center of mass, or at a point of the world. */
#define PUSH(name)                                                                        \
  PROCEDURE(apply_##name, "hi" XYZ "|" XYZ, "world, body, x, y, z] or [... at x, y, z") { \
    return answer(detent_world3_apply_##name(&context, handle(a, 0), id(a, 1), VECTOR(2), \
                                             count(a) > 5 ? VECTOR(5) : NULL));           \
  }
PUSH(impulse)
PUSH(force)
PROCEDURE(apply_torque, "hi" XYZ, "world, body, x, y, z") {
  return answer(detent_world3_apply_torque(&context, handle(a, 0), id(a, 1), NUMBERS(2)));
}

PROCEDURE(step, "h", "world") { return answer(detent_world3_step(&context, handle(a, 0))); }
/* The pairs that began or ceased to touch in the last step. */
PROCEDURE(touch_events, "h", "world") {
  uint32_t size = 0;
  const detent_status status =
      detent_world3_events(&context, handle(a, 0), buffer.touches, ROOM_TOUCHES, &size);
  return touches_or_failure(status, size);
}
/* The pairs that touch: those of one body, or all. */
PROCEDURE(touching, "h|i", "world] or [world, body") {
  uint32_t size = 0;
  const detent_status status =
      detent_world3_touching(&context, handle(a, 0), id(a, 1), buffer.touches, ROOM_TOUCHES, &size);
  return touches_or_failure(status, size);
}

/* A joint as numbers, with anchors and frames from points and axes of the world. */
PROCEDURE(joint_at, "hhii" XYZ XYZ AXES,
          "world, kind, a, b, point of a x, y, z, point of b x, y, z, axes: 9 numbers") {
  const detent_handle world = handle(a, 0);
  const detent_rotation3 axes = rotation(a, 10);
  detent_joint3 made;
  detent_status status = detent_joint3_defaults(natural(a, 1), &made);
  if (status == DETENT_OK) {
    made.a = id(a, 2);
    made.b = id(a, 3);
    status = detent_world3_local_point(&context, world, made.a, VECTOR(4), &made.anchor_a);
  }
  if (status == DETENT_OK) {
    status = detent_world3_local_point(&context, world, made.b, VECTOR(7), &made.anchor_b);
  }
  if (status == DETENT_OK) {
    status = detent_world3_local_frame(&context, world, made.a, &axes, &made.frame_a);
  }
  if (status == DETENT_OK) {
    status = detent_world3_local_frame(&context, world, made.b, &axes, &made.frame_b);
  }
  return joint_or_failure(status, &made);
}
PROCEDURE(add_joint, "h" JOINT, "world, joint: 38 numbers") {
  const detent_joint3 given = joint(a, 1);
  detent_id made = {0, 0};
  const detent_status status = detent_world3_add_joint(&context, handle(a, 0), &given, &made);
  return id_or_failure(status, made);
}
PROCEDURE(change_joint, "hi" JOINT, "world, id, joint: 38 numbers") {
  const detent_joint3 given = joint(a, 2);
  return answer(detent_world3_change_joint(&context, handle(a, 0), id(a, 1), &given));
}
PROCEDURE(remove_joint, "hi", "world, joint") {
  return answer(detent_world3_remove_joint(&context, handle(a, 0), id(a, 1)));
}
PROCEDURE(joint, "hi", "world, joint") {
  detent_joint3 found;
  const detent_status status = detent_world3_joint(&context, handle(a, 0), id(a, 1), &found);
  return joint_or_failure(status, &found);
}
IDS(joint_ids)
/* The joints that broke in the last step. */
IDS(broken)
PROCEDURE(joint_force, "hi", "world, joint") {
  detent_vec3 force;
  const detent_status status = detent_world3_joint_force(&context, handle(a, 0), id(a, 1), &force);
  const int32_t numbers[] = {force.x, force.y, force.z};
  return numbers_or_failure(status, numbers, 3);
}
PROCEDURE(joint_torque, "hi", "world, joint") {
  int32_t torque[3];
  const detent_status status =
      detent_world3_joint_torque(&context, handle(a, 0), id(a, 1), torque);
  return numbers_or_failure(status, torque, 3);
}

PROCEDURE(world_digest, "h", "world") {
  uint64_t digest = 0;
  const detent_status status = detent_world3_digest(&context, handle(a, 0), &digest);
  return status == DETENT_OK ? integer((int64_t)digest) : failure(status);
}
PROCEDURE(world_snapshot, "h", "world") {
  uint32_t size = 0;
  const detent_status status =
      detent_world3_snapshot(&context, handle(a, 0), buffer.bytes, ROOM_BYTES, &size);
  return pool(buffer.bytes, status == DETENT_OK ? size : 0);
}
PROCEDURE(world_restore, "hb", "world, bytes") {
  const uint32_t size = bytes(a, 1, buffer.bytes, ROOM_BYTES);
  return integer(detent_world3_restore(&context, handle(a, 0), buffer.bytes, size));
}
/* A word of a session's world. */
PROCEDURE(word, "hi", "world, index") {
  uint32_t words[DETENT_WORDS] = {0};
  detent_world3_words(&context, handle(a, 0), words);
  return integer(words[(uint64_t)number(a, 1) % DETENT_WORDS]);
}
PROCEDURE(set_word, "hii", "world, index, word") {
  uint32_t words[DETENT_WORDS] = {0};
  detent_world3_words(&context, handle(a, 0), words);
  words[(uint64_t)number(a, 1) % DETENT_WORDS] = natural(a, 2);
  return answer(detent_world3_set_words(&context, handle(a, 0), words));
}

PROCEDURE(add_object, "his", "scene, user, " SHAPE_NAMES) {
  detent_traits traits = {0, 1, DETENT_MOVING, {0, 0}};
  const detent_shape3 given = shape(a, 2);
  detent_id made = {0, 0};
  traits.user = (uint64_t)number(a, 1);
  return id_or_failure(detent_scene3_add(&context, handle(a, 0), &given, &traits, &made), made);
}
PROCEDURE(replace_object, "his", "scene, object, " SHAPE_NAMES) {
  const detent_shape3 given = shape(a, 2);
  return answer(detent_scene3_replace(&context, handle(a, 0), id(a, 1), &given));
}
/* The direction is in steps of 2^-30. The id, the distance and the normal in 24 bytes, or no bytes
 * for a miss. */
PROCEDURE(raycast, "h" XYZ XYZ "n",
          "scene, origin x, y, z, direction x, y, z, max_distance") {
  detent_ray3 ray;
  detent_object_hit3 hit;
  uint32_t words[6];
  uint8_t to[24];
  int i;
  detent_status status;
  ray.origin = vector(a, 1);
  ray.direction.x = length(a, 4);
  ray.direction.y = length(a, 5);
  ray.direction.z = length(a, 6);
  ray.max_distance = length(a, 7);
  status = detent_scene3_raycast(&context, handle(a, 0), &ray, 0xffffffffu, &hit);
  if (status != DETENT_OK) return status < 0 ? failure(status) : pool(NULL, 0);
  words[0] = hit.id.index;
  words[1] = hit.id.generation;
  words[2] = (uint32_t)hit.distance;
  words[3] = (uint32_t)hit.normal.x;
  words[4] = (uint32_t)hit.normal.y;
  words[5] = (uint32_t)hit.normal.z;
  for (i = 0; i < 24; ++i) to[i] = (uint8_t)(words[i / 4] >> 8 * (i % 4));
  return pool(to, 24);
}
PROCEDURE(scene_digest, "h", "scene") {
  uint64_t digest = 0;
  const detent_status status = detent_scene3_digest(&context, handle(a, 0), &digest);
  return status == DETENT_OK ? integer((int64_t)digest) : failure(status);
}

PROCEDURE(session, "hihhhh", "world, match, self, players, bytes per input, words") {
  detent_session_settings settings;
  detent_handle session = 0;
  detent_status status = detent_session_default_settings(&settings);
  settings.match = (uint64_t)number(a, 1);
  settings.self = natural(a, 2);
  settings.players = natural(a, 3);
  settings.input_size = natural(a, 4);
  settings.words = natural(a, 5);
  status = detent_session3_create(&context, &settings, handle(a, 0), &session);
  return handle_or_failure(status, session);
}
PROCEDURE(session_world, "h", "session") {
  detent_handle world = 0;
  const detent_status status = detent_session3_world(&context, handle(a, 0), &world);
  return handle_or_failure(status, world);
}
/* The concatenated inputs of all players, or nothing. */
PROCEDURE(begin_frame, "h|b", "session, bytes of this player's input") {
  uint8_t pad[DETENT_INPUT] = {0}, inputs[DETENT_PLAYERS * DETENT_INPUT];
  detent_frame frame;
  const uint32_t size = bytes(a, 1, pad, sizeof pad);
  const detent_status status =
      detent_session3_begin_frame(&context, handle(a, 0), pad, &frame, inputs);
  return pool(inputs, status == DETENT_OK ? frame.players * size : 0);
}
PROCEDURE(end_frame, "h", "session") {
  return answer(detent_session3_end_frame(&context, handle(a, 0)));
}
PROCEDURE(receive, "hhbi", "session, peer, bytes of a packet, microseconds") {
  uint8_t packet[DETENT_PACKET];
  const uint32_t size = bytes(a, 2, packet, sizeof packet);
  return integer(detent_session3_receive(&context, handle(a, 0), natural(a, 1), packet, size,
                                         (uint64_t)number(a, 3)));
}
/* One byte with the peer, then its next packet; or nothing. */
PROCEDURE(packet, "hi", "session, microseconds") {
  uint8_t packet[1 + DETENT_PACKET];
  uint32_t peer = 0, size = 0;
  const detent_status status = detent_session3_packet(
      &context, handle(a, 0), (uint64_t)number(a, 1), &peer, packet + 1, DETENT_PACKET, &size);
  packet[0] = (uint8_t)peer;
  return pool(packet, status == DETENT_OK ? size + 1 : 0);
}
/* Kind, peer and frame (four bytes) of the next event, or nothing. */
PROCEDURE(event, "h", "session") {
  detent_session_event event;
  uint8_t to[6];
  int i;
  if (detent_session3_event(&context, handle(a, 0), &event, NULL, 0) != DETENT_OK) {
    return pool(NULL, 0);
  }
  to[0] = (uint8_t)event.kind;
  to[1] = (uint8_t)event.peer;
  for (i = 0; i < 4; ++i) to[2 + i] = (uint8_t)(event.frame >> 8 * i);
  return pool(to, 6);
}
/* 0: its frame, 1: its final frame, 2: the number of resimulated frames. */
PROCEDURE(session_status, "hi", "session, which") {
  detent_session_status status;
  const detent_status answered = detent_session3_status(&context, handle(a, 0), &status);
  if (answered != DETENT_OK) return failure(answered);
  switch (number(a, 1)) {
    case 0:
      return integer(status.frame);
    case 1:
      return integer(status.final_frame);
    default:
      return integer((int64_t)status.resimulated);
  }
}
