// SPDX-License-Identifier: MIT
import * as types from './interface.mjs';

export * as status from './interface.mjs';

export declare const ONE: 65536;
export declare const UNIT: 1073741824;
export declare const ALL_LAYERS: 4294967295;
export declare const DYNAMIC: 0;
export declare const KINEMATIC: 1;
export declare const FIXED: 2;

/** The kinds of joints. */
export declare const joints: {
  distance: 1; ball: 2; hinge: 3; weld: 4; slider: 5; wheel: 6; cone: 7;
};

/** The nearest length to a number. Throws RangeError out of range. */
export declare function raw(value: number): number;
/** The exact value of a length. */
export declare function number(length: number): number;

/** A failed call. `status` is one of the negative constants. */
export declare class DetentError extends Error {
  readonly status: number;
}

/** The kinds of events, and the reasons why a session has no frame to simulate. */
export declare const events: Record<'connected' | 'silent' | 'heard_again' | 'peer_paused' | 'peer_resumed' |
  'dropped' | 'expelled' | 'left' | 'too_slow' | 'contradiction' | 'desync' | 'desync_field' | 'arrived' |
  'loaded' | 'no_such_world' | 'joined', number>;
export declare const states: Record<'played' | 'connecting' | 'catching_up' | 'starved' | 'ahead' |
  'paused' | 'over' | 'joining', number>;

export type Id = types.Id;
/** The types of a dimension. */
export interface Of2 {
  vec: types.Vec2; shape: types.Shape2; ray: types.Ray2; hit: types.Hit2; objectHit: types.ObjectHit2;
  settings: types.World2Settings; options: types.Body2Options; body: types.Body2;
  worldContact: types.World2Contact;
  contactPoint: types.ContactPoint2; sweep: types.Sweep2; joint: types.Joint2; part: types.Part2;
  transform: types.Transform2; mover: types.Mover2; moverSettings: types.Mover2Settings;
  move: types.Move2;
}
export interface Of3 {
  vec: types.Vec3; shape: types.Shape3; ray: types.Ray3; hit: types.Hit3; objectHit: types.ObjectHit3;
  settings: types.World3Settings; options: types.Body3Options; body: types.Body3;
  worldContact: types.World3Contact;
  contactPoint: types.ContactPoint3; sweep: types.Sweep3; joint: types.Joint3; part: types.Part3;
  transform: types.Transform3; mover: types.Mover3; moverSettings: types.Mover3Settings;
  move: types.Move3;
}
type Of = Of2 | Of3;
/** A shape, made by a function of Space. */
export type Shape<D extends Of> = Partial<D['shape']> & { kind: number };

/** A part of a compound; missing fields have defaults. */
export type Part<D extends Of> = Partial<Omit<D['part'], 'shape'>> & { shape: Shape<D> };

/** Shapes, rays and queries of one dimension. */
/** A lens, with perspective or orthographic. `fov` is in 2^-32 of a turn. */
export type Lens = { near_distance: number; far_distance: number } &
  ({ fov: number; aspect: number } | { half_width: number; half_height: number });

export declare class Space<D extends Of> {
  ray(origin: D['vec'], direction: D['vec'], max_distance?: number): D['ray'];
  sphere(center: D['vec'], radius: number): Shape<D>;
  aabb(min: D['vec'], max: D['vec']): Shape<D>;
  obb(center: D['vec'], half_extents: D['vec'], axis?: D['vec'][]): Shape<D>;
  plane(normal: D['vec'], offset: number): Shape<D>;
  triangle(a: D['vec'], b: D['vec'], c: D['vec']): Shape<D>;
  capsule(a: D['vec'], b: D['vec'], radius: number): Shape<D>;
  segment(start: D['vec'], end: D['vec']): Shape<D>;
  point(at: D['vec']): Shape<D>;
  placed(asset: Asset, translation: D['vec'], axis?: D['vec'][], scale?: number): Shape<D>;
  /** Cameras and frusta: 3D only, with the module of `loadWithMovers`. Null if the camera has no
   *  view. */
  camera(eye: types.Vec3, target: types.Vec3, lens: Lens, up?: types.Vec3): types.Camera3 | null;
  frustum(camera: types.Camera3): types.Frustum3;
  /** The ray through the middle of a pixel: width and height of the image, column and row. */
  pickRay(camera: types.Camera3, size: [number, number], pixel: [number, number]): types.Ray3;
  raycast(ray: D['ray'], shape: Shape<D>): D['hit'] | null;
  /** Distances, -1 for a miss. A ray is its origin, direction and max_distance. */
  raycastMany(rays: Int32Array, shape: Shape<D>): Int32Array;
  contains(shape: Shape<D>, point: D['vec']): boolean;
  overlaps(a: Shape<D>, b: Shape<D>): boolean;
  closestPoint(shape: Shape<D>, point: D['vec']): D['vec'];
  distance(shape: Shape<D>, other: Shape<D> | D['vec']): number;
}

/** Queries of two shapes made by functions of Space. */
export declare class Pairs<D extends Of> {
  contact(a: Shape<D>, b: Shape<D>): { normal: D['vec']; depth: number; points: D['contactPoint'][] } | null;
  closestPoints(a: Shape<D>, b: Shape<D>): [D['vec'], D['vec']];
  cast(shape: Shape<D>, direction: D['vec'], max_distance: number, target: Shape<D>): D['hit'] | null;
  sweep(start: D['vec'], end: D['vec'], start_axis?: D['vec'][], end_axis?: D['vec'][]): D['sweep'];
  /** `time` is in steps of 2^-30. */
  timeOfImpact(a: Shape<D>, sweep_a: D['sweep'], b: Shape<D>, sweep_b?: D['sweep'] | null,
    target?: number): types.Impact | null;
}

export declare class Detent<D extends Of, S extends Scene<D> = Scene<D>> {
  readonly space: Space<D>;
  readonly version: number;
  readonly resultsVersion: number;
  readonly hasMovers: boolean;
  open(): Context<D, S>;
}

type Source = URL | string | Response | BufferSource | WebAssembly.Module;
/** The module of a dimension, by default detent2.wasm.gz or detent3.wasm.gz next to index.mjs. Bytes may be
 *  compressed by gzip. */
export declare function load(dimension: 2, source?: Source): Promise<Detent<Of2>>;
export declare function load(dimension: 3, source?: Source): Promise<Detent<Of3>>;
/** In place of it, a module that also has characters and casts in scenes, by default movers2.wasm.gz
 *  or movers3.wasm.gz. */
export declare function loadWithMovers(dimension: 2, source?: Source):
  Promise<Detent<Of2, SceneWithMovers<Of2>>>;
export declare function loadWithMovers(dimension: 3, source?: Source):
  Promise<Detent<Of3, SceneWithMovers<Of3>>>;
/** The module of queries of two shapes, by default pairs2.wasm.gz or pairs3.wasm.gz. */
export declare function loadPairs(dimension: 2, source?: Source): Promise<Pairs<Of2>>;
export declare function loadPairs(dimension: 3, source?: Source): Promise<Pairs<Of3>>;

export declare class Context<D extends Of, S extends Scene<D> = Scene<D>> {
  close(): void;
  scene(): S;
  world(settings?: Partial<D['settings']>): World<D>;
  session(start: World<D>, settings?: Partial<types.SessionSettings>): Session<D>;
  replay(bytes: Uint8Array, start: World<D>, settings?: { input_size?: number; words?: number }): Replay<D>;
  /** 3D only. */
  mesh(name: number, vertices: types.Vec3[], faces: [number, number, number][]): Asset;
  hull(name: number, points: D['vec'][]): Asset;
  /** A convex hull for bodies. */
  solid(name: number, points: D['vec'][]): Asset;
  /** Shapes that move as one body. */
  compound(name: number, parts: Part<D>[]): Asset;
  /** 3D only. */
  heightField(name: number, corner: types.Vec2, cell: number, columns: number, rows: number,
    heights: ArrayLike<number>): Asset;
}

export declare class Asset {
  readonly handle: number;
  destroy(): void;
}

declare class Held {
  readonly size: number;
  destroy(): void;
  digest(): bigint;
  remove(id: Id): boolean;
  snapshot(): Uint8Array;
  restore(snapshot: Uint8Array): void;
  /** The names of the first fields that differ. */
  diff(other: this, most?: number): string[];
}

export declare class Scene<D extends Of> extends Held {
  add(shape: Shape<D>, traits?: { layers?: number; user?: bigint | number; fixed?: boolean; frame?: Id }):
    Id | null;
  addFrame(translation: D['vec'], axis?: D['vec'][], scale?: number, parent?: Id): Id | null;
  moveFrame(frame: Id, translation: D['vec'], axis?: D['vec'][], scale?: number): boolean;
  removeFrame(frame: Id): boolean;
  replace(id: Id, shape: Shape<D>): boolean;
  move(id: Id, by: D['vec']): boolean;
  object(id: Id): { shape: D['shape']; traits: types.Traits } | null;
  optimize(): void;
  /** Holds the shapes of the world's bodies, with their ids, and nothing else: call it after each step,
   *  or whenever queries are due. */
  follow(world: World<D>, options?: { sensors?: boolean }): void;
  raycast(ray: D['ray'], layers?: number): D['objectHit'] | null;
  raycastAny(ray: D['ray'], layers?: number): boolean;
  raycastAll(ray: D['ray'], layers?: number): D['objectHit'][];
  raycastMany(rays: Int32Array, layers?: number): Int32Array;
  nearest(question: Shape<D>, layers?: number): types.Found | null;
  any(question: Shape<D>, layers?: number): boolean;
  all(question: Shape<D>, layers?: number): types.Found[];
  overlaps(): types.Pair[];
}

/** A scene of `loadWithMovers`. */
export declare class SceneWithMovers<D extends Of> extends Scene<D> {
  /** The first object that a moving sphere, AABB, OBB, capsule or segment touches. */
  cast(shape: Shape<D>, direction: D['vec'], max_distance: number, layers?: number): D['objectHit'] | null;
  castAny(shape: Shape<D>, direction: D['vec'], max_distance: number, layers?: number): boolean;
  /** Sorted by distance, then id. */
  castAll(shape: Shape<D>, direction: D['vec'], max_distance: number, layers?: number): D['objectHit'][];
  /** Objects that a frustum overlaps, sorted by distance from its near corners, then id. 3D only.
   *  */
  visible(frustum: types.Frustum3, layers?: number): types.Found[];
  /** A capsule or AABB character. */
  mover(shape: Shape<D>, settings?: Partial<D['moverSettings']>): Mover<D>;
}

export declare class Mover<D extends Of> {
  /** The whole state: keep it, and assign it to go back. */
  state: D['mover'];
  settings: D['moverSettings'];
  readonly isGrounded: boolean;
  /** The first end of the capsule, or the least corner of the box. */
  readonly position: D['vec'];
  /** What the last move did and touched; null before the first. */
  readonly lastMove: Omit<D['move'], 'count'> | null;
  /** `by` includes gravity. Returns the displacement. */
  move(by: D['vec'], options?: { layers?: number; ignored?: Id }): D['vec'];
  /** The part of a velocity that does not lead into what the last move touched. */
  clip(velocity: D['vec']): D['vec'];
}

export declare class World<D extends Of> extends Held {
  add(shape: Shape<D>, options?: Partial<D['options']>): Id;
  step(): void;
  body(id: Id): D['body'] | null;
  bodyIds(): Id[];
  info(id: Id): types.BodyInfo | null;
  /** The body of an object of a scene that follows this world, and the part of a compound. */
  partOf(object: Id): { body: Id; part: number } | null;
  /** Puts a body elsewhere, or turns it, at once. It keeps its joints. */
  setPosition(id: Id, position: D['vec']): boolean;
  setRotation(id: Id, axis: D['vec'][]): boolean;
  setFilter(id: Id, layers: number, collidesWith: number): boolean;
  setFriction(id: Id, friction: number): boolean;
  setRestitution(id: Id, restitution: number): boolean;
  setSensor(id: Id, isSensor: boolean): boolean;
  setGravityScale(id: Id, scale: number): boolean;
  setDamping(id: Id, linear: number, angular: number): boolean;
  /** `locked` is `status.LOCK_X` and so on, added up. */
  setLocked(id: Id, locked: number): boolean;
  setFast(id: Id, isFast: boolean): boolean;
  /** Wakes nothing. */
  setUser(id: Id, user: bigint | number): boolean;
  /** Wakes all bodies. */
  setGravity(gravity: D['vec']): void;
  setVelocity(id: Id, velocity: D['vec']): boolean;
  setAngularVelocity(id: Id, velocity: number[]): boolean;
  applyImpulse(id: Id, impulse: D['vec'], at?: D['vec']): boolean;
  applyForce(id: Id, force: D['vec'], at?: D['vec']): boolean;
  applyTorque(id: Id, torque: number[]): boolean;
  /** `kind` is one of `joints`. */
  addJoint(kind: number, a: Id, b: Id, fields?: Partial<D['joint']>): Id | null;
  changeJoint(id: Id, joint: D['joint']): boolean;
  removeJoint(id: Id): boolean;
  joint(id: Id): D['joint'] | null;
  /** On its body b in the last step. */
  jointForce(id: Id): D['vec'] | null;
  jointTorque(id: Id): number[] | null;
  jointIds(): Id[];
  broken(): Id[];
  localPoint(id: Id, point: D['vec']): D['vec'] | null;
  localFrame(id: Id, axis: D['vec'][]): D['vec'][] | null;
  frame(id: Id): D['transform'] | null;
  /** The pairs that touch, of one body or of all. */
  touching(id?: Id): types.Touch[];
  /** The contacts that touch, of one body or of all; none of sensors. */
  contacts(id?: Id): Omit<D['worldContact'], 'count'>[];
  events(): types.Touch[];
}

/** The world of a session or replay. It can be changed only during a frame. */
export declare class PlayedWorld<D extends Of> extends World<D> {
  words: number[];
  readonly wordCount: number;
}
/** A frame to simulate: the input of each player, null for one that takes no part. */
export interface Frame {
  number: number;
  inputs: (Uint8Array | null)[];
}
declare class Played<D extends Of> extends Held {
  readonly world: PlayedWorld<D>;
  readonly inputSize: number;
  readonly state: number;
}

export declare class Session<D extends Of> extends Played<D> {
  frames(pad: Uint8Array): Generator<Frame>;
  /** Times are in microseconds. */
  receive(peer: number, packet: Uint8Array, now: number | bigint): boolean;
  packets(now: number | bigint): { peer: number; bytes: Uint8Array }[];
  event(): { kind: number; peer: number; frame: number; field: string; object: Id | null } | null;
  readonly status: types.SessionStatus;
  matched(peer: number): number;
  isAwaited(player: number): boolean;
  drop(peer: number): void;
  pause(isPaused?: boolean): void;
  replay(): Uint8Array | null;
}

export declare class Replay<D extends Of> extends Played<D> {
  frames(): Generator<Frame>;
  check(): types.ReplayCheck;
}
