/* SPDX-License-Identifier: MIT */
/* The scripted match of every binding, in C99: boxes fall on a floor, a scene has a ball around each,
 * rays look down at them. Prints 16 digits that follow from every answer. */
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

/* Stops at the first call that fails. */
#define TRY(call) \
  if ((call) != DETENT_OK) return fprintf(stderr, "match.c:%d: it fails\n", __LINE__), 1

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
  TRY(detent_close(&context));
  printf("%016" PRIx64 "\n", sum);
  return 0;
}
