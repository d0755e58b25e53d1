// SPDX-License-Identifier: MIT
//
// usage: node --no-liftoff engines.mjs FOLDER [SCENE...]; tests/bench/worlds/run builds FOLDER and runs it
// Steps the scenes of plans.hpp in detent's WebAssembly (q16_16 and float), in Rapier and in Jolt,
// alternating step by step. Prints two tables as CSV: milliseconds per step, the mean of steps 60
// to 299, and how well each scene stands.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import RAPIER from '@dimforge/rapier3d-deterministic-compat';
import initJolt from 'jolt-physics';

const [folder, ...wanted] = process.argv.slice(2);
const [box, ball, capsule] = [0, 1, 2];
const dt = 1 / 60, gravity = -10, friction = 0.6;

/** The quaternion (x, y, z, w) of a rotation about an axis of any length. */
const quaternion = ([x, y, z], angle) => {
  const s = Math.sin(angle / 2) / Math.hypot(x, y, z);
  return [x * s, y * s, z * s, Math.cos(angle / 2)];
};
const turned = ([x, y, z, w], v) => {
  const t = [2 * (y * v[2] - z * v[1]), 2 * (z * v[0] - x * v[2]), 2 * (x * v[1] - y * v[0])];
  return [v[0] + w * t[0] + y * t[2] - z * t[1], v[1] + w * t[1] + z * t[0] - x * t[2], v[2] + w * t[2] + x * t[1] - y * t[0]];
};
const columns = (q) => [[1, 0, 0], [0, 1, 0], [0, 0, 1]].map((v) => turned(q, v));
const xyz = ([x, y, z]) => ({ x, y, z });

class Detent {
  constructor(scalar) {
    this.name = scalar;
    const module = new WebAssembly.Module(readFileSync(join(folder, `${scalar}.wasm`)));
    const nothing = Object.fromEntries(WebAssembly.Module.imports(module).map((each) => [each.name, () => 0]));
    this.wasm = new WebAssembly.Instance(module, { wasi_snapshot_preview1: nothing }).exports;
    this.wasm._initialize();
  }
  names() {
    return Array.from({ length: this.wasm.plan_count() }, (_, i) => {
      const bytes = new Uint8Array(this.wasm.memory.buffer, this.wasm.plan_name(i));
      return Buffer.from(bytes.subarray(0, bytes.indexOf(0))).toString();
    });
  }
  rows(kind, width) {
    const all = new Float64Array(this.wasm.memory.buffer, this.wasm[`${kind}_data`](), this.wasm[`${kind}_count`]() * width);
    return Array.from({ length: all.length / width }, (_, i) => Array.from(all.subarray(i * width, (i + 1) * width)));
  }
  plan(i) {
    this.wasm.load(i);
    const items = this.rows('item', 12).map((r) =>
      ({ kind: r[0], moves: r[1] !== 0, at: r.slice(2, 5), half: r.slice(5, 8), turn: quaternion(r.slice(8, 11), r[11]) }));
    const links = this.rows('link', 9).map((r) => ({ a: r[0], b: r[1], at: r.slice(2, 5), isHinge: r[5] !== 0, axis: r.slice(6, 9) }));
    return { index: i, items, links, points: this.rows('point', 3), sleeps: this.wasm.sleeps() !== 0 };
  }
  load(plan) {
    this.wasm.load(plan.index);
    this.count = plan.items.length;
  }
  step() {
    this.wasm.step();
  }
  poses() {
    const all = new Float64Array(this.wasm.memory.buffer, this.wasm.pose_data(), this.count * 12);
    return Array.from({ length: this.count }, (_, i) => {
      const r = Array.from(all.subarray(12 * i, 12 * i + 12));
      return { at: r.slice(0, 3), axes: [r.slice(3, 6), r.slice(6, 9), r.slice(9, 12)] };
    });
  }
  free() {}
}

class Rapier {
  name = 'Rapier';
  load(plan) {
    this.world = new RAPIER.World({ x: 0, y: gravity, z: 0 });
    this.world.timestep = dt;
    const corners = new Float32Array(plan.points.flat());
    this.bodies = plan.items.map(({ kind, moves, at, half, turn: [x, y, z, w] }) => {
      const body = (moves ? RAPIER.RigidBodyDesc.dynamic() : RAPIER.RigidBodyDesc.fixed())
        .setTranslation(...at).setRotation({ x, y, z, w }).setCanSleep(plan.sleeps);
      const shape = kind === box ? RAPIER.ColliderDesc.cuboid(...half)
        : kind === ball ? RAPIER.ColliderDesc.ball(half[0])
        : kind === capsule ? RAPIER.ColliderDesc.capsule(half[1], half[0])
        : RAPIER.ColliderDesc.convexHull(corners);
      const made = this.world.createRigidBody(body);
      this.world.createCollider(shape.setFriction(friction), made);
      return made;
    });
    const poses = this.poses();
    for (const { a, b, at, isHinge, axis } of plan.links) {
      const [inA, inB] = [a, b].map((i) => xyz(local(poses[i], at)));
      const data = isHinge ? RAPIER.JointData.revolute(inA, inB, xyz(axis)) : RAPIER.JointData.spherical(inA, inB);
      const joint = this.world.createImpulseJoint(data, this.bodies[a], this.bodies[b], true);
      if (isHinge) joint.setLimits(-1.2, 1.2);
    }
  }
  step() {
    this.world.step();
  }
  poses() {
    return this.bodies.map((body) => {
      const p = body.translation(), q = body.rotation();
      return { at: [p.x, p.y, p.z], axes: columns([q.x, q.y, q.z, q.w]) };
    });
  }
  free() {
    this.world.free();
  }
}

/** The package's limits give a step too little memory for 10,000 boxes. */
class Jolt {
  name = 'Jolt';
  constructor(jolt) {
    this.jolt = jolt;
  }
  load(plan) {
    const J = this.jolt, settings = new J.JoltSettings();
    settings.mMaxWorkerThreads = 0;
    const pairs = new J.ObjectLayerPairFilterTable(2);  // fixed, moving
    pairs.EnableCollision(0, 1);
    pairs.EnableCollision(1, 1);
    const layers = new J.BroadPhaseLayerInterfaceTable(2, 2);
    layers.MapObjectToBroadPhaseLayer(0, new J.BroadPhaseLayer(0));
    layers.MapObjectToBroadPhaseLayer(1, new J.BroadPhaseLayer(1));
    settings.mObjectLayerPairFilter = pairs;
    settings.mBroadPhaseLayerInterface = layers;
    settings.mObjectVsBroadPhaseLayerFilter = new J.ObjectVsBroadPhaseLayerFilterTable(layers, 2, pairs, 2);
    this.system = new J.JoltInterface(settings);
    J.destroy(settings);
    const physics = this.system.GetPhysicsSystem(), world = physics.GetBodyInterface();
    physics.SetGravity(new J.Vec3(0, gravity, 0));
    let hull;
    const hullShape = () => {
      if (!hull) {
        const of = new J.ConvexHullShapeSettings();
        for (const p of plan.points) of.mPoints.push_back(new J.Vec3(...p));
        hull = of.Create().Get();
      }
      return hull;
    };
    this.bodies = plan.items.map(({ kind, moves, at, half, turn }) => {
      const shape = kind === box ? new J.BoxShape(new J.Vec3(...half))
        : kind === ball ? new J.SphereShape(half[0])
        : kind === capsule ? new J.CapsuleShape(half[1], half[0])
        : hullShape();
      const options = new J.BodyCreationSettings(shape, new J.RVec3(...at), new J.Quat(...turn),
        moves ? J.EMotionType_Dynamic : J.EMotionType_Static, moves ? 1 : 0);
      options.mFriction = friction;
      options.mAllowSleeping = plan.sleeps;
      options.mLinearDamping = 0;
      options.mAngularDamping = 0;
      const body = world.CreateBody(options);
      J.destroy(options);
      world.AddBody(body.GetID(), moves ? J.EActivation_Activate : J.EActivation_DontActivate);
      return body;
    });
    for (const { a, b, at, isHinge, axis } of plan.links) {
      const of = isHinge ? new J.HingeConstraintSettings() : new J.PointConstraintSettings();
      of.mSpace = J.EConstraintSpace_WorldSpace;
      of.mPoint1 = new J.RVec3(...at);
      of.mPoint2 = new J.RVec3(...at);
      if (isHinge) {
        const normal = axis[0] !== 0 ? [0, 1, 0] : [1, 0, 0];
        of.mHingeAxis1 = of.mHingeAxis2 = new J.Vec3(...axis);
        of.mNormalAxis1 = of.mNormalAxis2 = new J.Vec3(...normal);
        of.mLimitsMin = -1.2;
        of.mLimitsMax = 1.2;
      }
      physics.AddConstraint(of.Create(this.bodies[a], this.bodies[b]));
      J.destroy(of);
    }
  }
  step() {
    this.system.Step(dt, 1);
  }
  poses() {
    return this.bodies.map((body) => {
      const p = body.GetPosition(), q = body.GetRotation();
      return { at: [p.GetX(), p.GetY(), p.GetZ()], axes: columns([q.GetX(), q.GetY(), q.GetZ(), q.GetW()]) };
    });
  }
  free() {
    this.jolt.destroy(this.system);
  }
}

const minus = (a, b) => a.map((x, i) => x - b[i]);
const dot = (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0);
/** Converts a world point to a body's frame, and back. */
const local = ({ at, axes }, p) => axes.map((axis) => dot(axis, minus(p, at)));
const placed = ({ at, axes }, p) => at.map((x, i) => x + dot(axes.map((axis) => axis[i]), p));

/** How well a scene stands: numbers by name, in world units. */
function quality(plan, first, last, before) {
  const moving = plan.items.map((item, i) => i).filter((i) => plan.items[i].moves);
  const distances = moving.map((i) => Math.hypot(...minus(last[i].at, before[i].at)));
  const found = { 'fastest body': Math.max(...distances) / dt };
  if (plan.name.startsWith('stack') || plan.name.startsWith('pyramid')) {
    const top = moving[moving.length - 1], moved = minus(last[top].at, first[top].at);
    found['sag of the top'] = -moved[1];
    found['drift of the top'] = Math.hypot(moved[0], moved[2]);
  }
  if (plan.links.length > 0) {
    const gaps = plan.links.map(({ a, b, at }) =>
      Math.hypot(...minus(placed(last[a], local(first[a], at)), placed(last[b], local(first[b], at)))));
    found['mean gap of joints'] = dot(gaps, gaps.map(() => 1)) / gaps.length;
    found['largest gap of joints'] = Math.max(...gaps);
  }
  if (plan.items.some(({ kind }) => kind === ball) && plan.links.length === 0) {
    const depths = [];
    for (const i of moving) {
      for (const j of moving) {
        if (i >= j) continue;
        const depth = plan.items[i].half[0] + plan.items[j].half[0] - Math.hypot(...minus(last[i].at, last[j].at));
        if (depth > 0) depths.push(depth);
      }
    }
    found['mean penetration'] = dot(depths, depths.map(() => 1)) / Math.max(1, depths.length);
    found['largest penetration'] = Math.max(0, ...depths);
  }
  return found;
}

await RAPIER.init();
const detent = new Detent('q16_16');
const engines = [detent, new Detent('float'), new Rapier(), new Jolt(await initJolt())];
const rows = [];
const text = (x, digits) => x === undefined ? '' : x.toFixed(digits);
console.log(`scene,${engines.map(({ name }) => `${name} ms`).join()},${engines.slice(1).map(({ name }) => `detent : ${name}`).join()}`);
for (const [index, name] of detent.names().entries()) {
  if (wanted.length > 0 && !wanted.includes(name)) continue;
  const plan = { name, ...detent.plan(index) };
  const steps = plan.items.length > 5000 ? 100 : 300, from = Math.min(60, steps / 2);
  const able = engines.filter((engine) => !(engine instanceof Jolt) || plan.items.length < 5000);
  for (const engine of able) engine.load(plan);
  const first = able.map((engine) => engine.poses()), times = able.map(() => 0);
  let before;
  for (let i = 0; i < steps; ++i) {
    if (i === steps - 1) before = able.map((engine) => engine.poses());
    for (const [e, engine] of able.entries()) {
      const start = performance.now();
      engine.step();
      if (i >= from) times[e] += performance.now() - start;
    }
  }
  const mean = engines.map((_, e) => able[e] && times[e] / (steps - from));
  const ratios = mean.slice(1).map((time) => time && mean[0] / time);
  console.log(`${name},${mean.map((time) => text(time, 3)).join()},${ratios.map((ratio) => text(ratio, 2)).join()}`);
  const found = able.map((engine, e) => quality(plan, first[e], engine.poses(), before[e]));
  for (const what of Object.keys(found[0])) {
    rows.push(`${name},${what},${engines.map((_, e) => text(found[e]?.[what], 4)).join()}`);
  }
  for (const engine of able) engine.free();
}
console.log(`\nscene,after the last step,${engines.map(({ name }) => name).join()}`);
for (const row of rows) console.log(row);
