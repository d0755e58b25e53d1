// SPDX-License-Identifier: MIT
//
// The scripted match that every binding plays: boxes fall on a floor, a scene holds a ball around
// each, and rays are cast down at them. Prints a digest of all results, 16 digits equal to those of
// tests/c/match.cpp.

import { FIXED, ONE, UNIT, events, load } from '../index.mjs';

const bodies = 12, ticks = 120, rays = 8;

// A player's input; it takes effect two frames later.
const press = (frame, player) => Uint8Array.from(frame < 80
  ? [Math.floor(frame / (7 + 4 * player)) % 5, Math.floor(frame / 3) % 4] : [0, 0]);

function simulate(world, balls, inputs) {
  const { words } = world;
  inputs.forEach(([speed, which], player) => {
    words[player] += speed;
    if (speed === 0) return;
    world.setVelocity(balls[2 * player + (which % 2)], [(speed - 2) * ONE, which * ONE, 0]);
  });
  world.words = words;
  world.step();
}

// A two-player match between two sessions in one program. Packets are delayed; every fifth is lost.
function playForTwo(context, space, mix) {
  const frames = 120;
  const require = (isSo) => {
    if (!isSo) throw new Error('the match for two is not as it should be');
  };
  const start = context.world();
  start.add(space.aabb([-20 * ONE, -ONE, -20 * ONE], [20 * ONE, 0, 20 * ONE]), { motion: FIXED });
  const balls = [0, 1, 2, 3].map((i) =>
    start.add(space.sphere([(2 * i - 3) * ONE, 2 * ONE, 0], ONE / 2)));
  const sessions = [0, 1].map((self) => context.session(start,
    { match: 4711, self, input_size: 2, words: 2, replay_every: 10 * (1 - self) }));
  const wire = [];
  let sent = 0;
  for (let now = 0; sessions.some((session) => session.status.frame < frames); now += 16667) {
    while (wire.length > 8) {
      const { peer, bytes } = wire.shift();
      sessions[peer].receive(1 - peer, bytes, now);
    }
    sessions.forEach((session, player) => {
      const { frame } = session.status;
      if (frame < frames) {
        for (const { inputs } of session.frames(press(frame, player))) {
          simulate(session.world, balls, inputs);
        }
      }
      wire.push(...session.packets(now).filter(() => ++sent % 5 !== 0));
    });
  }
  for (const session of sessions) {
    require(session.event().kind === events.connected && session.event() === null);
    require(session.status.resimulated > 0n);
  }
  mix(sessions[0].world.digest());
  require(sessions[0].world.diff(sessions[1].world).length === 0);
  sessions[1].world.words.forEach(mix);

  const replay = context.replay(sessions[0].replay(), start, { input_size: 2, words: 2 });
  for (const { inputs } of replay.frames()) simulate(replay.world, balls, inputs);
  const { is_equal, frames: checked } = replay.check();
  require(is_equal === 1 && checked > 100 && checked === sessions[0].status.final_frame);
}

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
  playForTwo(context, space, mix);
  context.close();
  return sum.toString(16).padStart(16, '0');
}

if (typeof process !== 'undefined') {  // in node, not in a browser
  const { pathToFileURL } = await import('node:url');
  if (import.meta.url === pathToFileURL(process.argv[1]).href) console.log(await play());
}
