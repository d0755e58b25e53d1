// SPDX-License-Identifier: MIT
// Compiled by tsc in strict mode: checks the types of the calls.
import { FIXED, ONE, UNIT, events, load, loadWithMovers, states } from 'detent';
const detent = await load(3);
const { space } = detent;
const context = detent.open();
const start = context.world({ ticks_per_second: 60 });
start.add(space.aabb([0, 0, 0], [ONE, ONE, ONE]), { motion: FIXED });
const ball = start.add(space.sphere([0, 9 * ONE, 0], ONE));
const session = context.session(start, { match: 4711n, self: 0, players: 1, input_size: 2, words: 2, replay_every: 10 });
for (const { number, inputs } of session.frames(Uint8Array.of(1, 2))) {
  const words = session.world.words;
  words[0] = number + (inputs[0]?.[0] ?? 0);
  session.world.words = words;
  session.world.setVelocity(ball, [0, UNIT, 0]);
  session.world.step();
}
if (session.state !== states.played) throw new Error();
for (let event = session.event(); event; event = session.event()) {
  if (event.kind === events.desync_field) console.log(event.field, event.object?.index);
}
for (const { peer, bytes } of session.packets(0)) session.receive(peer, bytes, 0n);
const digest: bigint = session.status.digest;
const file = session.replay();
if (file) for (const frame of context.replay(file, start, { input_size: 2, words: 2 }).frames()) console.log(frame.number);
const names: string[] = start.diff(session.world);
const hit = context.scene().raycast(space.ray([0, 0, 0], [UNIT, 0, 0], ONE));
console.log(digest, names, hit?.id.index);
const walked = (await loadWithMovers(2)).open().scene();
const walker = walked.mover({ kind: 6, capsule: { a: [0, 0], b: [0, ONE], radius: ONE } }, { step_height: 0 });
const moved: [number, number] = walker.move([ONE, 0], { layers: 1 });
console.log(moved, walker.isGrounded, walker.lastMove?.touched[0]?.object.index, walked.castAll(
  { kind: 1, sphere: { center: [0, 0], radius: 1 } }, [UNIT, 0], ONE).length);
const wide = await loadWithMovers(3);
const camera = wide.space.camera([0, 0, ONE], [0, 0, 0], { half_width: ONE, half_height: ONE, near_distance: 0, far_distance: ONE });
if (camera) console.log(wide.open().scene().visible(wide.space.frustum(camera)).length);
// @ts-expect-error: a scene of the module without characters
context.scene().castAny(space.sphere([0, 0, 0], ONE), [UNIT, 0, 0], ONE);
// @ts-expect-error: a point of another dimension
space.sphere([0, 0], ONE);
