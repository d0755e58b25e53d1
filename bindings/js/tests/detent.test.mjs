// SPDX-License-Identifier: MIT
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { gunzipSync } from 'node:zlib';

import * as detent from '../index.mjs';
import { play } from '../examples/match.mjs';

const { ONE, UNIT, status } = detent;
const folder = pathToFileURL(`${process.env.DETENT_WASM ?? `${import.meta.dirname}/..`}/`);
const file = (dimension, name = 'detent') => new URL(`${name}${dimension}.wasm.gz`, folder);

test('the match ends as in C++', async () => {
  assert.equal(await play(file(3)), process.env.DETENT_MATCH);
});

test('single queries', async () => {
  const { space } = await detent.load(3, file(3));
  const ball = space.sphere([10 * ONE, 0, 0], ONE);
  const hit = space.raycast(space.ray([0, 0, 0], [UNIT, 0, 0]), ball);
  assert.deepEqual(hit, { distance: 9 * ONE, point: [9 * ONE, 0, 0], normal: [-UNIT, 0, 0] });
  assert.equal(space.raycast(space.ray([0, 0, 0], [-UNIT, 0, 0]), ball), null);
  assert.equal(space.contains(ball, [11 * ONE, 0, 0]), true);
  assert.equal(space.contains(ball, [11 * ONE + 1, 0, 0]), false);
  assert.deepEqual(space.closestPoint(ball, [0, 0, 0]), [9 * ONE, 0, 0]);
  const box = space.aabb([0, 0, 0], [ONE, ONE, ONE]);
  assert.equal(space.distance(ball, [0, 0, 0]), 9 * ONE);
  assert.equal(space.distance(ball, box), 8 * ONE);
  assert.equal(space.overlaps(ball, box), false);
  const rays = new Int32Array([0, 0, 0, UNIT, 0, 0, 99 * ONE, 0, 0, 0, 0, UNIT, 0, 99 * ONE]);
  assert.deepEqual([...space.raycastMany(rays, ball)], [9 * ONE, -1]);
});

test('scenes in 2D', async () => {
  const library = await detent.load(2, file(2));
  const { space } = library, context = library.open(), scene = context.scene();
  const ids = [0, 1, 2, 3].map((i) => scene.add(space.sphere([i * ONE, 0], ONE), { layers: 1 << i }));
  const ray = space.ray([-5 * ONE, 0], [UNIT, 0]);
  assert.deepEqual(scene.raycastAll(ray).map((hit) => hit.id), ids);
  assert.deepEqual(scene.raycast(ray, 6).id, ids[1]);
  assert.deepEqual(scene.nearest(space.point([9 * ONE, 0])).id, ids[3]);
  assert.equal(scene.overlaps().length, 5);
  assert.equal(scene.move(ids[3], [5 * ONE, 0]), true);
  assert.equal(scene.overlaps().length, 3);
  const saved = scene.snapshot(), digest = scene.digest();
  assert.equal(scene.remove(ids[0]), true);
  assert.equal(scene.remove(ids[0]), false);
  scene.restore(saved);
  assert.deepEqual([scene.size, scene.digest()], [4, digest]);
  context.close();
});

test('lists longer than the first buffer', async () => {
  const library = await detent.load(3, file(3));
  const { space } = library, scene = library.open().scene();
  for (let i = 0; i < 100; ++i) scene.add(space.sphere([i, 0, 0], ONE));
  assert.equal(scene.all(space.point([0, 0, 0])).length, 100);
});

test('assets', async () => {
  const library = await detent.load(3, file(3));
  const { space } = library, context = library.open(), scene = context.scene();
  const corners = [[0, 0, 0], [ONE, 0, 0], [0, ONE, 0], [0, 0, ONE]];
  const mesh = context.mesh(1, corners, [[0, 1, 2], [0, 2, 3]]);
  const hull = context.hull(1, corners);
  const field = context.heightField(1, [0, 0], ONE, 2, 2, [0, 0, 0, 0]);
  [mesh, hull, field].forEach((asset, x) => scene.add(space.placed(asset, [10 * x * ONE, 0, 0])));
  assert.equal(scene.nearest(space.point([11 * ONE, 0, 0])).id.index, 1);
  const hit = scene.raycast(space.ray([20 * ONE + ONE / 4, ONE, ONE / 4], [0, -UNIT, 0]));
  assert.deepEqual([hit.id.index, hit.has_triangle, hit.triangle], [2, 1, 0]);
  assert.equal(scene.object({ index: 0, generation: 1 }).shape.placed.scale, ONE);
  assert.throws(() => mesh.destroy(), { status: status.IN_USE });
});

test('scenes that follow worlds', async () => {
  const library = await detent.load(3, file(3));
  const { space } = library, context = library.open();
  const world = context.world({ gravity: [0, 0, 0] }), scene = context.scene();
  const gate = world.add(space.obb([0, 0, 0], [3 * ONE, ONE / 64, 3 * ONE]), { motion: detent.FIXED, is_sensor: 1 });
  const ball = world.add(space.sphere([0, 4 * ONE, 0], ONE / 16),
    { is_fast: 1, velocity: [0, -500 * ONE, 0], user: 7n });
  const parts = [0, 5].map((x) => ({ shape: space.sphere([x * ONE, 0, 0], ONE) }));
  const pair = world.add(space.placed(context.compound(1, parts), [20 * ONE, 0, 0]));
  const down = space.ray([0, 9 * ONE, 0], [0, -UNIT, 0], 20 * ONE);
  scene.follow(world);
  assert.deepEqual([scene.raycast(down).id, scene.size], [ball, 3]);
  scene.follow(world, { sensors: true });
  assert.deepEqual(scene.raycastAll(down)[1].id, gate);
  const part = scene.raycast(space.ray([30 * ONE, 0, 0], [-UNIT, 0, 0], 20 * ONE));
  assert.deepEqual(world.partOf(part.id), { body: pair, part: 1 });
  assert.equal(world.partOf({ index: 99, generation: 1 }), null);
  world.step(); // the ball passes the gate
  assert.deepEqual(world.events().map((event) => [event.a, event.b, event.begins]), [[gate, ball, 1], [gate, ball, 0]]);
  assert.deepEqual(world.bodyIds(), [gate, ball, pair]);
  assert.deepEqual([world.info(ball).user, world.info(pair).part_count, world.info(gate).is_sensor], [7n, 2, 1]);
  assert.equal(world.info({ index: 99, generation: 1 }), null);
  const joint = world.addJoint(detent.joints.distance, ball, pair, { upper: 99 * ONE });
  assert.equal(world.setVelocity(ball, [0, 0, 0]), true);
  assert.equal(world.setPosition(ball, [0, 0, 0]), true);
  assert.equal(world.setRotation(pair, [[0, UNIT, 0], [-UNIT, 0, 0], [0, 0, UNIT]]), true);
  assert.deepEqual([world.body(ball).position, world.jointIds()], [[0, 0, 0], [joint]]);
  assert.deepEqual(world.frame(pair).rotation.axis[0], [0, UNIT, 0]);
  world.step();
  assert.deepEqual(world.touching().map((touch) => [touch.a, touch.b]), [[gate, ball]]);
  assert.deepEqual([world.touching(ball).length, world.touching(pair).length], [1, 0]);
  context.close();
});

test('contacts and setters of bodies', async () => {
  const library = await detent.load(3, file(3));
  const { space } = library, context = library.open(), world = context.world();
  const floor = world.add(space.aabb([-5 * ONE, -ONE, -5 * ONE], [5 * ONE, 0, 5 * ONE]), { motion: detent.FIXED });
  const box = world.add(space.aabb([-ONE, 0, -ONE], [ONE, 2 * ONE, ONE]));
  for (let tick = 0; tick < 30; ++tick) world.step();
  const [contact] = world.contacts();
  assert.deepEqual(world.contacts(box), [contact]);
  assert.deepEqual([contact.a, contact.b, contact.normal, contact.points.length], [floor, box, [0, UNIT, 0], 4]);
  assert.ok(Math.abs(detent.number(contact.impulse) - 8 * 10 / 240) < 0.01);  // its weight in a substep
  assert.equal(world.setFriction(box, ONE / 4), true);
  assert.equal(world.setRestitution(box, ONE / 2), true);
  assert.equal(world.setSensor(box, true), true);
  assert.equal(world.setFilter(box, 2, 4), true);
  assert.equal(world.setGravityScale(box, -ONE), true);
  assert.equal(world.setDamping(box, 0, ONE), true);
  assert.equal(world.setLocked(box, detent.status.LOCK_X), true);
  assert.equal(world.setFast(box, true), true);
  assert.equal(world.setUser(box, 2n ** 64n - 2n), true);
  const { layers, collides_with, is_sensor, user } = world.info(box);
  assert.deepEqual([layers, collides_with, is_sensor, user], [2, 4, 1, 2n ** 64n - 2n]);
  world.setVelocity(box, [ONE, 0, 0]);
  world.step();
  assert.deepEqual([world.contacts(), world.events().length], [[], 1]);
  const [along, up] = world.body(box).velocity;
  assert.equal(along, 0);  // locked
  assert.ok(Math.abs(up - 10 * ONE / 60) < 20);  // it rises, undamped
  world.setGravity([0, 10 * ONE, 0]);
  world.step();
  assert.ok(Math.abs(world.body(box).velocity[1]) < 40);  // that pulled it back
  assert.equal(world.setFilter({ index: 9, generation: 9 }, 1, 1), false);
  assert.throws(() => world.setFriction(box, -1), detent.DetentError);
  assert.throws(() => world.setDamping(box, 0, -1), detent.DetentError);
  context.close();
});

test('worlds in 2D', async () => {
  const library = await detent.load(2, file(2));
  const { space } = library, world = library.open().world({ gravity: [0, -20 * ONE] });
  world.add(space.aabb([-5 * ONE, -ONE], [5 * ONE, 0]), { motion: detent.FIXED });
  const ball = world.add(space.sphere([0, 2 * ONE], ONE), { restitution: ONE / 2 });
  let began = 0;
  for (let i = 0; i < 240; ++i) {
    world.step();
    began += world.events().filter((event) => event.begins).length;
  }
  assert.ok(began > 1);  // it bounces
  assert.ok(Math.abs(detent.number(world.body(ball).position[1]) - 1) < 0.05);
  assert.equal(world.setVelocity(ball, [0, ONE]), true);
  assert.equal(world.body(ball).velocity[1], ONE);
  const ghost = world.add(space.sphere([20 * ONE, 0], ONE), { gravity_scale: 0 });
  assert.equal(world.applyImpulse(ghost, [ONE, 0], [20 * ONE, ONE]), true);
  const spin = world.body(ghost).angular_velocity[0];
  assert.ok(spin < 0);
  assert.equal(world.applyTorque(ghost, [ONE]), true);
  assert.equal(world.applyForce(ghost, [0, 60 * ONE]), true);
  world.step();
  assert.ok(world.body(ghost).angular_velocity[0] > spin);
  assert.ok(world.body(ghost).velocity[1] > 0);
});

test('pairs', async () => {
  const { space } = await detent.load(3, file(3)), pairs = await detent.loadPairs(3, file(3, 'pairs'));
  const box = space.aabb([0, 0, 0], [2 * ONE, 2 * ONE, 2 * ONE]);
  const contact = pairs.contact(box, space.sphere([ONE, 2.5 * ONE, ONE], ONE));
  assert.deepEqual([contact.normal, contact.depth, contact.points.length], [[0, UNIT, 0], ONE / 2, 1]);
  const high = space.sphere([ONE, 5 * ONE, ONE], ONE);
  assert.equal(pairs.contact(box, high), null);
  assert.deepEqual(pairs.closestPoints(box, high), [[ONE, 2 * ONE, ONE], [ONE, 4 * ONE, ONE]]);
  const hit = pairs.cast(high, [0, -UNIT, 0], 10 * ONE, box);
  assert.deepEqual(hit, { distance: 2 * ONE, point: [ONE, 2 * ONE, ONE], normal: [0, UNIT, 0] });
  assert.equal(pairs.cast(high, [0, UNIT, 0], 10 * ONE, box), null);
  const impact = pairs.timeOfImpact(high, pairs.sweep([0, 0, 0], [0, -4 * ONE, 0]), box);
  assert.throws(() => pairs.cast(high, [0, 1, 0], ONE, box), { status: status.NOT_UNIT });
  assert.ok(Math.abs(impact.time / UNIT - 0.5) < 0.001 && impact.is_hit);
});

test('joints and frames', async () => {
  const library = await detent.load(2, file(2));
  const { space } = library, context = library.open(), world = context.world();
  const wall = world.add(space.sphere([0, 5 * ONE], ONE / 8), { motion: detent.FIXED });
  const arm = world.add(space.obb([ONE, 5 * ONE], [ONE, ONE / 8]));
  const anchor_b = world.localPoint(arm, [0, 5 * ONE]);
  assert.deepEqual(anchor_b, [-ONE, 0]);
  const hinge = world.addJoint(detent.joints.hinge, wall, arm,
    { anchor_b, motor_speed: 2 * ONE, motor_force: 50 * ONE });
  for (let i = 0; i < 30; ++i) world.step();
  assert.ok(Math.abs(world.body(arm).angular_velocity[0] - 2 * ONE) < ONE / 10);
  assert.ok(Math.hypot(...world.jointForce(hinge)) > ONE);
  const [torque, ...rest] = world.jointTorque(hinge);
  assert.ok(torque > ONE && rest.length === 0);  // the motor lifts the arm
  assert.equal(world.changeJoint(hinge, { ...world.joint(hinge), break_force: 1 }), true);
  world.step();
  assert.deepEqual(world.broken(), [hinge]);
  assert.deepEqual([world.joint(hinge), world.jointForce(hinge), world.jointTorque(hinge)], [null, null, null]);
  assert.equal(world.addJoint(detent.joints.weld, wall, wall), null);
  const solid = context.solid(3, [[0, 0], [ONE, 0], [0, ONE]]);
  assert.ok(world.add(space.placed(solid, [9 * ONE, 9 * ONE])));
  const dumbbell = context.compound(4, [
    { shape: space.sphere([-ONE, 0], ONE / 2), density: 3 * ONE }, { shape: space.sphere([ONE, 0], ONE / 2) },
    { shape: space.placed(solid, [0, ONE]), is_sensor: 1 }]);
  const body = world.add(space.placed(dumbbell, [0, 20 * ONE]), { is_fast: 1 });
  assert.deepEqual(world.frame(body).translation, [0, 20 * ONE]);
  assert.ok(world.body(body).position[0] < 0);
  assert.throws(() => solid.destroy(), { status: detent.status.IN_USE });
  const scene = context.scene(), frame = scene.addFrame([ONE, 0]);
  const ball = scene.add(space.sphere([0, 0], ONE), { frame });
  assert.equal(scene.moveFrame(frame, [7 * ONE, 0]), true);
  assert.deepEqual(scene.nearest(space.point([7 * ONE, 0])).id, ball);
  assert.equal(scene.removeFrame(frame), false);
  context.close();
});

test('walks end where they do in Python', async () => {
  const library = await detent.loadWithMovers(3, file(3, 'movers'));
  const { space } = library, context = library.open(), scene = context.scene();
  const whole = (x) => Math.floor(x);
  scene.add(space.aabb([-20 * ONE, -ONE, -20 * ONE], [20 * ONE, 0, 20 * ONE]));
  for (let i = 1; i < 5; ++i) scene.add(space.aabb([i * ONE, 0, -ONE], [9 * ONE, i * ONE / 4, ONE]));
  scene.add(space.sphere([-4 * ONE, 0, whole(ONE / 3)], ONE));
  const lift = scene.addFrame([0, 0, 6 * ONE]);
  scene.add(space.aabb([-2 * ONE, 0, -2 * ONE], [2 * ONE, ONE / 8, 2 * ONE]), { frame: lift });
  const third = ONE / 3;
  const ends = [space.capsule([0, ONE, 0], [0, 2 * ONE, 0], ONE / 2),
    space.aabb([whole(-third), ONE, whole(-third)], [whole(third), 2 * ONE, whole(third)])].map((shape) => {
    const walker = scene.mover(shape);
    let digest = 0;
    for (let tick = 0; tick < 160; ++tick) {
      const [x, z] = [[1, 0], [-1, 0], [0, 1], [1, -1]][whole(tick / 40)];
      scene.moveFrame(lift, [tick * ONE / 64, 0, 6 * ONE]);
      walker.move([whole(x * ONE / 6), -ONE / 8, whole(z * ONE / 6)]);
      for (const word of [...walker.position, walker.isGrounded ? 1 : 0]) {
        digest = (Math.imul(digest, 31) + word) >>> 0;
      }
    }
    return [walker.position, digest];
  });
  assert.deepEqual(ends, [[[450484, 33792, 99329], 437337545], [[452882, 1024, 66561], 3168979696]]);
  context.close();
});

test('characters and casts in scenes', async () => {
  const library = await detent.loadWithMovers(3, file(3, 'movers'));
  const { space } = library, context = library.open(), scene = context.scene();
  const floor = scene.add(space.aabb([-9 * ONE, -ONE, -9 * ONE], [9 * ONE, 0, 9 * ONE]));
  const wall = scene.add(space.aabb([3 * ONE, 0, -9 * ONE], [4 * ONE, 9 * ONE, 9 * ONE]), { layers: 2 });
  const player = scene.mover(space.capsule([0, ONE, 0], [0, 2 * ONE, 0], ONE / 2), { step_height: 0 });
  assert.equal(player.lastMove, null);
  for (let i = 0; i < 60; ++i) player.move([ONE / 8, -ONE / 8, 0]);
  assert.equal(player.isGrounded, true);
  assert.ok(Math.abs(detent.number(player.position[0]) - 2.5) < 0.05);
  assert.deepEqual(player.state.object, floor);
  assert.deepEqual(player.lastMove.touched.map((touch) => touch.object).sort((a, b) => a.index - b.index),
    [floor, wall]);
  assert.deepEqual(player.clip([ONE, 0, 0]), [0, 0, 0]);
  const { state } = player;
  assert.ok(player.move([ONE, 0, 0], { ignored: wall })[0] > ONE / 2);
  const there = player.position;
  player.state = state;
  player.move([ONE, 0, 0], { layers: 1 });
  assert.deepEqual(player.position, there);
  const ball = space.sphere([0, 5 * ONE, 0], ONE);
  assert.throws(() => scene.mover(ball).move([ONE, 0, 0]), { status: status.NO_QUERY });

  const hit = scene.cast(ball, [UNIT, 0, 0], 9 * ONE);
  assert.deepEqual([hit.id, hit.distance, hit.point, hit.normal],
    [wall, 2 * ONE, [3 * ONE, 5 * ONE, 0], [-UNIT, 0, 0]]);
  assert.equal(scene.cast(ball, [UNIT, 0, 0], 2 * ONE - 1), null);
  const capsule = space.capsule([0, 2 * ONE, 0], [0, 3 * ONE, 0], ONE / 2);
  assert.equal(scene.cast(capsule, [0, -UNIT, 0], 9 * ONE).distance, 1.5 * ONE);
  const box = space.aabb([0, ONE, 0], [ONE, 2 * ONE, ONE]);
  for (const shape of [ball, capsule, box]) {
    assert.deepEqual(scene.castAll(shape, [UNIT, 0, 0], 9 * ONE).map(({ id }) => id), [wall]);
    assert.equal(scene.castAny(shape, [UNIT, 0, 0], 9 * ONE), true);
    assert.equal(scene.castAny(shape, [UNIT, 0, 0], 9 * ONE, 1), false);
    assert.equal(scene.castAny(shape, [0, UNIT, 0], 9 * ONE), false);
  }
  const slope = [-UNIT / 5 * 4, -UNIT / 5 * 3, 0].map(Math.round);
  assert.deepEqual(scene.castAll(space.aabb([6 * ONE, 3 * ONE, 0], [7 * ONE, 4 * ONE, ONE]), slope, 20 * ONE)
    .map(({ id }) => id), [wall, floor]);
  assert.throws(() => scene.cast(ball, [1, 0, 0], ONE), { status: status.NOT_UNIT });
  context.close();
});

test('cameras and what they see', async () => {
  const library = await detent.loadWithMovers(3, file(3, 'movers'));
  const { space } = library, context = library.open(), scene = context.scene();
  const ball = scene.add(space.sphere([0, 0, 0], ONE));
  scene.add(space.sphere([0, 0, 20 * ONE], ONE));
  const lens = { fov: 2 ** 29, aspect: ONE, near_distance: ONE, far_distance: 50 * ONE };
  const camera = space.camera([0, 0, 10 * ONE], [0, 0, 0], lens);
  assert.deepEqual(scene.visible(space.frustum(camera)), [{ distance: 8 * ONE, id: ball }]);
  assert.deepEqual(scene.raycast(space.pickRay(camera, [641, 481], [320, 240])).id, ball);
  assert.equal(scene.raycast(space.pickRay(camera, [641, 481], [0, 0])), null);
  assert.equal(space.camera([0, 0, 0], [0, 0, 0], lens), null);
  assert.throws(() => space.frustum({ ...camera, aspect: 0 }), { status: status.BAD_ARGUMENT });
  context.close();
});

test('characters and casts in scenes in 2D', async () => {
  const library = await detent.loadWithMovers(2, file(2, 'movers'));
  const { space } = library, context = library.open(), scene = context.scene();
  const floor = scene.add(space.aabb([-9 * ONE, -ONE], [9 * ONE, 0]));
  const walker = scene.mover(space.aabb([0, ONE], [ONE, 2 * ONE]));
  for (let i = 0; i < 20; ++i) walker.move([ONE / 8, -ONE / 8]);
  assert.deepEqual([walker.position, walker.isGrounded], [[20 * ONE / 8, 1024], true]);
  const hits = scene.castAll(space.sphere([0, 5 * ONE], ONE), [0, -UNIT], 9 * ONE);
  assert.deepEqual(hits.map(({ id, distance }) => [id, distance]), [[floor, 4 * ONE]]);
  const plain = await detent.load(2, file(2));
  assert.equal(plain.hasMovers, false);
  assert.equal(plain.open().scene().cast, undefined);
  context.close();
});

test('a module is a file of less than 300,000 bytes', async () => {
  for (const dimension of [2, 3]) {
    const size = (await readFile(file(dimension))).length;
    assert.ok(size < 300_000, `${dimension}D takes ${size} bytes`);
  }
});

test('a module comes compressed, expanded or compiled', async () => {
  const packed = await readFile(file(2)), bytes = gunzipSync(packed);
  const view = new Uint8Array(packed.length + 8).subarray(8);  // not at the start of its buffer
  view.set(packed);
  for (const source of [packed, view, bytes, view.slice().buffer, new Response(packed), new Response(bytes),
    await WebAssembly.compile(bytes)]) {
    const { space } = await detent.load(2, source);
    assert.equal(space.contains(space.sphere([0, 0], ONE), [ONE, 0]), true);
  }
});

test('errors', async () => {
  const library = await detent.load(3, file(3));
  const { space } = library, context = library.open(), scene = context.scene();
  const ball = space.sphere([0, 0, 0], ONE);
  assert.throws(() => space.raycast(space.ray([0, 0, 0], [1, 0, 0]), ball), { status: status.NOT_UNIT });
  scene.destroy();
  assert.throws(() => scene.size, { status: status.BAD_HANDLE });
  context.close();
  assert.throws(() => context.scene(), { status: status.BAD_CONTEXT });
  assert.equal(detent.raw(-0.5), -32768);
  assert.throws(() => detent.raw(32768), RangeError);
});

test('an integer that does not fit throws', async () => {
  const library = await detent.load(3, file(3));
  const { space } = library, context = library.open(), scene = context.scene();
  const limit = 2 ** 31, ball = space.sphere([limit - 1, -limit, 0], ONE);
  const id = scene.add(ball, { layers: 2 ** 32 - 1 });
  for (const wrong of [limit, -limit - 1, 0.5, NaN]) {
    assert.throws(() => scene.add(space.sphere([0, wrong, 0], ONE)), RangeError);
    assert.throws(() => scene.add(space.sphere([0, 0, 0], wrong)), RangeError);
    assert.throws(() => space.contains(ball, [0, 0, wrong]), RangeError);
    assert.throws(() => space.raycast(space.ray([0, 0, 0], [UNIT, 0, 0], wrong), ball), RangeError);
  }
  assert.throws(() => scene.add(ball, { layers: -1 }), RangeError);
  assert.throws(() => scene.raycast(space.ray([0, 0, 0], [UNIT, 0, 0]), 2 ** 32), RangeError);
  assert.deepEqual(scene.nearest(space.point([0, 0, 0])).id, id);
  context.close();
});

test('every method has a type', async () => {
  const types = await readFile(new URL('../index.d.mts', import.meta.url), 'utf8');
  for (const name of Object.keys(detent)) assert.match(types, new RegExp(`\\b${name}\\b`));
  const library = await detent.load(3, file(3));
  const context = library.open();
  const inner = new Set(['call', 'run', 'withWords', 'asset', 'create', 'out', 'out2', 'list', 'listOf', 'shape',
    'push', 'turn', 'transform', 'joint_', 'constructor', 'bytes', 'data', 'withBytes', 'setUp', 'open', 'moving']);
  const world = context.world(), session = context.session(world, { replay_every: 1 });
  const pairs = await detent.loadPairs(3, file(3, 'pairs'));
  const walked = (await detent.loadWithMovers(3, file(3, 'movers'))).open().scene();
  const mover = walked.mover(library.space.aabb([0, 0, 0], [ONE, ONE, ONE]));
  for (const one of [library, library.space, pairs, context, context.scene(), walked, mover, session, session.world,
    context.replay(session.replay(), world)]) {
    for (let of = Object.getPrototypeOf(one); of !== Object.prototype; of = Object.getPrototypeOf(of)) {
      for (const name of Object.getOwnPropertyNames(of)) {
        if (!inner.has(name)) assert.match(types, new RegExp(`\\b${name}[(:]`), name);
      }
    }
  }
});
