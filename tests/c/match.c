/* SPDX-License-Identifier: MIT */
/* The scripted match that every binding plays, in C99: boxes fall on a floor, a scene holds a ball
 * around each, and rays are cast down at them. Prints a digest of all results, 16 digits. */
#include <detent.h>
#include <inttypes.h>
#include <stdio.h>

enum { ONE = 65536, BODIES = 12, TICKS = 120, RAYS = 8 };

static uint32_t state = 1;
static int32_t draw(int32_t count) {
  state = state * 1664525u + 1013904223u;
  return (int32_t)((state >> 8) % (uint32_t)count);
}

static uint64_t sum;
static void mix(uint64_t value) { sum = sum * 6364136223846793005u + value; }

/* Stops at the first failed call. */
#define TRY(call) \
  if ((call) != DETENT_OK) return fprintf(stderr, "match.c:%d: it fails\n", __LINE__), 1

/* A two-player match between two sessions in one program. Packets are delayed; every fifth is lost.
 * */
enum { FRAMES = 120, PADS = 2, LATE = 8 };

typedef struct {
  uint32_t to, size;
  uint8_t bytes[DETENT_PACKET];
} packet;
static packet wire[4096];

static void press(uint8_t* pad, uint32_t frame, uint32_t player) {
  pad[0] = (uint8_t)(frame < 80 ? frame / (7 + 4 * player) % 5 : 0);
  pad[1] = (uint8_t)(frame < 80 ? frame / 3 % 4 : 0);
}

static int simulate(detent_context* context, detent_handle world, const detent_id* balls,
                    const detent_frame* frame, const uint8_t* inputs) {
  uint32_t words[2], player;
  TRY(detent_world3_words(context, world, words));
  for (player = 0; player < frame->players; ++player) {
    const uint8_t* pad = inputs + PADS * player;
    detent_vec3 velocity = {0};
    words[player] += pad[0];
    if (pad[0] == 0) continue;
    velocity.x = (pad[0] - 2) * ONE;
    velocity.y = pad[1] * ONE;
    TRY(detent_world3_set_velocity(context, world, balls[2 * player + pad[1] % 2], &velocity));
  }
  TRY(detent_world3_set_words(context, world, words));
  TRY(detent_world3_step(context, world));
  return 0;
}

static int play_for_two(detent_context* context) {
  static uint8_t saved[65536];
  detent_session_settings settings;
  detent_body3_options options;
  detent_shape3 shape = {0};
  detent_handle start, sessions[2], worlds[2], replay, world;
  detent_id floor, balls[4];
  detent_frame frame;
  detent_replay_check check;
  detent_session_status status[2];
  uint8_t inputs[2 * PADS], pad[PADS];
  uint32_t sent = 0, first = 0, end = 0, player, tick, size, words[2];
  uint64_t digest;
  int i;

  TRY(detent_world3_create(context, NULL, &start));
  TRY(detent_body3_default_options(&options));
  options.motion = DETENT_FIXED_BODY;
  shape.kind = DETENT_AABB;
  shape.as.aabb.min.x = shape.as.aabb.min.z = -20 * ONE;
  shape.as.aabb.min.y = -ONE;
  shape.as.aabb.max.x = shape.as.aabb.max.z = 20 * ONE;
  shape.as.aabb.max.y = 0;
  TRY(detent_world3_add(context, start, &shape, &options, &floor));
  for (i = 0; i < 4; ++i) {
    detent_shape3 ball = {0};
    ball.kind = DETENT_SPHERE;
    ball.as.sphere.center.x = (2 * i - 3) * ONE;
    ball.as.sphere.center.y = 2 * ONE;
    ball.as.sphere.radius = ONE / 2;
    TRY(detent_world3_add(context, start, &ball, NULL, &balls[i]));
  }

  TRY(detent_session_default_settings(&settings));
  settings.match = 4711;
  settings.input_size = PADS;
  settings.words = 2;
  for (player = 0; player < 2; ++player) {
    settings.self = player;
    settings.replay_every = 10 * (1 - player);
    TRY(detent_session3_create(context, &settings, start, &sessions[player]));
    TRY(detent_session3_world(context, sessions[player], &worlds[player]));
    TRY(detent_session3_status(context, sessions[player], &status[player]));
  }
  for (tick = 0; status[0].frame < FRAMES || status[1].frame < FRAMES; ++tick) {
    const uint64_t now = (uint64_t)tick * 16667;
    for (; end - first > LATE; ++first) {
      const packet* p = &wire[first];
      TRY(detent_session3_receive(context, sessions[p->to], 1 - p->to, p->bytes, p->size, now));
    }
    for (player = 0; player < 2; ++player) {
      const detent_handle session = sessions[player];
      uint32_t to;
      press(pad, status[player].frame, player);
      while (status[player].frame < FRAMES &&
             detent_session3_begin_frame(context, session, pad, &frame, inputs) == DETENT_OK) {
        if (simulate(context, worlds[player], balls, &frame, inputs)) return 1;
        TRY(detent_session3_end_frame(context, session));
      }
      TRY(detent_session3_status(context, session, &status[player]));
      while (end < 4096 && detent_session3_packet(context, session, now, &to, wire[end].bytes,
                                                  DETENT_PACKET, &wire[end].size) == DETENT_OK) {
        wire[end].to = to;
        if (++sent % 5 != 0) ++end;
      }
    }
  }
  for (player = 0; player < 2; ++player) {
    detent_session_event event;
    while (detent_session3_event(context, sessions[player], &event, NULL, 0) == DETENT_OK) {
      TRY(event.kind == DETENT_CONNECTED);
    }
    TRY(status[player].resimulated > 0);
  }
  TRY(detent_world3_digest(context, worlds[0], &digest));
  mix(digest);
  TRY(detent_world3_digest(context, worlds[1], &digest));
  TRY(detent_world3_diff(context, worlds[0], worlds[1], 1, NULL, 0, &size) == DETENT_NO);
  TRY(detent_world3_words(context, worlds[1], words));
  mix(words[0]);
  mix(words[1]);

  TRY(detent_session3_replay(context, sessions[0], saved, sizeof saved, &size));
  TRY(detent_replay3_create(context, saved, size, start, PADS, 2, &replay));
  TRY(detent_replay3_world(context, replay, &world));
  while (detent_replay3_begin_frame(context, replay, &frame, inputs) == DETENT_OK) {
    if (simulate(context, world, balls, &frame, inputs)) return 1;
    TRY(detent_replay3_end_frame(context, replay));
  }
  TRY(detent_replay3_check(context, replay, &check));
  TRY(check.state == DETENT_REPLAY_WHOLE && check.is_equal);
  TRY(check.frames == status[0].final_frame && check.frames > 100);
  TRY(detent_replay3_destroy(context, replay));
  TRY(detent_session3_destroy(context, sessions[0]));
  TRY(detent_session3_destroy(context, sessions[1]));
  return 0;
}

int main(void) {
  detent_context context = {{0}};
  detent_handle world, scene;
  detent_body3_options options;
  detent_shape3 shape = {0};
  detent_id floor, bodies[BODIES], balls[BODIES];
  static uint8_t saved[65536];
  uint32_t saved_size = 0;
  uint64_t digest;
  int i, k, tick;

  TRY(detent_open(&context, NULL));
  TRY(detent_world3_create(&context, NULL, &world));
  TRY(detent_scene3_create(&context, &scene));
  TRY(detent_body3_default_options(&options));

  shape.kind = DETENT_AABB;
  shape.as.aabb.min.x = shape.as.aabb.min.z = -20 * ONE;
  shape.as.aabb.min.y = -ONE;
  shape.as.aabb.max.x = shape.as.aabb.max.z = 20 * ONE;
  shape.as.aabb.max.y = 0;
  options.motion = DETENT_FIXED_BODY;
  TRY(detent_world3_add(&context, world, &shape, &options, &floor));

  for (i = 0; i < BODIES; ++i) {
    detent_shape3 box = {0};
    detent_shape3 ball = {0};
    detent_traits traits = {0, 1, DETENT_MOVING, {0, 0}};
    box.kind = DETENT_OBB;
    box.as.obb.center.x = draw(4 * ONE) - 2 * ONE;
    box.as.obb.center.y = (2 + 2 * i) * ONE;
    box.as.obb.center.z = draw(4 * ONE) - 2 * ONE;
    box.as.obb.half_extents.x = ONE / 2 + draw(ONE / 2);
    box.as.obb.half_extents.y = ONE / 2 + draw(ONE / 2);
    box.as.obb.half_extents.z = ONE / 2 + draw(ONE / 2);
    for (k = 0; k < 3; ++k) (&box.as.obb.rotation.axis[k].x)[k] = 1 << 30;
    TRY(detent_world3_add(&context, world, &box, NULL, &bodies[i]));
    ball.kind = DETENT_SPHERE;
    ball.as.sphere.center = box.as.obb.center;
    ball.as.sphere.radius = ONE;
    traits.user = (uint64_t)i;
    TRY(detent_scene3_add(&context, scene, &ball, &traits, &balls[i]));
  }

  for (tick = 0; tick < TICKS; ++tick) {
    if (tick % 10 == 5) {
      const detent_vec3 up = {ONE, 5 * ONE, 0};
      TRY(detent_world3_set_velocity(&context, world, bodies[tick / 10], &up));
    }
    TRY(detent_world3_step(&context, world));
    for (i = 0; i < BODIES; ++i) {
      detent_body3 body;
      detent_shape3 ball = {0};
      TRY(detent_world3_body(&context, world, bodies[i], &body));
      ball.kind = DETENT_SPHERE;
      ball.as.sphere.center = body.position;
      ball.as.sphere.radius = ONE;
      TRY(detent_scene3_replace(&context, scene, balls[i], &ball));
    }
    for (i = 0; i < RAYS; ++i) {
      detent_ray3 ray = {{0, 30 * ONE, 0}, {0, -(1 << 30), 0}, 40 * ONE};
      detent_object_hit3 hit;
      ray.origin.x = draw(8 * ONE) - 4 * ONE;
      ray.origin.z = draw(8 * ONE) - 4 * ONE;
      if (detent_scene3_raycast(&context, scene, &ray, 1, &hit) == DETENT_OK) {
        mix((uint32_t)hit.distance);
        mix(hit.id.index);
        mix((uint32_t)hit.normal.y);
      } else {
        mix(UINT32_MAX);
      }
    }
    TRY(detent_world3_digest(&context, world, &digest));
    mix(digest);
    TRY(detent_scene3_digest(&context, scene, &digest));
    mix(digest);
    if (tick == TICKS / 2) {
      TRY(detent_world3_snapshot(&context, world, saved, sizeof saved, &saved_size));
      mix(saved_size);
    }
  }

  TRY(detent_world3_restore(&context, world, saved, saved_size));
  for (tick = 0; tick < 10; ++tick) TRY(detent_world3_step(&context, world));
  TRY(detent_world3_digest(&context, world, &digest));
  mix(digest);
  if (play_for_two(&context)) return 1;
  TRY(detent_close(&context));
  printf("%016" PRIx64 "\n", sum);
  return 0;
}
