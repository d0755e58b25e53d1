// SPDX-License-Identifier: MIT
// Written by bindings/generate from bindings/detent.h.in: change that file instead.

export declare const OK: 1;
export declare const NO: 0;
export declare const BAD_ARGUMENT: -1;
export declare const BAD_CONTEXT: -2;
export declare const BAD_HANDLE: -3;
export declare const NOT_UNIT: -4;
export declare const NO_QUERY: -5;
export declare const NO_MEMORY: -6;
export declare const BROKEN: -7;
export declare const FULL: -8;
export declare const IN_USE: -9;
export declare const NOT_NOW: -10;
export declare const NO_SNAPSHOT: -20;
export declare const OTHER_VERSION: -21;
export declare const TRUNCATED: -22;
export declare const CORRUPTED: -23;
export declare const OTHER_SCENE: -24;
export declare const OTHER_FIXED_PART: -25;
export declare const NO_ROOM: -26;
export declare const UNKNOWN_ASSET: -27;
export declare const OTHER_ASSET: -28;
export declare const SPHERE: 1;
export declare const AABB: 2;
export declare const OBB: 3;
export declare const PLANE: 4;
export declare const TRIANGLE: 5;
export declare const CAPSULE: 6;
export declare const SEGMENT: 7;
export declare const POINT: 8;
export declare const HULL: 9;
export declare const MESH: 10;
export declare const HEIGHT_FIELD: 11;
export declare const COMPOUND: 12;
export declare const MOVING: 0;
export declare const FIXED: 1;
export declare const DYNAMIC_BODY: 0;
export declare const KINEMATIC_BODY: 1;
export declare const FIXED_BODY: 2;
export declare const DISTANCE_JOINT: 1;
export declare const BALL_JOINT: 2;
export declare const HINGE_JOINT: 3;
export declare const WELD_JOINT: 4;
export declare const SLIDER_JOINT: 5;
export declare const WHEEL_JOINT: 6;
export declare const LOCK_X: 1;
export declare const LOCK_Y: 2;
export declare const LOCK_Z: 4;
export declare const LOCK_TURN_X: 8;
export declare const LOCK_TURN_Y: 16;
export declare const LOCK_TURN_Z: 32;
export declare const PLAYED: 0;
export declare const CONNECTING: 1;
export declare const CATCHING_UP: 2;
export declare const STARVED: 3;
export declare const AHEAD: 4;
export declare const PAUSED: 5;
export declare const OVER: 6;
export declare const JOINING: 7;
export declare const CONNECTED: 0;
export declare const SILENT: 1;
export declare const HEARD_AGAIN: 2;
export declare const PEER_PAUSED: 3;
export declare const PEER_RESUMED: 4;
export declare const DROPPED: 5;
export declare const EXPELLED: 6;
export declare const LEFT: 7;
export declare const TOO_SLOW: 8;
export declare const CONTRADICTION: 9;
export declare const DESYNC: 10;
export declare const DESYNC_FIELD: 11;
export declare const ARRIVED: 12;
export declare const LOADED: 13;
export declare const NO_SUCH_WORLD: 14;
export declare const JOINED: 15;
export declare const REPLAY_WHOLE: 0;
export declare const REPLAY_CUT: 1;
export declare const REPLAY_CORRUPTED: 2;
export declare const INPUT: 16;
export declare const PACKET: 1200;
export declare const LATE_SNAPSHOT: 65536;
export declare const NAME: 119;
export declare const WORDS: 256;
export declare const PLAYERS: 8;

/** An object of a scene or a body of a world. No two have the same id, ever; {0, 0} is none. */
export interface Id {
  index: number;
  generation: number;
}

/** Two objects or bodies. */
export interface Pair {
  first: Id;
  second: Id;
}

/** A pair of bodies that began (1) or ended (0) to touch in the last step; of compounds a pair of parts. */
export interface Touch {
  a: Id;
  b: Id;
  begins: number;
  part_a: number;
  part_b: number;
}

/** An object that a query found, and its distance in steps of 2^-16. */
export interface Found {
  distance: number;
  id: Id;
}

/** When two moving shapes meet. They are apart before `time`, in steps of 2^-30, and at most `distance` apart at it. If `is_hit` is 0, the search ended early, and whether they meet later is not known. */
export interface Impact {
  time: number;
  distance: number;
  is_hit: number;
}

/** A match and one peer in it. Times are in microseconds, of a clock that only this peer needs. */
export interface SessionSettings {
  match: bigint;
  send_interval: bigint;
  silence: bigint;
  self: number;
  players: number;
  spectators: number;
  delay: number;
  prediction: number;
  frames_per_call: number;
  absent: number;
  life: number;
  wants_seat: number;
  input_size: number;
  words: number;
  replay_every: number;
}

/** A frame to simulate, or why there is none. Players whose bit is set in `present` take part. */
export interface Frame {
  number: number;
  players: number;
  present: number;
  state: number;
}

/** Something that happened in a session, with a peer or in a frame. */
export interface SessionEvent {
  kind: number;
  peer: number;
  frame: number;
  name_size: number;
  has_object: number;
  object: Id;
}

/** How far a session is. */
export interface SessionStatus {
  digest: bigint;
  resimulated: bigint;
  frame: number;
  final_frame: number;
  checked_frame: number;
  start_frame: number;
  is_player: number;
  players: number;
}

/** What simulating a replay again gave so far. */
export interface ReplayCheck {
  state: number;
  frames: number;
  equal: number;
  is_equal: number;
  players: number;
}

/** What a scene stores with an object. */
export interface Traits {
  user: bigint;
  layers: number;
  motion: number;
  frame: Id;
}

/** Everything else is made in a context, which is the caller's memory: set it to zeros, open it, close it. It must stay where it is while it is open. Contexts share nothing. Of one context, calls that only read (their context is const) may run in several threads at once; all others need it alone. */
export interface Context {
  words: bigint[];
}

/** A point or vector, in steps of 2^-16. */
export type Vec2 = [number, number];

/** A unit vector, in steps of 2^-30; used exactly as stored. */
export type Direction2 = [number, number];

/** The axes of a frame in the world. */
export interface Rotation2 {
  axis: Direction2[];
}

/** p -> translation + scale * rotation * p; `scale` in steps of 2^-16. */
export interface Transform2 {
  translation: Vec2;
  rotation: Rotation2;
  scale: number;
}

/** The points origin + t * direction with 0 <= t <= max_distance. */
export interface Ray2 {
  origin: Vec2;
  direction: Direction2;
  max_distance: number;
}

/** The points within `radius` of `center`; none if the radius is negative. */
export interface Sphere2 {
  center: Vec2;
  radius: number;
}

/** The points between two corners; none if min > max on an axis. */
export interface Aabb2 {
  min: Vec2;
  max: Vec2;
}

/** A box turned about its center; none if a half extent is negative. */
export interface Obb2 {
  center: Vec2;
  half_extents: Vec2;
  rotation: Rotation2;
}

/** The points x with dot(normal, x) = offset. */
export interface Plane2 {
  normal: Direction2;
  offset: number;
}

/** The points between three corners. */
export interface Triangle2 {
  a: Vec2;
  b: Vec2;
  c: Vec2;
}

/** The points within `radius` of the segment from a to b; none if the radius is negative. */
export interface Capsule2 {
  a: Vec2;
  b: Vec2;
  radius: number;
}

/** The points between two ends. */
export interface Segment2 {
  start: Vec2;
  end: Vec2;
}

/** A shape of any kind: `kind` says which member is set. `asset` is the handle of a hull, mesh or height field, and ignored for other kinds. */
export interface Shape2 {
  kind: number;
  asset: number;
  sphere?: Sphere2;
  aabb?: Aabb2;
  obb?: Obb2;
  plane?: Plane2;
  triangle?: Triangle2;
  capsule?: Capsule2;
  segment?: Segment2;
  point?: Vec2;
  placed?: Transform2;
}

/** Where a ray or a moving shape first touches a shape. The distance is rounded down. */
export interface Hit2 {
  distance: number;
  point: Vec2;
  normal: Direction2;
}

/** One point of a contact, on the surface of the first shape, and how deep the second shape is there: its surface is at point - depth * normal. `feature` names the corners, edges or faces that meet, and stays the same while they do. */
export interface ContactPoint2 {
  point: Vec2;
  depth: number;
  feature: number;
}

/** How two shapes a and b that overlap are separated by the least translation: b moves by `depth`, rounded up, along `normal`, which points from a to b. The first `count` points are set, the others zeros. */
export interface Manifold2 {
  normal: Direction2;
  depth: number;
  count: number;
  points: ContactPoint2[];
}

/** The motion of a frame from one pose to another, over the time from 0 to 1: its origin goes evenly, and it turns about one axis by at most half a turn. */
export interface Sweep2 {
  start: Vec2;
  end: Vec2;
  start_rotation: Rotation2;
  end_rotation: Rotation2;
}

/** Where a ray first touches an object; in a mesh or height field also the index of the triangle. */
export interface ObjectHit2 {
  distance: number;
  id: Id;
  point: Vec2;
  normal: Direction2;
  triangle: number;
  has_triangle: number;
}

/** A character: a capsule or AABB that walks, and what it stands on. It is all of its state. Set it to zeros and the shape to where it starts; zeros in `is_grounded` let it leave the ground. A ball is a capsule whose ends are equal. */
export interface Mover2 {
  shape: Shape2;
  is_grounded: number;
  object: Id;
  normal: Direction2;
  frame: Id;
  local: Vec2;
  point: Vec2;
}

/** How a character moves. Lengths in steps of 2^-16. */
export interface Mover2Settings {
  up: Direction2;
  skin: number;
  step_height: number;
  snap_distance: number;
  max_slope: number;
}

/** Something that a character touched during a move; the normal points away from it. */
export interface Mover2Touch {
  object: Id;
  point: Vec2;
  normal: Direction2;
}

/** What a move did. The first `count` of the touches are set, the others zeros. */
export interface Move2 {
  moved: Vec2;
  carried: Vec2;
  pushed: Vec2;
  count: number;
  is_stuck: number;
  touched: Mover2Touch[];
}

/** How a world steps. Lengths and speeds in steps of 2^-16. */
export interface World2Settings {
  ticks_per_second: number;
  substeps: number;
  gravity: Vec2;
  margin: number;
  push_speed: number;
  bounce_threshold: number;
  sleep_speed: number;
}

/** What a body is made of, and how it starts. Shares and densities in steps of 2^-16. */
export interface Body2Options {
  user: bigint;
  layers: number;
  collides_with: number;
  motion: number;
  density: number;
  friction: number;
  restitution: number;
  linear_damping: number;
  angular_damping: number;
  velocity: Vec2;
  angular_velocity: number[];
  gravity_scale: number;
  locked: number;
  is_sensor: number;
  is_fast: number;
  reserved: number[];
}

/** A part of a compound: a sphere, AABB, OBB, capsule or solid hull in the compound's frame, and what it is made of, in steps of 2^-16. Start from `detent_part2_defaults`. */
export interface Part2 {
  shape: Shape2;
  density: number;
  friction: number;
  restitution: number;
  is_sensor: number;
}

/** A joint of two bodies a and b. Anchors and frames are in the frames of their bodies. Seconds are those of the world's settings, angles radians; all numbers in steps of 2^-16. A kind that does not have a field ignores it. */
export interface Joint2 {
  kind: number;
  a: Id;
  b: Id;
  anchor_a: Vec2;
  anchor_b: Vec2;
  frame_a: Rotation2;
  frame_b: Rotation2;
  collide: number;
  break_force: number;
  has_limits: number;
  lower: number;
  upper: number;
  motor_speed: number;
  motor_force: number;
  length: number;
  frequency: number;
  damping_ratio: number;
}

/** Where a body is and how it moves, rounded to nearest. */
export interface Body2 {
  position: Vec2;
  rotation: Rotation2;
  velocity: Vec2;
  angular_velocity: number[];
  is_asleep: number;
}

/** A point or vector, in steps of 2^-16. */
export type Vec3 = [number, number, number];

/** A unit vector, in steps of 2^-30; used exactly as stored. */
export type Direction3 = [number, number, number];

/** The axes of a frame in the world. */
export interface Rotation3 {
  axis: Direction3[];
}

/** p -> translation + scale * rotation * p; `scale` in steps of 2^-16. */
export interface Transform3 {
  translation: Vec3;
  rotation: Rotation3;
  scale: number;
}

/** The points origin + t * direction with 0 <= t <= max_distance. */
export interface Ray3 {
  origin: Vec3;
  direction: Direction3;
  max_distance: number;
}

/** The points within `radius` of `center`; none if the radius is negative. */
export interface Sphere3 {
  center: Vec3;
  radius: number;
}

/** The points between two corners; none if min > max on an axis. */
export interface Aabb3 {
  min: Vec3;
  max: Vec3;
}

/** A box turned about its center; none if a half extent is negative. */
export interface Obb3 {
  center: Vec3;
  half_extents: Vec3;
  rotation: Rotation3;
}

/** The points x with dot(normal, x) = offset. */
export interface Plane3 {
  normal: Direction3;
  offset: number;
}

/** The points between three corners. */
export interface Triangle3 {
  a: Vec3;
  b: Vec3;
  c: Vec3;
}

/** The points within `radius` of the segment from a to b; none if the radius is negative. */
export interface Capsule3 {
  a: Vec3;
  b: Vec3;
  radius: number;
}

/** The points between two ends. */
export interface Segment3 {
  start: Vec3;
  end: Vec3;
}

/** A shape of any kind: `kind` says which member is set. `asset` is the handle of a hull, mesh or height field, and ignored for other kinds. */
export interface Shape3 {
  kind: number;
  asset: number;
  sphere?: Sphere3;
  aabb?: Aabb3;
  obb?: Obb3;
  plane?: Plane3;
  triangle?: Triangle3;
  capsule?: Capsule3;
  segment?: Segment3;
  point?: Vec3;
  placed?: Transform3;
}

/** Where a ray or a moving shape first touches a shape. The distance is rounded down. */
export interface Hit3 {
  distance: number;
  point: Vec3;
  normal: Direction3;
}

/** One point of a contact, on the surface of the first shape, and how deep the second shape is there: its surface is at point - depth * normal. `feature` names the corners, edges or faces that meet, and stays the same while they do. */
export interface ContactPoint3 {
  point: Vec3;
  depth: number;
  feature: number;
}

/** How two shapes a and b that overlap are separated by the least translation: b moves by `depth`, rounded up, along `normal`, which points from a to b. The first `count` points are set, the others zeros. */
export interface Manifold3 {
  normal: Direction3;
  depth: number;
  count: number;
  points: ContactPoint3[];
}

/** The motion of a frame from one pose to another, over the time from 0 to 1: its origin goes evenly, and it turns about one axis by at most half a turn. */
export interface Sweep3 {
  start: Vec3;
  end: Vec3;
  start_rotation: Rotation3;
  end_rotation: Rotation3;
}

/** Where a ray first touches an object; in a mesh or height field also the index of the triangle. */
export interface ObjectHit3 {
  distance: number;
  id: Id;
  point: Vec3;
  normal: Direction3;
  triangle: number;
  has_triangle: number;
}

/** A character: a capsule or AABB that walks, and what it stands on. It is all of its state. Set it to zeros and the shape to where it starts; zeros in `is_grounded` let it leave the ground. A ball is a capsule whose ends are equal. */
export interface Mover3 {
  shape: Shape3;
  is_grounded: number;
  object: Id;
  normal: Direction3;
  frame: Id;
  local: Vec3;
  point: Vec3;
}

/** How a character moves. Lengths in steps of 2^-16. */
export interface Mover3Settings {
  up: Direction3;
  skin: number;
  step_height: number;
  snap_distance: number;
  max_slope: number;
}

/** Something that a character touched during a move; the normal points away from it. */
export interface Mover3Touch {
  object: Id;
  point: Vec3;
  normal: Direction3;
}

/** What a move did. The first `count` of the touches are set, the others zeros. */
export interface Move3 {
  moved: Vec3;
  carried: Vec3;
  pushed: Vec3;
  count: number;
  is_stuck: number;
  touched: Mover3Touch[];
}

/** How a world steps. Lengths and speeds in steps of 2^-16. */
export interface World3Settings {
  ticks_per_second: number;
  substeps: number;
  gravity: Vec3;
  margin: number;
  push_speed: number;
  bounce_threshold: number;
  sleep_speed: number;
}

/** What a body is made of, and how it starts. Shares and densities in steps of 2^-16. */
export interface Body3Options {
  user: bigint;
  layers: number;
  collides_with: number;
  motion: number;
  density: number;
  friction: number;
  restitution: number;
  linear_damping: number;
  angular_damping: number;
  velocity: Vec3;
  angular_velocity: number[];
  gravity_scale: number;
  locked: number;
  is_sensor: number;
  is_fast: number;
  reserved: number[];
}

/** A part of a compound: a sphere, AABB, OBB, capsule or solid hull in the compound's frame, and what it is made of, in steps of 2^-16. Start from `detent_part3_defaults`. */
export interface Part3 {
  shape: Shape3;
  density: number;
  friction: number;
  restitution: number;
  is_sensor: number;
}

/** A joint of two bodies a and b. Anchors and frames are in the frames of their bodies. Seconds are those of the world's settings, angles radians; all numbers in steps of 2^-16. A kind that does not have a field ignores it. */
export interface Joint3 {
  kind: number;
  a: Id;
  b: Id;
  anchor_a: Vec3;
  anchor_b: Vec3;
  frame_a: Rotation3;
  frame_b: Rotation3;
  collide: number;
  break_force: number;
  has_limits: number;
  lower: number;
  upper: number;
  motor_speed: number;
  motor_force: number;
  length: number;
  frequency: number;
  damping_ratio: number;
}

/** Where a body is and how it moves, rounded to nearest. */
export interface Body3 {
  position: Vec3;
  rotation: Rotation3;
  velocity: Vec3;
  angular_velocity: number[];
  is_asleep: number;
}

/** A camera: where it is and what its lens sees. The pose is that of `detent_camera3_look_at`: axis 0 to the right, axis 1 up, looking along -axis 2; its scale is ignored. */
export interface Camera3 {
  pose: Transform3;
  has_perspective: number;
  fov: number;
  aspect: number;
  half_width: number;
  half_height: number;
  near_distance: number;
  far_distance: number;
}

/** What a camera sees: the convex hull of eight corners. Corner i is on the right if i & 1, at the top if i & 2, and far if i & 4; every query is exact for eight points in any order. */
export interface Frustum3 {
  corners: Vec3[];
}

/** A point of the screen: pixels from the top left corner in steps of 2^-16, so that 32768 is the middle of the first, and the depth along the line of sight, a length. */
export interface ScreenPoint3 {
  x: number;
  y: number;
  depth: number;
}
