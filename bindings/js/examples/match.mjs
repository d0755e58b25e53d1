// SPDX-License-Identifier: MIT
//
// The scripted match of every binding: boxes fall on a floor, a scene has a ball around each, rays look
// down at them. Prints 16 digits that follow from every answer: those of tests/c/match.cpp.

import { pathToFileURL } from 'node:url';
import { FIXED, ONE, UNIT, load } from '../index.mjs';

const bodies = 12, ticks = 120, rays = 8;

export async function play(source) {
  const detent = await load(3, source);
  const { space } = detent;
  const context = detent.open();
  const world = context.world(), scene = context.scene();

  let state = 1, sum = 0n;
  const draw = (count) => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return (state >>> 8) % count;
  };
  const mix = (value) => {
    sum = BigInt.asUintN(64, sum * 6364136223846793005n + BigInt(value));
  };

  world.add(space.aabb([-20 * ONE, -ONE, -20 * ONE], [20 * ONE, 0, 20 * ONE]), { motion: FIXED });
  const boxes = [], balls = [];
  for (let i = 0; i < bodies; ++i) {
    const center = [draw(4 * ONE) - 2 * ONE, (2 + 2 * i) * ONE, draw(4 * ONE) - 2 * ONE];
    const half = [0, 1, 2].map(() => ONE / 2 + draw(ONE / 2));
    boxes.push(world.add(space.obb(center, half)));
    balls.push(scene.add(space.sphere(center, ONE), { user: i }));
  }

  let saved;
  for (let tick = 0; tick < ticks; ++tick) {
    if (tick % 10 === 5) world.setVelocity(boxes[(tick - 5) / 10], [ONE, 5 * ONE, 0]);
    world.step();
    boxes.forEach((box, i) => scene.replace(balls[i], space.sphere(world.body(box).position, ONE)));
    for (let i = 0; i < rays; ++i) {
      const origin = [draw(8 * ONE) - 4 * ONE, 30 * ONE, draw(8 * ONE) - 4 * ONE];
      const hit = scene.raycast(space.ray(origin, [0, -UNIT, 0], 40 * ONE), 1);
      if (hit) {
        mix(hit.distance >>> 0);
        mix(hit.id.index);
        mix(hit.normal[1] >>> 0);
      } else {
        mix(0xffffffff);
      }
    }
    mix(world.digest());
    mix(scene.digest());
    if (tick === ticks / 2) {
      saved = world.snapshot();
      mix(saved.length);
    }
  }

  world.restore(saved);
  for (let i = 0; i < 10; ++i) world.step();
  mix(world.digest());
  context.close();
  return sum.toString(16).padStart(16, '0');
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) console.log(await play());
