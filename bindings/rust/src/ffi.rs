// SPDX-License-Identifier: MIT
// Written by bindings/generate from bindings/detent.h.in: change that file instead.
//! The C interface as it is.

#![allow(missing_docs)]

use std::os::raw::{c_char, c_void};

pub const OK: i32 = 1;
pub const NO: i32 = 0;
pub const BAD_ARGUMENT: i32 = -1;
pub const BAD_CONTEXT: i32 = -2;
pub const BAD_HANDLE: i32 = -3;
pub const NOT_UNIT: i32 = -4;
pub const NO_QUERY: i32 = -5;
pub const NO_MEMORY: i32 = -6;
pub const BROKEN: i32 = -7;
pub const FULL: i32 = -8;
pub const IN_USE: i32 = -9;
pub const NOT_NOW: i32 = -10;
pub const NO_SNAPSHOT: i32 = -20;
pub const OTHER_VERSION: i32 = -21;
pub const TRUNCATED: i32 = -22;
pub const CORRUPTED: i32 = -23;
pub const OTHER_SCENE: i32 = -24;
pub const OTHER_FIXED_PART: i32 = -25;
pub const NO_ROOM: i32 = -26;
pub const UNKNOWN_ASSET: i32 = -27;
pub const OTHER_ASSET: i32 = -28;
pub const SPHERE: u32 = 1;
pub const AABB: u32 = 2;
pub const OBB: u32 = 3;
pub const PLANE: u32 = 4;
pub const TRIANGLE: u32 = 5;
pub const CAPSULE: u32 = 6;
pub const SEGMENT: u32 = 7;
pub const POINT: u32 = 8;
pub const HULL: u32 = 9;
pub const MESH: u32 = 10;
pub const HEIGHT_FIELD: u32 = 11;
pub const COMPOUND: u32 = 12;
pub const MOVING: u32 = 0;
pub const FIXED: u32 = 1;
pub const DYNAMIC_BODY: u32 = 0;
pub const KINEMATIC_BODY: u32 = 1;
pub const FIXED_BODY: u32 = 2;
pub const DISTANCE_JOINT: u32 = 1;
pub const BALL_JOINT: u32 = 2;
pub const HINGE_JOINT: u32 = 3;
pub const WELD_JOINT: u32 = 4;
pub const SLIDER_JOINT: u32 = 5;
pub const WHEEL_JOINT: u32 = 6;
pub const CONE_JOINT: u32 = 7;
pub const LOCK_X: u32 = 1;
pub const LOCK_Y: u32 = 2;
pub const LOCK_Z: u32 = 4;
pub const LOCK_TURN_X: u32 = 8;
pub const LOCK_TURN_Y: u32 = 16;
pub const LOCK_TURN_Z: u32 = 32;
pub const PLAYED: u32 = 0;
pub const CONNECTING: u32 = 1;
pub const CATCHING_UP: u32 = 2;
pub const STARVED: u32 = 3;
pub const AHEAD: u32 = 4;
pub const PAUSED: u32 = 5;
pub const OVER: u32 = 6;
pub const JOINING: u32 = 7;
pub const CONNECTED: u32 = 0;
pub const SILENT: u32 = 1;
pub const HEARD_AGAIN: u32 = 2;
pub const PEER_PAUSED: u32 = 3;
pub const PEER_RESUMED: u32 = 4;
pub const DROPPED: u32 = 5;
pub const EXPELLED: u32 = 6;
pub const LEFT: u32 = 7;
pub const TOO_SLOW: u32 = 8;
pub const CONTRADICTION: u32 = 9;
pub const DESYNC: u32 = 10;
pub const DESYNC_FIELD: u32 = 11;
pub const ARRIVED: u32 = 12;
pub const LOADED: u32 = 13;
pub const NO_SUCH_WORLD: u32 = 14;
pub const JOINED: u32 = 15;
pub const REPLAY_WHOLE: u32 = 0;
pub const REPLAY_CUT: u32 = 1;
pub const REPLAY_CORRUPTED: u32 = 2;
pub const INPUT: u32 = 16;
pub const PACKET: u32 = 1200;
pub const LATE_SNAPSHOT: u32 = 65536;
pub const NAME: u32 = 119;
pub const WORDS: u32 = 256;
pub const PLAYERS: u32 = 8;

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
/// The id of an object of a scene or a body of a world. Ids are never reused; {0, 0} is none.
pub struct Id {
    pub index: u32,
    pub generation: u32,
}
const _: () = assert!(std::mem::size_of::<Id>() == 8);

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
/// Two objects or bodies.
pub struct Pair {
    pub first: Id,
    pub second: Id,
}
const _: () = assert!(std::mem::size_of::<Pair>() == 16);

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
/// A pair of bodies that began (1) or ceased (0) to touch in the last step; for compounds, a pair of parts.
pub struct Touch {
    pub a: Id,
    pub b: Id,
    pub begins: u32,
    pub part_a: u32,
    pub part_b: u32,
}
const _: () = assert!(std::mem::size_of::<Touch>() == 28);

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
/// The properties of a body.
pub struct BodyInfo {
    pub user: u64,
    pub layers: u32,
    pub collides_with: u32,
    pub motion: u32,
    pub is_sensor: u32,
    pub is_asleep: u32,
    pub part_count: u32,
}
const _: () = assert!(std::mem::size_of::<BodyInfo>() == 32);

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
/// An object found by a query, and its distance in steps of 2^-16.
pub struct Found {
    pub distance: i32,
    pub id: Id,
}
const _: () = assert!(std::mem::size_of::<Found>() == 12);

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
/// When two moving shapes meet. They are disjoint before `time` (in steps of 2^-30) and at most `distance` apart at `time`. If `is_hit` is 0 the search ended early, and whether they meet later is unknown.
pub struct Impact {
    pub time: i32,
    pub distance: i32,
    pub is_hit: u32,
}
const _: () = assert!(std::mem::size_of::<Impact>() == 12);

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
/// The settings of a match and of one peer. Times are in microseconds of this peer's own clock.
pub struct SessionSettings {
    pub match_: u64,
    pub send_interval: u64,
    pub silence: u64,
    pub self_: u32,
    pub players: u32,
    pub spectators: u32,
    pub delay: u32,
    pub prediction: u32,
    pub frames_per_call: u32,
    pub absent: u32,
    pub life: u32,
    pub wants_seat: u32,
    pub input_size: u32,
    pub words: u32,
    pub replay_every: u32,
}
const _: () = assert!(std::mem::size_of::<SessionSettings>() == 72);

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
/// A frame to simulate, or the reason why there is none. Players whose bit in `present` is set take part.
pub struct Frame {
    pub number: u32,
    pub players: u32,
    pub present: u32,
    pub state: u32,
}
const _: () = assert!(std::mem::size_of::<Frame>() == 16);

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
/// An event of a session.
pub struct SessionEvent {
    pub kind: u32,
    pub peer: u32,
    pub frame: u32,
    pub name_size: u32,
    pub has_object: u32,
    pub object: Id,
}
const _: () = assert!(std::mem::size_of::<SessionEvent>() == 28);

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
/// The progress of a session.
pub struct SessionStatus {
    pub digest: u64,
    pub resimulated: u64,
    pub frame: u32,
    pub final_frame: u32,
    pub checked_frame: u32,
    pub start_frame: u32,
    pub is_player: u32,
    pub players: u32,
}
const _: () = assert!(std::mem::size_of::<SessionStatus>() == 40);

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
/// The result of resimulating a replay so far.
pub struct ReplayCheck {
    pub state: u32,
    pub frames: u32,
    pub equal: u32,
    pub is_equal: u32,
    pub players: u32,
}
const _: () = assert!(std::mem::size_of::<ReplayCheck>() == 20);

#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
/// What a scene stores with an object, besides its shape.
pub struct Traits {
    pub user: u64,
    pub layers: u32,
    pub motion: u32,
    pub frame: Id,
}
const _: () = assert!(std::mem::size_of::<Traits>() == 24);

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
/// The owner of everything else. The caller provides its memory: zero it, open it and close it, and do not move it while it is open. Contexts share nothing. On one context, functions that only read (const detent_context*) may run in several threads at once; any other call needs exclusive access.
pub struct Context {
    pub words: [u64; 4],
}
const _: () = assert!(std::mem::size_of::<Context>() == 32);

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
/// A point or vector, in steps of 2^-16.
pub struct Vec2 {
    pub x: i32,
    pub y: i32,
}
const _: () = assert!(std::mem::size_of::<Vec2>() == 8);

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
/// A unit vector, in steps of 2^-30; used as stored, never normalised.
pub struct Direction2 {
    pub x: i32,
    pub y: i32,
}
const _: () = assert!(std::mem::size_of::<Direction2>() == 8);

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
/// The axes of a frame in the world.
pub struct Rotation2 {
    pub axis: [Direction2; 2],
}
const _: () = assert!(std::mem::size_of::<Rotation2>() == 16);

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
/// p -> translation + scale * rotation * p; `scale` in steps of 2^-16.
pub struct Transform2 {
    pub translation: Vec2,
    pub rotation: Rotation2,
    pub scale: i32,
}
const _: () = assert!(std::mem::size_of::<Transform2>() == 28);

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
/// The points origin + t * direction with 0 <= t <= max_distance.
pub struct Ray2 {
    pub origin: Vec2,
    pub direction: Direction2,
    pub max_distance: i32,
}
const _: () = assert!(std::mem::size_of::<Ray2>() == 20);

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
/// The points within `radius` of `center`; none if the radius is negative.
pub struct Sphere2 {
    pub center: Vec2,
    pub radius: i32,
}
const _: () = assert!(std::mem::size_of::<Sphere2>() == 12);

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
/// The points between two corners, inclusive; none if min > max on an axis.
pub struct Aabb2 {
    pub min: Vec2,
    pub max: Vec2,
}
const _: () = assert!(std::mem::size_of::<Aabb2>() == 16);

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
/// A box rotated about its center; none if a half extent is negative.
pub struct Obb2 {
    pub center: Vec2,
    pub half_extents: Vec2,
    pub rotation: Rotation2,
}
const _: () = assert!(std::mem::size_of::<Obb2>() == 32);

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
/// The points x with dot(normal, x) = offset.
pub struct Plane2 {
    pub normal: Direction2,
    pub offset: i32,
}
const _: () = assert!(std::mem::size_of::<Plane2>() == 12);

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
/// The points of the triangle with these corners.
pub struct Triangle2 {
    pub a: Vec2,
    pub b: Vec2,
    pub c: Vec2,
}
const _: () = assert!(std::mem::size_of::<Triangle2>() == 24);

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
/// The points within `radius` of the segment from a to b; none if the radius is negative.
pub struct Capsule2 {
    pub a: Vec2,
    pub b: Vec2,
    pub radius: i32,
}
const _: () = assert!(std::mem::size_of::<Capsule2>() == 20);

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
/// The points between the two ends.
pub struct Segment2 {
    pub start: Vec2,
    pub end: Vec2,
}
const _: () = assert!(std::mem::size_of::<Segment2>() == 16);

#[repr(C)]
#[derive(Clone, Copy)]
pub union Shape2As {
    pub sphere: Sphere2,
    pub aabb: Aabb2,
    pub obb: Obb2,
    pub plane: Plane2,
    pub triangle: Triangle2,
    pub capsule: Capsule2,
    pub segment: Segment2,
    pub point: Vec2,
    pub placed: Transform2,
}

#[repr(C)]
#[derive(Clone, Copy)]
/// A shape of any kind. `kind` selects the member of the union. `asset` is the handle of a hull, mesh or height field; other kinds ignore it.
pub struct Shape2 {
    pub kind: u32,
    pub asset: u32,
    pub of: Shape2As,
}
const _: () = assert!(std::mem::size_of::<Shape2>() == 40);

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
/// The first contact of a ray or moving shape with a shape. The distance is rounded down.
pub struct Hit2 {
    pub distance: i32,
    pub point: Vec2,
    pub normal: Direction2,
}
const _: () = assert!(std::mem::size_of::<Hit2>() == 20);

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
/// One contact point on the surface of the first shape. The second shape's surface is at point - depth * normal. `feature` identifies the corners, edges or faces that meet, and is stable while they do.
pub struct ContactPoint2 {
    pub point: Vec2,
    pub depth: i32,
    pub feature: u32,
}
const _: () = assert!(std::mem::size_of::<ContactPoint2>() == 16);

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
/// The least translation that separates two overlapping shapes a and b: move b by `depth`, rounded up, along `normal`, which points from a to b. The first `count` points are set, the others are zero.
pub struct Manifold2 {
    pub normal: Direction2,
    pub depth: i32,
    pub count: u32,
    pub points: [ContactPoint2; 2],
}
const _: () = assert!(std::mem::size_of::<Manifold2>() == 48);

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
/// The motion of a frame between two poses over the time 0 to 1. The origin moves at constant velocity; the frame rotates about one axis by at most half a turn.
pub struct Sweep2 {
    pub start: Vec2,
    pub end: Vec2,
    pub start_rotation: Rotation2,
    pub end_rotation: Rotation2,
}
const _: () = assert!(std::mem::size_of::<Sweep2>() == 48);

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
/// The first point where a ray touches an object; for a mesh or height field also the triangle's index.
pub struct ObjectHit2 {
    pub distance: i32,
    pub id: Id,
    pub point: Vec2,
    pub normal: Direction2,
    pub triangle: u32,
    pub has_triangle: u32,
}
const _: () = assert!(std::mem::size_of::<ObjectHit2>() == 36);

#[repr(C)]
#[derive(Clone, Copy)]
/// A walking character: its capsule or AABB, and what it stands on. This is its whole state. Start with zeros and the shape in place. Setting `is_grounded` to 0 makes it leave the ground. A ball is a capsule with equal ends.
pub struct Mover2 {
    pub shape: Shape2,
    pub is_grounded: u32,
    pub object: Id,
    pub normal: Direction2,
    pub frame: Id,
    pub local: Vec2,
    pub point: Vec2,
}
const _: () = assert!(std::mem::size_of::<Mover2>() == 84);

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
/// Settings of a character's movement. Lengths in steps of 2^-16.
pub struct Mover2Settings {
    pub up: Direction2,
    pub skin: i32,
    pub step_height: i32,
    pub snap_distance: i32,
    pub max_slope: u32,
}
const _: () = assert!(std::mem::size_of::<Mover2Settings>() == 24);

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
/// Something the character touched during a move. The normal points away from it.
pub struct Mover2Touch {
    pub object: Id,
    pub point: Vec2,
    pub normal: Direction2,
}
const _: () = assert!(std::mem::size_of::<Mover2Touch>() == 24);

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
/// The result of a move. The first `count` touches are set, the others are zero.
pub struct Move2 {
    pub moved: Vec2,
    pub carried: Vec2,
    pub pushed: Vec2,
    pub count: u32,
    pub is_stuck: u32,
    pub touched: [Mover2Touch; 8],
}
const _: () = assert!(std::mem::size_of::<Move2>() == 224);

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
/// A point at which two bodies touch. Lengths and impulses in steps of 2^-16.
pub struct World2ContactPoint {
    pub point: Vec2,
    pub separation: i32,
    pub impulse: i32,
    pub feature: u32,
}
const _: () = assert!(std::mem::size_of::<World2ContactPoint>() == 20);

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
/// The contact of two bodies; for compounds that of two parts, for meshes and height fields that of one triangle. The first `count` points are set, the others are zero. Impulses act on b; a gets the opposite. They are those of the last substep, in units of mass times units per second.
pub struct World2Contact {
    pub a: Id,
    pub b: Id,
    pub part_a: u32,
    pub part_b: u32,
    pub triangle: u32,
    pub normal: Direction2,
    pub impulse: i32,
    pub friction: Vec2,
    pub count: u32,
    pub points: [World2ContactPoint; 2],
}
const _: () = assert!(std::mem::size_of::<World2Contact>() == 92);

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
/// Settings of a world. Lengths and speeds in steps of 2^-16.
pub struct World2Settings {
    pub ticks_per_second: i32,
    pub substeps: i32,
    pub gravity: Vec2,
    pub margin: i32,
    pub push_speed: i32,
    pub bounce_threshold: i32,
    pub sleep_speed: i32,
    pub hold_distance: i32,
}
const _: () = assert!(std::mem::size_of::<World2Settings>() == 36);

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
/// The material and initial state of a body. Ratios and densities in steps of 2^-16.
pub struct Body2Options {
    pub user: u64,
    pub layers: u32,
    pub collides_with: u32,
    pub motion: u32,
    pub density: i32,
    pub friction: i32,
    pub restitution: i32,
    pub rolling_resistance: i32,
    pub linear_damping: i32,
    pub angular_damping: i32,
    pub velocity: Vec2,
    pub angular_velocity: [i32; 1],
    pub gravity_scale: i32,
    pub locked: u32,
    pub is_sensor: u32,
    pub is_fast: u32,
    pub reserved: [u32; 2],
}
const _: () = assert!(std::mem::size_of::<Body2Options>() == 80);

#[repr(C)]
#[derive(Clone, Copy)]
/// A part of a compound: a sphere, AABB, OBB, capsule or solid hull in the compound's frame, and its material, in steps of 2^-16. Start from `detent_part2_defaults`.
pub struct Part2 {
    pub shape: Shape2,
    pub density: i32,
    pub friction: i32,
    pub restitution: i32,
    pub rolling_resistance: i32,
    pub is_sensor: u32,
}
const _: () = assert!(std::mem::size_of::<Part2>() == 60);

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
/// A joint between two bodies a and b. Anchors and frames are in body space. Time is in the seconds of the world's settings, angles in radians, and all numbers are in steps of 2^-16. Fields that a kind does not have are ignored.
pub struct Joint2 {
    pub kind: u32,
    pub a: Id,
    pub b: Id,
    pub anchor_a: Vec2,
    pub anchor_b: Vec2,
    pub frame_a: Rotation2,
    pub frame_b: Rotation2,
    pub collide: u32,
    pub break_force: i32,
    pub has_limits: u32,
    pub lower: i32,
    pub upper: i32,
    pub motor_speed: i32,
    pub motor_force: i32,
    pub length: i32,
    pub frequency: i32,
    pub damping_ratio: i32,
    pub cone_angle: i32,
}
const _: () = assert!(std::mem::size_of::<Joint2>() == 112);

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
/// The state of a body, rounded to nearest.
pub struct Body2 {
    pub position: Vec2,
    pub rotation: Rotation2,
    pub velocity: Vec2,
    pub angular_velocity: [i32; 1],
    pub is_asleep: u32,
}
const _: () = assert!(std::mem::size_of::<Body2>() == 40);

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
/// A point or vector, in steps of 2^-16.
pub struct Vec3 {
    pub x: i32,
    pub y: i32,
    pub z: i32,
}
const _: () = assert!(std::mem::size_of::<Vec3>() == 12);

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
/// A unit vector, in steps of 2^-30; used as stored, never normalised.
pub struct Direction3 {
    pub x: i32,
    pub y: i32,
    pub z: i32,
}
const _: () = assert!(std::mem::size_of::<Direction3>() == 12);

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
/// The axes of a frame in the world.
pub struct Rotation3 {
    pub axis: [Direction3; 3],
}
const _: () = assert!(std::mem::size_of::<Rotation3>() == 36);

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
/// p -> translation + scale * rotation * p; `scale` in steps of 2^-16.
pub struct Transform3 {
    pub translation: Vec3,
    pub rotation: Rotation3,
    pub scale: i32,
}
const _: () = assert!(std::mem::size_of::<Transform3>() == 52);

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
/// The points origin + t * direction with 0 <= t <= max_distance.
pub struct Ray3 {
    pub origin: Vec3,
    pub direction: Direction3,
    pub max_distance: i32,
}
const _: () = assert!(std::mem::size_of::<Ray3>() == 28);

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
/// The points within `radius` of `center`; none if the radius is negative.
pub struct Sphere3 {
    pub center: Vec3,
    pub radius: i32,
}
const _: () = assert!(std::mem::size_of::<Sphere3>() == 16);

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
/// The points between two corners, inclusive; none if min > max on an axis.
pub struct Aabb3 {
    pub min: Vec3,
    pub max: Vec3,
}
const _: () = assert!(std::mem::size_of::<Aabb3>() == 24);

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
/// A box rotated about its center; none if a half extent is negative.
pub struct Obb3 {
    pub center: Vec3,
    pub half_extents: Vec3,
    pub rotation: Rotation3,
}
const _: () = assert!(std::mem::size_of::<Obb3>() == 60);

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
/// The points x with dot(normal, x) = offset.
pub struct Plane3 {
    pub normal: Direction3,
    pub offset: i32,
}
const _: () = assert!(std::mem::size_of::<Plane3>() == 16);

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
/// The points of the triangle with these corners.
pub struct Triangle3 {
    pub a: Vec3,
    pub b: Vec3,
    pub c: Vec3,
}
const _: () = assert!(std::mem::size_of::<Triangle3>() == 36);

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
/// The points within `radius` of the segment from a to b; none if the radius is negative.
pub struct Capsule3 {
    pub a: Vec3,
    pub b: Vec3,
    pub radius: i32,
}
const _: () = assert!(std::mem::size_of::<Capsule3>() == 28);

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
/// The points between the two ends.
pub struct Segment3 {
    pub start: Vec3,
    pub end: Vec3,
}
const _: () = assert!(std::mem::size_of::<Segment3>() == 24);

#[repr(C)]
#[derive(Clone, Copy)]
pub union Shape3As {
    pub sphere: Sphere3,
    pub aabb: Aabb3,
    pub obb: Obb3,
    pub plane: Plane3,
    pub triangle: Triangle3,
    pub capsule: Capsule3,
    pub segment: Segment3,
    pub point: Vec3,
    pub placed: Transform3,
}

#[repr(C)]
#[derive(Clone, Copy)]
/// A shape of any kind. `kind` selects the member of the union. `asset` is the handle of a hull, mesh or height field; other kinds ignore it.
pub struct Shape3 {
    pub kind: u32,
    pub asset: u32,
    pub of: Shape3As,
}
const _: () = assert!(std::mem::size_of::<Shape3>() == 68);

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
/// The first contact of a ray or moving shape with a shape. The distance is rounded down.
pub struct Hit3 {
    pub distance: i32,
    pub point: Vec3,
    pub normal: Direction3,
}
const _: () = assert!(std::mem::size_of::<Hit3>() == 28);

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
/// One contact point on the surface of the first shape. The second shape's surface is at point - depth * normal. `feature` identifies the corners, edges or faces that meet, and is stable while they do.
pub struct ContactPoint3 {
    pub point: Vec3,
    pub depth: i32,
    pub feature: u32,
}
const _: () = assert!(std::mem::size_of::<ContactPoint3>() == 20);

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
/// The least translation that separates two overlapping shapes a and b: move b by `depth`, rounded up, along `normal`, which points from a to b. The first `count` points are set, the others are zero.
pub struct Manifold3 {
    pub normal: Direction3,
    pub depth: i32,
    pub count: u32,
    pub points: [ContactPoint3; 4],
}
const _: () = assert!(std::mem::size_of::<Manifold3>() == 100);

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
/// The motion of a frame between two poses over the time 0 to 1. The origin moves at constant velocity; the frame rotates about one axis by at most half a turn.
pub struct Sweep3 {
    pub start: Vec3,
    pub end: Vec3,
    pub start_rotation: Rotation3,
    pub end_rotation: Rotation3,
}
const _: () = assert!(std::mem::size_of::<Sweep3>() == 96);

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
/// The first point where a ray touches an object; for a mesh or height field also the triangle's index.
pub struct ObjectHit3 {
    pub distance: i32,
    pub id: Id,
    pub point: Vec3,
    pub normal: Direction3,
    pub triangle: u32,
    pub has_triangle: u32,
}
const _: () = assert!(std::mem::size_of::<ObjectHit3>() == 44);

#[repr(C)]
#[derive(Clone, Copy)]
/// A walking character: its capsule or AABB, and what it stands on. This is its whole state. Start with zeros and the shape in place. Setting `is_grounded` to 0 makes it leave the ground. A ball is a capsule with equal ends.
pub struct Mover3 {
    pub shape: Shape3,
    pub is_grounded: u32,
    pub object: Id,
    pub normal: Direction3,
    pub frame: Id,
    pub local: Vec3,
    pub point: Vec3,
}
const _: () = assert!(std::mem::size_of::<Mover3>() == 124);

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
/// Settings of a character's movement. Lengths in steps of 2^-16.
pub struct Mover3Settings {
    pub up: Direction3,
    pub skin: i32,
    pub step_height: i32,
    pub snap_distance: i32,
    pub max_slope: u32,
}
const _: () = assert!(std::mem::size_of::<Mover3Settings>() == 28);

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
/// Something the character touched during a move. The normal points away from it.
pub struct Mover3Touch {
    pub object: Id,
    pub point: Vec3,
    pub normal: Direction3,
}
const _: () = assert!(std::mem::size_of::<Mover3Touch>() == 32);

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
/// The result of a move. The first `count` touches are set, the others are zero.
pub struct Move3 {
    pub moved: Vec3,
    pub carried: Vec3,
    pub pushed: Vec3,
    pub count: u32,
    pub is_stuck: u32,
    pub touched: [Mover3Touch; 8],
}
const _: () = assert!(std::mem::size_of::<Move3>() == 300);

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
/// A point at which two bodies touch. Lengths and impulses in steps of 2^-16.
pub struct World3ContactPoint {
    pub point: Vec3,
    pub separation: i32,
    pub impulse: i32,
    pub feature: u32,
}
const _: () = assert!(std::mem::size_of::<World3ContactPoint>() == 24);

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
/// The contact of two bodies; for compounds that of two parts, for meshes and height fields that of one triangle. The first `count` points are set, the others are zero. Impulses act on b; a gets the opposite. They are those of the last substep, in units of mass times units per second.
pub struct World3Contact {
    pub a: Id,
    pub b: Id,
    pub part_a: u32,
    pub part_b: u32,
    pub triangle: u32,
    pub normal: Direction3,
    pub impulse: i32,
    pub friction: Vec3,
    pub count: u32,
    pub points: [World3ContactPoint; 4],
}
const _: () = assert!(std::mem::size_of::<World3Contact>() == 156);

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
/// Settings of a world. Lengths and speeds in steps of 2^-16.
pub struct World3Settings {
    pub ticks_per_second: i32,
    pub substeps: i32,
    pub gravity: Vec3,
    pub margin: i32,
    pub push_speed: i32,
    pub bounce_threshold: i32,
    pub sleep_speed: i32,
    pub hold_distance: i32,
}
const _: () = assert!(std::mem::size_of::<World3Settings>() == 40);

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
/// The material and initial state of a body. Ratios and densities in steps of 2^-16.
pub struct Body3Options {
    pub user: u64,
    pub layers: u32,
    pub collides_with: u32,
    pub motion: u32,
    pub density: i32,
    pub friction: i32,
    pub restitution: i32,
    pub rolling_resistance: i32,
    pub linear_damping: i32,
    pub angular_damping: i32,
    pub velocity: Vec3,
    pub angular_velocity: [i32; 3],
    pub gravity_scale: i32,
    pub locked: u32,
    pub is_sensor: u32,
    pub is_fast: u32,
    pub reserved: [u32; 3],
}
const _: () = assert!(std::mem::size_of::<Body3Options>() == 96);

#[repr(C)]
#[derive(Clone, Copy)]
/// A part of a compound: a sphere, AABB, OBB, capsule or solid hull in the compound's frame, and its material, in steps of 2^-16. Start from `detent_part3_defaults`.
pub struct Part3 {
    pub shape: Shape3,
    pub density: i32,
    pub friction: i32,
    pub restitution: i32,
    pub rolling_resistance: i32,
    pub is_sensor: u32,
}
const _: () = assert!(std::mem::size_of::<Part3>() == 88);

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
/// A joint between two bodies a and b. Anchors and frames are in body space. Time is in the seconds of the world's settings, angles in radians, and all numbers are in steps of 2^-16. Fields that a kind does not have are ignored.
pub struct Joint3 {
    pub kind: u32,
    pub a: Id,
    pub b: Id,
    pub anchor_a: Vec3,
    pub anchor_b: Vec3,
    pub frame_a: Rotation3,
    pub frame_b: Rotation3,
    pub collide: u32,
    pub break_force: i32,
    pub has_limits: u32,
    pub lower: i32,
    pub upper: i32,
    pub motor_speed: i32,
    pub motor_force: i32,
    pub length: i32,
    pub frequency: i32,
    pub damping_ratio: i32,
    pub cone_angle: i32,
}
const _: () = assert!(std::mem::size_of::<Joint3>() == 160);

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
/// The state of a body, rounded to nearest.
pub struct Body3 {
    pub position: Vec3,
    pub rotation: Rotation3,
    pub velocity: Vec3,
    pub angular_velocity: [i32; 3],
    pub is_asleep: u32,
}
const _: () = assert!(std::mem::size_of::<Body3>() == 76);

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
/// A camera: its pose and lens. The pose is that of `detent_camera3_look_at`: axis 0 points right, axis 1 up, and it looks along -axis 2. The scale is ignored.
pub struct Camera3 {
    pub pose: Transform3,
    pub has_perspective: u32,
    pub fov: u32,
    pub aspect: i32,
    pub half_width: i32,
    pub half_height: i32,
    pub near_distance: i32,
    pub far_distance: i32,
}
const _: () = assert!(std::mem::size_of::<Camera3>() == 80);

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
/// The view volume of a camera: the convex hull of eight corners. Corner i is right if i & 1, top if i & 2 and far if i & 4. Every query is exact for any eight points in any order.
pub struct Frustum3 {
    pub corners: [Vec3; 8],
}
const _: () = assert!(std::mem::size_of::<Frustum3>() == 96);

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
/// A screen point: pixels from the top left corner in steps of 2^-16, so that 32768 is the middle of the first pixel, and the depth along the line of sight, a length.
pub struct ScreenPoint3 {
    pub x: i32,
    pub y: i32,
    pub depth: i32,
}
const _: () = assert!(std::mem::size_of::<ScreenPoint3>() == 12);

#[link(name = "detent")]
extern "C" {
    pub fn detent_version() -> i32;
    pub fn detent_results_version() -> i32;
    pub fn detent_describe(status: i32) -> *const c_char;
    pub fn detent_open(context: *mut Context, allocator: *const c_void) -> i32;
    pub fn detent_close(context: *mut Context) -> i32;
    pub fn detent_count(context: *const Context, count: *mut u32) -> i32;
    pub fn detent_session_default_settings(settings: *mut SessionSettings) -> i32;
    pub fn detent_mesh_create(context: *mut Context, id: u32, vertices: *const Vec3, vertex_count: u32, faces: *const u32, face_count: u32, mesh: *mut u32) -> i32;
    pub fn detent_height_field_create(context: *mut Context, id: u32, corner: *const Vec2, cell: i32, columns: u32, rows: u32, heights: *const i32, field: *mut u32) -> i32;
    pub fn detent_asset_destroy(context: *mut Context, asset: u32) -> i32;
    pub fn detent_raycast2(ray: *const Ray2, shape: *const Shape2, hit: *mut Hit2) -> i32;
    pub fn detent_raycast2_many(rays: *const Ray2, count: u32, shape: *const Shape2, distances: *mut i32) -> i32;
    pub fn detent_contains2(shape: *const Shape2, point: *const Vec2) -> i32;
    pub fn detent_overlaps2(a: *const Shape2, b: *const Shape2) -> i32;
    pub fn detent_closest_point2(shape: *const Shape2, point: *const Vec2, closest: *mut Vec2) -> i32;
    pub fn detent_distance_to_point2(shape: *const Shape2, point: *const Vec2, distance: *mut i32) -> i32;
    pub fn detent_distance2(a: *const Shape2, b: *const Shape2, distance: *mut i32) -> i32;
    pub fn detent_contact2(a: *const Shape2, b: *const Shape2, contact: *mut Manifold2) -> i32;
    pub fn detent_closest_points2(a: *const Shape2, b: *const Shape2, point_a: *mut Vec2, point_b: *mut Vec2) -> i32;
    pub fn detent_cast2(shape: *const Shape2, direction: *const Direction2, max_distance: i32, target: *const Shape2, hit: *mut Hit2) -> i32;
    pub fn detent_time_of_impact2(a: *const Shape2, sweep_a: *const Sweep2, b: *const Shape2, sweep_b: *const Sweep2, target: i32, impact: *mut Impact) -> i32;
    pub fn detent_ray2_contains(ray: *const Ray2, point: *const Vec2) -> i32;
    pub fn detent_ray2_closest_point(ray: *const Ray2, point: *const Vec2, closest: *mut Vec2) -> i32;
    pub fn detent_ray2_distance_to_point(ray: *const Ray2, point: *const Vec2, distance: *mut i32) -> i32;
    pub fn detent_shapes2_raycast(context: *const Context, ray: *const Ray2, shapes: *const Shape2, count: u32, hit: *mut Hit2) -> i32;
    pub fn detent_shapes2_contains(context: *const Context, shapes: *const Shape2, count: u32, point: *const Vec2) -> i32;
    pub fn detent_shapes2_overlaps(context: *const Context, a: *const Shape2, a_count: u32, b: *const Shape2, b_count: u32) -> i32;
    pub fn detent_shapes2_closest_point(context: *const Context, shapes: *const Shape2, count: u32, point: *const Vec2, closest: *mut Vec2) -> i32;
    pub fn detent_shapes2_distance_to_point(context: *const Context, shapes: *const Shape2, count: u32, point: *const Vec2, distance: *mut i32) -> i32;
    pub fn detent_shapes2_distance(context: *const Context, a: *const Shape2, a_count: u32, b: *const Shape2, b_count: u32, distance: *mut i32) -> i32;
    pub fn detent_shapes2_closest_points(context: *const Context, a: *const Shape2, a_count: u32, b: *const Shape2, b_count: u32, point_a: *mut Vec2, point_b: *mut Vec2) -> i32;
    pub fn detent_shapes2_cast(context: *const Context, shape: *const Shape2, direction: *const Direction2, max_distance: i32, targets: *const Shape2, count: u32, hit: *mut Hit2) -> i32;
    pub fn detent_shapes2_contact(context: *const Context, a: *const Shape2, b: *const Shape2, contact: *mut Manifold2) -> i32;
    pub fn detent_shapes2_time_of_impact(context: *const Context, a: *const Shape2, sweep_a: *const Sweep2, b: *const Shape2, sweep_b: *const Sweep2, target: i32, impact: *mut Impact) -> i32;
    pub fn detent_hull2_create(context: *mut Context, id: u32, points: *const Vec2, count: u32, hull: *mut u32) -> i32;
    pub fn detent_solid2_create(context: *mut Context, id: u32, points: *const Vec2, count: u32, solid: *mut u32) -> i32;
    pub fn detent_part2_defaults(part: *mut Part2) -> i32;
    pub fn detent_compound2_create(context: *mut Context, id: u32, parts: *const Part2, count: u32, compound: *mut u32) -> i32;
    pub fn detent_scene2_create(context: *mut Context, scene: *mut u32) -> i32;
    pub fn detent_scene2_destroy(context: *mut Context, scene: u32) -> i32;
    pub fn detent_scene2_add(context: *mut Context, scene: u32, shape: *const Shape2, traits: *const Traits, id: *mut Id) -> i32;
    pub fn detent_scene2_add_as(context: *mut Context, scene: u32, id: Id, shape: *const Shape2, traits: *const Traits) -> i32;
    pub fn detent_scene2_remove(context: *mut Context, scene: u32, id: Id) -> i32;
    pub fn detent_scene2_replace(context: *mut Context, scene: u32, id: Id, shape: *const Shape2) -> i32;
    pub fn detent_scene2_move(context: *mut Context, scene: u32, id: Id, by: *const Vec2) -> i32;
    pub fn detent_scene2_object(context: *const Context, scene: u32, id: Id, shape: *mut Shape2, traits: *mut Traits) -> i32;
    pub fn detent_scene2_set_traits(context: *mut Context, scene: u32, id: Id, traits: *const Traits) -> i32;
    pub fn detent_scene2_add_frame(context: *mut Context, scene: u32, transform: *const Transform2, parent: Id, frame: *mut Id) -> i32;
    pub fn detent_scene2_move_frame(context: *mut Context, scene: u32, frame: Id, transform: *const Transform2) -> i32;
    pub fn detent_scene2_remove_frame(context: *mut Context, scene: u32, frame: Id) -> i32;
    pub fn detent_scene2_frame(context: *const Context, scene: u32, frame: Id, local: *mut Transform2, world: *mut Transform2) -> i32;
    pub fn detent_scene2_size(context: *const Context, scene: u32, size: *mut u32) -> i32;
    pub fn detent_scene2_optimize(context: *mut Context, scene: u32) -> i32;
    pub fn detent_scene2_raycast(context: *const Context, scene: u32, ray: *const Ray2, layers: u32, hit: *mut ObjectHit2) -> i32;
    pub fn detent_scene2_raycast_any(context: *const Context, scene: u32, ray: *const Ray2, layers: u32) -> i32;
    pub fn detent_scene2_raycast_all(context: *const Context, scene: u32, ray: *const Ray2, layers: u32, hits: *mut ObjectHit2, room: u32, count: *mut u32) -> i32;
    pub fn detent_scene2_raycast_many(context: *const Context, scene: u32, rays: *const Ray2, count: u32, layers: u32, hits: *mut ObjectHit2) -> i32;
    pub fn detent_scene2_nearest(context: *const Context, scene: u32, question: *const Shape2, layers: u32, found: *mut Found) -> i32;
    pub fn detent_scene2_any(context: *const Context, scene: u32, question: *const Shape2, layers: u32) -> i32;
    pub fn detent_scene2_all(context: *const Context, scene: u32, question: *const Shape2, layers: u32, found: *mut Found, room: u32, count: *mut u32) -> i32;
    pub fn detent_scene2_overlaps(context: *const Context, scene: u32, pairs: *mut Pair, room: u32, count: *mut u32) -> i32;
    pub fn detent_scene2_cast(context: *const Context, scene: u32, shape: *const Shape2, direction: *const Direction2, max_distance: i32, layers: u32, hit: *mut ObjectHit2) -> i32;
    pub fn detent_scene2_cast_any(context: *const Context, scene: u32, shape: *const Shape2, direction: *const Direction2, max_distance: i32, layers: u32) -> i32;
    pub fn detent_scene2_cast_all(context: *const Context, scene: u32, shape: *const Shape2, direction: *const Direction2, max_distance: i32, layers: u32, hits: *mut ObjectHit2, room: u32, count: *mut u32) -> i32;
    pub fn detent_mover2_default_settings(settings: *mut Mover2Settings) -> i32;
    pub fn detent_mover2_move(context: *const Context, scene: u32, mover: *mut Mover2, by: *const Vec2, settings: *const Mover2Settings, layers: u32, ignored: Id, result: *mut Move2) -> i32;
    pub fn detent_mover2_clip_velocity(velocity: *const Vec2, result: *const Move2, clipped: *mut Vec2) -> i32;
    pub fn detent_scene2_digest(context: *const Context, scene: u32, digest: *mut u64) -> i32;
    pub fn detent_scene2_snapshot(context: *const Context, scene: u32, bytes: *mut c_void, room: u32, size: *mut u32) -> i32;
    pub fn detent_scene2_restore(context: *mut Context, scene: u32, bytes: *const c_void, size: u32) -> i32;
    pub fn detent_world2_default_settings(settings: *mut World2Settings) -> i32;
    pub fn detent_body2_default_options(options: *mut Body2Options) -> i32;
    pub fn detent_world2_create(context: *mut Context, settings: *const World2Settings, world: *mut u32) -> i32;
    pub fn detent_world2_destroy(context: *mut Context, world: u32) -> i32;
    pub fn detent_world2_add(context: *mut Context, world: u32, shape: *const Shape2, options: *const Body2Options, id: *mut Id) -> i32;
    pub fn detent_world2_add_as(context: *mut Context, world: u32, id: Id, shape: *const Shape2, options: *const Body2Options) -> i32;
    pub fn detent_world2_remove(context: *mut Context, world: u32, id: Id) -> i32;
    pub fn detent_world2_step(context: *mut Context, world: u32) -> i32;
    pub fn detent_scene2_follow(context: *mut Context, scene: u32, world: u32, sensors: u32) -> i32;
    pub fn detent_world2_part_of(context: *const Context, world: u32, object: Id, body: *mut Id, part: *mut u32) -> i32;
    pub fn detent_world2_body(context: *const Context, world: u32, id: Id, body: *mut Body2) -> i32;
    pub fn detent_world2_bodies(context: *const Context, world: u32, ids: *const Id, count: u32, bodies: *mut Body2) -> i32;
    pub fn detent_world2_frame(context: *const Context, world: u32, id: Id, frame: *mut Transform2) -> i32;
    pub fn detent_world2_info(context: *const Context, world: u32, id: Id, info: *mut BodyInfo) -> i32;
    pub fn detent_world2_set_position(context: *mut Context, world: u32, id: Id, position: *const Vec2) -> i32;
    pub fn detent_world2_set_rotation(context: *mut Context, world: u32, id: Id, rotation: *const Rotation2) -> i32;
    pub fn detent_world2_set_filter(context: *mut Context, world: u32, id: Id, layers: u32, collides_with: u32) -> i32;
    pub fn detent_world2_set_friction(context: *mut Context, world: u32, id: Id, friction: i32) -> i32;
    pub fn detent_world2_set_restitution(context: *mut Context, world: u32, id: Id, restitution: i32) -> i32;
    pub fn detent_world2_set_sensor(context: *mut Context, world: u32, id: Id, is_sensor: u32) -> i32;
    pub fn detent_world2_set_gravity_scale(context: *mut Context, world: u32, id: Id, scale: i32) -> i32;
    pub fn detent_world2_set_damping(context: *mut Context, world: u32, id: Id, linear: i32, angular: i32) -> i32;
    pub fn detent_world2_set_locked(context: *mut Context, world: u32, id: Id, locked: u32) -> i32;
    pub fn detent_world2_set_fast(context: *mut Context, world: u32, id: Id, is_fast: u32) -> i32;
    pub fn detent_world2_set_user(context: *mut Context, world: u32, id: Id, user: u64) -> i32;
    pub fn detent_world2_set_gravity(context: *mut Context, world: u32, gravity: *const Vec2) -> i32;
    pub fn detent_world2_set_velocity(context: *mut Context, world: u32, id: Id, velocity: *const Vec2) -> i32;
    pub fn detent_world2_set_angular_velocity(context: *mut Context, world: u32, id: Id, velocity: *const i32) -> i32;
    pub fn detent_world2_apply_impulse(context: *mut Context, world: u32, id: Id, impulse: *const Vec2, at: *const Vec2) -> i32;
    pub fn detent_world2_apply_force(context: *mut Context, world: u32, id: Id, force: *const Vec2, at: *const Vec2) -> i32;
    pub fn detent_world2_apply_torque(context: *mut Context, world: u32, id: Id, torque: *const i32) -> i32;
    pub fn detent_joint2_defaults(kind: u32, joint: *mut Joint2) -> i32;
    pub fn detent_world2_add_joint(context: *mut Context, world: u32, joint: *const Joint2, id: *mut Id) -> i32;
    pub fn detent_world2_change_joint(context: *mut Context, world: u32, id: Id, joint: *const Joint2) -> i32;
    pub fn detent_world2_remove_joint(context: *mut Context, world: u32, id: Id) -> i32;
    pub fn detent_world2_joint(context: *const Context, world: u32, id: Id, joint: *mut Joint2) -> i32;
    pub fn detent_world2_joint_force(context: *const Context, world: u32, id: Id, force: *mut Vec2) -> i32;
    pub fn detent_world2_joint_torque(context: *const Context, world: u32, id: Id, torque: *mut i32) -> i32;
    pub fn detent_world2_joint_count(context: *const Context, world: u32, count: *mut u32) -> i32;
    pub fn detent_world2_joint_ids(context: *const Context, world: u32, joints: *mut Id, room: u32, count: *mut u32) -> i32;
    pub fn detent_world2_broken(context: *const Context, world: u32, joints: *mut Id, room: u32, count: *mut u32) -> i32;
    pub fn detent_world2_local_point(context: *const Context, world: u32, id: Id, point: *const Vec2, local: *mut Vec2) -> i32;
    pub fn detent_world2_local_frame(context: *const Context, world: u32, id: Id, frame: *const Rotation2, local: *mut Rotation2) -> i32;
    pub fn detent_world2_size(context: *const Context, world: u32, size: *mut u32) -> i32;
    pub fn detent_world2_body_ids(context: *const Context, world: u32, ids: *mut Id, room: u32, count: *mut u32) -> i32;
    pub fn detent_world2_touching(context: *const Context, world: u32, body: Id, touches: *mut Touch, room: u32, count: *mut u32) -> i32;
    pub fn detent_world2_contacts(context: *const Context, world: u32, body: Id, contacts: *mut World2Contact, room: u32, count: *mut u32) -> i32;
    pub fn detent_world2_events(context: *const Context, world: u32, events: *mut Touch, room: u32, count: *mut u32) -> i32;
    pub fn detent_world2_digest(context: *const Context, world: u32, digest: *mut u64) -> i32;
    pub fn detent_world2_digest_of(context: *const Context, world: u32, id: Id, digest: *mut u64) -> i32;
    pub fn detent_world2_snapshot(context: *const Context, world: u32, bytes: *mut c_void, room: u32, size: *mut u32) -> i32;
    pub fn detent_world2_restore(context: *mut Context, world: u32, bytes: *const c_void, size: u32) -> i32;
    pub fn detent_world2_diff(context: *const Context, a: u32, b: u32, most: u32, names: *mut c_void, room: u32, size: *mut u32) -> i32;
    pub fn detent_scene2_diff(context: *const Context, a: u32, b: u32, most: u32, names: *mut c_void, room: u32, size: *mut u32) -> i32;
    pub fn detent_session2_create(context: *mut Context, settings: *const SessionSettings, world: u32, session: *mut u32) -> i32;
    pub fn detent_session2_destroy(context: *mut Context, session: u32) -> i32;
    pub fn detent_session2_world(context: *const Context, session: u32, world: *mut u32) -> i32;
    pub fn detent_session2_receive(context: *mut Context, session: u32, peer: u32, bytes: *const c_void, size: u32, now: u64) -> i32;
    pub fn detent_session2_begin_frame(context: *mut Context, session: u32, input: *const c_void, frame: *mut Frame, inputs: *mut c_void) -> i32;
    pub fn detent_session2_end_frame(context: *mut Context, session: u32) -> i32;
    pub fn detent_session2_packet(context: *mut Context, session: u32, now: u64, peer: *mut u32, bytes: *mut c_void, room: u32, size: *mut u32) -> i32;
    pub fn detent_session2_event(context: *mut Context, session: u32, event: *mut SessionEvent, name: *mut c_void, room: u32) -> i32;
    pub fn detent_session2_status(context: *const Context, session: u32, status: *mut SessionStatus) -> i32;
    pub fn detent_session2_matched(context: *const Context, session: u32, peer: u32, frame: *mut u32) -> i32;
    pub fn detent_session2_is_awaited(context: *const Context, session: u32, player: u32) -> i32;
    pub fn detent_session2_drop(context: *mut Context, session: u32, peer: u32) -> i32;
    pub fn detent_session2_pause(context: *mut Context, session: u32, is_paused: u32) -> i32;
    pub fn detent_session2_replay(context: *const Context, session: u32, bytes: *mut c_void, room: u32, size: *mut u32) -> i32;
    pub fn detent_world2_words(context: *const Context, world: u32, words: *mut u32) -> i32;
    pub fn detent_world2_set_words(context: *mut Context, world: u32, words: *const u32) -> i32;
    pub fn detent_replay2_create(context: *mut Context, bytes: *const c_void, size: u32, world: u32, input_size: u32, words: u32, replay: *mut u32) -> i32;
    pub fn detent_replay2_destroy(context: *mut Context, replay: u32) -> i32;
    pub fn detent_replay2_world(context: *const Context, replay: u32, world: *mut u32) -> i32;
    pub fn detent_replay2_begin_frame(context: *mut Context, replay: u32, frame: *mut Frame, inputs: *mut c_void) -> i32;
    pub fn detent_replay2_end_frame(context: *mut Context, replay: u32) -> i32;
    pub fn detent_replay2_check(context: *const Context, replay: u32, check: *mut ReplayCheck) -> i32;
    pub fn detent_raycast3(ray: *const Ray3, shape: *const Shape3, hit: *mut Hit3) -> i32;
    pub fn detent_raycast3_many(rays: *const Ray3, count: u32, shape: *const Shape3, distances: *mut i32) -> i32;
    pub fn detent_contains3(shape: *const Shape3, point: *const Vec3) -> i32;
    pub fn detent_overlaps3(a: *const Shape3, b: *const Shape3) -> i32;
    pub fn detent_closest_point3(shape: *const Shape3, point: *const Vec3, closest: *mut Vec3) -> i32;
    pub fn detent_distance_to_point3(shape: *const Shape3, point: *const Vec3, distance: *mut i32) -> i32;
    pub fn detent_distance3(a: *const Shape3, b: *const Shape3, distance: *mut i32) -> i32;
    pub fn detent_contact3(a: *const Shape3, b: *const Shape3, contact: *mut Manifold3) -> i32;
    pub fn detent_closest_points3(a: *const Shape3, b: *const Shape3, point_a: *mut Vec3, point_b: *mut Vec3) -> i32;
    pub fn detent_cast3(shape: *const Shape3, direction: *const Direction3, max_distance: i32, target: *const Shape3, hit: *mut Hit3) -> i32;
    pub fn detent_time_of_impact3(a: *const Shape3, sweep_a: *const Sweep3, b: *const Shape3, sweep_b: *const Sweep3, target: i32, impact: *mut Impact) -> i32;
    pub fn detent_ray3_contains(ray: *const Ray3, point: *const Vec3) -> i32;
    pub fn detent_ray3_closest_point(ray: *const Ray3, point: *const Vec3, closest: *mut Vec3) -> i32;
    pub fn detent_ray3_distance_to_point(ray: *const Ray3, point: *const Vec3, distance: *mut i32) -> i32;
    pub fn detent_shapes3_raycast(context: *const Context, ray: *const Ray3, shapes: *const Shape3, count: u32, hit: *mut Hit3) -> i32;
    pub fn detent_shapes3_contains(context: *const Context, shapes: *const Shape3, count: u32, point: *const Vec3) -> i32;
    pub fn detent_shapes3_overlaps(context: *const Context, a: *const Shape3, a_count: u32, b: *const Shape3, b_count: u32) -> i32;
    pub fn detent_shapes3_closest_point(context: *const Context, shapes: *const Shape3, count: u32, point: *const Vec3, closest: *mut Vec3) -> i32;
    pub fn detent_shapes3_distance_to_point(context: *const Context, shapes: *const Shape3, count: u32, point: *const Vec3, distance: *mut i32) -> i32;
    pub fn detent_shapes3_distance(context: *const Context, a: *const Shape3, a_count: u32, b: *const Shape3, b_count: u32, distance: *mut i32) -> i32;
    pub fn detent_shapes3_closest_points(context: *const Context, a: *const Shape3, a_count: u32, b: *const Shape3, b_count: u32, point_a: *mut Vec3, point_b: *mut Vec3) -> i32;
    pub fn detent_shapes3_cast(context: *const Context, shape: *const Shape3, direction: *const Direction3, max_distance: i32, targets: *const Shape3, count: u32, hit: *mut Hit3) -> i32;
    pub fn detent_shapes3_contact(context: *const Context, a: *const Shape3, b: *const Shape3, contact: *mut Manifold3) -> i32;
    pub fn detent_shapes3_time_of_impact(context: *const Context, a: *const Shape3, sweep_a: *const Sweep3, b: *const Shape3, sweep_b: *const Sweep3, target: i32, impact: *mut Impact) -> i32;
    pub fn detent_hull3_create(context: *mut Context, id: u32, points: *const Vec3, count: u32, hull: *mut u32) -> i32;
    pub fn detent_solid3_create(context: *mut Context, id: u32, points: *const Vec3, count: u32, solid: *mut u32) -> i32;
    pub fn detent_part3_defaults(part: *mut Part3) -> i32;
    pub fn detent_compound3_create(context: *mut Context, id: u32, parts: *const Part3, count: u32, compound: *mut u32) -> i32;
    pub fn detent_scene3_create(context: *mut Context, scene: *mut u32) -> i32;
    pub fn detent_scene3_destroy(context: *mut Context, scene: u32) -> i32;
    pub fn detent_scene3_add(context: *mut Context, scene: u32, shape: *const Shape3, traits: *const Traits, id: *mut Id) -> i32;
    pub fn detent_scene3_add_as(context: *mut Context, scene: u32, id: Id, shape: *const Shape3, traits: *const Traits) -> i32;
    pub fn detent_scene3_remove(context: *mut Context, scene: u32, id: Id) -> i32;
    pub fn detent_scene3_replace(context: *mut Context, scene: u32, id: Id, shape: *const Shape3) -> i32;
    pub fn detent_scene3_move(context: *mut Context, scene: u32, id: Id, by: *const Vec3) -> i32;
    pub fn detent_scene3_object(context: *const Context, scene: u32, id: Id, shape: *mut Shape3, traits: *mut Traits) -> i32;
    pub fn detent_scene3_set_traits(context: *mut Context, scene: u32, id: Id, traits: *const Traits) -> i32;
    pub fn detent_scene3_add_frame(context: *mut Context, scene: u32, transform: *const Transform3, parent: Id, frame: *mut Id) -> i32;
    pub fn detent_scene3_move_frame(context: *mut Context, scene: u32, frame: Id, transform: *const Transform3) -> i32;
    pub fn detent_scene3_remove_frame(context: *mut Context, scene: u32, frame: Id) -> i32;
    pub fn detent_scene3_frame(context: *const Context, scene: u32, frame: Id, local: *mut Transform3, world: *mut Transform3) -> i32;
    pub fn detent_scene3_size(context: *const Context, scene: u32, size: *mut u32) -> i32;
    pub fn detent_scene3_optimize(context: *mut Context, scene: u32) -> i32;
    pub fn detent_scene3_raycast(context: *const Context, scene: u32, ray: *const Ray3, layers: u32, hit: *mut ObjectHit3) -> i32;
    pub fn detent_scene3_raycast_any(context: *const Context, scene: u32, ray: *const Ray3, layers: u32) -> i32;
    pub fn detent_scene3_raycast_all(context: *const Context, scene: u32, ray: *const Ray3, layers: u32, hits: *mut ObjectHit3, room: u32, count: *mut u32) -> i32;
    pub fn detent_scene3_raycast_many(context: *const Context, scene: u32, rays: *const Ray3, count: u32, layers: u32, hits: *mut ObjectHit3) -> i32;
    pub fn detent_scene3_nearest(context: *const Context, scene: u32, question: *const Shape3, layers: u32, found: *mut Found) -> i32;
    pub fn detent_scene3_any(context: *const Context, scene: u32, question: *const Shape3, layers: u32) -> i32;
    pub fn detent_scene3_all(context: *const Context, scene: u32, question: *const Shape3, layers: u32, found: *mut Found, room: u32, count: *mut u32) -> i32;
    pub fn detent_scene3_overlaps(context: *const Context, scene: u32, pairs: *mut Pair, room: u32, count: *mut u32) -> i32;
    pub fn detent_scene3_cast(context: *const Context, scene: u32, shape: *const Shape3, direction: *const Direction3, max_distance: i32, layers: u32, hit: *mut ObjectHit3) -> i32;
    pub fn detent_scene3_cast_any(context: *const Context, scene: u32, shape: *const Shape3, direction: *const Direction3, max_distance: i32, layers: u32) -> i32;
    pub fn detent_scene3_cast_all(context: *const Context, scene: u32, shape: *const Shape3, direction: *const Direction3, max_distance: i32, layers: u32, hits: *mut ObjectHit3, room: u32, count: *mut u32) -> i32;
    pub fn detent_mover3_default_settings(settings: *mut Mover3Settings) -> i32;
    pub fn detent_mover3_move(context: *const Context, scene: u32, mover: *mut Mover3, by: *const Vec3, settings: *const Mover3Settings, layers: u32, ignored: Id, result: *mut Move3) -> i32;
    pub fn detent_mover3_clip_velocity(velocity: *const Vec3, result: *const Move3, clipped: *mut Vec3) -> i32;
    pub fn detent_scene3_digest(context: *const Context, scene: u32, digest: *mut u64) -> i32;
    pub fn detent_scene3_snapshot(context: *const Context, scene: u32, bytes: *mut c_void, room: u32, size: *mut u32) -> i32;
    pub fn detent_scene3_restore(context: *mut Context, scene: u32, bytes: *const c_void, size: u32) -> i32;
    pub fn detent_world3_default_settings(settings: *mut World3Settings) -> i32;
    pub fn detent_body3_default_options(options: *mut Body3Options) -> i32;
    pub fn detent_world3_create(context: *mut Context, settings: *const World3Settings, world: *mut u32) -> i32;
    pub fn detent_world3_destroy(context: *mut Context, world: u32) -> i32;
    pub fn detent_world3_add(context: *mut Context, world: u32, shape: *const Shape3, options: *const Body3Options, id: *mut Id) -> i32;
    pub fn detent_world3_add_as(context: *mut Context, world: u32, id: Id, shape: *const Shape3, options: *const Body3Options) -> i32;
    pub fn detent_world3_remove(context: *mut Context, world: u32, id: Id) -> i32;
    pub fn detent_world3_step(context: *mut Context, world: u32) -> i32;
    pub fn detent_scene3_follow(context: *mut Context, scene: u32, world: u32, sensors: u32) -> i32;
    pub fn detent_world3_part_of(context: *const Context, world: u32, object: Id, body: *mut Id, part: *mut u32) -> i32;
    pub fn detent_world3_body(context: *const Context, world: u32, id: Id, body: *mut Body3) -> i32;
    pub fn detent_world3_bodies(context: *const Context, world: u32, ids: *const Id, count: u32, bodies: *mut Body3) -> i32;
    pub fn detent_world3_frame(context: *const Context, world: u32, id: Id, frame: *mut Transform3) -> i32;
    pub fn detent_world3_info(context: *const Context, world: u32, id: Id, info: *mut BodyInfo) -> i32;
    pub fn detent_world3_set_position(context: *mut Context, world: u32, id: Id, position: *const Vec3) -> i32;
    pub fn detent_world3_set_rotation(context: *mut Context, world: u32, id: Id, rotation: *const Rotation3) -> i32;
    pub fn detent_world3_set_filter(context: *mut Context, world: u32, id: Id, layers: u32, collides_with: u32) -> i32;
    pub fn detent_world3_set_friction(context: *mut Context, world: u32, id: Id, friction: i32) -> i32;
    pub fn detent_world3_set_restitution(context: *mut Context, world: u32, id: Id, restitution: i32) -> i32;
    pub fn detent_world3_set_sensor(context: *mut Context, world: u32, id: Id, is_sensor: u32) -> i32;
    pub fn detent_world3_set_gravity_scale(context: *mut Context, world: u32, id: Id, scale: i32) -> i32;
    pub fn detent_world3_set_damping(context: *mut Context, world: u32, id: Id, linear: i32, angular: i32) -> i32;
    pub fn detent_world3_set_locked(context: *mut Context, world: u32, id: Id, locked: u32) -> i32;
    pub fn detent_world3_set_fast(context: *mut Context, world: u32, id: Id, is_fast: u32) -> i32;
    pub fn detent_world3_set_user(context: *mut Context, world: u32, id: Id, user: u64) -> i32;
    pub fn detent_world3_set_gravity(context: *mut Context, world: u32, gravity: *const Vec3) -> i32;
    pub fn detent_world3_set_velocity(context: *mut Context, world: u32, id: Id, velocity: *const Vec3) -> i32;
    pub fn detent_world3_set_angular_velocity(context: *mut Context, world: u32, id: Id, velocity: *const i32) -> i32;
    pub fn detent_world3_apply_impulse(context: *mut Context, world: u32, id: Id, impulse: *const Vec3, at: *const Vec3) -> i32;
    pub fn detent_world3_apply_force(context: *mut Context, world: u32, id: Id, force: *const Vec3, at: *const Vec3) -> i32;
    pub fn detent_world3_apply_torque(context: *mut Context, world: u32, id: Id, torque: *const i32) -> i32;
    pub fn detent_joint3_defaults(kind: u32, joint: *mut Joint3) -> i32;
    pub fn detent_world3_add_joint(context: *mut Context, world: u32, joint: *const Joint3, id: *mut Id) -> i32;
    pub fn detent_world3_change_joint(context: *mut Context, world: u32, id: Id, joint: *const Joint3) -> i32;
    pub fn detent_world3_remove_joint(context: *mut Context, world: u32, id: Id) -> i32;
    pub fn detent_world3_joint(context: *const Context, world: u32, id: Id, joint: *mut Joint3) -> i32;
    pub fn detent_world3_joint_force(context: *const Context, world: u32, id: Id, force: *mut Vec3) -> i32;
    pub fn detent_world3_joint_torque(context: *const Context, world: u32, id: Id, torque: *mut i32) -> i32;
    pub fn detent_world3_joint_count(context: *const Context, world: u32, count: *mut u32) -> i32;
    pub fn detent_world3_joint_ids(context: *const Context, world: u32, joints: *mut Id, room: u32, count: *mut u32) -> i32;
    pub fn detent_world3_broken(context: *const Context, world: u32, joints: *mut Id, room: u32, count: *mut u32) -> i32;
    pub fn detent_world3_local_point(context: *const Context, world: u32, id: Id, point: *const Vec3, local: *mut Vec3) -> i32;
    pub fn detent_world3_local_frame(context: *const Context, world: u32, id: Id, frame: *const Rotation3, local: *mut Rotation3) -> i32;
    pub fn detent_world3_size(context: *const Context, world: u32, size: *mut u32) -> i32;
    pub fn detent_world3_body_ids(context: *const Context, world: u32, ids: *mut Id, room: u32, count: *mut u32) -> i32;
    pub fn detent_world3_touching(context: *const Context, world: u32, body: Id, touches: *mut Touch, room: u32, count: *mut u32) -> i32;
    pub fn detent_world3_contacts(context: *const Context, world: u32, body: Id, contacts: *mut World3Contact, room: u32, count: *mut u32) -> i32;
    pub fn detent_world3_events(context: *const Context, world: u32, events: *mut Touch, room: u32, count: *mut u32) -> i32;
    pub fn detent_world3_digest(context: *const Context, world: u32, digest: *mut u64) -> i32;
    pub fn detent_world3_digest_of(context: *const Context, world: u32, id: Id, digest: *mut u64) -> i32;
    pub fn detent_world3_snapshot(context: *const Context, world: u32, bytes: *mut c_void, room: u32, size: *mut u32) -> i32;
    pub fn detent_world3_restore(context: *mut Context, world: u32, bytes: *const c_void, size: u32) -> i32;
    pub fn detent_world3_diff(context: *const Context, a: u32, b: u32, most: u32, names: *mut c_void, room: u32, size: *mut u32) -> i32;
    pub fn detent_scene3_diff(context: *const Context, a: u32, b: u32, most: u32, names: *mut c_void, room: u32, size: *mut u32) -> i32;
    pub fn detent_session3_create(context: *mut Context, settings: *const SessionSettings, world: u32, session: *mut u32) -> i32;
    pub fn detent_session3_destroy(context: *mut Context, session: u32) -> i32;
    pub fn detent_session3_world(context: *const Context, session: u32, world: *mut u32) -> i32;
    pub fn detent_session3_receive(context: *mut Context, session: u32, peer: u32, bytes: *const c_void, size: u32, now: u64) -> i32;
    pub fn detent_session3_begin_frame(context: *mut Context, session: u32, input: *const c_void, frame: *mut Frame, inputs: *mut c_void) -> i32;
    pub fn detent_session3_end_frame(context: *mut Context, session: u32) -> i32;
    pub fn detent_session3_packet(context: *mut Context, session: u32, now: u64, peer: *mut u32, bytes: *mut c_void, room: u32, size: *mut u32) -> i32;
    pub fn detent_session3_event(context: *mut Context, session: u32, event: *mut SessionEvent, name: *mut c_void, room: u32) -> i32;
    pub fn detent_session3_status(context: *const Context, session: u32, status: *mut SessionStatus) -> i32;
    pub fn detent_session3_matched(context: *const Context, session: u32, peer: u32, frame: *mut u32) -> i32;
    pub fn detent_session3_is_awaited(context: *const Context, session: u32, player: u32) -> i32;
    pub fn detent_session3_drop(context: *mut Context, session: u32, peer: u32) -> i32;
    pub fn detent_session3_pause(context: *mut Context, session: u32, is_paused: u32) -> i32;
    pub fn detent_session3_replay(context: *const Context, session: u32, bytes: *mut c_void, room: u32, size: *mut u32) -> i32;
    pub fn detent_world3_words(context: *const Context, world: u32, words: *mut u32) -> i32;
    pub fn detent_world3_set_words(context: *mut Context, world: u32, words: *const u32) -> i32;
    pub fn detent_replay3_create(context: *mut Context, bytes: *const c_void, size: u32, world: u32, input_size: u32, words: u32, replay: *mut u32) -> i32;
    pub fn detent_replay3_destroy(context: *mut Context, replay: u32) -> i32;
    pub fn detent_replay3_world(context: *const Context, replay: u32, world: *mut u32) -> i32;
    pub fn detent_replay3_begin_frame(context: *mut Context, replay: u32, frame: *mut Frame, inputs: *mut c_void) -> i32;
    pub fn detent_replay3_end_frame(context: *mut Context, replay: u32) -> i32;
    pub fn detent_replay3_check(context: *const Context, replay: u32, check: *mut ReplayCheck) -> i32;
    pub fn detent_camera3_look_at(eye: *const Vec3, target: *const Vec3, up: *const Vec3, pose: *mut Transform3) -> i32;
    pub fn detent_camera3_frustum(camera: *const Camera3, frustum: *mut Frustum3) -> i32;
    pub fn detent_camera3_pick_ray(camera: *const Camera3, width: i32, height: i32, column: i32, row: i32, ray: *mut Ray3) -> i32;
    pub fn detent_camera3_project(camera: *const Camera3, width: i32, height: i32, point: *const Vec3, seen: *mut ScreenPoint3) -> i32;
    pub fn detent_camera3_unproject(camera: *const Camera3, width: i32, height: i32, column: i32, row: i32, depth: i32, point: *mut Vec3) -> i32;
    pub fn detent_frustum3_raycast(ray: *const Ray3, frustum: *const Frustum3, hit: *mut Hit3) -> i32;
    pub fn detent_frustum3_contains(frustum: *const Frustum3, point: *const Vec3) -> i32;
    pub fn detent_frustum3_overlaps(context: *const Context, frustum: *const Frustum3, shapes: *const Shape3, count: u32) -> i32;
    pub fn detent_frustum3_overlaps_frustum(a: *const Frustum3, b: *const Frustum3) -> i32;
    pub fn detent_frustum3_closest_point(frustum: *const Frustum3, point: *const Vec3, closest: *mut Vec3) -> i32;
    pub fn detent_frustum3_distance_to_point(frustum: *const Frustum3, point: *const Vec3, distance: *mut i32) -> i32;
    pub fn detent_scene3_frustum_nearest(context: *const Context, scene: u32, frustum: *const Frustum3, layers: u32, found: *mut Found) -> i32;
    pub fn detent_scene3_frustum_any(context: *const Context, scene: u32, frustum: *const Frustum3, layers: u32) -> i32;
    pub fn detent_scene3_frustum_all(context: *const Context, scene: u32, frustum: *const Frustum3, layers: u32, found: *mut Found, room: u32, count: *mut u32) -> i32;
}
