// SPDX-License-Identifier: MIT
// Written by bindings/generate from bindings/detent.h.in: change that file instead.
// The C interface as it is.
using System;
using System.Runtime.InteropServices;

namespace Detent {

/// <summary>The id of an object of a scene or a body of a world. Ids are never reused; {0, 0} is none.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct Id {
  public uint index;
  public uint generation;
}

/// <summary>Two objects or bodies.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct Pair {
  public Id first;
  public Id second;
}

/// <summary>A pair of bodies that began (1) or ceased (0) to touch in the last step; for compounds, a pair of parts.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct Touch {
  public Id a;
  public Id b;
  public uint begins;
  public uint part_a;
  public uint part_b;
}

/// <summary>The properties of a body.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct BodyInfo {
  public ulong user;
  public uint layers;
  public uint collides_with;
  public uint motion;
  public uint is_sensor;
  public uint is_asleep;
  public uint part_count;
}

/// <summary>An object found by a query, and its distance in steps of 2^-16.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct Found {
  public int distance;
  public Id id;
}

/// <summary>When two moving shapes meet. They are disjoint before `time` (in steps of 2^-30) and at most `distance` apart at `time`. If `is_hit` is 0 the search ended early, and whether they meet later is unknown.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct Impact {
  public int time;
  public int distance;
  public uint is_hit;
}

/// <summary>The settings of a match and of one peer. Times are in microseconds of this peer's own clock.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct SessionSettings {
  public ulong match;
  public ulong send_interval;
  public ulong silence;
  public uint self;
  public uint players;
  public uint spectators;
  public uint delay;
  public uint prediction;
  public uint frames_per_call;
  public uint absent;
  public uint life;
  public uint wants_seat;
  public uint input_size;
  public uint words;
  public uint replay_every;
}

/// <summary>A frame to simulate, or the reason why there is none. Players whose bit in `present` is set take part.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct Frame {
  public uint number;
  public uint players;
  public uint present;
  public uint state;
}

/// <summary>An event of a session.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct SessionEvent {
  public uint kind;
  public uint peer;
  public uint frame;
  public uint name_size;
  public uint has_object;
  public Id @object;
}

/// <summary>The progress of a session.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct SessionStatus {
  public ulong digest;
  public ulong resimulated;
  public uint frame;
  public uint final_frame;
  public uint checked_frame;
  public uint start_frame;
  public uint is_player;
  public uint players;
}

/// <summary>The result of resimulating a replay so far.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct ReplayCheck {
  public uint state;
  public uint frames;
  public uint equal;
  public uint is_equal;
  public uint players;
}

/// <summary>What a scene stores with an object, besides its shape.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct Traits {
  public ulong user;
  public uint layers;
  public uint motion;
  public Id frame;
}

/// <summary>The owner of everything else. The caller provides its memory: zero it, open it and close it, and do not move it while it is open. Contexts share nothing. On one context, functions that only read (const detent_context*) may run in several threads at once; any other call needs exclusive access.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct ContextMemory {
  public ulong words0;
  public ulong words1;
  public ulong words2;
  public ulong words3;
}

/// <summary>A point or vector, in steps of 2^-16.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct Vec2 {
  public int x;
  public int y;
}

/// <summary>A unit vector, in steps of 2^-30; used as stored, never normalised.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct Direction2 {
  public int x;
  public int y;
}

/// <summary>The axes of a frame in the world.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct Rotation2 {
  public Direction2 axis0;
  public Direction2 axis1;
}

/// <summary>p -> translation + scale * rotation * p; `scale` in steps of 2^-16.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct Transform2 {
  public Vec2 translation;
  public Rotation2 rotation;
  public int scale;
}

/// <summary>The points origin + t * direction with 0 &lt;= t &lt;= max_distance.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct Ray2 {
  public Vec2 origin;
  public Direction2 direction;
  public int max_distance;
}

/// <summary>The points within `radius` of `center`; none if the radius is negative.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct Sphere2 {
  public Vec2 center;
  public int radius;
}

/// <summary>The points between two corners, inclusive; none if min > max on an axis.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct Aabb2 {
  public Vec2 min;
  public Vec2 max;
}

/// <summary>A box rotated about its center; none if a half extent is negative.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct Obb2 {
  public Vec2 center;
  public Vec2 half_extents;
  public Rotation2 rotation;
}

/// <summary>The points x with dot(normal, x) = offset.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct Plane2 {
  public Direction2 normal;
  public int offset;
}

/// <summary>The points of the triangle with these corners.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct Triangle2 {
  public Vec2 a;
  public Vec2 b;
  public Vec2 c;
}

/// <summary>The points within `radius` of the segment from a to b; none if the radius is negative.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct Capsule2 {
  public Vec2 a;
  public Vec2 b;
  public int radius;
}

/// <summary>The points between the two ends.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct Segment2 {
  public Vec2 start;
  public Vec2 end;
}

[StructLayout(LayoutKind.Explicit)]
public struct Shape2As {
  [FieldOffset(0)] public Sphere2 sphere;
  [FieldOffset(0)] public Aabb2 aabb;
  [FieldOffset(0)] public Obb2 obb;
  [FieldOffset(0)] public Plane2 plane;
  [FieldOffset(0)] public Triangle2 triangle;
  [FieldOffset(0)] public Capsule2 capsule;
  [FieldOffset(0)] public Segment2 segment;
  [FieldOffset(0)] public Vec2 point;
  [FieldOffset(0)] public Transform2 placed;
}

/// <summary>A shape of any kind. `kind` selects the member of the union. `asset` is the handle of a hull, mesh or height field; other kinds ignore it.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct Shape2 {
  public uint kind;
  public uint asset;
  public Shape2As of;
}

/// <summary>The first contact of a ray or moving shape with a shape. The distance is rounded down.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct Hit2 {
  public int distance;
  public Vec2 point;
  public Direction2 normal;
}

/// <summary>One contact point on the surface of the first shape. The second shape's surface is at point - depth * normal. `feature` identifies the corners, edges or faces that meet, and is stable while they do.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct ContactPoint2 {
  public Vec2 point;
  public int depth;
  public uint feature;
}

/// <summary>The least translation that separates two overlapping shapes a and b: move b by `depth`, rounded up, along `normal`, which points from a to b. The first `count` points are set, the others are zero.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct Manifold2 {
  public Direction2 normal;
  public int depth;
  public uint count;
  public ContactPoint2 points0;
  public ContactPoint2 points1;
}

/// <summary>The motion of a frame between two poses over the time 0 to 1. The origin moves at constant velocity; the frame rotates about one axis by at most half a turn.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct Sweep2 {
  public Vec2 start;
  public Vec2 end;
  public Rotation2 start_rotation;
  public Rotation2 end_rotation;
}

/// <summary>The first point where a ray touches an object; for a mesh or height field also the triangle's index.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct ObjectHit2 {
  public int distance;
  public Id id;
  public Vec2 point;
  public Direction2 normal;
  public uint triangle;
  public uint has_triangle;
}

/// <summary>A walking character: its capsule or AABB, and what it stands on. This is its whole state. Start with zeros and the shape in place. Setting `is_grounded` to 0 makes it leave the ground. A ball is a capsule with equal ends.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct Mover2 {
  public Shape2 shape;
  public uint is_grounded;
  public Id @object;
  public Direction2 normal;
  public Id frame;
  public Vec2 local;
  public Vec2 point;
}

/// <summary>Settings of a character's movement. Lengths in steps of 2^-16.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct Mover2Settings {
  public Direction2 up;
  public int skin;
  public int step_height;
  public int snap_distance;
  public uint max_slope;
}

/// <summary>Something the character touched during a move. The normal points away from it.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct Mover2Touch {
  public Id @object;
  public Vec2 point;
  public Direction2 normal;
}

/// <summary>The result of a move. The first `count` touches are set, the others are zero.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct Move2 {
  public Vec2 moved;
  public Vec2 carried;
  public Vec2 pushed;
  public uint count;
  public uint is_stuck;
  public Mover2Touch touched0;
  public Mover2Touch touched1;
  public Mover2Touch touched2;
  public Mover2Touch touched3;
  public Mover2Touch touched4;
  public Mover2Touch touched5;
  public Mover2Touch touched6;
  public Mover2Touch touched7;
}

/// <summary>A point at which two bodies touch. Lengths and impulses in steps of 2^-16.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct World2ContactPoint {
  public Vec2 point;
  public int separation;
  public int impulse;
  public uint feature;
}

/// <summary>The contact of two bodies; for compounds that of two parts, for meshes and height fields that of one triangle. The first `count` points are set, the others are zero. Impulses act on b; a gets the opposite. They are those of the last substep, in units of mass times units per second.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct World2Contact {
  public Id a;
  public Id b;
  public uint part_a;
  public uint part_b;
  public uint triangle;
  public Direction2 normal;
  public int impulse;
  public Vec2 friction;
  public uint count;
  public World2ContactPoint points0;
  public World2ContactPoint points1;
}

/// <summary>Settings of a world. Lengths and speeds in steps of 2^-16.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct World2Settings {
  public int ticks_per_second;
  public int substeps;
  public Vec2 gravity;
  public int margin;
  public int push_speed;
  public int bounce_threshold;
  public int sleep_speed;
  public int hold_distance;
}

/// <summary>The material and initial state of a body. Ratios and densities in steps of 2^-16.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct Body2Options {
  public ulong user;
  public uint layers;
  public uint collides_with;
  public uint motion;
  public int density;
  public int friction;
  public int restitution;
  public int rolling_resistance;
  public int linear_damping;
  public int angular_damping;
  public Vec2 velocity;
  public int angular_velocity0;
  public int gravity_scale;
  public uint locked;
  public uint is_sensor;
  public uint is_fast;
  public uint reserved0;
  public uint reserved1;
}

/// <summary>A part of a compound: a sphere, AABB, OBB, capsule or solid hull in the compound's frame, and its material, in steps of 2^-16. Start from `detent_part2_defaults`.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct Part2 {
  public Shape2 shape;
  public int density;
  public int friction;
  public int restitution;
  public int rolling_resistance;
  public uint is_sensor;
}

/// <summary>A joint between two bodies a and b. Anchors and frames are in body space. Time is in the seconds of the world's settings, angles in radians, and all numbers are in steps of 2^-16. Fields that a kind does not have are ignored.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct Joint2 {
  public uint kind;
  public Id a;
  public Id b;
  public Vec2 anchor_a;
  public Vec2 anchor_b;
  public Rotation2 frame_a;
  public Rotation2 frame_b;
  public uint collide;
  public int break_force;
  public uint has_limits;
  public int lower;
  public int upper;
  public int motor_speed;
  public int motor_force;
  public int length;
  public int frequency;
  public int damping_ratio;
  public int cone_angle;
}

/// <summary>The state of a body, rounded to nearest.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct Body2 {
  public Vec2 position;
  public Rotation2 rotation;
  public Vec2 velocity;
  public int angular_velocity0;
  public uint is_asleep;
}

/// <summary>A point or vector, in steps of 2^-16.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct Vec3 {
  public int x;
  public int y;
  public int z;
}

/// <summary>A unit vector, in steps of 2^-30; used as stored, never normalised.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct Direction3 {
  public int x;
  public int y;
  public int z;
}

/// <summary>The axes of a frame in the world.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct Rotation3 {
  public Direction3 axis0;
  public Direction3 axis1;
  public Direction3 axis2;
}

/// <summary>p -> translation + scale * rotation * p; `scale` in steps of 2^-16.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct Transform3 {
  public Vec3 translation;
  public Rotation3 rotation;
  public int scale;
}

/// <summary>The points origin + t * direction with 0 &lt;= t &lt;= max_distance.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct Ray3 {
  public Vec3 origin;
  public Direction3 direction;
  public int max_distance;
}

/// <summary>The points within `radius` of `center`; none if the radius is negative.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct Sphere3 {
  public Vec3 center;
  public int radius;
}

/// <summary>The points between two corners, inclusive; none if min > max on an axis.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct Aabb3 {
  public Vec3 min;
  public Vec3 max;
}

/// <summary>A box rotated about its center; none if a half extent is negative.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct Obb3 {
  public Vec3 center;
  public Vec3 half_extents;
  public Rotation3 rotation;
}

/// <summary>The points x with dot(normal, x) = offset.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct Plane3 {
  public Direction3 normal;
  public int offset;
}

/// <summary>The points of the triangle with these corners.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct Triangle3 {
  public Vec3 a;
  public Vec3 b;
  public Vec3 c;
}

/// <summary>The points within `radius` of the segment from a to b; none if the radius is negative.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct Capsule3 {
  public Vec3 a;
  public Vec3 b;
  public int radius;
}

/// <summary>The points between the two ends.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct Segment3 {
  public Vec3 start;
  public Vec3 end;
}

[StructLayout(LayoutKind.Explicit)]
public struct Shape3As {
  [FieldOffset(0)] public Sphere3 sphere;
  [FieldOffset(0)] public Aabb3 aabb;
  [FieldOffset(0)] public Obb3 obb;
  [FieldOffset(0)] public Plane3 plane;
  [FieldOffset(0)] public Triangle3 triangle;
  [FieldOffset(0)] public Capsule3 capsule;
  [FieldOffset(0)] public Segment3 segment;
  [FieldOffset(0)] public Vec3 point;
  [FieldOffset(0)] public Transform3 placed;
}

/// <summary>A shape of any kind. `kind` selects the member of the union. `asset` is the handle of a hull, mesh or height field; other kinds ignore it.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct Shape3 {
  public uint kind;
  public uint asset;
  public Shape3As of;
}

/// <summary>The first contact of a ray or moving shape with a shape. The distance is rounded down.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct Hit3 {
  public int distance;
  public Vec3 point;
  public Direction3 normal;
}

/// <summary>One contact point on the surface of the first shape. The second shape's surface is at point - depth * normal. `feature` identifies the corners, edges or faces that meet, and is stable while they do.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct ContactPoint3 {
  public Vec3 point;
  public int depth;
  public uint feature;
}

/// <summary>The least translation that separates two overlapping shapes a and b: move b by `depth`, rounded up, along `normal`, which points from a to b. The first `count` points are set, the others are zero.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct Manifold3 {
  public Direction3 normal;
  public int depth;
  public uint count;
  public ContactPoint3 points0;
  public ContactPoint3 points1;
  public ContactPoint3 points2;
  public ContactPoint3 points3;
}

/// <summary>The motion of a frame between two poses over the time 0 to 1. The origin moves at constant velocity; the frame rotates about one axis by at most half a turn.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct Sweep3 {
  public Vec3 start;
  public Vec3 end;
  public Rotation3 start_rotation;
  public Rotation3 end_rotation;
}

/// <summary>The first point where a ray touches an object; for a mesh or height field also the triangle's index.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct ObjectHit3 {
  public int distance;
  public Id id;
  public Vec3 point;
  public Direction3 normal;
  public uint triangle;
  public uint has_triangle;
}

/// <summary>A walking character: its capsule or AABB, and what it stands on. This is its whole state. Start with zeros and the shape in place. Setting `is_grounded` to 0 makes it leave the ground. A ball is a capsule with equal ends.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct Mover3 {
  public Shape3 shape;
  public uint is_grounded;
  public Id @object;
  public Direction3 normal;
  public Id frame;
  public Vec3 local;
  public Vec3 point;
}

/// <summary>Settings of a character's movement. Lengths in steps of 2^-16.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct Mover3Settings {
  public Direction3 up;
  public int skin;
  public int step_height;
  public int snap_distance;
  public uint max_slope;
}

/// <summary>Something the character touched during a move. The normal points away from it.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct Mover3Touch {
  public Id @object;
  public Vec3 point;
  public Direction3 normal;
}

/// <summary>The result of a move. The first `count` touches are set, the others are zero.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct Move3 {
  public Vec3 moved;
  public Vec3 carried;
  public Vec3 pushed;
  public uint count;
  public uint is_stuck;
  public Mover3Touch touched0;
  public Mover3Touch touched1;
  public Mover3Touch touched2;
  public Mover3Touch touched3;
  public Mover3Touch touched4;
  public Mover3Touch touched5;
  public Mover3Touch touched6;
  public Mover3Touch touched7;
}

/// <summary>A point at which two bodies touch. Lengths and impulses in steps of 2^-16.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct World3ContactPoint {
  public Vec3 point;
  public int separation;
  public int impulse;
  public uint feature;
}

/// <summary>The contact of two bodies; for compounds that of two parts, for meshes and height fields that of one triangle. The first `count` points are set, the others are zero. Impulses act on b; a gets the opposite. They are those of the last substep, in units of mass times units per second.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct World3Contact {
  public Id a;
  public Id b;
  public uint part_a;
  public uint part_b;
  public uint triangle;
  public Direction3 normal;
  public int impulse;
  public Vec3 friction;
  public uint count;
  public World3ContactPoint points0;
  public World3ContactPoint points1;
  public World3ContactPoint points2;
  public World3ContactPoint points3;
}

/// <summary>Settings of a world. Lengths and speeds in steps of 2^-16.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct World3Settings {
  public int ticks_per_second;
  public int substeps;
  public Vec3 gravity;
  public int margin;
  public int push_speed;
  public int bounce_threshold;
  public int sleep_speed;
  public int hold_distance;
}

/// <summary>The material and initial state of a body. Ratios and densities in steps of 2^-16.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct Body3Options {
  public ulong user;
  public uint layers;
  public uint collides_with;
  public uint motion;
  public int density;
  public int friction;
  public int restitution;
  public int rolling_resistance;
  public int linear_damping;
  public int angular_damping;
  public Vec3 velocity;
  public int angular_velocity0;
  public int angular_velocity1;
  public int angular_velocity2;
  public int gravity_scale;
  public uint locked;
  public uint is_sensor;
  public uint is_fast;
  public uint reserved0;
  public uint reserved1;
  public uint reserved2;
}

/// <summary>A part of a compound: a sphere, AABB, OBB, capsule or solid hull in the compound's frame, and its material, in steps of 2^-16. Start from `detent_part3_defaults`.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct Part3 {
  public Shape3 shape;
  public int density;
  public int friction;
  public int restitution;
  public int rolling_resistance;
  public uint is_sensor;
}

/// <summary>A joint between two bodies a and b. Anchors and frames are in body space. Time is in the seconds of the world's settings, angles in radians, and all numbers are in steps of 2^-16. Fields that a kind does not have are ignored.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct Joint3 {
  public uint kind;
  public Id a;
  public Id b;
  public Vec3 anchor_a;
  public Vec3 anchor_b;
  public Rotation3 frame_a;
  public Rotation3 frame_b;
  public uint collide;
  public int break_force;
  public uint has_limits;
  public int lower;
  public int upper;
  public int motor_speed;
  public int motor_force;
  public int length;
  public int frequency;
  public int damping_ratio;
  public int cone_angle;
}

/// <summary>The state of a body, rounded to nearest.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct Body3 {
  public Vec3 position;
  public Rotation3 rotation;
  public Vec3 velocity;
  public int angular_velocity0;
  public int angular_velocity1;
  public int angular_velocity2;
  public uint is_asleep;
}

/// <summary>A camera: its pose and lens. The pose is that of `detent_camera3_look_at`: axis 0 points right, axis 1 up, and it looks along -axis 2. The scale is ignored.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct Camera3 {
  public Transform3 pose;
  public uint has_perspective;
  public uint fov;
  public int aspect;
  public int half_width;
  public int half_height;
  public int near_distance;
  public int far_distance;
}

/// <summary>The view volume of a camera: the convex hull of eight corners. Corner i is right if i &amp; 1, top if i &amp; 2 and far if i &amp; 4. Every query is exact for any eight points in any order.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct Frustum3 {
  public Vec3 corners0;
  public Vec3 corners1;
  public Vec3 corners2;
  public Vec3 corners3;
  public Vec3 corners4;
  public Vec3 corners5;
  public Vec3 corners6;
  public Vec3 corners7;
}

/// <summary>A screen point: pixels from the top left corner in steps of 2^-16, so that 32768 is the middle of the first pixel, and the depth along the line of sight, a length.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct ScreenPoint3 {
  public int x;
  public int y;
  public int depth;
}

public static unsafe class C {
  public const int OK = 1;
  public const int NO = 0;
  public const int BAD_ARGUMENT = -1;
  public const int BAD_CONTEXT = -2;
  public const int BAD_HANDLE = -3;
  public const int NOT_UNIT = -4;
  public const int NO_QUERY = -5;
  public const int NO_MEMORY = -6;
  public const int BROKEN = -7;
  public const int FULL = -8;
  public const int IN_USE = -9;
  public const int NOT_NOW = -10;
  public const int NO_SNAPSHOT = -20;
  public const int OTHER_VERSION = -21;
  public const int TRUNCATED = -22;
  public const int CORRUPTED = -23;
  public const int OTHER_SCENE = -24;
  public const int OTHER_FIXED_PART = -25;
  public const int NO_ROOM = -26;
  public const int UNKNOWN_ASSET = -27;
  public const int OTHER_ASSET = -28;
  public const uint SPHERE = 1;
  public const uint AABB = 2;
  public const uint OBB = 3;
  public const uint PLANE = 4;
  public const uint TRIANGLE = 5;
  public const uint CAPSULE = 6;
  public const uint SEGMENT = 7;
  public const uint POINT = 8;
  public const uint HULL = 9;
  public const uint MESH = 10;
  public const uint HEIGHT_FIELD = 11;
  public const uint COMPOUND = 12;
  public const uint MOVING = 0;
  public const uint FIXED = 1;
  public const uint DYNAMIC_BODY = 0;
  public const uint KINEMATIC_BODY = 1;
  public const uint FIXED_BODY = 2;
  public const uint DISTANCE_JOINT = 1;
  public const uint BALL_JOINT = 2;
  public const uint HINGE_JOINT = 3;
  public const uint WELD_JOINT = 4;
  public const uint SLIDER_JOINT = 5;
  public const uint WHEEL_JOINT = 6;
  public const uint CONE_JOINT = 7;
  public const uint LOCK_X = 1;
  public const uint LOCK_Y = 2;
  public const uint LOCK_Z = 4;
  public const uint LOCK_TURN_X = 8;
  public const uint LOCK_TURN_Y = 16;
  public const uint LOCK_TURN_Z = 32;
  public const uint PLAYED = 0;
  public const uint CONNECTING = 1;
  public const uint CATCHING_UP = 2;
  public const uint STARVED = 3;
  public const uint AHEAD = 4;
  public const uint PAUSED = 5;
  public const uint OVER = 6;
  public const uint JOINING = 7;
  public const uint CONNECTED = 0;
  public const uint SILENT = 1;
  public const uint HEARD_AGAIN = 2;
  public const uint PEER_PAUSED = 3;
  public const uint PEER_RESUMED = 4;
  public const uint DROPPED = 5;
  public const uint EXPELLED = 6;
  public const uint LEFT = 7;
  public const uint TOO_SLOW = 8;
  public const uint CONTRADICTION = 9;
  public const uint DESYNC = 10;
  public const uint DESYNC_FIELD = 11;
  public const uint ARRIVED = 12;
  public const uint LOADED = 13;
  public const uint NO_SUCH_WORLD = 14;
  public const uint JOINED = 15;
  public const uint REPLAY_WHOLE = 0;
  public const uint REPLAY_CUT = 1;
  public const uint REPLAY_CORRUPTED = 2;
  public const uint INPUT = 16;
  public const uint PACKET = 1200;
  public const uint LATE_SNAPSHOT = 65536;
  public const uint NAME = 119;
  public const uint WORDS = 256;
  public const uint PLAYERS = 8;

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_version();

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_results_version();

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern IntPtr detent_describe(int status);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_open(ContextMemory* context, void* allocator);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_close(ContextMemory* context);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_count(ContextMemory* context, uint* count);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_session_default_settings(SessionSettings* settings);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_mesh_create(ContextMemory* context, uint id, Vec3* vertices, uint vertex_count, uint* faces, uint face_count, uint* mesh);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_height_field_create(ContextMemory* context, uint id, Vec2* corner, int cell, uint columns, uint rows, int* heights, uint* field);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_asset_destroy(ContextMemory* context, uint asset);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_raycast2(Ray2* ray, Shape2* shape, Hit2* hit);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_raycast2_many(Ray2* rays, uint count, Shape2* shape, int* distances);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_contains2(Shape2* shape, Vec2* point);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_overlaps2(Shape2* a, Shape2* b);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_closest_point2(Shape2* shape, Vec2* point, Vec2* closest);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_distance_to_point2(Shape2* shape, Vec2* point, int* distance);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_distance2(Shape2* a, Shape2* b, int* distance);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_contact2(Shape2* a, Shape2* b, Manifold2* contact);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_closest_points2(Shape2* a, Shape2* b, Vec2* point_a, Vec2* point_b);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_cast2(Shape2* shape, Direction2* direction, int max_distance, Shape2* target, Hit2* hit);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_time_of_impact2(Shape2* a, Sweep2* sweep_a, Shape2* b, Sweep2* sweep_b, int target, Impact* impact);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_ray2_contains(Ray2* ray, Vec2* point);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_ray2_closest_point(Ray2* ray, Vec2* point, Vec2* closest);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_ray2_distance_to_point(Ray2* ray, Vec2* point, int* distance);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_shapes2_raycast(ContextMemory* context, Ray2* ray, Shape2* shapes, uint count, Hit2* hit);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_shapes2_contains(ContextMemory* context, Shape2* shapes, uint count, Vec2* point);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_shapes2_overlaps(ContextMemory* context, Shape2* a, uint a_count, Shape2* b, uint b_count);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_shapes2_closest_point(ContextMemory* context, Shape2* shapes, uint count, Vec2* point, Vec2* closest);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_shapes2_distance_to_point(ContextMemory* context, Shape2* shapes, uint count, Vec2* point, int* distance);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_shapes2_distance(ContextMemory* context, Shape2* a, uint a_count, Shape2* b, uint b_count, int* distance);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_shapes2_closest_points(ContextMemory* context, Shape2* a, uint a_count, Shape2* b, uint b_count, Vec2* point_a, Vec2* point_b);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_shapes2_cast(ContextMemory* context, Shape2* shape, Direction2* direction, int max_distance, Shape2* targets, uint count, Hit2* hit);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_shapes2_contact(ContextMemory* context, Shape2* a, Shape2* b, Manifold2* contact);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_shapes2_time_of_impact(ContextMemory* context, Shape2* a, Sweep2* sweep_a, Shape2* b, Sweep2* sweep_b, int target, Impact* impact);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_hull2_create(ContextMemory* context, uint id, Vec2* points, uint count, uint* hull);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_solid2_create(ContextMemory* context, uint id, Vec2* points, uint count, uint* solid);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_part2_defaults(Part2* part);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_compound2_create(ContextMemory* context, uint id, Part2* parts, uint count, uint* compound);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_scene2_create(ContextMemory* context, uint* scene);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_scene2_destroy(ContextMemory* context, uint scene);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_scene2_add(ContextMemory* context, uint scene, Shape2* shape, Traits* traits, Id* id);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_scene2_add_as(ContextMemory* context, uint scene, Id id, Shape2* shape, Traits* traits);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_scene2_remove(ContextMemory* context, uint scene, Id id);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_scene2_replace(ContextMemory* context, uint scene, Id id, Shape2* shape);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_scene2_move(ContextMemory* context, uint scene, Id id, Vec2* by);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_scene2_object(ContextMemory* context, uint scene, Id id, Shape2* shape, Traits* traits);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_scene2_set_traits(ContextMemory* context, uint scene, Id id, Traits* traits);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_scene2_add_frame(ContextMemory* context, uint scene, Transform2* transform, Id parent, Id* frame);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_scene2_move_frame(ContextMemory* context, uint scene, Id frame, Transform2* transform);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_scene2_remove_frame(ContextMemory* context, uint scene, Id frame);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_scene2_frame(ContextMemory* context, uint scene, Id frame, Transform2* local, Transform2* world);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_scene2_size(ContextMemory* context, uint scene, uint* size);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_scene2_optimize(ContextMemory* context, uint scene);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_scene2_raycast(ContextMemory* context, uint scene, Ray2* ray, uint layers, ObjectHit2* hit);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_scene2_raycast_any(ContextMemory* context, uint scene, Ray2* ray, uint layers);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_scene2_raycast_all(ContextMemory* context, uint scene, Ray2* ray, uint layers, ObjectHit2* hits, uint room, uint* count);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_scene2_raycast_many(ContextMemory* context, uint scene, Ray2* rays, uint count, uint layers, ObjectHit2* hits);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_scene2_nearest(ContextMemory* context, uint scene, Shape2* question, uint layers, Found* found);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_scene2_any(ContextMemory* context, uint scene, Shape2* question, uint layers);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_scene2_all(ContextMemory* context, uint scene, Shape2* question, uint layers, Found* found, uint room, uint* count);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_scene2_overlaps(ContextMemory* context, uint scene, Pair* pairs, uint room, uint* count);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_scene2_cast(ContextMemory* context, uint scene, Shape2* shape, Direction2* direction, int max_distance, uint layers, ObjectHit2* hit);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_scene2_cast_any(ContextMemory* context, uint scene, Shape2* shape, Direction2* direction, int max_distance, uint layers);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_scene2_cast_all(ContextMemory* context, uint scene, Shape2* shape, Direction2* direction, int max_distance, uint layers, ObjectHit2* hits, uint room, uint* count);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_mover2_default_settings(Mover2Settings* settings);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_mover2_move(ContextMemory* context, uint scene, Mover2* mover, Vec2* by, Mover2Settings* settings, uint layers, Id ignored, Move2* result);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_mover2_clip_velocity(Vec2* velocity, Move2* result, Vec2* clipped);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_scene2_digest(ContextMemory* context, uint scene, ulong* digest);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_scene2_snapshot(ContextMemory* context, uint scene, void* bytes, uint room, uint* size);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_scene2_restore(ContextMemory* context, uint scene, void* bytes, uint size);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world2_default_settings(World2Settings* settings);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_body2_default_options(Body2Options* options);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world2_create(ContextMemory* context, World2Settings* settings, uint* world);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world2_destroy(ContextMemory* context, uint world);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world2_add(ContextMemory* context, uint world, Shape2* shape, Body2Options* options, Id* id);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world2_add_as(ContextMemory* context, uint world, Id id, Shape2* shape, Body2Options* options);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world2_remove(ContextMemory* context, uint world, Id id);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world2_step(ContextMemory* context, uint world);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_scene2_follow(ContextMemory* context, uint scene, uint world, uint sensors);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world2_part_of(ContextMemory* context, uint world, Id @object, Id* body, uint* part);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world2_body(ContextMemory* context, uint world, Id id, Body2* body);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world2_bodies(ContextMemory* context, uint world, Id* ids, uint count, Body2* bodies);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world2_frame(ContextMemory* context, uint world, Id id, Transform2* frame);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world2_info(ContextMemory* context, uint world, Id id, BodyInfo* info);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world2_set_position(ContextMemory* context, uint world, Id id, Vec2* position);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world2_set_rotation(ContextMemory* context, uint world, Id id, Rotation2* rotation);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world2_set_filter(ContextMemory* context, uint world, Id id, uint layers, uint collides_with);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world2_set_friction(ContextMemory* context, uint world, Id id, int friction);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world2_set_restitution(ContextMemory* context, uint world, Id id, int restitution);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world2_set_sensor(ContextMemory* context, uint world, Id id, uint is_sensor);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world2_set_gravity_scale(ContextMemory* context, uint world, Id id, int scale);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world2_set_damping(ContextMemory* context, uint world, Id id, int linear, int angular);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world2_set_locked(ContextMemory* context, uint world, Id id, uint locked);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world2_set_fast(ContextMemory* context, uint world, Id id, uint is_fast);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world2_set_user(ContextMemory* context, uint world, Id id, ulong user);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world2_set_gravity(ContextMemory* context, uint world, Vec2* gravity);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world2_set_velocity(ContextMemory* context, uint world, Id id, Vec2* velocity);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world2_set_angular_velocity(ContextMemory* context, uint world, Id id, int* velocity);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world2_apply_impulse(ContextMemory* context, uint world, Id id, Vec2* impulse, Vec2* at);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world2_apply_force(ContextMemory* context, uint world, Id id, Vec2* force, Vec2* at);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world2_apply_torque(ContextMemory* context, uint world, Id id, int* torque);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_joint2_defaults(uint kind, Joint2* joint);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world2_add_joint(ContextMemory* context, uint world, Joint2* joint, Id* id);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world2_change_joint(ContextMemory* context, uint world, Id id, Joint2* joint);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world2_remove_joint(ContextMemory* context, uint world, Id id);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world2_joint(ContextMemory* context, uint world, Id id, Joint2* joint);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world2_joint_force(ContextMemory* context, uint world, Id id, Vec2* force);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world2_joint_torque(ContextMemory* context, uint world, Id id, int* torque);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world2_joint_count(ContextMemory* context, uint world, uint* count);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world2_joint_ids(ContextMemory* context, uint world, Id* joints, uint room, uint* count);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world2_broken(ContextMemory* context, uint world, Id* joints, uint room, uint* count);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world2_local_point(ContextMemory* context, uint world, Id id, Vec2* point, Vec2* local);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world2_local_frame(ContextMemory* context, uint world, Id id, Rotation2* frame, Rotation2* local);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world2_size(ContextMemory* context, uint world, uint* size);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world2_body_ids(ContextMemory* context, uint world, Id* ids, uint room, uint* count);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world2_touching(ContextMemory* context, uint world, Id body, Touch* touches, uint room, uint* count);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world2_contacts(ContextMemory* context, uint world, Id body, World2Contact* contacts, uint room, uint* count);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world2_events(ContextMemory* context, uint world, Touch* events, uint room, uint* count);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world2_digest(ContextMemory* context, uint world, ulong* digest);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world2_digest_of(ContextMemory* context, uint world, Id id, ulong* digest);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world2_snapshot(ContextMemory* context, uint world, void* bytes, uint room, uint* size);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world2_restore(ContextMemory* context, uint world, void* bytes, uint size);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world2_diff(ContextMemory* context, uint a, uint b, uint most, void* names, uint room, uint* size);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_scene2_diff(ContextMemory* context, uint a, uint b, uint most, void* names, uint room, uint* size);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_session2_create(ContextMemory* context, SessionSettings* settings, uint world, uint* session);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_session2_destroy(ContextMemory* context, uint session);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_session2_world(ContextMemory* context, uint session, uint* world);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_session2_receive(ContextMemory* context, uint session, uint peer, void* bytes, uint size, ulong now);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_session2_begin_frame(ContextMemory* context, uint session, void* input, Frame* frame, void* inputs);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_session2_end_frame(ContextMemory* context, uint session);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_session2_packet(ContextMemory* context, uint session, ulong now, uint* peer, void* bytes, uint room, uint* size);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_session2_event(ContextMemory* context, uint session, SessionEvent* @event, void* name, uint room);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_session2_status(ContextMemory* context, uint session, SessionStatus* status);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_session2_matched(ContextMemory* context, uint session, uint peer, uint* frame);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_session2_is_awaited(ContextMemory* context, uint session, uint player);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_session2_drop(ContextMemory* context, uint session, uint peer);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_session2_pause(ContextMemory* context, uint session, uint is_paused);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_session2_replay(ContextMemory* context, uint session, void* bytes, uint room, uint* size);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world2_words(ContextMemory* context, uint world, uint* words);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world2_set_words(ContextMemory* context, uint world, uint* words);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_replay2_create(ContextMemory* context, void* bytes, uint size, uint world, uint input_size, uint words, uint* replay);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_replay2_destroy(ContextMemory* context, uint replay);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_replay2_world(ContextMemory* context, uint replay, uint* world);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_replay2_begin_frame(ContextMemory* context, uint replay, Frame* frame, void* inputs);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_replay2_end_frame(ContextMemory* context, uint replay);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_replay2_check(ContextMemory* context, uint replay, ReplayCheck* check);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_raycast3(Ray3* ray, Shape3* shape, Hit3* hit);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_raycast3_many(Ray3* rays, uint count, Shape3* shape, int* distances);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_contains3(Shape3* shape, Vec3* point);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_overlaps3(Shape3* a, Shape3* b);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_closest_point3(Shape3* shape, Vec3* point, Vec3* closest);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_distance_to_point3(Shape3* shape, Vec3* point, int* distance);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_distance3(Shape3* a, Shape3* b, int* distance);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_contact3(Shape3* a, Shape3* b, Manifold3* contact);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_closest_points3(Shape3* a, Shape3* b, Vec3* point_a, Vec3* point_b);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_cast3(Shape3* shape, Direction3* direction, int max_distance, Shape3* target, Hit3* hit);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_time_of_impact3(Shape3* a, Sweep3* sweep_a, Shape3* b, Sweep3* sweep_b, int target, Impact* impact);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_ray3_contains(Ray3* ray, Vec3* point);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_ray3_closest_point(Ray3* ray, Vec3* point, Vec3* closest);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_ray3_distance_to_point(Ray3* ray, Vec3* point, int* distance);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_shapes3_raycast(ContextMemory* context, Ray3* ray, Shape3* shapes, uint count, Hit3* hit);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_shapes3_contains(ContextMemory* context, Shape3* shapes, uint count, Vec3* point);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_shapes3_overlaps(ContextMemory* context, Shape3* a, uint a_count, Shape3* b, uint b_count);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_shapes3_closest_point(ContextMemory* context, Shape3* shapes, uint count, Vec3* point, Vec3* closest);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_shapes3_distance_to_point(ContextMemory* context, Shape3* shapes, uint count, Vec3* point, int* distance);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_shapes3_distance(ContextMemory* context, Shape3* a, uint a_count, Shape3* b, uint b_count, int* distance);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_shapes3_closest_points(ContextMemory* context, Shape3* a, uint a_count, Shape3* b, uint b_count, Vec3* point_a, Vec3* point_b);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_shapes3_cast(ContextMemory* context, Shape3* shape, Direction3* direction, int max_distance, Shape3* targets, uint count, Hit3* hit);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_shapes3_contact(ContextMemory* context, Shape3* a, Shape3* b, Manifold3* contact);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_shapes3_time_of_impact(ContextMemory* context, Shape3* a, Sweep3* sweep_a, Shape3* b, Sweep3* sweep_b, int target, Impact* impact);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_hull3_create(ContextMemory* context, uint id, Vec3* points, uint count, uint* hull);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_solid3_create(ContextMemory* context, uint id, Vec3* points, uint count, uint* solid);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_part3_defaults(Part3* part);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_compound3_create(ContextMemory* context, uint id, Part3* parts, uint count, uint* compound);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_scene3_create(ContextMemory* context, uint* scene);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_scene3_destroy(ContextMemory* context, uint scene);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_scene3_add(ContextMemory* context, uint scene, Shape3* shape, Traits* traits, Id* id);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_scene3_add_as(ContextMemory* context, uint scene, Id id, Shape3* shape, Traits* traits);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_scene3_remove(ContextMemory* context, uint scene, Id id);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_scene3_replace(ContextMemory* context, uint scene, Id id, Shape3* shape);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_scene3_move(ContextMemory* context, uint scene, Id id, Vec3* by);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_scene3_object(ContextMemory* context, uint scene, Id id, Shape3* shape, Traits* traits);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_scene3_set_traits(ContextMemory* context, uint scene, Id id, Traits* traits);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_scene3_add_frame(ContextMemory* context, uint scene, Transform3* transform, Id parent, Id* frame);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_scene3_move_frame(ContextMemory* context, uint scene, Id frame, Transform3* transform);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_scene3_remove_frame(ContextMemory* context, uint scene, Id frame);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_scene3_frame(ContextMemory* context, uint scene, Id frame, Transform3* local, Transform3* world);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_scene3_size(ContextMemory* context, uint scene, uint* size);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_scene3_optimize(ContextMemory* context, uint scene);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_scene3_raycast(ContextMemory* context, uint scene, Ray3* ray, uint layers, ObjectHit3* hit);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_scene3_raycast_any(ContextMemory* context, uint scene, Ray3* ray, uint layers);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_scene3_raycast_all(ContextMemory* context, uint scene, Ray3* ray, uint layers, ObjectHit3* hits, uint room, uint* count);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_scene3_raycast_many(ContextMemory* context, uint scene, Ray3* rays, uint count, uint layers, ObjectHit3* hits);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_scene3_nearest(ContextMemory* context, uint scene, Shape3* question, uint layers, Found* found);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_scene3_any(ContextMemory* context, uint scene, Shape3* question, uint layers);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_scene3_all(ContextMemory* context, uint scene, Shape3* question, uint layers, Found* found, uint room, uint* count);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_scene3_overlaps(ContextMemory* context, uint scene, Pair* pairs, uint room, uint* count);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_scene3_cast(ContextMemory* context, uint scene, Shape3* shape, Direction3* direction, int max_distance, uint layers, ObjectHit3* hit);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_scene3_cast_any(ContextMemory* context, uint scene, Shape3* shape, Direction3* direction, int max_distance, uint layers);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_scene3_cast_all(ContextMemory* context, uint scene, Shape3* shape, Direction3* direction, int max_distance, uint layers, ObjectHit3* hits, uint room, uint* count);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_mover3_default_settings(Mover3Settings* settings);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_mover3_move(ContextMemory* context, uint scene, Mover3* mover, Vec3* by, Mover3Settings* settings, uint layers, Id ignored, Move3* result);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_mover3_clip_velocity(Vec3* velocity, Move3* result, Vec3* clipped);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_scene3_digest(ContextMemory* context, uint scene, ulong* digest);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_scene3_snapshot(ContextMemory* context, uint scene, void* bytes, uint room, uint* size);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_scene3_restore(ContextMemory* context, uint scene, void* bytes, uint size);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world3_default_settings(World3Settings* settings);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_body3_default_options(Body3Options* options);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world3_create(ContextMemory* context, World3Settings* settings, uint* world);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world3_destroy(ContextMemory* context, uint world);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world3_add(ContextMemory* context, uint world, Shape3* shape, Body3Options* options, Id* id);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world3_add_as(ContextMemory* context, uint world, Id id, Shape3* shape, Body3Options* options);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world3_remove(ContextMemory* context, uint world, Id id);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world3_step(ContextMemory* context, uint world);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_scene3_follow(ContextMemory* context, uint scene, uint world, uint sensors);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world3_part_of(ContextMemory* context, uint world, Id @object, Id* body, uint* part);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world3_body(ContextMemory* context, uint world, Id id, Body3* body);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world3_bodies(ContextMemory* context, uint world, Id* ids, uint count, Body3* bodies);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world3_frame(ContextMemory* context, uint world, Id id, Transform3* frame);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world3_info(ContextMemory* context, uint world, Id id, BodyInfo* info);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world3_set_position(ContextMemory* context, uint world, Id id, Vec3* position);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world3_set_rotation(ContextMemory* context, uint world, Id id, Rotation3* rotation);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world3_set_filter(ContextMemory* context, uint world, Id id, uint layers, uint collides_with);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world3_set_friction(ContextMemory* context, uint world, Id id, int friction);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world3_set_restitution(ContextMemory* context, uint world, Id id, int restitution);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world3_set_sensor(ContextMemory* context, uint world, Id id, uint is_sensor);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world3_set_gravity_scale(ContextMemory* context, uint world, Id id, int scale);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world3_set_damping(ContextMemory* context, uint world, Id id, int linear, int angular);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world3_set_locked(ContextMemory* context, uint world, Id id, uint locked);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world3_set_fast(ContextMemory* context, uint world, Id id, uint is_fast);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world3_set_user(ContextMemory* context, uint world, Id id, ulong user);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world3_set_gravity(ContextMemory* context, uint world, Vec3* gravity);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world3_set_velocity(ContextMemory* context, uint world, Id id, Vec3* velocity);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world3_set_angular_velocity(ContextMemory* context, uint world, Id id, int* velocity);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world3_apply_impulse(ContextMemory* context, uint world, Id id, Vec3* impulse, Vec3* at);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world3_apply_force(ContextMemory* context, uint world, Id id, Vec3* force, Vec3* at);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world3_apply_torque(ContextMemory* context, uint world, Id id, int* torque);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_joint3_defaults(uint kind, Joint3* joint);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world3_add_joint(ContextMemory* context, uint world, Joint3* joint, Id* id);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world3_change_joint(ContextMemory* context, uint world, Id id, Joint3* joint);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world3_remove_joint(ContextMemory* context, uint world, Id id);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world3_joint(ContextMemory* context, uint world, Id id, Joint3* joint);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world3_joint_force(ContextMemory* context, uint world, Id id, Vec3* force);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world3_joint_torque(ContextMemory* context, uint world, Id id, int* torque);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world3_joint_count(ContextMemory* context, uint world, uint* count);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world3_joint_ids(ContextMemory* context, uint world, Id* joints, uint room, uint* count);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world3_broken(ContextMemory* context, uint world, Id* joints, uint room, uint* count);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world3_local_point(ContextMemory* context, uint world, Id id, Vec3* point, Vec3* local);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world3_local_frame(ContextMemory* context, uint world, Id id, Rotation3* frame, Rotation3* local);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world3_size(ContextMemory* context, uint world, uint* size);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world3_body_ids(ContextMemory* context, uint world, Id* ids, uint room, uint* count);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world3_touching(ContextMemory* context, uint world, Id body, Touch* touches, uint room, uint* count);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world3_contacts(ContextMemory* context, uint world, Id body, World3Contact* contacts, uint room, uint* count);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world3_events(ContextMemory* context, uint world, Touch* events, uint room, uint* count);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world3_digest(ContextMemory* context, uint world, ulong* digest);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world3_digest_of(ContextMemory* context, uint world, Id id, ulong* digest);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world3_snapshot(ContextMemory* context, uint world, void* bytes, uint room, uint* size);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world3_restore(ContextMemory* context, uint world, void* bytes, uint size);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world3_diff(ContextMemory* context, uint a, uint b, uint most, void* names, uint room, uint* size);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_scene3_diff(ContextMemory* context, uint a, uint b, uint most, void* names, uint room, uint* size);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_session3_create(ContextMemory* context, SessionSettings* settings, uint world, uint* session);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_session3_destroy(ContextMemory* context, uint session);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_session3_world(ContextMemory* context, uint session, uint* world);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_session3_receive(ContextMemory* context, uint session, uint peer, void* bytes, uint size, ulong now);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_session3_begin_frame(ContextMemory* context, uint session, void* input, Frame* frame, void* inputs);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_session3_end_frame(ContextMemory* context, uint session);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_session3_packet(ContextMemory* context, uint session, ulong now, uint* peer, void* bytes, uint room, uint* size);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_session3_event(ContextMemory* context, uint session, SessionEvent* @event, void* name, uint room);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_session3_status(ContextMemory* context, uint session, SessionStatus* status);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_session3_matched(ContextMemory* context, uint session, uint peer, uint* frame);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_session3_is_awaited(ContextMemory* context, uint session, uint player);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_session3_drop(ContextMemory* context, uint session, uint peer);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_session3_pause(ContextMemory* context, uint session, uint is_paused);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_session3_replay(ContextMemory* context, uint session, void* bytes, uint room, uint* size);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world3_words(ContextMemory* context, uint world, uint* words);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_world3_set_words(ContextMemory* context, uint world, uint* words);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_replay3_create(ContextMemory* context, void* bytes, uint size, uint world, uint input_size, uint words, uint* replay);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_replay3_destroy(ContextMemory* context, uint replay);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_replay3_world(ContextMemory* context, uint replay, uint* world);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_replay3_begin_frame(ContextMemory* context, uint replay, Frame* frame, void* inputs);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_replay3_end_frame(ContextMemory* context, uint replay);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_replay3_check(ContextMemory* context, uint replay, ReplayCheck* check);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_camera3_look_at(Vec3* eye, Vec3* target, Vec3* up, Transform3* pose);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_camera3_frustum(Camera3* camera, Frustum3* frustum);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_camera3_pick_ray(Camera3* camera, int width, int height, int column, int row, Ray3* ray);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_camera3_project(Camera3* camera, int width, int height, Vec3* point, ScreenPoint3* seen);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_camera3_unproject(Camera3* camera, int width, int height, int column, int row, int depth, Vec3* point);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_frustum3_raycast(Ray3* ray, Frustum3* frustum, Hit3* hit);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_frustum3_contains(Frustum3* frustum, Vec3* point);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_frustum3_overlaps(ContextMemory* context, Frustum3* frustum, Shape3* shapes, uint count);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_frustum3_overlaps_frustum(Frustum3* a, Frustum3* b);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_frustum3_closest_point(Frustum3* frustum, Vec3* point, Vec3* closest);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_frustum3_distance_to_point(Frustum3* frustum, Vec3* point, int* distance);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_scene3_frustum_nearest(ContextMemory* context, uint scene, Frustum3* frustum, uint layers, Found* found);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_scene3_frustum_any(ContextMemory* context, uint scene, Frustum3* frustum, uint layers);

  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]
  public static extern int detent_scene3_frustum_all(ContextMemory* context, uint scene, Frustum3* frustum, uint layers, Found* found, uint room, uint* count);

  /// <summary>Throws if a structure does not have the same size as in C.</summary>
  public static void CheckSizes() {
    if (sizeof(Id) != 8) throw new TypeLoadException("detent_id");
    if (sizeof(Pair) != 16) throw new TypeLoadException("detent_pair");
    if (sizeof(Touch) != 28) throw new TypeLoadException("detent_touch");
    if (sizeof(BodyInfo) != 32) throw new TypeLoadException("detent_body_info");
    if (sizeof(Found) != 12) throw new TypeLoadException("detent_found");
    if (sizeof(Impact) != 12) throw new TypeLoadException("detent_impact");
    if (sizeof(SessionSettings) != 72) throw new TypeLoadException("detent_session_settings");
    if (sizeof(Frame) != 16) throw new TypeLoadException("detent_frame");
    if (sizeof(SessionEvent) != 28) throw new TypeLoadException("detent_session_event");
    if (sizeof(SessionStatus) != 40) throw new TypeLoadException("detent_session_status");
    if (sizeof(ReplayCheck) != 20) throw new TypeLoadException("detent_replay_check");
    if (sizeof(Traits) != 24) throw new TypeLoadException("detent_traits");
    if (sizeof(ContextMemory) != 32) throw new TypeLoadException("detent_context");
    if (sizeof(Vec2) != 8) throw new TypeLoadException("detent_vec2");
    if (sizeof(Direction2) != 8) throw new TypeLoadException("detent_direction2");
    if (sizeof(Rotation2) != 16) throw new TypeLoadException("detent_rotation2");
    if (sizeof(Transform2) != 28) throw new TypeLoadException("detent_transform2");
    if (sizeof(Ray2) != 20) throw new TypeLoadException("detent_ray2");
    if (sizeof(Sphere2) != 12) throw new TypeLoadException("detent_sphere2");
    if (sizeof(Aabb2) != 16) throw new TypeLoadException("detent_aabb2");
    if (sizeof(Obb2) != 32) throw new TypeLoadException("detent_obb2");
    if (sizeof(Plane2) != 12) throw new TypeLoadException("detent_plane2");
    if (sizeof(Triangle2) != 24) throw new TypeLoadException("detent_triangle2");
    if (sizeof(Capsule2) != 20) throw new TypeLoadException("detent_capsule2");
    if (sizeof(Segment2) != 16) throw new TypeLoadException("detent_segment2");
    if (sizeof(Shape2) != 40) throw new TypeLoadException("detent_shape2");
    if (sizeof(Hit2) != 20) throw new TypeLoadException("detent_hit2");
    if (sizeof(ContactPoint2) != 16) throw new TypeLoadException("detent_contact_point2");
    if (sizeof(Manifold2) != 48) throw new TypeLoadException("detent_manifold2");
    if (sizeof(Sweep2) != 48) throw new TypeLoadException("detent_sweep2");
    if (sizeof(ObjectHit2) != 36) throw new TypeLoadException("detent_object_hit2");
    if (sizeof(Mover2) != 84) throw new TypeLoadException("detent_mover2");
    if (sizeof(Mover2Settings) != 24) throw new TypeLoadException("detent_mover2_settings");
    if (sizeof(Mover2Touch) != 24) throw new TypeLoadException("detent_mover2_touch");
    if (sizeof(Move2) != 224) throw new TypeLoadException("detent_move2");
    if (sizeof(World2ContactPoint) != 20) throw new TypeLoadException("detent_world2_contact_point");
    if (sizeof(World2Contact) != 92) throw new TypeLoadException("detent_world2_contact");
    if (sizeof(World2Settings) != 36) throw new TypeLoadException("detent_world2_settings");
    if (sizeof(Body2Options) != 80) throw new TypeLoadException("detent_body2_options");
    if (sizeof(Part2) != 60) throw new TypeLoadException("detent_part2");
    if (sizeof(Joint2) != 112) throw new TypeLoadException("detent_joint2");
    if (sizeof(Body2) != 40) throw new TypeLoadException("detent_body2");
    if (sizeof(Vec3) != 12) throw new TypeLoadException("detent_vec3");
    if (sizeof(Direction3) != 12) throw new TypeLoadException("detent_direction3");
    if (sizeof(Rotation3) != 36) throw new TypeLoadException("detent_rotation3");
    if (sizeof(Transform3) != 52) throw new TypeLoadException("detent_transform3");
    if (sizeof(Ray3) != 28) throw new TypeLoadException("detent_ray3");
    if (sizeof(Sphere3) != 16) throw new TypeLoadException("detent_sphere3");
    if (sizeof(Aabb3) != 24) throw new TypeLoadException("detent_aabb3");
    if (sizeof(Obb3) != 60) throw new TypeLoadException("detent_obb3");
    if (sizeof(Plane3) != 16) throw new TypeLoadException("detent_plane3");
    if (sizeof(Triangle3) != 36) throw new TypeLoadException("detent_triangle3");
    if (sizeof(Capsule3) != 28) throw new TypeLoadException("detent_capsule3");
    if (sizeof(Segment3) != 24) throw new TypeLoadException("detent_segment3");
    if (sizeof(Shape3) != 68) throw new TypeLoadException("detent_shape3");
    if (sizeof(Hit3) != 28) throw new TypeLoadException("detent_hit3");
    if (sizeof(ContactPoint3) != 20) throw new TypeLoadException("detent_contact_point3");
    if (sizeof(Manifold3) != 100) throw new TypeLoadException("detent_manifold3");
    if (sizeof(Sweep3) != 96) throw new TypeLoadException("detent_sweep3");
    if (sizeof(ObjectHit3) != 44) throw new TypeLoadException("detent_object_hit3");
    if (sizeof(Mover3) != 124) throw new TypeLoadException("detent_mover3");
    if (sizeof(Mover3Settings) != 28) throw new TypeLoadException("detent_mover3_settings");
    if (sizeof(Mover3Touch) != 32) throw new TypeLoadException("detent_mover3_touch");
    if (sizeof(Move3) != 300) throw new TypeLoadException("detent_move3");
    if (sizeof(World3ContactPoint) != 24) throw new TypeLoadException("detent_world3_contact_point");
    if (sizeof(World3Contact) != 156) throw new TypeLoadException("detent_world3_contact");
    if (sizeof(World3Settings) != 40) throw new TypeLoadException("detent_world3_settings");
    if (sizeof(Body3Options) != 96) throw new TypeLoadException("detent_body3_options");
    if (sizeof(Part3) != 88) throw new TypeLoadException("detent_part3");
    if (sizeof(Joint3) != 160) throw new TypeLoadException("detent_joint3");
    if (sizeof(Body3) != 76) throw new TypeLoadException("detent_body3");
    if (sizeof(Camera3) != 80) throw new TypeLoadException("detent_camera3");
    if (sizeof(Frustum3) != 96) throw new TypeLoadException("detent_frustum3");
    if (sizeof(ScreenPoint3) != 12) throw new TypeLoadException("detent_screen_point3");
  }
}

}
