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
export declare const CONE_JOINT: 7;
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

/** The id of an object of a scene or a body of a world. Ids are never reused; {0, 0} is none. */
export interface Id {
  index: number;
  generation: number;
}

/** Two objects or bodies. */
export interface Pair {
  first: Id;
  second: Id;
}

/** A pair of bodies that began (1) or ceased (0) to touch in the last step; for compounds, a pair of parts. */
export interface Touch {
  a: Id;
  b: Id;
  begins: number;
  part_a: number;
  part_b: number;
}

/** The properties of a body. */
export interface BodyInfo {
  user: bigint;
  layers: number;
  collides_with: number;
  motion: number;
  is_sensor: number;
  is_asleep: number;
  part_count: number;
}

/** An object found by a query, and its distance in steps of 2^-16. */
export interface Found {
  distance: number;
  id: Id;
}

/** When two moving shapes meet. They are disjoint before `time` (in steps of 2^-30) and at most `distance` apart at `time`. If `is_hit` is 0 the search ended early, and whether they meet later is unknown. */
export interface Impact {
  time: number;
  distance: number;
  is_hit: number;
}

/** The settings of a match and of one peer. Times are in microseconds of this peer's own clock. */
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

/** A frame to simulate, or the reason why there is none. Players whose bit in `present` is set take part. */
export interface Frame {
  number: number;
  players: number;
  present: number;
  state: number;
}

/** An event of a session. */
export interface SessionEvent {
  kind: number;
  peer: number;
  frame: number;
  name_size: number;
  has_object: number;
  object: Id;
}

/** The progress of a session. */
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

/** The result of resimulating a replay so far. */
export interface ReplayCheck {
  state: number;
  frames: number;
  equal: number;
  is_equal: number;
  players: number;
}

/** What a scene stores with an object, besides its shape. */
export interface Traits {
  user: bigint;
  layers: number;
  motion: number;
  frame: Id;
}

/** The owner of everything else. The caller provides its memory: zero it, open it and close it, and do not move it while it is open. Contexts share nothing. On one context, functions that only read (const detent_context*) may run in several threads at once; any other call needs exclusive access. */
export interface Context {
  words: bigint[];
}

/** A point or vector, in steps of 2^-16. */
export type Vec2 = [number, number];

/** A unit vector, in steps of 2^-30; used as stored, never normalised. */
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

/** The points between two corners, inclusive; none if min > max on an axis. */
export interface Aabb2 {
  min: Vec2;
  max: Vec2;
}

/** A box rotated about its center; none if a half extent is negative. */
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

/** The points of the triangle with these corners. */
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

/** The points between the two ends. */
export interface Segment2 {
  start: Vec2;
  end: Vec2;
}

/** A shape of any kind. `kind` selects the member of the union. `asset` is the handle of a hull, mesh or height field; other kinds ignore it. */
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

/** The first contact of a ray or moving shape with a shape. The distance is rounded down. */
export interface Hit2 {
  distance: number;
  point: Vec2;
  normal: Direction2;
}

/** One contact point on the surface of the first shape. The second shape's surface is at point - depth * normal. `feature` identifies the corners, edges or faces that meet, and is stable while they do. */
export interface ContactPoint2 {
  point: Vec2;
  depth: number;
  feature: number;
}

/** The least translation that separates two overlapping shapes a and b: move b by `depth`, rounded up, along `normal`, which points from a to b. The first `count` points are set, the others are zero. */
export interface Manifold2 {
  normal: Direction2;
  depth: number;
  count: number;
  points: ContactPoint2[];
}

/** The motion of a frame between two poses over the time 0 to 1. The origin moves at constant velocity; the frame rotates about one axis by at most half a turn. */
export interface Sweep2 {
  start: Vec2;
  end: Vec2;
  start_rotation: Rotation2;
  end_rotation: Rotation2;
}

/** The first point where a ray touches an object; for a mesh or height field also the triangle's index. */
export interface ObjectHit2 {
  distance: number;
  id: Id;
  point: Vec2;
  normal: Direction2;
  triangle: number;
  has_triangle: number;
}

/** A walking character: its capsule or AABB, and what it stands on. This is its whole state. Start with zeros and the shape in place. Setting `is_grounded` to 0 makes it leave the ground. A ball is a capsule with equal ends. */
export interface Mover2 {
  shape: Shape2;
  is_grounded: number;
  object: Id;
  normal: Direction2;
  frame: Id;
  local: Vec2;
  point: Vec2;
}

/** Settings of a character's movement. Lengths in steps of 2^-16. */
export interface Mover2Settings {
  up: Direction2;
  skin: number;
  step_height: number;
  snap_distance: number;
  max_slope: number;
}

/** Something the character touched during a move. The normal points away from it. */
export interface Mover2Touch {
  object: Id;
  point: Vec2;
  normal: Direction2;
}

/** The result of a move. The first `count` touches are set, the others are zero. */
export interface Move2 {
  moved: Vec2;
  carried: Vec2;
  pushed: Vec2;
  count: number;
  is_stuck: number;
  touched: Mover2Touch[];
}

/** A point at which two bodies touch. Lengths and impulses in steps of 2^-16. */
export interface World2ContactPoint {
  point: Vec2;
  separation: number;
  impulse: number;
  feature: number;
}

/** The contact of two bodies; for compounds that of two parts, for meshes and height fields that of one triangle. The first `count` points are set, the others are zero. Impulses act on b; a gets the opposite. They are those of the last substep, in units of mass times units per second. */
export interface World2Contact {
  a: Id;
  b: Id;
  part_a: number;
  part_b: number;
  triangle: number;
  normal: Direction2;
  impulse: number;
  friction: Vec2;
  count: number;
  points: World2ContactPoint[];
}

/** Settings of a world. Lengths and speeds in steps of 2^-16. */
export interface World2Settings {
  ticks_per_second: number;
  substeps: number;
  gravity: Vec2;
  margin: number;
  push_speed: number;
  bounce_threshold: number;
  sleep_speed: number;
  hold_distance: number;
}

/** The material and initial state of a body. Ratios and densities in steps of 2^-16. */
export interface Body2Options {
  user: bigint;
  layers: number;
  collides_with: number;
  motion: number;
  density: number;
  friction: number;
  restitution: number;
  rolling_resistance: number;
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

/** A part of a compound: a sphere, AABB, OBB, capsule or solid hull in the compound's frame, and its material, in steps of 2^-16. Start from `detent_part2_defaults`. */
export interface Part2 {
  shape: Shape2;
  density: number;
  friction: number;
  restitution: number;
  rolling_resistance: number;
  is_sensor: number;
}

/** A joint between two bodies a and b. Anchors and frames are in body space. Time is in the seconds of the world's settings, angles in radians, and all numbers are in steps of 2^-16. Fields that a kind does not have are ignored. */
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
  cone_angle: number;
}

/** The state of a body, rounded to nearest. */
export interface Body2 {
  position: Vec2;
  rotation: Rotation2;
  velocity: Vec2;
  angular_velocity: number[];
  is_asleep: number;
}

/** A point or vector, in steps of 2^-16. */
export type Vec3 = [number, number, number];

/** A unit vector, in steps of 2^-30; used as stored, never normalised. */
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

/** The points between two corners, inclusive; none if min > max on an axis. */
export interface Aabb3 {
  min: Vec3;
  max: Vec3;
}

/** A box rotated about its center; none if a half extent is negative. */
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

/** The points of the triangle with these corners. */
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

/** The points between the two ends. */
export interface Segment3 {
  start: Vec3;
  end: Vec3;
}

/** A shape of any kind. `kind` selects the member of the union. `asset` is the handle of a hull, mesh or height field; other kinds ignore it. */
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

/** The first contact of a ray or moving shape with a shape. The distance is rounded down. */
export interface Hit3 {
  distance: number;
  point: Vec3;
  normal: Direction3;
}

/** One contact point on the surface of the first shape. The second shape's surface is at point - depth * normal. `feature` identifies the corners, edges or faces that meet, and is stable while they do. */
export interface ContactPoint3 {
  point: Vec3;
  depth: number;
  feature: number;
}

/** The least translation that separates two overlapping shapes a and b: move b by `depth`, rounded up, along `normal`, which points from a to b. The first `count` points are set, the others are zero. */
export interface Manifold3 {
  normal: Direction3;
  depth: number;
  count: number;
  points: ContactPoint3[];
}

/** The motion of a frame between two poses over the time 0 to 1. The origin moves at constant velocity; the frame rotates about one axis by at most half a turn. */
export interface Sweep3 {
  start: Vec3;
  end: Vec3;
  start_rotation: Rotation3;
  end_rotation: Rotation3;
}

/** The first point where a ray touches an object; for a mesh or height field also the triangle's index. */
export interface ObjectHit3 {
  distance: number;
  id: Id;
  point: Vec3;
  normal: Direction3;
  triangle: number;
  has_triangle: number;
}

/** A walking character: its capsule or AABB, and what it stands on. This is its whole state. Start with zeros and the shape in place. Setting `is_grounded` to 0 makes it leave the ground. A ball is a capsule with equal ends. */
export interface Mover3 {
  shape: Shape3;
  is_grounded: number;
  object: Id;
  normal: Direction3;
  frame: Id;
  local: Vec3;
  point: Vec3;
}

/** Settings of a character's movement. Lengths in steps of 2^-16. */
export interface Mover3Settings {
  up: Direction3;
  skin: number;
  step_height: number;
  snap_distance: number;
  max_slope: number;
}

/** Something the character touched during a move. The normal points away from it. */
export interface Mover3Touch {
  object: Id;
  point: Vec3;
  normal: Direction3;
}

/** The result of a move. The first `count` touches are set, the others are zero. */
export interface Move3 {
  moved: Vec3;
  carried: Vec3;
  pushed: Vec3;
  count: number;
  is_stuck: number;
  touched: Mover3Touch[];
}

/** A point at which two bodies touch. Lengths and impulses in steps of 2^-16. */
export interface World3ContactPoint {
  point: Vec3;
  separation: number;
  impulse: number;
  feature: number;
}

/** The contact of two bodies; for compounds that of two parts, for meshes and height fields that of one triangle. The first `count` points are set, the others are zero. Impulses act on b; a gets the opposite. They are those of the last substep, in units of mass times units per second. */
export interface World3Contact {
  a: Id;
  b: Id;
  part_a: number;
  part_b: number;
  triangle: number;
  normal: Direction3;
  impulse: number;
  friction: Vec3;
  count: number;
  points: World3ContactPoint[];
}

/** Settings of a world. Lengths and speeds in steps of 2^-16. */
export interface World3Settings {
  ticks_per_second: number;
  substeps: number;
  gravity: Vec3;
  margin: number;
  push_speed: number;
  bounce_threshold: number;
  sleep_speed: number;
  hold_distance: number;
}

/** The material and initial state of a body. Ratios and densities in steps of 2^-16. */
export interface Body3Options {
  user: bigint;
  layers: number;
  collides_with: number;
  motion: number;
  density: number;
  friction: number;
  restitution: number;
  rolling_resistance: number;
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

/** A part of a compound: a sphere, AABB, OBB, capsule or solid hull in the compound's frame, and its material, in steps of 2^-16. Start from `detent_part3_defaults`. */
export interface Part3 {
  shape: Shape3;
  density: number;
  friction: number;
  restitution: number;
  rolling_resistance: number;
  is_sensor: number;
}

/** A joint between two bodies a and b. Anchors and frames are in body space. Time is in the seconds of the world's settings, angles in radians, and all numbers are in steps of 2^-16. Fields that a kind does not have are ignored. */
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
  cone_angle: number;
}

/** The state of a body, rounded to nearest. */
export interface Body3 {
  position: Vec3;
  rotation: Rotation3;
  velocity: Vec3;
  angular_velocity: number[];
  is_asleep: number;
}

/** A camera: its pose and lens. The pose is that of `detent_camera3_look_at`: axis 0 points right, axis 1 up, and it looks along -axis 2. The scale is ignored. */
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

/** The view volume of a camera: the convex hull of eight corners. Corner i is right if i & 1, top if i & 2 and far if i & 4. Every query is exact for any eight points in any order. */
export interface Frustum3 {
  corners: Vec3[];
}

/** A screen point: pixels from the top left corner in steps of 2^-16, so that 32768 is the middle of the first pixel, and the depth along the line of sight, a length. */
export interface ScreenPoint3 {
  x: number;
  y: number;
  depth: number;
}
