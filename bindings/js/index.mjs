// SPDX-License-Identifier: MIT
//
// Correctly rounded collision queries, scenes and worlds with the same bits on every machine, in
// WebAssembly. All numbers are raw integers: a length of 1 is ONE, a direction's component of 1 is
// UNIT; a number that is no integer of 32 bits throws a RangeError. Points and directions are arrays;
// digests are BigInts. The types are in index.d.mts.

import * as constants from './interface.mjs';

const { layouts } = constants;
export * as status from './interface.mjs';

export const ONE = 65536;
export const UNIT = 2 ** 30;
export const ALL_LAYERS = 0xffffffff;
export const DYNAMIC = constants.DYNAMIC_BODY;
export const KINEMATIC = constants.KINEMATIC_BODY;
export const FIXED = constants.FIXED_BODY;
/** The kinds of joints. */
export const joints = {
  distance: constants.DISTANCE_JOINT, ball: constants.BALL_JOINT, hinge: constants.HINGE_JOINT,
  weld: constants.WELD_JOINT, slider: constants.SLIDER_JOINT, wheel: constants.WHEEL_JOINT,
  cone: constants.CONE_JOINT,
};

/** The nearest length to a number; halves are rounded up. Throws RangeError out of range. */
export function raw(value) {
  const result = Math.round(value * ONE);
  if (!(result >= -(2 ** 31) && result < 2 ** 31)) throw new RangeError(`${value} is out of range`);
  return result;
}
/** The exact value of a length. */
export const number = (length) => length / ONE;

/** A failed call. `status` is one of the negative constants. */
export class DetentError extends Error {
  constructor(status, message) {
    super(message);
    this.name = 'DetentError';
    this.status = status;
  }
}

/** The kinds of events of sessions, and the reasons why a session has no frame to simulate. */
export const events = Object.fromEntries(['CONNECTED', 'SILENT', 'HEARD_AGAIN', 'PEER_PAUSED', 'PEER_RESUMED',
  'DROPPED', 'EXPELLED', 'LEFT', 'TOO_SLOW', 'CONTRADICTION', 'DESYNC', 'DESYNC_FIELD', 'ARRIVED', 'LOADED',
  'NO_SUCH_WORLD', 'JOINED'].map((name) => [name.toLowerCase(), constants[name]]));
export const states = Object.fromEntries(['PLAYED', 'CONNECTING', 'CATCHING_UP', 'STARVED', 'AHEAD', 'PAUSED',
  'OVER', 'JOINING'].map((name) => [name.toLowerCase(), constants[name]]));

/** An integer of 32 bits. DataView and WebAssembly would keep only the low bits of a larger one. */
function fitting(value, least) {
  const number = Number(value);  // of a boolean, too
  if (!(Number.isInteger(number) && number >= least && number < least + 2 ** 32)) {
    throw new RangeError(`${value} is no integer from ${least} to ${least + 2 ** 32 - 1}`);
  }
  return number;
}

const kinds = { sphere: 1, aabb: 2, obb: 3, plane: 4, triangle: 5, capsule: 6, segment: 7, point: 8 };
const memberOf = ['', ...Object.keys(kinds), 'placed', 'placed', 'point', 'placed'];
/** The kind of an asset's shape by the lowest bits of its handle; others are hulls. */
const kindOfAsset = {
  5: constants.MESH, 8: constants.HEIGHT_FIELD, 11: constants.COMPOUND, 12: constants.COMPOUND,
};
const scratchSize = 4096;

/** The module's memory, and one block of it for the arguments of a call. */
class Memory {
  constructor(exports) {
    this.exports = exports;
    this.scratch = this.allocate(scratchSize);
    this.used = 0;
  }
  allocate(size) {
    const at = this.exports.malloc(size);
    if (at === 0) throw new RangeError('there is no memory left');
    return at;
  }
  view() {
    if (!this.data || this.data.buffer !== this.exports.memory.buffer) {
      this.data = new DataView(this.exports.memory.buffer);
    }
    return this.data;
  }
  /** Allocates `size` bytes until the call returns. */
  place(size) {
    const at = this.used;
    this.used += (size + 7) & ~7;
    if (this.used > scratchSize) throw new RangeError('too many arguments');
    return this.scratch + at;
  }
  /** Copies a value for the call. */
  put(type, value) {
    const at = this.place(layouts[type].size);
    new Uint8Array(this.exports.memory.buffer, at, layouts[type].size).fill(0);
    this.write(at, type, value);
    return at;
  }

  write(at, type, value) {
    const view = this.view();
    if (type === 'int32_t') return view.setInt32(at, fitting(value, -(2 ** 31)), true);
    if (type === 'uint32_t') return view.setUint32(at, fitting(value, 0), true);
    if (type === 'uint64_t') return view.setBigUint64(at, BigInt(value), true);
    const layout = layouts[type];
    layout.fields.forEach(([name, of, offset, count], i) => {
      const field = layout.isVector ? value[i] : value[name];
      if (field === undefined) return;
      const size = layouts[of]?.size ?? 4;
      for (let k = 0; k < Math.max(count, 1); ++k) {
        this.write(at + offset + k * size, of, count ? field[k] : field);
      }
    });
    for (const [name, of, offset] of layout.union) {
      if (name === memberOf[value.kind]) this.write(at + offset, of, value[name]);
    }
  }
  read(at, type) {
    const view = this.view();
    if (type === 'int32_t') return view.getInt32(at, true);
    if (type === 'uint32_t') return view.getUint32(at, true);
    if (type === 'uint64_t') return view.getBigUint64(at, true);
    const layout = layouts[type];
    const value = layout.isVector ? [] : {};
    layout.fields.forEach(([name, of, offset, count], i) => {
      const size = layouts[of]?.size ?? 4;
      const field = count
        ? Array.from({ length: count }, (_, k) => this.read(at + offset + k * size, of))
        : this.read(at + offset, of);
      value[layout.isVector ? i : name] = field;
    });
    for (const [name, of, offset] of layout.union) {
      if (name === memberOf[value.kind]) value[name] = this.read(at + offset, of);
    }
    return value;
  }
  text(at) {
    const bytes = new Uint8Array(this.exports.memory.buffer, at);
    return String.fromCharCode(...bytes.subarray(0, bytes.indexOf(0)));
  }
}

/** The bytes of a module. Its file is compressed, so that it is small from every server; a server that says
 *  so (`content-encoding: gzip`) makes the browser expand it, and then there is nothing to do. */
async function expand(bytes) {
  const start = ArrayBuffer.isView(bytes)
    ? new Uint8Array(bytes.buffer, bytes.byteOffset, bytes.byteLength) : new Uint8Array(bytes);
  if (start[0] !== 0x1f || start[1] !== 0x8b) return bytes;
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'))).arrayBuffer();
}

async function instantiate(source) {
  let from = source;
  if (from instanceof URL && from.protocol === 'file:') {
    from = await (await import('node:fs/promises')).readFile(from);
  } else if (from instanceof URL || typeof from === 'string') {
    from = await fetch(from);
  }
  if (typeof Response !== 'undefined' && from instanceof Response) from = await from.arrayBuffer();
  if (!(from instanceof WebAssembly.Module)) from = await expand(from);
  const module = from instanceof WebAssembly.Module ? from : await WebAssembly.compile(from);
  const imports = {};
  for (const { module: room, name } of WebAssembly.Module.imports(module)) {
    // Called only by libc's abort: an allocation failed.
    (imports[room] ??= {})[name] = () => {
      throw new RangeError('there is no memory left');
    };
  }
  const { exports } = await WebAssembly.instantiate(module, imports);
  exports._initialize?.();
  return exports;
}

/** Instantiates the module of a dimension: from a URL, a Response, bytes or a compiled module; by default
 *  from detent2.wasm.gz or detent3.wasm.gz next to this file. Bytes may be compressed by gzip. */
export async function load(dimension, source = new URL(`./detent${dimension}.wasm.gz`, import.meta.url)) {
  return new Detent(await instantiate(source), dimension);
}
/** The same with characters and casts in scenes: a larger module, by default movers2.wasm.gz or
 *  movers3.wasm.gz. It replaces the one that `load` takes, since scenes are in the memory of their module. */
export async function loadWithMovers(dimension,
  source = new URL(`./movers${dimension}.wasm.gz`, import.meta.url)) {
  return new Detent(await instantiate(source), dimension);
}
/** Contacts, closest points, casts and times of impact of two shapes: by default from pairs2.wasm.gz or
 *  pairs3.wasm.gz. */
export async function loadPairs(dimension, source = new URL(`./pairs${dimension}.wasm.gz`, import.meta.url)) {
  return new Pairs(new Module(await instantiate(source)), dimension);
}

const axesOf = (dimension) => Array.from({ length: dimension }, (_, k) =>
  Array.from({ length: dimension }, (_, i) => (i === k ? UNIT : 0)));
const typesOf = (dimension) => Object.fromEntries(
  ['vec', 'direction', 'rotation', 'transform', 'ray', 'shape', 'hit', 'object_hit', 'body', 'manifold',
    'sweep', 'joint', 'part', 'mover', 'move'].map((name) => [name, `detent_${name}${dimension}`]));

/** Shapes, rays and queries of one dimension. */
class Space {
  constructor(detent, dimension) {
    this.detent = detent;
    this.dimension = dimension;
    this.axes = axesOf(dimension);
    this.types = typesOf(dimension);
    this.rayWords = layouts[this.types.ray].size / 4;
  }

  ray(origin, direction, max_distance = 2 ** 31 - 1) {
    return { origin, direction, max_distance };
  }
  sphere(center, radius) {
    return { kind: kinds.sphere, sphere: { center, radius } };
  }
  aabb(min, max) {
    return { kind: kinds.aabb, aabb: { min, max } };
  }
  obb(center, half_extents, axis = this.axes) {
    return { kind: kinds.obb, obb: { center, half_extents, rotation: { axis } } };
  }
  plane(normal, offset) {
    return { kind: kinds.plane, plane: { normal, offset } };
  }
  triangle(a, b, c) {
    return { kind: kinds.triangle, triangle: { a, b, c } };
  }
  capsule(a, b, radius) {
    return { kind: kinds.capsule, capsule: { a, b, radius } };
  }
  segment(start, end) {
    return { kind: kinds.segment, segment: { start, end } };
  }
  point(point) {
    return { kind: kinds.point, point };
  }
  /** An asset as a shape. In a scene: a transformed mesh or hull, or a translated height field. In
   *  a world also a solid hull or a compound. */
  placed(asset, translation, axis = this.axes, scale = ONE) {
    const kind = kindOfAsset[asset.handle & 31] ?? constants.HULL;
    const shape = { kind, asset: asset.handle };
    if (kind === constants.HEIGHT_FIELD) return { ...shape, point: translation };
    return { ...shape, placed: { translation, rotation: { axis }, scale } };
  }

  /** A camera at `eye` that looks at `target`. `lens` has near_distance, far_distance, and either
   *  fov (in 2^-32 of a turn) and aspect, or half_width and half_height. Null if it has no view. 3D
   *  only. */
  camera(eye, target, lens, up = [0, ONE, 0]) {
    return this.detent.call((memory) => {
      const pose = memory.place(layouts.detent_transform3.size);
      const points = [eye, target, up].map((v) => memory.put('detent_vec3', v));
      const yes = this.detent.run('camera3_look_at', ...points, pose);
      if (!yes) return null;
      const has_perspective = 'fov' in lens ? 1 : 0;
      return { pose: memory.read(pose, 'detent_transform3'), has_perspective, ...lens };
    });
  }
  /** The view volume of a camera: { corners }. */
  frustum(camera) {
    return this.detent.call((memory) => {
      const at = memory.place(layouts.detent_frustum3.size);
      this.detent.run('camera3_frustum', memory.put('detent_camera3', camera), at);
      return memory.read(at, 'detent_frustum3');
    });
  }
  /** The ray through the middle of a pixel of an image of this size. */
  pickRay(camera, [width, height], [column, row]) {
    return this.detent.call((memory) => {
      const at = memory.place(layouts.detent_ray3.size);
      this.detent.run('camera3_pick_ray', memory.put('detent_camera3', camera), width, height, column, row, at);
      return memory.read(at, 'detent_ray3');
    });
  }

  raycast(ray, shape) {
    return this.detent.call((memory) => {
      const hit = memory.place(layouts[this.types.hit].size);
      const yes = this.run('raycast{N}', memory.put(this.types.ray, ray),
        memory.put(this.types.shape, shape), hit);
      return yes ? memory.read(hit, this.types.hit) : null;
    });
  }
  /** Distances of many rays, -1 for a miss: an Int32Array of origin, direction and max_distance. */
  raycastMany(rays, shape) {
    const count = rays.length / this.rayWords;
    if (!Number.isInteger(count)) throw new RangeError(`a ray has ${this.rayWords} numbers`);
    return this.detent.withWords(rays, count, (from, to, memory) =>
      this.run('raycast{N}_many', from, count, memory.put(this.types.shape, shape), to));
  }
  contains(shape, point) {
    return this.detent.call((memory) =>
      this.run('contains{N}', memory.put(this.types.shape, shape), memory.put(this.types.vec, point)));
  }
  overlaps(a, b) {
    return this.detent.call((memory) =>
      this.run('overlaps{N}', memory.put(this.types.shape, a), memory.put(this.types.shape, b)));
  }
  closestPoint(shape, point) {
    return this.detent.call((memory) => {
      const closest = memory.place(16);
      this.run('closest_point{N}', memory.put(this.types.shape, shape),
        memory.put(this.types.vec, point), closest);
      return memory.read(closest, this.types.vec);
    });
  }
  /** The distance between two shapes, or between a shape and a point (an array). */
  distance(shape, other) {
    return this.detent.call((memory) => {
      const distance = memory.place(4);
      const one = memory.put(this.types.shape, shape);
      if (Array.isArray(other)) {
        this.run('distance_to_point{N}', one, memory.put(this.types.vec, other), distance);
      } else {
        this.run('distance{N}', one, memory.put(this.types.shape, other), distance);
      }
      return memory.read(distance, 'int32_t');
    });
  }

  run(name, ...words) {
    return this.detent.run(name.replace('{N}', this.dimension), ...words);
  }
}

/** Queries of two shapes in one dimension. */
class Pairs {
  constructor(detent, dimension) {
    this.detent = detent;
    this.dimension = dimension;
    this.axes = axesOf(dimension);
    this.types = typesOf(dimension);
  }
  /** { normal, depth, points } of two overlapping shapes, or null. */
  contact(a, b) {
    return this.detent.call((memory) => {
      const at = memory.place(layouts[this.types.manifold].size);
      if (!this.run('contact{N}', memory.put(this.types.shape, a), memory.put(this.types.shape, b), at)) {
        return null;
      }
      const { normal, depth, count, points } = memory.read(at, this.types.manifold);
      return { normal, depth, points: points.slice(0, count) };
    });
  }
  /** The closest points of two shapes. */
  closestPoints(a, b) {
    return this.detent.call((memory) => {
      const one = memory.place(16), other = memory.place(16);
      this.run('closest_points{N}', memory.put(this.types.shape, a), memory.put(this.types.shape, b),
        one, other);
      return [memory.read(one, this.types.vec), memory.read(other, this.types.vec)];
    });
  }
  /** The first contact of a shape moving along a direction with a target, or null. */
  cast(shape, direction, max_distance, target) {
    return this.detent.call((memory) => {
      const hit = memory.place(layouts[this.types.hit].size);
      const yes = this.run('cast{N}', memory.put(this.types.shape, shape),
        memory.put(this.types.direction, direction), max_distance,
        memory.put(this.types.shape, target), hit);
      return yes ? memory.read(hit, this.types.hit) : null;
    });
  }
  /** The motion of a frame, for timeOfImpact. */
  sweep(start, end, start_axis = this.axes, end_axis = this.axes) {
    return { start, end, start_rotation: { axis: start_axis }, end_rotation: { axis: end_axis } };
  }
  /** When two moving shapes first come closer than `target`, or null. Pass null as the sweep of a
   *  shape that does not move. */
  timeOfImpact(a, sweep_a, b, sweep_b = null, target = 8) {
    return this.detent.call((memory) => {
      const impact = memory.place(layouts.detent_impact.size);
      const yes = this.run('time_of_impact{N}', memory.put(this.types.shape, a),
        memory.put(this.types.sweep, sweep_a), memory.put(this.types.shape, b),
        sweep_b ? memory.put(this.types.sweep, sweep_b) : 0, target, impact);
      return yes ? memory.read(impact, 'detent_impact') : null;
    });
  }

  run(name, ...words) {
    return this.detent.run(name.replace('{N}', this.dimension), ...words);
  }
}

/** An instance of a module. */
class Module {
  constructor(exports) {
    this.memory = new Memory(exports);
  }
  /** Returns f(memory), then frees what f allocated. */
  call(f) {
    const { used } = this.memory;
    try {
      return f(this.memory);
    } finally {
      this.memory.used = used;
    }
  }
  /** True for yes or done, false for no or none; throws on an error. */
  run(name, ...words) {
    for (const word of words) if (typeof word === 'number') fitting(word, word < 0 ? -(2 ** 31) : 0);
    const status = this.memory.exports[`detent_${name}`](...words);
    if (status >= 0) return status === constants.OK;
    throw new DetentError(status, this.memory.text(this.memory.exports.detent_describe(status)));
  }
}

/** The library in one dimension. Its shapes, rays and queries are those of Space. */
class Detent extends Module {
  constructor(exports, dimension) {
    super(exports);
    this.space = new Space(this, dimension);
    this.version = exports.detent_version();
    this.resultsVersion = exports.detent_results_version();
    this.hasMovers = `detent_mover${dimension}_move` in exports;
  }
  /** The `count` words that f(from, to) writes, given a copy of the input. */
  withWords(words, count, f) {
    const { memory } = this;
    const from = memory.allocate(4 * words.length + 4), to = memory.allocate(4 * count + 4);
    try {
      new Int32Array(memory.exports.memory.buffer, from, words.length).set(words);
      this.call(() => f(from, to, memory));
      return new Int32Array(memory.exports.memory.buffer, to, count).slice();
    } finally {
      memory.exports.free(from);
      memory.exports.free(to);
    }
  }
  /** A context, which makes scenes, worlds and assets. Close it when they are no longer needed. */
  open() {
    return new Context(this);
  }
}

class Context {
  constructor(detent) {
    this.detent = detent;
    this.at = detent.memory.allocate(layouts.detent_context.size);
    new Uint8Array(detent.memory.exports.memory.buffer, this.at, layouts.detent_context.size).fill(0);
    detent.run('open', this.at, 0);
  }
  close() {
    this.detent.run('close', this.at);
  }
  scene() {
    const { detent } = this;
    return new (detent.hasMovers ? SceneWithMovers : Scene)(this, detent.space);
  }
  world(settings = {}) {
    return new World(this, this.detent.space, settings);
  }
  /** A network match. All peers begin with a copy of `start`. */
  session(start, settings = {}) {
    return new Session(this, this.detent.space, start, settings);
  }
  /** A replay, with the inputs and words of its session. */
  replay(bytes, start, { input_size = 1, words = 0 } = {}) {
    return new Replay(this, this.detent.space, bytes, start, input_size, words);
  }
  /** A mesh; each triangle is three vertex indices. `name` is its id in snapshots, not 0. 3D only.
   *  */
  mesh(name, vertices, faces) {
    return this.asset([vertices.flat(), faces.flat()], ([points, indices], out) =>
      this.detent.run('mesh_create', this.at, name, points, vertices.length, indices, faces.length, out));
  }
  hull(name, points) {
    return this.asset([points.flat()], ([list], out) =>
      this.detent.space.run('hull{N}_create', this.at, name, list, points.length, out));
  }
  /** A convex hull for bodies. */
  solid(name, points) {
    return this.asset([points.flat()], ([list], out) =>
      this.detent.space.run('solid{N}_create', this.at, name, list, points.length, out));
  }
  /** Shapes that move as one body. Each part has a `shape` (a sphere, AABB, OBB, capsule or placed
   *  solid hull) and its material. */
  compound(name, parts) {
    const { space } = this.detent;
    const { size } = layouts[space.types.part];
    return this.asset([new Int32Array(parts.length * size / 4)], ([list], out) => {
      const { memory } = this.detent;
      parts.forEach((part, i) => {
        const at = list + i * size;
        space.run('part{N}_defaults', at);
        const made = memory.read(at, space.types.part);
        memory.write(at, space.types.part, { ...made, ...part });
      });
      return space.run('compound{N}_create', this.at, name, list, parts.length, out);
    });
  }
  /** 3D only. */
  heightField(name, corner, cell, columns, rows, heights) {
    if (heights.length !== columns * rows) throw new RangeError('there must be columns * rows heights');
    return this.asset([heights, corner], ([list, at], out) =>
      this.detent.run('height_field_create', this.at, name, at, cell, columns, rows, list, out));
  }
  asset(lists, create) {
    const { memory } = this.detent;
    const places = lists.map((list) => memory.allocate(4 * list.length + 4));
    try {
      lists.forEach((list, i) =>
        new Int32Array(memory.exports.memory.buffer, places[i], list.length).set(list));
      return this.detent.call(() => {
        const out = memory.place(4);
        create(places, out);
        return new Asset(this, memory.read(out, 'uint32_t'));
      });
    } finally {
      places.forEach((at) => memory.exports.free(at));
    }
  }
}

class Asset {
  constructor(context, handle) {
    this.context = context;
    this.handle = handle;
  }
  destroy() {
    this.context.detent.run('asset_destroy', this.context.at, this.handle);
  }
}

/** The common base of scenes and worlds. */
class Held {
  constructor(context, space, kind) {
    this.context = context;
    this.space = space;
    this.kind = kind;
    this.types = space.types;
  }
  create(...words) {
    this.handle = this.call((memory) => {
      const out = memory.place(4);
      this.space.run(`${this.kind}{N}_create`, this.context.at, ...words, out);
      return memory.read(out, 'uint32_t');
    });
  }
  call(f) {
    return this.context.detent.call(f);
  }
  run(name, ...words) {
    return this.space.run(`${this.kind}{N}_${name}`, this.context.at, this.handle, ...words);
  }
  out(name, type) {
    return this.call((memory) => {
      const at = memory.place(8);
      this.run(name, at);
      return memory.read(at, type);
    });
  }
  destroy() {
    this.run('destroy');
  }
  get size() {
    return this.out('size', 'uint32_t');
  }
  /** A 64-bit digest of the contents, equal on every machine. */
  digest() {
    return this.out('digest', 'uint64_t');
  }
  remove(id) {
    return this.call((memory) => this.run('remove', memory.put('detent_id', id)));
  }
  snapshot() {
    const { memory } = this.context.detent;
    const size = this.out2('snapshot', 0, 0);
    const at = memory.allocate(size);
    try {
      this.out2('snapshot', at, size);
      return new Uint8Array(memory.exports.memory.buffer, at, size).slice();
    } finally {
      memory.exports.free(at);
    }
  }
  out2(name, ...words) {
    return this.call((memory) => {
      const count = memory.place(4);
      this.run(name, ...words, count);
      return memory.read(count, 'uint32_t');
    });
  }
  restore(snapshot) {
    const { memory } = this.context.detent;
    const at = memory.allocate(snapshot.length + 1);
    try {
      new Uint8Array(memory.exports.memory.buffer, at, snapshot.length).set(snapshot);
      this.run('restore', at, snapshot.length);
    } finally {
      memory.exports.free(at);
    }
  }
  /** All results of a function that writes a list. */
  list(name, type, ...words) {
    const { memory } = this.context.detent;
    for (let room = 64; ;) {
      const at = memory.allocate(room * layouts[type].size);
      try {
        const count = this.out2(name, ...words, at, room);
        if (count <= room) {
          return Array.from({ length: count }, (_, i) => memory.read(at + i * layouts[type].size, type));
        }
        room = count;
      } finally {
        memory.exports.free(at);
      }
    }
  }
  shape(memory, shape) {
    return memory.put(this.types.shape, shape);
  }
  /** The names of the first fields that differ, such as `body 3:17 (sphere) velocity.y`. */
  diff(other, most = 16) {
    return this.bytes('diff', other.handle, most).split('\n').slice(0, -1);
  }
  /** The bytes written by a function that first reports their number, as a string with one
   *  character each. */
  bytes(name, ...words) {
    return String.fromCharCode(...this.data(name, ...words));
  }
  data(name, ...words) {
    const { memory } = this.context.detent;
    const size = this.out2(name, ...words, 0, 0);
    const at = memory.allocate(size + 1);
    try {
      this.out2(name, ...words, at, size);
      return new Uint8Array(memory.exports.memory.buffer, at, size).slice();
    } finally {
      memory.exports.free(at);
    }
  }
  /** Calls f(at, size) with a copy of the bytes. */
  withBytes(bytes, f) {
    const { memory } = this.context.detent;
    const at = memory.allocate(bytes.length + 1);
    try {
      new Uint8Array(memory.exports.memory.buffer, at, bytes.length).set(bytes);
      return f(at, bytes.length);
    } finally {
      memory.exports.free(at);
    }
  }
}

/** Objects and queries over them. */
class Scene extends Held {
  constructor(context, space) {
    super(context, space, 'scene');
    this.create();
  }
  /** The id of a new object, or null if its frame does not exist. */
  add(shape, { layers = 1, user = 0n, fixed = false, frame } = {}) {
    return this.call((memory) => {
      const id = memory.place(8);
      const traits = memory.put('detent_traits', { user, layers, motion: fixed ? 1 : 0, frame });
      return this.run('add', this.shape(memory, shape), traits, id) ? memory.read(id, 'detent_id') : null;
    });
  }
  transform(memory, translation, axis, scale) {
    return memory.put(this.types.transform, { translation, rotation: { axis }, scale });
  }
  /** A frame that carries objects, or null if its parent does not exist. */
  addFrame(translation, axis = this.space.axes, scale = ONE, parent = { index: 0, generation: 0 }) {
    return this.call((memory) => {
      const id = memory.place(8);
      const done = this.run('add_frame', this.transform(memory, translation, axis, scale),
        memory.put('detent_id', parent), id);
      return done ? memory.read(id, 'detent_id') : null;
    });
  }
  moveFrame(frame, translation, axis = this.space.axes, scale = ONE) {
    return this.call((memory) => this.run('move_frame', memory.put('detent_id', frame),
      this.transform(memory, translation, axis, scale)));
  }
  /** False if the frame is not empty. */
  removeFrame(frame) {
    return this.call((memory) => this.run('remove_frame', memory.put('detent_id', frame)));
  }
  replace(id, shape) {
    return this.call((memory) =>
      this.run('replace', memory.put('detent_id', id), this.shape(memory, shape)));
  }
  move(id, by) {
    return this.call((memory) =>
      this.run('move', memory.put('detent_id', id), memory.put(this.types.vec, by)));
  }
  /** { shape, traits } of an object, or null. */
  object(id) {
    return this.call((memory) => {
      const shape = memory.place(layouts[this.types.shape].size);
      const traits = memory.place(layouts.detent_traits.size);
      if (!this.run('object', memory.put('detent_id', id), shape, traits)) return null;
      return { shape: memory.read(shape, this.types.shape), traits: memory.read(traits, 'detent_traits') };
    });
  }
  optimize() {
    this.run('optimize');
  }
  /** Holds the shapes of the world's bodies, with their ids, and nothing else: call it after each step,
   *  or whenever queries are due. */
  follow(world, { sensors = false } = {}) {
    this.run('follow', world.handle, sensors ? 1 : 0);
  }
  /** The first object that the ray touches, or null. */
  raycast(ray, layers = ALL_LAYERS) {
    return this.call((memory) => {
      const hit = memory.place(layouts[this.types.object_hit].size);
      const yes = this.run('raycast', memory.put(this.types.ray, ray), layers, hit);
      return yes ? memory.read(hit, this.types.object_hit) : null;
    });
  }
  raycastAny(ray, layers = ALL_LAYERS) {
    return this.call((memory) => this.run('raycast_any', memory.put(this.types.ray, ray), layers));
  }
  /** All objects that the ray touches, sorted by distance, then id. */
  raycastAll(ray, layers = ALL_LAYERS) {
    return this.call((memory) =>
      this.list('raycast_all', this.types.object_hit, memory.put(this.types.ray, ray), layers));
  }
  /** The first hits of many rays: an Int32Array with the words of one object hit per ray. */
  raycastMany(rays, layers = ALL_LAYERS) {
    const count = rays.length / this.space.rayWords;
    if (!Number.isInteger(count)) throw new RangeError(`a ray has ${this.space.rayWords} numbers`);
    const words = layouts[this.types.object_hit].size / 4;
    return this.context.detent.withWords(rays, count * words, (from, to) =>
      this.run('raycast_many', from, count, layers, to));
  }
  /** The object nearest to a point, or the nearest that a shape overlaps; or null. */
  nearest(question, layers = ALL_LAYERS) {
    return this.call((memory) => {
      const found = memory.place(layouts.detent_found.size);
      const yes = this.run('nearest', this.shape(memory, question), layers, found);
      return yes ? memory.read(found, 'detent_found') : null;
    });
  }
  any(question, layers = ALL_LAYERS) {
    return this.call((memory) => this.run('any', this.shape(memory, question), layers));
  }
  all(question, layers = ALL_LAYERS) {
    return this.call((memory) => this.list('all', 'detent_found', this.shape(memory, question), layers));
  }
  overlaps() {
    return this.list('overlaps', 'detent_pair');
  }
}

/** A scene of a module with characters and casts. */
class SceneWithMovers extends Scene {
  /** The first object that a sphere, AABB, OBB, capsule or segment touches when it moves along a
   *  direction, or null. */
  cast(shape, direction, max_distance, layers = ALL_LAYERS) {
    return this.call((memory) => {
      const hit = memory.place(layouts[this.types.object_hit].size);
      const yes = this.run('cast', ...this.moving(memory, shape, direction, max_distance), layers, hit);
      return yes ? memory.read(hit, this.types.object_hit) : null;
    });
  }
  castAny(shape, direction, max_distance, layers = ALL_LAYERS) {
    return this.call((memory) =>
      this.run('cast_any', ...this.moving(memory, shape, direction, max_distance), layers));
  }
  /** All objects that the moving shape touches, sorted by distance, then id. */
  castAll(shape, direction, max_distance, layers = ALL_LAYERS) {
    return this.call((memory) => this.list('cast_all', this.types.object_hit,
      ...this.moving(memory, shape, direction, max_distance), layers));
  }
  moving(memory, shape, direction, max_distance) {
    return [this.shape(memory, shape), memory.put(this.types.direction, direction), max_distance];
  }
  /** All objects that a frustum such as `space.frustum(camera)` overlaps, sorted by distance from
   *  the center of its near corners, then id. 3D only. */
  visible(frustum, layers = ALL_LAYERS) {
    return this.call((memory) => this.list('frustum_all', 'detent_found',
      memory.put('detent_frustum3', frustum), layers));
  }
  /** A capsule or AABB character. `settings` has fields of a mover's settings. */
  mover(shape, settings = {}) {
    return new Mover(this, shape, settings);
  }
}

/** A character that walks, slides along walls, climbs steps and is carried by frames. `state` is
 *  its whole state, a plain object: keep it, and assign it to go back. */
class Mover {
  #result = null;
  constructor(scene, shape, settings) {
    this.scene = scene;
    this.lastMove = null;
    this.settingsType = `detent_mover${scene.space.dimension}_settings`;
    scene.call((memory) => {
      this.state = memory.read(memory.put(scene.types.mover, { shape }), scene.types.mover);
      const at = memory.place(layouts[this.settingsType].size);
      scene.space.run('mover{N}_default_settings', at);
      this.settings = { ...memory.read(at, this.settingsType), ...settings };
    });
  }
  get isGrounded() {
    return this.state.is_grounded === 1;
  }
  /** The first end of the capsule, or the least corner of the box. */
  get position() {
    const { capsule, aabb } = this.state.shape;
    return capsule ? capsule.a : aabb.min;
  }
  /** Moves by `by`, gravity included, as far as the objects in `layers` other than `ignored` allow.
   *  Returns the displacement; `lastMove` has the details. */
  move(by, { layers = ALL_LAYERS, ignored = { index: 0, generation: 0 } } = {}) {
    const { scene } = this, { types } = scene;
    return scene.call((memory) => {
      const state = memory.put(types.mover, this.state), result = memory.place(layouts[types.move].size);
      scene.space.run('mover{N}_move', scene.context.at, scene.handle, state, memory.put(types.vec, by),
        memory.put(this.settingsType, this.settings), layers, memory.put('detent_id', ignored), result);
      this.state = memory.read(state, types.mover);
      this.#result = memory.read(result, types.move);
      const { count, touched, ...rest } = this.#result;
      this.lastMove = { ...rest, touched: touched.slice(0, count) };
      return [...rest.moved];
    });
  }
  /** The part of a velocity that does not lead into what the last move touched. */
  clip(velocity) {
    const { scene } = this, { types } = scene;
    return scene.call((memory) => {
      const clipped = memory.place(16);
      scene.space.run('mover{N}_clip_velocity', memory.put(types.vec, velocity),
        memory.put(types.move, this.#result ?? {}), clipped);
      return memory.read(clipped, types.vec);
    });
  }
}

/** Bodies that fall, collide and come to rest. */
class World extends Held {
  constructor(context, space, settings) {
    super(context, space, 'world');
    if (settings === null) return;  // the world of a session
    const type = `detent_world${space.dimension}_settings`;
    this.call((memory) => {
      const at = memory.place(layouts[type].size);
      space.run('world{N}_default_settings', at);
      memory.write(at, type, settings);
      this.create(at);
    });
  }
  /** Adds a sphere, AABB, OBB, capsule, or something `placed`: a solid hull, a compound or, in 3D,
   *  a mesh or height field. Options are the fields of a body's options. */
  add(shape, options = {}) {
    const type = `detent_body${this.space.dimension}_options`;
    return this.call((memory) => {
      const at = memory.place(layouts[type].size), id = memory.place(8);
      this.space.run('body{N}_default_options', at);
      memory.write(at, type, options);
      this.run('add', this.shape(memory, shape), at, id);
      return memory.read(id, 'detent_id');
    });
  }
  /** Simulates one tick. */
  step() {
    this.run('step');
  }
  /** The state of a body, or null. */
  body(id) {
    return this.call((memory) => {
      const body = memory.place(layouts[this.types.body].size);
      return this.run('body', memory.put('detent_id', id), body) ? memory.read(body, this.types.body) : null;
    });
  }
  /** The ids of all bodies. */
  bodyIds() {
    return this.list('body_ids', 'detent_id');
  }
  /** The properties of a body, or null. */
  info(id) {
    return this.call((memory) => {
      const info = memory.place(layouts.detent_body_info.size);
      return this.run('info', memory.put('detent_id', id), info) ? memory.read(info, 'detent_body_info') : null;
    });
  }
  /** The body and part of an object of a scene that follows this world, or null. */
  partOf(id) {
    return this.call((memory) => {
      const body = memory.place(8), part = memory.place(4);
      return this.run('part_of', memory.put('detent_id', id), body, part)
        ? { body: memory.read(body, 'detent_id'), part: memory.read(part, 'uint32_t') } : null;
    });
  }
  /** Puts a body elsewhere at once; it keeps its joints. False if no body has this id. */
  setPosition(id, position) {
    return this.call((memory) =>
      this.run('set_position', memory.put('detent_id', id), memory.put(this.types.vec, position)));
  }
  /** Sets the layers of a body and those it collides with. False if no body has this id. */
  setFilter(id, layers, collidesWith) {
    return this.call((memory) => this.run('set_filter', memory.put('detent_id', id), layers, collidesWith));
  }
  setFriction(id, friction) {
    return this.call((memory) => this.run('set_friction', memory.put('detent_id', id), friction));
  }
  setRestitution(id, restitution) {
    return this.call((memory) => this.run('set_restitution', memory.put('detent_id', id), restitution));
  }
  /** Makes a body a sensor or solid. */
  setSensor(id, isSensor) {
    return this.call((memory) => this.run('set_sensor', memory.put('detent_id', id), isSensor ? 1 : 0));
  }
  setGravityScale(id, scale) {
    return this.call((memory) => this.run('set_gravity_scale', memory.put('detent_id', id), scale));
  }
  setDamping(id, linear, angular) {
    return this.call((memory) => this.run('set_damping', memory.put('detent_id', id), linear, angular));
  }
  /** Sets the locked axes: `status.LOCK_X` and so on, added up. */
  setLocked(id, locked) {
    return this.call((memory) => this.run('set_locked', memory.put('detent_id', id), locked));
  }
  setFast(id, isFast) {
    return this.call((memory) => this.run('set_fast', memory.put('detent_id', id), isFast ? 1 : 0));
  }
  /** Sets the user word of a body; wakes nothing. */
  setUser(id, user) {
    return this.call((memory) => this.run('set_user', memory.put('detent_id', id), BigInt(user)));
  }
  /** Sets the gravity of the world and wakes all bodies. */
  setGravity(gravity) {
    this.call((memory) => this.run('set_gravity', memory.put(this.types.vec, gravity)));
  }
  /** Turns a body about its center at once; it keeps its joints. */
  setRotation(id, axis) {
    return this.call((memory) =>
      this.run('set_rotation', memory.put('detent_id', id), memory.put(this.types.rotation, { axis })));
  }
  setVelocity(id, velocity) {
    return this.call((memory) =>
      this.run('set_velocity', memory.put('detent_id', id), memory.put(this.types.vec, velocity)));
  }
  /** Three numbers in 3D, one in 2D. */
  setAngularVelocity(id, velocity) {
    return this.turn('set_angular_velocity', id, velocity);
  }
  /** Applies an impulse at a world point, by default at the center of mass. */
  applyImpulse(id, impulse, at) {
    return this.push('apply_impulse', id, impulse, at);
  }
  /** Applies a force during the next step. */
  applyForce(id, force, at) {
    return this.push('apply_force', id, force, at);
  }
  /** Applies a torque during the next step; three numbers in 3D, one in 2D. */
  applyTorque(id, torque) {
    return this.turn('apply_torque', id, torque);
  }
  push(name, id, how, at) {
    return this.call((memory) =>
      this.run(name, memory.put('detent_id', id), memory.put(this.types.vec, how),
        at ? memory.put(this.types.vec, at) : 0));
  }
  turn(name, id, numbers) {
    return this.call((memory) => {
      const to = memory.place(12);
      numbers.forEach((one, i) => memory.write(to + 4 * i, 'int32_t', one));
      return this.run(name, memory.put('detent_id', id), to);
    });
  }
  joint_(kind, a, b, fields) {
    return this.call((memory) => {
      const at = memory.place(layouts[this.types.joint].size);
      this.space.run('joint{N}_defaults', kind, at);
      memory.write(at, this.types.joint, { ...fields, a, b });
      return memory.read(at, this.types.joint);
    });
  }
  /** Joins two bodies. `kind` is one of `joints`, `fields` are some of a joint's. Returns its id,
   *  or null if a body does not exist. */
  addJoint(kind, a, b, fields = {}) {
    const joint = this.joint_(kind, a, b, fields);
    return this.call((memory) => {
      const id = memory.place(8);
      return this.run('add_joint', memory.put(this.types.joint, joint), id)
        ? memory.read(id, 'detent_id') : null;
    });
  }
  /** Replaces a joint by another of the same kind, such as `joint(id)` with another motor. */
  changeJoint(id, joint) {
    return this.call((memory) =>
      this.run('change_joint', memory.put('detent_id', id), memory.put(this.types.joint, joint)));
  }
  removeJoint(id) {
    return this.call((memory) => this.run('remove_joint', memory.put('detent_id', id)));
  }
  /** The fields of a joint, or null. */
  joint(id) {
    return this.call((memory) => {
      const at = memory.place(layouts[this.types.joint].size);
      return this.run('joint', memory.put('detent_id', id), at) ? memory.read(at, this.types.joint) : null;
    });
  }
  /** The force of a joint on its body b in the last step. Null without the joint. */
  jointForce(id) {
    return this.call((memory) => {
      const force = memory.place(16);
      const done = this.run('joint_force', memory.put('detent_id', id), force);
      return done ? memory.read(force, this.types.vec) : null;
    });
  }
  /** The torque of a joint on its body b in the last step: three numbers in 3D, one in 2D. Null without
   *  the joint. */
  jointTorque(id) {
    return this.call((memory) => {
      const torque = memory.place(12), length = this.space.dimension === 2 ? 1 : 3;
      const done = this.run('joint_torque', memory.put('detent_id', id), torque);
      return done ? Array.from({ length }, (_, i) => memory.read(torque + 4 * i, 'int32_t')) : null;
    });
  }
  /** The ids of all joints. */
  jointIds() {
    return this.list('joint_ids', 'detent_id');
  }
  /** The joints that broke in the last step. */
  broken() {
    return this.list('broken', 'detent_id');
  }
  /** Converts a world point to a body's frame, for the anchor of a joint. Null without the body. */
  localPoint(id, point) {
    return this.call((memory) => {
      const local = memory.place(16);
      const done = this.run('local_point', memory.put('detent_id', id),
        memory.put(this.types.vec, point), local);
      return done ? memory.read(local, this.types.vec) : null;
    });
  }
  /** Converts world axes to a body's frame, for the frame of a joint. Null without the body. */
  localFrame(id, axis) {
    return this.call((memory) => {
      const local = memory.place(layouts[this.types.rotation].size);
      const done = this.run('local_frame', memory.put('detent_id', id),
        memory.put(this.types.rotation, { axis }), local);
      return done ? memory.read(local, this.types.rotation).axis : null;
    });
  }
  /** The frame in which a compound's parts or a hull's points were given. */
  frame(id) {
    return this.call((memory) => {
      const frame = memory.place(layouts[this.types.transform].size);
      const done = this.run('frame', memory.put('detent_id', id), frame);
      return done ? memory.read(frame, this.types.transform) : null;
    });
  }
  /** The pairs that touch, of one body or of all. */
  touching(id = { index: 0, generation: 0 }) {
    return this.listOf('touching', 'detent_touch', id);
  }
  /** The contacts that touch, of one body or of all; none of sensors. */
  contacts(id = { index: 0, generation: 0 }) {
    return this.listOf('contacts', `detent_world${this.space.dimension}_contact`, id)
      .map(({ count, points, ...rest }) => ({ ...rest, points: points.slice(0, count) }));
  }
  listOf(name, type, id) {
    const { memory } = this.context.detent;
    const at = memory.allocate(8);
    try {
      memory.write(at, 'detent_id', id);
      return this.list(name, type, at);
    } finally {
      memory.exports.free(at);
    }
  }
  /** The pairs that began or ceased to touch in the last step. */
  events() {
    return this.list('events', 'detent_touch');
  }
}

/** The world of a session or replay. It can be changed only during a frame. */
class PlayedWorld extends World {
  constructor(owner, wordCount) {
    super(owner.context, owner.space, null);
    this.handle = owner.out('world', 'uint32_t');
    this.wordCount = wordCount;
  }
  /** Other game state that a rollback restores: unsigned 32-bit numbers, initially 0. */
  get words() {
    return this.call((memory) => {
      const at = memory.place(4 * this.wordCount);
      this.run('words', at);
      return Array.from({ length: this.wordCount }, (_, i) => memory.read(at + 4 * i, 'uint32_t'));
    });
  }
  set words(values) {
    if (values.length !== this.wordCount) throw new RangeError(`there are ${this.wordCount} words`);
    this.call((memory) => {
      const at = memory.place(4 * this.wordCount);
      values.forEach((value, i) => memory.write(at + 4 * i, 'uint32_t', value));
      this.run('set_words', at);
    });
  }
}

/** The common base of sessions and replays. */
class Played extends Held {
  setUp(inputSize, wordCount) {
    this.inputSize = inputSize;
    this.world = new PlayedWorld(this, wordCount);
  }
  /** Opens the next frame; null if there is none. */
  open(...before) {
    return this.call((memory) => {
      const at = memory.place(layouts.detent_frame.size);
      const inputs = memory.place(constants.PLAYERS * this.inputSize);
      const yes = this.run('begin_frame', ...before, at, inputs);
      const { number, players, present, state } = memory.read(at, 'detent_frame');
      this.state = state;
      if (!yes) return null;
      const bytes = new Uint8Array(memory.exports.memory.buffer, inputs, players * this.inputSize).slice();
      return { number, inputs: Array.from({ length: players }, (_, i) => ((present >> i) & 1
        ? bytes.subarray(i * this.inputSize, (i + 1) * this.inputSize) : null)) };
    });
  }
}

/** A network match. A frame that throws an exception is played again. */
class Session extends Played {
  constructor(context, space, start, settings) {
    super(context, space, 'session');
    const type = 'detent_session_settings';
    this.call((memory) => {
      const at = memory.place(layouts[type].size);
      context.detent.run('session_default_settings', at);
      memory.write(at, type, settings);
      this.create(at, start.handle);
      const given = memory.read(at, type);
      this.setUp(given.input_size, given.words);
    });
    this.state = constants.CONNECTING;
  }
  /** The frames to simulate now; the new one uses the input `pad`, a Uint8Array. `state` says why
   *  there are no more. */
  * frames(pad) {
    if (pad.length !== this.inputSize) throw new RangeError(`an input has ${this.inputSize} bytes`);
    for (;;) {
      const frame = this.withBytes(pad, (at) => this.open(at));
      if (!frame) return;
      yield frame;
      this.run('end_frame');
    }
  }
  /** Takes a packet that arrived at a time in microseconds; false if it was not used. */
  receive(peer, packet, now) {
    return this.withBytes(packet, (at, size) => this.run('receive', peer, at, size, BigInt(now)));
  }
  /** The packets due to be sent: { peer, bytes }. */
  packets(now) {
    const { memory } = this.context.detent;
    const room = memory.allocate(constants.PACKET), list = [];
    try {
      return this.call(() => {
        const peer = memory.place(4), size = memory.place(4);
        while (this.run('packet', BigInt(now), peer, room, constants.PACKET, size)) {
          const bytes = new Uint8Array(memory.exports.memory.buffer, room, memory.read(size, 'uint32_t'));
          list.push({ peer: memory.read(peer, 'uint32_t'), bytes: bytes.slice() });
        }
        return list;
      });
    } finally {
      memory.exports.free(room);
    }
  }
  /** The next event: { kind, peer, frame, field, object }, or null. */
  event() {
    return this.call((memory) => {
      const at = memory.place(layouts.detent_session_event.size), name = memory.place(constants.NAME);
      if (!this.run('event', at, name, constants.NAME)) return null;
      const { kind, peer, frame, name_size, has_object, object } = memory.read(at, 'detent_session_event');
      const field = String.fromCharCode(...new Uint8Array(memory.exports.memory.buffer, name, name_size));
      return { kind, peer, frame, field, object: has_object ? object : null };
    });
  }
  /** The progress: frame, final_frame, digest and others. */
  get status() {
    return this.call((memory) => {
      const at = memory.place(layouts.detent_session_status.size);
      this.run('status', at);
      return memory.read(at, 'detent_session_status');
    });
  }
  /** The number of frames known to be equal at the peer and here. */
  matched(peer) {
    return this.out2('matched', peer);
  }
  isAwaited(player) {
    return this.run('is_awaited', player);
  }
  drop(peer) {
    this.run('drop', peer);
  }
  pause(isPaused = true) {
    this.run('pause', isPaused ? 1 : 0);
  }
  /** The replay of all final frames, or null if none is recorded (`replay_every`). */
  replay() {
    const bytes = this.data('replay');
    return bytes.length === 0 ? null : bytes;
  }
}

/** A replay to resimulate. */
class Replay extends Played {
  constructor(context, space, bytes, start, inputSize, wordCount) {
    super(context, space, 'replay');
    this.withBytes(bytes, (at, size) => this.create(at, size, start.handle, inputSize, wordCount));
    this.setUp(inputSize, wordCount);
  }
  /** All its frames, up to the first digest that differs. */
  * frames() {
    for (let frame = this.open(); frame; frame = this.open()) {
      yield frame;
      this.run('end_frame');
    }
  }
  /** The result of the resimulation so far. */
  check() {
    return this.call((memory) => {
      const at = memory.place(layouts.detent_replay_check.size);
      this.run('check', at);
      return memory.read(at, 'detent_replay_check');
    });
  }
}
