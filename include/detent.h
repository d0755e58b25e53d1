/* SPDX-License-Identifier: MIT */
/* The C interface (C99) of detent: q16_16 in two and three dimensions; see docs/bindings.md. */
/* Written by bindings/generate from bindings/detent.h.in: change that file instead. */
#ifndef DETENT_H
#define DETENT_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#ifndef DETENT_API
#if defined(_WIN32) && defined(DETENT_SHARED)
#define DETENT_API __declspec(dllimport)
#elif defined(__GNUC__)
#define DETENT_API __attribute__((visibility("default")))
#else
#define DETENT_API
#endif
#endif

/* Units. A length is a raw integer in steps of 2^-16 of a world unit: 65536 is 1. A component of a
 * direction is in steps of 2^-30: 1073741824 is 1. Speeds are lengths per second, angular
 * velocities radians per second, in steps of 2^-16 too. Every int32_t is a valid length.
 *
 * Results are those of the C++ functions of the same names, bit for bit, on every machine. */

/** What a function returns: DETENT_OK or DETENT_NO, or an error below 0, which changes nothing. */
enum {
  DETENT_OK = 1,                 /**< done; or yes, there is one */
  DETENT_NO = 0,                 /**< no; or there is none, such as no hit */
  DETENT_BAD_ARGUMENT = -1,      /**< a null pointer, an unknown kind, a number out of range */
  DETENT_BAD_CONTEXT = -2,       /**< the context is null, not open, closed or a copy */
  DETENT_BAD_HANDLE = -3,        /**< a handle of another type, stale, or never given out */
  DETENT_NOT_UNIT = -4,          /**< a direction whose length is not 1 within 2^-29 */
  DETENT_NO_QUERY = -5,          /**< there is no such query for these kinds of shape */
  DETENT_NO_MEMORY = -6,         /**< an allocation failed */
  DETENT_BROKEN = -7,            /**< an allocation failed during a change: destroy the scene or world */
  DETENT_FULL = -8,              /**< no more objects, bodies, handles or assets */
  DETENT_IN_USE = -9,            /**< an object refers to the asset; or the asset's id is taken */
  DETENT_NOT_NOW = -10,          /**< a session's world changes in its frames only; or no frame is open */
  DETENT_NO_SNAPSHOT = -20,      /**< these bytes are not a snapshot */
  DETENT_OTHER_VERSION = -21,    /**< a snapshot of a version that this library does not read */
  DETENT_TRUNCATED = -22,        /**< the snapshot is cut off */
  DETENT_CORRUPTED = -23,        /**< the bytes of the snapshot have been changed */
  DETENT_OTHER_SCENE = -24,      /**< of another dimension, set of shapes or settings */
  DETENT_OTHER_FIXED_PART = -25, /**< fixed objects or bodies differ from those of the snapshot */
  DETENT_NO_ROOM = -26,          /**< the snapshot has more than a scene or world can hold */
  DETENT_UNKNOWN_ASSET = -27,    /**< the snapshot refers to an asset that the context has not */
  DETENT_OTHER_ASSET = -28       /**< the asset of this id has other triangles, points or heights */
};

/** The kind of a shape: which member of its union is set. */
enum {
  DETENT_SPHERE = 1,
  DETENT_AABB = 2,
  DETENT_OBB = 3,
  DETENT_PLANE = 4,
  DETENT_TRIANGLE = 5,
  DETENT_CAPSULE = 6,
  DETENT_SEGMENT = 7,     /**< in queries only: not an object of scenes */
  DETENT_POINT = 8,       /**< in queries of scenes only */
  DETENT_HULL = 9,        /**< in scenes: a hull, transformed by `placed`; in worlds a solid hull */
  DETENT_MESH = 10,       /**< in scenes and worlds, in 3D */
  DETENT_HEIGHT_FIELD = 11, /**< in scenes and worlds, in 3D: moved by `point`, not turned */
  DETENT_COMPOUND = 12    /**< in worlds only: several shapes that move as one, placed by `placed` */
};

/** How an object of a scene takes part: fixed ones are the level, and not in snapshots. */
enum { DETENT_MOVING = 0, DETENT_FIXED = 1 };

/** How a body moves: by forces and contacts; by its velocity alone; or never. */
enum { DETENT_DYNAMIC_BODY = 0, DETENT_KINEMATIC_BODY = 1, DETENT_FIXED_BODY = 2 };

/** The kind of a joint: what it keeps. */
enum {
  DETENT_DISTANCE_JOINT = 1, /**< the distance of two points between `lower` and `upper`; a spring */
  DETENT_BALL_JOINT = 2,     /**< two points together; soft with a frequency */
  DETENT_HINGE_JOINT = 3,    /**< two points, in 3D also axis 2 of both frames; limits, a motor */
  DETENT_WELD_JOINT = 4,     /**< two points and two frames together */
  DETENT_SLIDER_JOINT = 5,   /**< two frames, and the point of b on axis 0; limits, a motor, a spring */
  DETENT_WHEEL_JOINT = 6     /**< the point of b on axis 0; a spring, limits, a motor that turns */
};

/** The axes of the world that a body does not move along or turn about. In 2D each of the last three
 *  stops it from turning. */
enum {
  DETENT_LOCK_X = 1,
  DETENT_LOCK_Y = 2,
  DETENT_LOCK_Z = 4,
  DETENT_LOCK_TURN_X = 8,
  DETENT_LOCK_TURN_Y = 16,
  DETENT_LOCK_TURN_Z = 32
};

/** What a session did when no frame is left to simulate. */
enum {
  DETENT_PLAYED = 0,      /**< it simulated a new frame with the given input */
  DETENT_CONNECTING = 1,  /**< not every player has been heard */
  DETENT_CATCHING_UP = 2, /**< frames to simulate again are left for the next time */
  DETENT_STARVED = 3,     /**< an input of another player is needed first */
  DETENT_AHEAD = 4,       /**< the others are behind: it waits one frame for them */
  DETENT_PAUSED = 5,      /**< by a player */
  DETENT_OVER = 6,        /**< a spectator without players, or 2^31 frames */
  DETENT_JOINING = 7      /**< the snapshot of the match has not come yet */
};

/** What happened in a session. */
enum {
  DETENT_CONNECTED = 0,      /**< the first packet of this peer came */
  DETENT_SILENT = 1,         /**< nothing came from it for `silence`; you may drop it */
  DETENT_HEARD_AGAIN = 2,    /**< it was silent */
  DETENT_PEER_PAUSED = 3,    /**< it paused */
  DETENT_PEER_RESUMED = 4,   /**< it goes on */
  DETENT_DROPPED = 5,        /**< this player is out, as one of those who go on decided */
  DETENT_EXPELLED = 6,       /**< it dropped us: we go on alone */
  DETENT_LEFT = 7,           /**< all agree: `frame` is the first without this player's input */
  DETENT_TOO_SLOW = 8,       /**< a spectator fell behind by more than is kept */
  DETENT_CONTRADICTION = 9,  /**< it sent a second, different input for `frame`; the first one stays */
  DETENT_DESYNC = 10,        /**< its result of `frame` differs from ours; all before were equal */
  DETENT_DESYNC_FIELD = 11,  /**< the first field that differs in that result: the name */
  DETENT_ARRIVED = 12,       /**< it comes late or again, and gets a snapshot */
  DETENT_LOADED = 13,        /**< we came late and have the world before `frame`, from this peer */
  DETENT_NO_SUCH_WORLD = 14, /**< what it sent is no snapshot of our world: another one is asked */
  DETENT_JOINED = 15         /**< this player takes part from `frame` on */
};

/** How a replay ends. */
enum {
  DETENT_REPLAY_WHOLE = 0,    /**< every byte was read */
  DETENT_REPLAY_CUT = 1,      /**< the last block is not whole: its writer was stopped */
  DETENT_REPLAY_CORRUPTED = 2 /**< a byte has been changed; the frames before it were read */
};

/** Most bytes of a player's input, of a packet, of a snapshot for who comes late and of the name of a
 *  field; most words of a session's world; most players. */
enum {
  DETENT_INPUT = 16,
  DETENT_PACKET = 1200,
  DETENT_LATE_SNAPSHOT = 65536,
  DETENT_NAME = 119,
  DETENT_WORDS = 256,
  DETENT_PLAYERS = 8
};

/** A status: see DETENT_OK. */
typedef int32_t detent_status;

/** A scene, world or asset of a context; 0 is none. Handles of destroyed ones are never given out
 *  again by the same context. A handle means nothing to another context. */
typedef uint32_t detent_handle;

/** An object of a scene or a body of a world. No two have the same id, ever; {0, 0} is none. */
typedef struct detent_id {
  uint32_t index;
  uint32_t generation;
} detent_id;

/** Two objects or bodies. */
typedef struct detent_pair {
  detent_id first;
  detent_id second;
} detent_pair;

/** A pair of bodies that began (1) or ended (0) to touch in the last step; of compounds a pair of parts. */
typedef struct detent_touch {
  detent_id a;
  detent_id b;
  uint32_t begins;
  uint32_t part_a; /**< the number of the part of a compound; 0 for other bodies */
  uint32_t part_b;
} detent_touch;

/** An object that a query found, and its distance in steps of 2^-16. */
typedef struct detent_found {
  int32_t distance;
  detent_id id;
} detent_found;

/** When two moving shapes meet. They are apart before `time`, in steps of 2^-30, and at most
 *  `distance` apart at it. If `is_hit` is 0, the search ended early, and whether they meet later is not
 *  known. */
typedef struct detent_impact {
  int32_t time;
  int32_t distance;
  uint32_t is_hit;
} detent_impact;

/** A match and one peer in it. Times are in microseconds, of a clock that only this peer needs. */
typedef struct detent_session_settings {
  uint64_t match;           /**< the same for all peers: a random number, the host says it */
  uint64_t send_interval;   /**< at least this between two packets to a peer */
  uint64_t silence;         /**< a peer that sends nothing for this long is silent */
  uint32_t self;            /**< peers are numbered: players first, then spectators */
  uint32_t players;         /**< 1 to 8 */
  uint32_t spectators;      /**< peers are at most 16 */
  uint32_t delay;           /**< frames between an input and its effect, 0 to 8 */
  uint32_t prediction;      /**< 0 to 16; 0: every frame waits for all inputs, and delay is 1 or more */
  uint32_t frames_per_call; /**< the most that are simulated in one tick, 1 or more */
  uint32_t absent;          /**< seats that are free at the start, a bit each: the same for all peers */
  uint32_t life;            /**< 0; of who comes late or again, more than in its sessions before */
  uint32_t wants_seat;      /**< 0 or 1: whether a player that comes late wants to play */
  uint32_t input_size;      /**< bytes of a player's input, 1 to 16: the same for all peers */
  uint32_t words;           /**< 32-bit words next to the world, 0 to 256: the same for all peers */
  uint32_t replay_every;    /**< records a replay, with a digest after so many frames, 1 to 255; or 0 */
} detent_session_settings;

/** A frame to simulate, or why there is none. Players whose bit is set in `present` take part. */
typedef struct detent_frame {
  uint32_t number;   /**< from 0 */
  uint32_t players;
  uint32_t present;
  uint32_t state;    /**< DETENT_PLAYED and the like, when there is none */
} detent_frame;

/** Something that happened in a session, with a peer or in a frame. */
typedef struct detent_session_event {
  uint32_t kind;       /**< DETENT_CONNECTED and the like */
  uint32_t peer;
  uint32_t frame;
  uint32_t name_size;  /**< bytes of the name of the field */
  uint32_t has_object;
  detent_id object;    /**< the body that the field belongs to, if there is one */
} detent_session_event;

/** How far a session is. */
typedef struct detent_session_status {
  uint64_t digest;        /**< of the results of all frames before `checked_frame` */
  uint64_t resimulated;   /**< frames that were simulated again, counted each time */
  uint32_t frame;         /**< frames played */
  uint32_t final_frame;   /**< frames whose results no packet can change */
  uint32_t checked_frame;
  uint32_t start_frame;   /**< 0, or that of the snapshot it began with */
  uint32_t is_player;     /**< whether it plays: one that came late does once it has its seat */
  uint32_t players;
} detent_session_status;

/** What simulating a replay again gave so far. */
typedef struct detent_replay_check {
  uint32_t state;    /**< DETENT_REPLAY_WHOLE and the like */
  uint32_t frames;   /**< simulated */
  uint32_t equal;    /**< the first so many have the recorded digest after the last of them */
  uint32_t is_equal; /**< if 0, the first frame that differs is one of `equal` to `frames` */
  uint32_t players;
} detent_replay_check;

/** What a scene stores with an object. */
typedef struct detent_traits {
  uint64_t user;    /**< any word; saved, never read */
  uint32_t layers;  /**< any bits; queries name those that they look at */
  uint32_t motion;  /**< DETENT_MOVING or DETENT_FIXED */
  detent_id frame;  /**< the frame that a moving object's shape is in; {0, 0}: the world */
} detent_traits;

/** Where a context takes memory from. `allocate` returns memory for `size` bytes aligned for any
 *  type, or null; `release` gets it back with the same size. Both null: malloc and free. */
typedef struct detent_allocator {
  void* user;
  void* (*allocate)(void* user, size_t size);
  void (*release)(void* user, void* memory, size_t size);
} detent_allocator;

/** Everything else is made in a context, which is the caller's memory: set it to zeros, open it,
 *  close it. It must stay where it is while it is open. Contexts share nothing. Of one context,
 *  calls that only read (their context is const) may run in several threads at once; all others need
 *  it alone. */
typedef struct detent_context {
  uint64_t words[4];
} detent_context;

/** A point or vector, in steps of 2^-16. */
typedef struct detent_vec2 {
  int32_t x, y;
} detent_vec2;

/** A unit vector, in steps of 2^-30; used exactly as stored. */
typedef struct detent_direction2 {
  int32_t x, y;
} detent_direction2;

/** The axes of a frame in the world. */
typedef struct detent_rotation2 {
  detent_direction2 axis[2];
} detent_rotation2;

/** p -> translation + scale * rotation * p; `scale` in steps of 2^-16. */
typedef struct detent_transform2 {
  detent_vec2 translation;
  detent_rotation2 rotation;
  int32_t scale;
} detent_transform2;

/** The points origin + t * direction with 0 <= t <= max_distance. */
typedef struct detent_ray2 {
  detent_vec2 origin;
  detent_direction2 direction;
  int32_t max_distance;
} detent_ray2;

/** The points within `radius` of `center`; none if the radius is negative. */
typedef struct detent_sphere2 {
  detent_vec2 center;
  int32_t radius;
} detent_sphere2;

/** The points between two corners; none if min > max on an axis. */
typedef struct detent_aabb2 {
  detent_vec2 min;
  detent_vec2 max;
} detent_aabb2;

/** A box turned about its center; none if a half extent is negative. */
typedef struct detent_obb2 {
  detent_vec2 center;
  detent_vec2 half_extents;
  detent_rotation2 rotation;
} detent_obb2;

/** The points x with dot(normal, x) = offset. */
typedef struct detent_plane2 {
  detent_direction2 normal;
  int32_t offset;
} detent_plane2;

/** The points between three corners. */
typedef struct detent_triangle2 {
  detent_vec2 a;
  detent_vec2 b;
  detent_vec2 c;
} detent_triangle2;

/** The points within `radius` of the segment from a to b; none if the radius is negative. */
typedef struct detent_capsule2 {
  detent_vec2 a;
  detent_vec2 b;
  int32_t radius;
} detent_capsule2;

/** The points between two ends. */
typedef struct detent_segment2 {
  detent_vec2 start;
  detent_vec2 end;
} detent_segment2;

/** A shape of any kind: `kind` says which member is set. `asset` is the handle of a hull, mesh or
 *  height field, and ignored for other kinds. */
typedef struct detent_shape2 {
  uint32_t kind;
  detent_handle asset;
  union {
    detent_sphere2 sphere;
    detent_aabb2 aabb;
    detent_obb2 obb;
    detent_plane2 plane;
    detent_triangle2 triangle;
    detent_capsule2 capsule;
    detent_segment2 segment;
    detent_vec2 point;
    detent_transform2 placed;
  } as;
} detent_shape2;

/** Where a ray or a moving shape first touches a shape. The distance is rounded down. */
typedef struct detent_hit2 {
  int32_t distance;
  detent_vec2 point;
  detent_direction2 normal;
} detent_hit2;

/** One point of a contact, on the surface of the first shape, and how deep the second shape is there:
 *  its surface is at point - depth * normal. `feature` names the corners, edges or faces that meet, and
 *  stays the same while they do. */
typedef struct detent_contact_point2 {
  detent_vec2 point;
  int32_t depth;
  uint32_t feature;
} detent_contact_point2;

/** How two shapes a and b that overlap are separated by the least translation: b moves by `depth`,
 *  rounded up, along `normal`, which points from a to b. The first `count` points are set, the others
 *  zeros. */
typedef struct detent_manifold2 {
  detent_direction2 normal;
  int32_t depth;
  uint32_t count;
  detent_contact_point2 points[2];
} detent_manifold2;

/** The motion of a frame from one pose to another, over the time from 0 to 1: its origin goes evenly,
 *  and it turns about one axis by at most half a turn. */
typedef struct detent_sweep2 {
  detent_vec2 start;
  detent_vec2 end;
  detent_rotation2 start_rotation;
  detent_rotation2 end_rotation;
} detent_sweep2;

/** Where a ray first touches an object; in a mesh or height field also the index of the triangle. */
typedef struct detent_object_hit2 {
  int32_t distance;
  detent_id id;
  detent_vec2 point;
  detent_direction2 normal;
  uint32_t triangle;
  uint32_t has_triangle; /**< 1 or 0 */
} detent_object_hit2;

/** A character: a capsule or AABB that walks, and what it stands on. It is all of its state. Set it to zeros
 *  and the shape to where it starts; zeros in `is_grounded` let it leave the ground. A ball is a capsule
 *  whose ends are equal. */
typedef struct detent_mover2 {
  detent_shape2 shape;
  uint32_t is_grounded; /**< 1 or 0; if 0, the fields below are not read */
  detent_id object;
  detent_direction2 normal;
  detent_id frame;      /**< of the object; it carries the character */
  detent_vec2 local;  /**< the point under the character, in the frame */
  detent_vec2 point;  /**< the same in the world */
} detent_mover2;

/** How a character moves. Lengths in steps of 2^-16. */
typedef struct detent_mover2_settings {
  detent_direction2 up;
  int32_t skin;          /**< how far it stays from what it walks along; at least 32 */
  int32_t step_height;   /**< the highest step that it climbs; 0 for none */
  int32_t snap_distance; /**< how far below it ground is followed; 0 for not at all */
  uint32_t max_slope;    /**< the steepest slope that it stands on, in 2^-32 of a turn */
} detent_mover2_settings;

/** Something that a character touched during a move; the normal points away from it. */
typedef struct detent_mover2_touch {
  detent_id object;
  detent_vec2 point;
  detent_direction2 normal;
} detent_mover2_touch;

/** What a move did. The first `count` of the touches are set, the others zeros. */
typedef struct detent_move2 {
  detent_vec2 moved;   /**< in all */
  detent_vec2 carried; /**< of this, by the frame of the ground */
  detent_vec2 pushed;  /**< of this, out of what it overlapped */
  uint32_t count;
  uint32_t is_stuck;     /**< 1: it overlaps something that it could not be pushed out of */
  detent_mover2_touch touched[8];
} detent_move2;

/** How a world steps. Lengths and speeds in steps of 2^-16. */
typedef struct detent_world2_settings {
  int32_t ticks_per_second;
  int32_t substeps; /**< ticks_per_second * substeps in [1, 32767] */
  detent_vec2 gravity;
  int32_t margin;           /**< distance at which bodies are in contact */
  int32_t push_speed;       /**< the fastest that an overlap is undone */
  int32_t bounce_threshold; /**< slower impacts do not bounce */
  int32_t sleep_speed;      /**< slower bodies may sleep; 0: never */
} detent_world2_settings;

/** What a body is made of, and how it starts. Shares and densities in steps of 2^-16. */
typedef struct detent_body2_options {
  uint64_t user; /**< any word; saved, never read */
  uint32_t layers;
  uint32_t collides_with; /**< the layers that it meets; both bodies must want to meet */
  uint32_t motion;        /**< DETENT_DYNAMIC_BODY, ... */
  int32_t density;
  int32_t friction;
  int32_t restitution;
  int32_t linear_damping;
  int32_t angular_damping;
  detent_vec2 velocity;
  int32_t angular_velocity[1];
  int32_t gravity_scale; /**< of the world's gravity; 65536 is all of it */
  uint32_t locked;       /**< DETENT_LOCK_X | ... */
  uint32_t is_sensor;    /**< 1: touches are reported, and push nobody */
  uint32_t is_fast;      /**< 1: it never passes through others, however fast */
  uint32_t reserved[1]; /**< not read; no compiler has to add bytes of its own */
} detent_body2_options;

/** A part of a compound: a sphere, AABB, OBB, capsule or solid hull in the compound's frame, and what it is
 *  made of, in steps of 2^-16. Start from `detent_part2_defaults`. */
typedef struct detent_part2 {
  detent_shape2 shape;
  int32_t density;     /**< 0: the part adds no mass */
  int32_t friction;
  int32_t restitution;
  uint32_t is_sensor;  /**< 1: its touches are reported, and push nobody */
} detent_part2;

/** A joint of two bodies a and b. Anchors and frames are in the frames of their bodies. Seconds are those
 *  of the world's settings, angles radians; all numbers in steps of 2^-16. A kind that does not have a
 *  field ignores it. */
typedef struct detent_joint2 {
  uint32_t kind;
  detent_id a;
  detent_id b;
  detent_vec2 anchor_a;       /**< less than 512 units from the centre */
  detent_vec2 anchor_b;
  detent_rotation2 frame_a;   /**< hinge, weld, slider, wheel */
  detent_rotation2 frame_b;
  uint32_t collide;             /**< 1: a and b may touch each other */
  int32_t break_force;          /**< a greater force ends the joint; 0: none does */
  uint32_t has_limits;          /**< hinge, slider, wheel: 1 or 0; distances always have them */
  int32_t lower;                /**< an angle of hinges, a length of the others */
  int32_t upper;
  int32_t motor_speed;          /**< hinge, slider, wheel */
  int32_t motor_force;          /**< the most of it; of hinges and wheels a torque; of balls no motor */
  int32_t length;               /**< of the spring: distance, slider, wheel */
  int32_t frequency;            /**< of the spring, per second; 0: none. Distance, ball, slider, wheel */
  int32_t damping_ratio;        /**< 65536: critical */
} detent_joint2;

/** Where a body is and how it moves, rounded to nearest. */
typedef struct detent_body2 {
  detent_vec2 position;
  detent_rotation2 rotation;
  detent_vec2 velocity;
  int32_t angular_velocity[1];
  uint32_t is_asleep;
} detent_body2;

/** A point or vector, in steps of 2^-16. */
typedef struct detent_vec3 {
  int32_t x, y, z;
} detent_vec3;

/** A unit vector, in steps of 2^-30; used exactly as stored. */
typedef struct detent_direction3 {
  int32_t x, y, z;
} detent_direction3;

/** The axes of a frame in the world. */
typedef struct detent_rotation3 {
  detent_direction3 axis[3];
} detent_rotation3;

/** p -> translation + scale * rotation * p; `scale` in steps of 2^-16. */
typedef struct detent_transform3 {
  detent_vec3 translation;
  detent_rotation3 rotation;
  int32_t scale;
} detent_transform3;

/** The points origin + t * direction with 0 <= t <= max_distance. */
typedef struct detent_ray3 {
  detent_vec3 origin;
  detent_direction3 direction;
  int32_t max_distance;
} detent_ray3;

/** The points within `radius` of `center`; none if the radius is negative. */
typedef struct detent_sphere3 {
  detent_vec3 center;
  int32_t radius;
} detent_sphere3;

/** The points between two corners; none if min > max on an axis. */
typedef struct detent_aabb3 {
  detent_vec3 min;
  detent_vec3 max;
} detent_aabb3;

/** A box turned about its center; none if a half extent is negative. */
typedef struct detent_obb3 {
  detent_vec3 center;
  detent_vec3 half_extents;
  detent_rotation3 rotation;
} detent_obb3;

/** The points x with dot(normal, x) = offset. */
typedef struct detent_plane3 {
  detent_direction3 normal;
  int32_t offset;
} detent_plane3;

/** The points between three corners. */
typedef struct detent_triangle3 {
  detent_vec3 a;
  detent_vec3 b;
  detent_vec3 c;
} detent_triangle3;

/** The points within `radius` of the segment from a to b; none if the radius is negative. */
typedef struct detent_capsule3 {
  detent_vec3 a;
  detent_vec3 b;
  int32_t radius;
} detent_capsule3;

/** The points between two ends. */
typedef struct detent_segment3 {
  detent_vec3 start;
  detent_vec3 end;
} detent_segment3;

/** A shape of any kind: `kind` says which member is set. `asset` is the handle of a hull, mesh or
 *  height field, and ignored for other kinds. */
typedef struct detent_shape3 {
  uint32_t kind;
  detent_handle asset;
  union {
    detent_sphere3 sphere;
    detent_aabb3 aabb;
    detent_obb3 obb;
    detent_plane3 plane;
    detent_triangle3 triangle;
    detent_capsule3 capsule;
    detent_segment3 segment;
    detent_vec3 point;
    detent_transform3 placed;
  } as;
} detent_shape3;

/** Where a ray or a moving shape first touches a shape. The distance is rounded down. */
typedef struct detent_hit3 {
  int32_t distance;
  detent_vec3 point;
  detent_direction3 normal;
} detent_hit3;

/** One point of a contact, on the surface of the first shape, and how deep the second shape is there:
 *  its surface is at point - depth * normal. `feature` names the corners, edges or faces that meet, and
 *  stays the same while they do. */
typedef struct detent_contact_point3 {
  detent_vec3 point;
  int32_t depth;
  uint32_t feature;
} detent_contact_point3;

/** How two shapes a and b that overlap are separated by the least translation: b moves by `depth`,
 *  rounded up, along `normal`, which points from a to b. The first `count` points are set, the others
 *  zeros. */
typedef struct detent_manifold3 {
  detent_direction3 normal;
  int32_t depth;
  uint32_t count;
  detent_contact_point3 points[4];
} detent_manifold3;

/** The motion of a frame from one pose to another, over the time from 0 to 1: its origin goes evenly,
 *  and it turns about one axis by at most half a turn. */
typedef struct detent_sweep3 {
  detent_vec3 start;
  detent_vec3 end;
  detent_rotation3 start_rotation;
  detent_rotation3 end_rotation;
} detent_sweep3;

/** Where a ray first touches an object; in a mesh or height field also the index of the triangle. */
typedef struct detent_object_hit3 {
  int32_t distance;
  detent_id id;
  detent_vec3 point;
  detent_direction3 normal;
  uint32_t triangle;
  uint32_t has_triangle; /**< 1 or 0 */
} detent_object_hit3;

/** A character: a capsule or AABB that walks, and what it stands on. It is all of its state. Set it to zeros
 *  and the shape to where it starts; zeros in `is_grounded` let it leave the ground. A ball is a capsule
 *  whose ends are equal. */
typedef struct detent_mover3 {
  detent_shape3 shape;
  uint32_t is_grounded; /**< 1 or 0; if 0, the fields below are not read */
  detent_id object;
  detent_direction3 normal;
  detent_id frame;      /**< of the object; it carries the character */
  detent_vec3 local;  /**< the point under the character, in the frame */
  detent_vec3 point;  /**< the same in the world */
} detent_mover3;

/** How a character moves. Lengths in steps of 2^-16. */
typedef struct detent_mover3_settings {
  detent_direction3 up;
  int32_t skin;          /**< how far it stays from what it walks along; at least 32 */
  int32_t step_height;   /**< the highest step that it climbs; 0 for none */
  int32_t snap_distance; /**< how far below it ground is followed; 0 for not at all */
  uint32_t max_slope;    /**< the steepest slope that it stands on, in 2^-32 of a turn */
} detent_mover3_settings;

/** Something that a character touched during a move; the normal points away from it. */
typedef struct detent_mover3_touch {
  detent_id object;
  detent_vec3 point;
  detent_direction3 normal;
} detent_mover3_touch;

/** What a move did. The first `count` of the touches are set, the others zeros. */
typedef struct detent_move3 {
  detent_vec3 moved;   /**< in all */
  detent_vec3 carried; /**< of this, by the frame of the ground */
  detent_vec3 pushed;  /**< of this, out of what it overlapped */
  uint32_t count;
  uint32_t is_stuck;     /**< 1: it overlaps something that it could not be pushed out of */
  detent_mover3_touch touched[8];
} detent_move3;

/** How a world steps. Lengths and speeds in steps of 2^-16. */
typedef struct detent_world3_settings {
  int32_t ticks_per_second;
  int32_t substeps; /**< ticks_per_second * substeps in [1, 32767] */
  detent_vec3 gravity;
  int32_t margin;           /**< distance at which bodies are in contact */
  int32_t push_speed;       /**< the fastest that an overlap is undone */
  int32_t bounce_threshold; /**< slower impacts do not bounce */
  int32_t sleep_speed;      /**< slower bodies may sleep; 0: never */
} detent_world3_settings;

/** What a body is made of, and how it starts. Shares and densities in steps of 2^-16. */
typedef struct detent_body3_options {
  uint64_t user; /**< any word; saved, never read */
  uint32_t layers;
  uint32_t collides_with; /**< the layers that it meets; both bodies must want to meet */
  uint32_t motion;        /**< DETENT_DYNAMIC_BODY, ... */
  int32_t density;
  int32_t friction;
  int32_t restitution;
  int32_t linear_damping;
  int32_t angular_damping;
  detent_vec3 velocity;
  int32_t angular_velocity[3];
  int32_t gravity_scale; /**< of the world's gravity; 65536 is all of it */
  uint32_t locked;       /**< DETENT_LOCK_X | ... */
  uint32_t is_sensor;    /**< 1: touches are reported, and push nobody */
  uint32_t is_fast;      /**< 1: it never passes through others, however fast */
  uint32_t reserved[2]; /**< not read; no compiler has to add bytes of its own */
} detent_body3_options;

/** A part of a compound: a sphere, AABB, OBB, capsule or solid hull in the compound's frame, and what it is
 *  made of, in steps of 2^-16. Start from `detent_part3_defaults`. */
typedef struct detent_part3 {
  detent_shape3 shape;
  int32_t density;     /**< 0: the part adds no mass */
  int32_t friction;
  int32_t restitution;
  uint32_t is_sensor;  /**< 1: its touches are reported, and push nobody */
} detent_part3;

/** A joint of two bodies a and b. Anchors and frames are in the frames of their bodies. Seconds are those
 *  of the world's settings, angles radians; all numbers in steps of 2^-16. A kind that does not have a
 *  field ignores it. */
typedef struct detent_joint3 {
  uint32_t kind;
  detent_id a;
  detent_id b;
  detent_vec3 anchor_a;       /**< less than 512 units from the centre */
  detent_vec3 anchor_b;
  detent_rotation3 frame_a;   /**< hinge, weld, slider, wheel */
  detent_rotation3 frame_b;
  uint32_t collide;             /**< 1: a and b may touch each other */
  int32_t break_force;          /**< a greater force ends the joint; 0: none does */
  uint32_t has_limits;          /**< hinge, slider, wheel: 1 or 0; distances always have them */
  int32_t lower;                /**< an angle of hinges, a length of the others */
  int32_t upper;
  int32_t motor_speed;          /**< hinge, slider, wheel */
  int32_t motor_force;          /**< the most of it; of hinges and wheels a torque; of balls no motor */
  int32_t length;               /**< of the spring: distance, slider, wheel */
  int32_t frequency;            /**< of the spring, per second; 0: none. Distance, ball, slider, wheel */
  int32_t damping_ratio;        /**< 65536: critical */
} detent_joint3;

/** Where a body is and how it moves, rounded to nearest. */
typedef struct detent_body3 {
  detent_vec3 position;
  detent_rotation3 rotation;
  detent_vec3 velocity;
  int32_t angular_velocity[3];
  uint32_t is_asleep;
} detent_body3;

/** A camera: where it is and what its lens sees. The pose is that of `detent_camera3_look_at`: axis 0 to the
 *  right, axis 1 up, looking along -axis 2; its scale is ignored. */
typedef struct detent_camera3 {
  detent_transform3 pose;
  uint32_t has_perspective; /**< 1 or 0 */
  uint32_t fov;             /**< of a perspective from top to bottom, in 2^-32 of a turn: above 0, below 165.7 degrees */
  int32_t aspect;           /**< of a perspective: width over height, in steps of 2^-16; above 0 */
  int32_t half_width;       /**< without perspective, a length above 0 */
  int32_t half_height;      /**< without perspective, a length above 0 */
  int32_t near_distance;    /**< less than `far_distance`; of a perspective above 0 */
  int32_t far_distance;
} detent_camera3;

/** What a camera sees: the convex hull of eight corners. Corner i is on the right if i & 1, at the top if
 *  i & 2, and far if i & 4; every query is exact for eight points in any order. */
typedef struct detent_frustum3 {
  detent_vec3 corners[8];
} detent_frustum3;

/** A point of the screen: pixels from the top left corner in steps of 2^-16, so that 32768 is the middle of
 *  the first, and the depth along the line of sight, a length. */
typedef struct detent_screen_point3 {
  int32_t x;
  int32_t y;
  int32_t depth;
} detent_screen_point3;

/** The version of the library: major * 10000 + minor * 100 + patch. */
DETENT_API int32_t detent_version(void);

/** Changes whenever an answer changes in any bit: recorded matches then no longer hold. */
DETENT_API int32_t detent_results_version(void);

/** The error or answer in words; never null. */
DETENT_API const char* detent_describe(detent_status status);

/** Opens a context. `allocator` may be null. The context itself, what it makes, and copies of triangles,
 *  points and heights take memory from it; the lists inside scenes and worlds from C++'s operator new.
 *  DETENT_BAD_CONTEXT if it is open already, DETENT_BAD_ARGUMENT if only one function is given. */
DETENT_API detent_status detent_open(detent_context* context, const detent_allocator* allocator);

/** Destroys everything made in the context and closes it; all its handles are stale. */
DETENT_API detent_status detent_close(detent_context* context);

/** How many scenes, worlds and assets the context has. */
DETENT_API detent_status detent_count(const detent_context* context, uint32_t* count);

/** The settings of an ordinary session: two players, delay 2, prediction 8, inputs of one byte. */
DETENT_API detent_status detent_session_default_settings(detent_session_settings* settings);

/** A mesh of `face_count` triangles; `faces` has three indices of `vertices` for each. Copies them.
 *  `id` is the caller's name in snapshots: not 0, and DETENT_IN_USE if another mesh has it.
 *  DETENT_BAD_ARGUMENT if a vertex is missing; at most 256 meshes a context, or DETENT_FULL. */
DETENT_API detent_status detent_mesh_create(detent_context* context, uint32_t id,
                                            const detent_vec3* vertices, uint32_t vertex_count,
                                            const uint32_t* faces, uint32_t face_count,
                                            detent_handle* mesh);

/** A height field: sample (column, row) is at x = corner.x + column * cell, z = corner.y + row * cell,
 *  and its y is heights[row * columns + column]. Copies the heights. `id` as for meshes.
 *  DETENT_BAD_ARGUMENT for fewer than two columns or rows, a cell that is not positive, or a far corner
 *  out of range. */
DETENT_API detent_status detent_height_field_create(detent_context* context, uint32_t id,
                                                    const detent_vec2* corner, int32_t cell,
                                                    uint32_t columns, uint32_t rows,
                                                    const int32_t* heights, detent_handle* field);

/** Destroys a mesh, hull, height field or compound. DETENT_IN_USE while an object, a body or a compound
 *  refers to it, or a session is there that might. */
DETENT_API detent_status detent_asset_destroy(detent_context* context, detent_handle asset);

/** Whether the ray touches the shape, and where. `hit` may be null. For the kinds from DETENT_SPHERE to
 *  DETENT_SEGMENT. Distance 0 if the ray starts inside. */
DETENT_API detent_status detent_raycast2(const detent_ray2* ray, const detent_shape2* shape,
                                           detent_hit2* hit);

/** The distances along `count` rays at which they touch one shape, -1 for none. Returns DETENT_OK
 *  after the last ray; the first wrong direction ends it with DETENT_NOT_UNIT. */
DETENT_API detent_status detent_raycast2_many(const detent_ray2* rays, uint32_t count,
                                                const detent_shape2* shape, int32_t* distances);

/** Whether the point is in the shape or on its surface, exactly. */
DETENT_API detent_status detent_contains2(const detent_shape2* shape, const detent_vec2* point);

/** Whether two shapes have a point in common, exactly. */
DETENT_API detent_status detent_overlaps2(const detent_shape2* a, const detent_shape2* b);

/** The point of the shape closest to `point`, each coordinate rounded to nearest. */
DETENT_API detent_status detent_closest_point2(const detent_shape2* shape,
                                                 const detent_vec2* point,
                                                 detent_vec2* closest);

/** The distance from the shape to `point`, rounded down; the greatest int32_t if the shape is empty. */
DETENT_API detent_status detent_distance_to_point2(const detent_shape2* shape,
                                                     const detent_vec2* point,
                                                     int32_t* distance);

/** The distance between two shapes, rounded down; 0 if they share a point. */
DETENT_API detent_status detent_distance2(const detent_shape2* a, const detent_shape2* b,
                                            int32_t* distance);

/** How two shapes that overlap are separated; touching counts. DETENT_NO if they do not. `contact` may
 *  be null. For the kinds from DETENT_SPHERE to DETENT_SEGMENT, but two planes. */
DETENT_API detent_status detent_contact2(const detent_shape2* a, const detent_shape2* b,
                                           detent_manifold2* contact);

/** The point of a closest to b and that of b closest to a, each coordinate rounded to nearest: the same
 *  point twice where they meet. Of several pairs it is the one whose point of a has the least x, then y,
 *  then z. The origin twice if a shape is empty. For the kinds from DETENT_SPHERE to DETENT_SEGMENT. */
DETENT_API detent_status detent_closest_points2(const detent_shape2* a,
                                                  const detent_shape2* b,
                                                  detent_vec2* point_a,
                                                  detent_vec2* point_b);

/** Where `shape`, moving along `direction` by at most `max_distance`, first touches `target`: how far it
 *  has moved, rounded down, the point of the target and the normal there, which faces the shape.
 *  DETENT_NO if it touches nothing. Distance 0 if they share a point at the start. `hit` may be null.
 *  For the kinds from DETENT_SPHERE to DETENT_SEGMENT, but planes do not move. */
DETENT_API detent_status detent_cast2(const detent_shape2* shape,
                                        const detent_direction2* direction, int32_t max_distance,
                                        const detent_shape2* target, detent_hit2* hit);

/** When two shapes, each given in the frame that its sweep moves, are first closer than `target` (a
 *  length; 8 is usual), rounded down. DETENT_NO if they stay apart. `sweep_b` may be null: b does not
 *  move; a plane must not. `impact` may be null. For the kinds from DETENT_SPHERE to DETENT_CAPSULE. */
DETENT_API detent_status detent_time_of_impact2(const detent_shape2* a,
                                                  const detent_sweep2* sweep_a,
                                                  const detent_shape2* b,
                                                  const detent_sweep2* sweep_b, int32_t target,
                                                  detent_impact* impact);

/** Whether the point is on the ray, exactly. */
DETENT_API detent_status detent_ray2_contains(const detent_ray2* ray, const detent_vec2* point);

/** The point of the ray closest to `point`, each coordinate rounded to nearest. */
DETENT_API detent_status detent_ray2_closest_point(const detent_ray2* ray,
                                                     const detent_vec2* point,
                                                     detent_vec2* closest);

/** The distance from the ray to `point`, rounded down. */
DETENT_API detent_status detent_ray2_distance_to_point(const detent_ray2* ray,
                                                         const detent_vec2* point,
                                                         int32_t* distance);

/** Where the ray first touches any of `count` shapes; of several at one distance the first in the list. The
 *  functions of `detent_shapes2` take the union of several shapes, which may be none: of the kinds from
 *  DETENT_SPHERE to DETENT_SEGMENT, and DETENT_HULL of `context`, whose transformed points are rounded to
 *  nearest. `context` may be null if there is no hull, and `hit` may be null. */
DETENT_API detent_status detent_shapes2_raycast(const detent_context* context,
                                                  const detent_ray2* ray,
                                                  const detent_shape2* shapes, uint32_t count,
                                                  detent_hit2* hit);

/** Whether the point is in any of the shapes, exactly. */
DETENT_API detent_status detent_shapes2_contains(const detent_context* context,
                                                   const detent_shape2* shapes, uint32_t count,
                                                   const detent_vec2* point);

/** Whether any of the shapes of one list has a point in common with one of the other, exactly. */
DETENT_API detent_status detent_shapes2_overlaps(const detent_context* context,
                                                   const detent_shape2* a, uint32_t a_count,
                                                   const detent_shape2* b, uint32_t b_count);

/** The closest point of the shape nearest to `point`, each coordinate rounded to nearest; of several at one
 *  distance, rounded down, the first. `point` itself for no shapes. */
DETENT_API detent_status detent_shapes2_closest_point(const detent_context* context,
                                                        const detent_shape2* shapes,
                                                        uint32_t count, const detent_vec2* point,
                                                        detent_vec2* closest);

/** The distance from the nearest shape to `point`, rounded down; the greatest int32_t for no shapes. */
DETENT_API detent_status detent_shapes2_distance_to_point(const detent_context* context,
                                                            const detent_shape2* shapes,
                                                            uint32_t count,
                                                            const detent_vec2* point,
                                                            int32_t* distance);

/** The least distance between a shape of one list and one of the other, rounded down; 0 if they share a
 *  point, the greatest int32_t if a list is empty. */
DETENT_API detent_status detent_shapes2_distance(const detent_context* context,
                                                   const detent_shape2* a, uint32_t a_count,
                                                   const detent_shape2* b, uint32_t b_count,
                                                   int32_t* distance);

/** The closest points of the two shapes that are nearest to each other, each coordinate rounded to nearest;
 *  of several shapes at one distance, rounded down, the first of a, then of b; of several pairs of points
 *  the one whose point of b has the least x, then y, then z. The origin twice if a list is empty. */
DETENT_API detent_status detent_shapes2_closest_points(const detent_context* context,
                                                         const detent_shape2* a, uint32_t a_count,
                                                         const detent_shape2* b, uint32_t b_count,
                                                         detent_vec2* point_a,
                                                         detent_vec2* point_b);

/** `detent_cast2` of one moving shape, which may be a hull, at any of `count` shapes; of several at one
 *  distance the first. `hit` may be null. */
DETENT_API detent_status detent_shapes2_cast(const detent_context* context,
                                               const detent_shape2* shape,
                                               const detent_direction2* direction,
                                               int32_t max_distance,
                                               const detent_shape2* targets, uint32_t count,
                                               detent_hit2* hit);

/** `detent_contact2` of two shapes of which each may be a hull. `contact` may be null. */
DETENT_API detent_status detent_shapes2_contact(const detent_context* context,
                                                  const detent_shape2* a,
                                                  const detent_shape2* b,
                                                  detent_manifold2* contact);

/** `detent_time_of_impact2` of two shapes of which each may be a hull. `sweep_b` and `impact` may be
 *  null. */
DETENT_API detent_status detent_shapes2_time_of_impact(const detent_context* context,
                                                         const detent_shape2* a,
                                                         const detent_sweep2* sweep_a,
                                                         const detent_shape2* b,
                                                         const detent_sweep2* sweep_b,
                                                         int32_t target, detent_impact* impact);

/** A convex hull of at most 64 points, in any order. Copies them. `id` as for meshes. */
DETENT_API detent_status detent_hull2_create(detent_context* context, uint32_t id,
                                               const detent_vec2* points, uint32_t count,
                                               detent_handle* hull);

/** A convex hull of at most 32 points with a volume, for bodies of worlds; its centre of mass is the
 *  place of such a body. At most 64 a context. DETENT_BAD_ARGUMENT without a volume. Copies the points.
 *  `id` as for meshes. */
DETENT_API detent_status detent_solid2_create(detent_context* context, uint32_t id,
                                                const detent_vec2* points, uint32_t count,
                                                detent_handle* solid);

/** A part that is a point without mass yet: density 1, friction 3/5, no restitution, no sensor. Set its
 *  shape. */
DETENT_API detent_status detent_part2_defaults(detent_part2* part);

/** A compound of 1 to 65536 parts, for bodies of worlds: they keep their places to each other, and their
 *  common centre of mass is the place of such a body. Where parts overlap, masses add. At most 256 a
 *  context. Copies the parts, and keeps their solid hulls in use. DETENT_NO_QUERY for other kinds of shape.
 *  `id` as for meshes. */
DETENT_API detent_status detent_compound2_create(detent_context* context, uint32_t id,
                                                   const detent_part2* parts, uint32_t count,
                                                   detent_handle* compound);

/** An empty scene, for all kinds of shape but segments and points. */
DETENT_API detent_status detent_scene2_create(detent_context* context, detent_handle* scene);

/** Destroys a scene. */
DETENT_API detent_status detent_scene2_destroy(detent_context* context, detent_handle scene);

/** Adds an object. `traits` may be null: layer 1, user 0, moving, in no frame. DETENT_FULL beyond 1,048,576
 *  objects, DETENT_NO if the frame does not exist, DETENT_BAD_ARGUMENT for a fixed object in a frame. */
DETENT_API detent_status detent_scene2_add(detent_context* context, detent_handle scene,
                                             const detent_shape2* shape,
                                             const detent_traits* traits, detent_id* id);

/** Adds an object with an id of the caller's. DETENT_NO if its index is taken or too large, or the
 *  generation 0 or 2^32 - 1. */
DETENT_API detent_status detent_scene2_add_as(detent_context* context, detent_handle scene,
                                                detent_id id, const detent_shape2* shape,
                                                const detent_traits* traits);

/** Removes an object. DETENT_NO if there is none with this id. */
DETENT_API detent_status detent_scene2_remove(detent_context* context, detent_handle scene,
                                                detent_id id);

/** Replaces the shape of an object, in its frame if it has one. DETENT_NO if there is none with this id. */
DETENT_API detent_status detent_scene2_replace(detent_context* context, detent_handle scene,
                                                 detent_id id, const detent_shape2* shape);

/** Moves an object by a vector; coordinates are clamped. DETENT_NO if there is none with this id. */
DETENT_API detent_status detent_scene2_move(detent_context* context, detent_handle scene,
                                              detent_id id, const detent_vec2* by);

/** The shape of an object in the world, and what is stored with it. Both may be null. DETENT_NO if there is none
 *  with this id. */
DETENT_API detent_status detent_scene2_object(const detent_context* context, detent_handle scene,
                                                detent_id id, detent_shape2* shape,
                                                detent_traits* traits);

/** Sets layers and user word of an object; its motion cannot change, and is ignored. */
DETENT_API detent_status detent_scene2_set_traits(detent_context* context, detent_handle scene,
                                                    detent_id id, const detent_traits* traits);

/** Adds a frame that objects can be in, inside `parent`; {0, 0}: the world. DETENT_NO if there is no such
 *  parent, DETENT_FULL if there is no room. */
DETENT_API detent_status detent_scene2_add_frame(detent_context* context, detent_handle scene,
                                                   const detent_transform2* transform,
                                                   detent_id parent, detent_id* frame);

/** Moves a frame in its parent, and everything in it. DETENT_NO if there is none with this id. */
DETENT_API detent_status detent_scene2_move_frame(detent_context* context, detent_handle scene,
                                                    detent_id frame,
                                                    const detent_transform2* transform);

/** Removes a frame. DETENT_NO if there is none with this id, or if anything is in it. */
DETENT_API detent_status detent_scene2_remove_frame(detent_context* context, detent_handle scene,
                                                      detent_id frame);

/** The transforms of a frame to its parent and to the world. Both may be null. DETENT_NO if there is
 *  none with this id. */
DETENT_API detent_status detent_scene2_frame(const detent_context* context, detent_handle scene,
                                               detent_id frame, detent_transform2* local,
                                               detent_transform2* world);

/** How many objects the scene has. */
DETENT_API detent_status detent_scene2_size(const detent_context* context, detent_handle scene,
                                              uint32_t* size);

/** Makes queries faster after many additions, such as loading a level. Never changes a result. */
DETENT_API detent_status detent_scene2_optimize(detent_context* context, detent_handle scene);

/** The object in `layers` that the ray touches first, and where; of several at one distance the least
 *  id. `hit` may be null. */
DETENT_API detent_status detent_scene2_raycast(const detent_context* context, detent_handle scene,
                                                 const detent_ray2* ray, uint32_t layers,
                                                 detent_object_hit2* hit);

/** Whether the ray touches any object in `layers`. */
DETENT_API detent_status detent_scene2_raycast_any(const detent_context* context,
                                                     detent_handle scene, const detent_ray2* ray,
                                                     uint32_t layers);

/** All objects in `layers` that the ray touches, by distance, then id. Writes the first `room` of them
 *  and their whole number to `count`. */
DETENT_API detent_status detent_scene2_raycast_all(const detent_context* context,
                                                     detent_handle scene, const detent_ray2* ray,
                                                     uint32_t layers, detent_object_hit2* hits,
                                                     uint32_t room, uint32_t* count);

/** `detent_scene2_raycast` for many rays; of a ray that hits nothing the id is {0, 0} and the distance
 *  -1. The first wrong direction ends it with DETENT_NOT_UNIT. */
DETENT_API detent_status detent_scene2_raycast_many(const detent_context* context,
                                                      detent_handle scene, const detent_ray2* rays,
                                                      uint32_t count, uint32_t layers,
                                                      detent_object_hit2* hits);

/** The object in `layers` nearest to a point, however far; or nearest to the center, start or end a
 *  of those that a sphere, AABB, OBB, capsule or segment overlaps. `found` may be null. */
DETENT_API detent_status detent_scene2_nearest(const detent_context* context, detent_handle scene,
                                                 const detent_shape2* question, uint32_t layers,
                                                 detent_found* found);

/** Whether the point, sphere, AABB, OBB, capsule or segment overlaps any object in `layers`. */
DETENT_API detent_status detent_scene2_any(const detent_context* context, detent_handle scene,
                                             const detent_shape2* question, uint32_t layers);

/** All objects in `layers` that the point, sphere, AABB, OBB, capsule or segment overlaps, by distance,
 *  then id. Writes the first `room` of them and their whole number to `count`. */
DETENT_API detent_status detent_scene2_all(const detent_context* context, detent_handle scene,
                                             const detent_shape2* question, uint32_t layers,
                                             detent_found* found, uint32_t room, uint32_t* count);

/** All pairs of overlapping objects of which one moves, sorted by id. Writes the first `room` of them
 *  and their whole number to `count`. */
DETENT_API detent_status detent_scene2_overlaps(const detent_context* context,
                                                  detent_handle scene, detent_pair* pairs,
                                                  uint32_t room, uint32_t* count);

/** The first object in `layers` that a moving shape touches: `detent_cast2` over all objects, for
 *  spheres, AABBs, OBBs, capsules and segments; of several at one distance the least id. DETENT_NO if there
 *  is none. `hit` may be null. */
DETENT_API detent_status detent_scene2_cast(const detent_context* context, detent_handle scene,
                                              const detent_shape2* shape,
                                              const detent_direction2* direction,
                                              int32_t max_distance, uint32_t layers,
                                              detent_object_hit2* hit);

/** Whether the moving shape touches any object in `layers`. */
DETENT_API detent_status detent_scene2_cast_any(const detent_context* context,
                                                  detent_handle scene,
                                                  const detent_shape2* shape,
                                                  const detent_direction2* direction,
                                                  int32_t max_distance, uint32_t layers);

/** All objects in `layers` that the moving shape touches, by distance, then id. Writes the first `room` of
 *  them and their whole number to `count`. */
DETENT_API detent_status detent_scene2_cast_all(const detent_context* context,
                                                  detent_handle scene,
                                                  const detent_shape2* shape,
                                                  const detent_direction2* direction,
                                                  int32_t max_distance, uint32_t layers,
                                                  detent_object_hit2* hits, uint32_t room,
                                                  uint32_t* count);

/** The settings of an ordinary character: up is y, skin 1/64, steps and snapping 1/3, slopes to 50
 *  degrees. */
DETENT_API detent_status detent_mover2_default_settings(detent_mover2_settings* settings);

/** Moves a character by `by`, gravity included, as far as the objects in `layers` other than `ignored`
 *  let it: carried by its ground, pushed out of what it overlaps, it walks and climbs steps, or flies,
 *  slides along what it meets and lands. It ends overlapping nothing that it did not overlap at the
 *  start. `settings` may be null: the ordinary ones. `result` may be null. DETENT_NO_QUERY for other shapes
 *  than capsules and AABBs. */
DETENT_API detent_status detent_mover2_move(const detent_context* context, detent_handle scene,
                                              detent_mover2* mover, const detent_vec2* by,
                                              const detent_mover2_settings* settings,
                                              uint32_t layers, detent_id ignored,
                                              detent_move2* result);

/** The part of a velocity that does not lead into what a character touched in a move: the closest one. */
DETENT_API detent_status detent_mover2_clip_velocity(const detent_vec2* velocity,
                                                       const detent_move2* result,
                                                       detent_vec2* clipped);

/** 64 bits of all objects: equal on every machine for equal scenes. */
DETENT_API detent_status detent_scene2_digest(const detent_context* context, detent_handle scene,
                                                uint64_t* digest);

/** Writes the canonical bytes of the moving objects to `bytes` if `room` holds them, and their number
 *  to `size`. DETENT_NO if there is less room: ask with room 0 first. */
DETENT_API detent_status detent_scene2_snapshot(const detent_context* context,
                                                  detent_handle scene, void* bytes, uint32_t room,
                                                  uint32_t* size);

/** Replaces the moving objects by those of a snapshot, whose assets the context has. Any bytes are
 *  safe; on an error the scene is unchanged. */
DETENT_API detent_status detent_scene2_restore(detent_context* context, detent_handle scene,
                                                 const void* bytes, uint32_t size);

/** The settings of an ordinary world: 60 ticks a second of 4 substeps, gravity -10 along y. */
DETENT_API detent_status detent_world2_default_settings(detent_world2_settings* settings);

/** The options of an ordinary body: dynamic, density 1, friction 3/5, at rest, in layer 1. */
DETENT_API detent_status detent_body2_default_options(detent_body2_options* options);

/** An empty world. `settings` may be null: the ordinary ones. */
DETENT_API detent_status detent_world2_create(detent_context* context,
                                                const detent_world2_settings* settings,
                                                detent_handle* world);

/** Destroys a world. */
DETENT_API detent_status detent_world2_destroy(detent_context* context, detent_handle world);

/** Adds a body: a sphere, AABB, OBB, capsule, solid hull or compound; in 3D also a mesh or height field,
 *  which are fixed or kinematic, whatever the options say. Where it has `placed`, the scale must be 65536.
 *  `options` may be null: the ordinary ones; density, friction and restitution of compounds are those of
 *  their parts. */
DETENT_API detent_status detent_world2_add(detent_context* context, detent_handle world,
                                             const detent_shape2* shape,
                                             const detent_body2_options* options, detent_id* id);

/** Adds a body with an id of the caller's, such as one that was removed. DETENT_NO if its index is taken or
 *  too large, or the generation 0 or 2^32 - 1. */
DETENT_API detent_status detent_world2_add_as(detent_context* context, detent_handle world,
                                                detent_id id, const detent_shape2* shape,
                                                const detent_body2_options* options);

/** Removes a body and wakes those that touched it. DETENT_NO if there is none with this id. */
DETENT_API detent_status detent_world2_remove(detent_context* context, detent_handle world,
                                                detent_id id);

/** One tick: all substeps. */
DETENT_API detent_status detent_world2_step(detent_context* context, detent_handle world);

/** Where a body is and how it moves. DETENT_NO if there is none with this id. */
DETENT_API detent_status detent_world2_body(const detent_context* context, detent_handle world,
                                              detent_id id, detent_body2* body);

/** The same for `count` bodies at once; zeros where there is none. */
DETENT_API detent_status detent_world2_bodies(const detent_context* context, detent_handle world,
                                                const detent_id* ids, uint32_t count,
                                                detent_body2* bodies);

/** Where the frame is in which the points of a hull, the parts of a compound or the triangles of a surface
 *  were given, rounded to nearest, with the scale 65536; of other shapes that of the body. DETENT_NO if
 *  there is none with this id. */
DETENT_API detent_status detent_world2_frame(const detent_context* context, detent_handle world,
                                               detent_id id, detent_transform2* frame);

/** Sets the velocity of a body, per second, and wakes it. Nothing happens to fixed bodies. */
DETENT_API detent_status detent_world2_set_velocity(detent_context* context, detent_handle world,
                                                      detent_id id, const detent_vec2* velocity);

/** Sets the angular velocity of a body (1 numbers, radians per second), and wakes it. */
DETENT_API detent_status detent_world2_set_angular_velocity(detent_context* context,
                                                              detent_handle world, detent_id id,
                                                              const int32_t* velocity);

/** Changes velocity and spin at once as an impulse (mass times units per second) at the point `at` of
 *  the world does, or at the centre if that is null, and wakes the body. Nothing happens to bodies that
 *  are not dynamic. DETENT_NO if there is none with this id. */
DETENT_API detent_status detent_world2_apply_impulse(detent_context* context, detent_handle world,
                                                       detent_id id, const detent_vec2* impulse,
                                                       const detent_vec2* at);

/** The same for a force (mass times units per second and second) that acts during the next step. */
DETENT_API detent_status detent_world2_apply_force(detent_context* context, detent_handle world,
                                                     detent_id id, const detent_vec2* force,
                                                     const detent_vec2* at);

/** A torque (1 numbers, mass times squared units per second and second) that acts during the next
 *  step, and wakes the body. DETENT_NO if there is none with this id. */
DETENT_API detent_status detent_world2_apply_torque(detent_context* context, detent_handle world,
                                                      detent_id id, const int32_t* torque);

/** A joint of a kind with all its fields as they are if you do not know better: bodies {0, 0}, anchors at
 *  the centres, no limits, motor or spring; a distance between 0 and 1. */
DETENT_API detent_status detent_joint2_defaults(uint32_t kind, detent_joint2* joint);

/** Adds a joint and wakes its bodies. DETENT_NO if one of them does not exist or both are the same,
 *  DETENT_FULL without room, DETENT_BAD_ARGUMENT for negative forces, frequencies or ratios. */
DETENT_API detent_status detent_world2_add_joint(detent_context* context, detent_handle world,
                                                   const detent_joint2* joint, detent_id* id);

/** Makes a joint another one of the same kind, such as one with another motor, and wakes its bodies; it
 *  keeps its impulses. DETENT_NO if there is none of this kind with this id, or not both bodies. */
DETENT_API detent_status detent_world2_change_joint(detent_context* context, detent_handle world,
                                                      detent_id id, const detent_joint2* joint);

/** Removes a joint and wakes its bodies. DETENT_NO if there is none with this id. */
DETENT_API detent_status detent_world2_remove_joint(detent_context* context, detent_handle world,
                                                      detent_id id);

/** A joint as it was added or last changed. DETENT_NO if there is none with this id. */
DETENT_API detent_status detent_world2_joint(const detent_context* context, detent_handle world,
                                               detent_id id, detent_joint2* joint);

/** How many joints the world has. */
DETENT_API detent_status detent_world2_joint_count(const detent_context* context,
                                                     detent_handle world, uint32_t* count);

/** The joints that broke in the last step, which are removed, by index. Writes the first `room` of them
 *  and their whole number to `count`. */
DETENT_API detent_status detent_world2_broken(const detent_context* context, detent_handle world,
                                                detent_id* joints, uint32_t room, uint32_t* count);

/** A point of the world in the frame of a body, rounded to nearest: an anchor of a joint. DETENT_NO if
 *  there is none with this id. */
DETENT_API detent_status detent_world2_local_point(const detent_context* context,
                                                     detent_handle world, detent_id id,
                                                     const detent_vec2* point,
                                                     detent_vec2* local);

/** Axes of the world in the frame of a body, rounded to nearest: a frame of a joint. DETENT_NO if there
 *  is none with this id. */
DETENT_API detent_status detent_world2_local_frame(const detent_context* context,
                                                     detent_handle world, detent_id id,
                                                     const detent_rotation2* frame,
                                                     detent_rotation2* local);

/** How many bodies the world has. */
DETENT_API detent_status detent_world2_size(const detent_context* context, detent_handle world,
                                              uint32_t* size);

/** The pairs that began or ended to touch in the last step, by id. Writes the first `room` of them and
 *  their whole number to `count`. */
DETENT_API detent_status detent_world2_events(const detent_context* context, detent_handle world,
                                                detent_touch* events, uint32_t room,
                                                uint32_t* count);

/** 64 bits of all bodies that are not fixed, their contacts and joints. */
DETENT_API detent_status detent_world2_digest(const detent_context* context, detent_handle world,
                                                uint64_t* digest);

/** 64 bits of one body. DETENT_NO if there is none with this id. */
DETENT_API detent_status detent_world2_digest_of(const detent_context* context,
                                                   detent_handle world, detent_id id,
                                                   uint64_t* digest);

/** Writes the canonical bytes of all bodies that are not fixed to `bytes` if `room` holds them, and
 *  their number to `size`. DETENT_NO if there is less room: ask with room 0 first. */
DETENT_API detent_status detent_world2_snapshot(const detent_context* context,
                                                  detent_handle world, void* bytes, uint32_t room,
                                                  uint32_t* size);

/** Makes the world the one of a snapshot taken with the same settings and fixed bodies, whose assets the
 *  context has. Any bytes are safe; on an error the world is unchanged. */
DETENT_API detent_status detent_world2_restore(detent_context* context, detent_handle world,
                                                 const void* bytes, uint32_t size);

/** Names the first fields in which two worlds differ, such as `body 3:17 (sphere) velocity.y`, at most
 *  `most` of them, each with a line feed behind it. Writes as much of that as `room` holds to `names`, and
 *  its whole size to `size`. DETENT_NO if all fields are equal. */
DETENT_API detent_status detent_world2_diff(const detent_context* context, detent_handle a,
                                              detent_handle b, uint32_t most, void* names,
                                              uint32_t room, uint32_t* size);

/** The same for two scenes: `object 1:2 (sphere) center.y`. */
DETENT_API detent_status detent_scene2_diff(const detent_context* context, detent_handle a,
                                              detent_handle b, uint32_t most, void* names,
                                              uint32_t room, uint32_t* size);

/** A session of a match that all peers start from equal worlds: copies of `world`. Until it is
 *  destroyed no asset that its bodies can have can be. */
DETENT_API detent_status detent_session2_create(detent_context* context,
                                                  const detent_session_settings* settings,
                                                  detent_handle world, detent_handle* session);

/** Destroys a session, and its world. */
DETENT_API detent_status detent_session2_destroy(detent_context* context, detent_handle session);

/** The world of a session, for all functions of worlds. It can be changed while a frame is open,
 *  otherwise only read: it is then the one after the last frame that is simulated. */
DETENT_API detent_status detent_session2_world(const detent_context* context,
                                                 detent_handle session, detent_handle* world);

/** Takes a packet that your transport got from `peer`, at the time `now`. Any bytes are safe. DETENT_NO if
 *  it was not used: of another match, broken, or from one who was dropped. */
DETENT_API detent_status detent_session2_receive(detent_context* context, detent_handle session,
                                                   uint32_t peer, const void* bytes, uint32_t size,
                                                   uint64_t now);

/** Opens the next frame that is due, to be simulated by you: change the world of the session by the
 *  inputs alone, step it, then call `detent_session2_end_frame`; and so on with the same input until
 *  there is none. Frames come again after inputs that were guessed wrong. `inputs` gets `input_size`
 *  bytes for each player. DETENT_NO if none is due now: `frame` says why. A frame that was not ended is
 *  opened again as it was at first. */
DETENT_API detent_status detent_session2_begin_frame(detent_context* context,
                                                       detent_handle session, const void* input,
                                                       detent_frame* frame, void* inputs);

/** The open frame is simulated. DETENT_NOT_NOW if none is open. */
DETENT_API detent_status detent_session2_end_frame(detent_context* context,
                                                     detent_handle session);

/** The next packet that is due at the time `now`, for your transport to send to `peer`, at most one for
 *  each: ask until there is none. `room` is DETENT_PACKET or more. */
DETENT_API detent_status detent_session2_packet(detent_context* context, detent_handle session,
                                                  uint64_t now, uint32_t* peer, void* bytes,
                                                  uint32_t room, uint32_t* size);

/** What happened since, oldest first; DETENT_NO if nothing else did. Writes as much of the name of a field
 *  as `room` holds; DETENT_NAME holds any. */
DETENT_API detent_status detent_session2_event(detent_context* context, detent_handle session,
                                                 detent_session_event* event, void* name,
                                                 uint32_t room);

/** How far the session is. */
DETENT_API detent_status detent_session2_status(const detent_context* context,
                                                  detent_handle session,
                                                  detent_session_status* status);

/** All frames before `frame` are known to be equal at `peer` and here. */
DETENT_API detent_status detent_session2_matched(const detent_context* context,
                                                   detent_handle session, uint32_t peer,
                                                   uint32_t* frame);

/** Whether this player keeps the session from going on. */
DETENT_API detent_status detent_session2_is_awaited(const detent_context* context,
                                                      detent_handle session, uint32_t player);

/** Goes on without a peer. All who go on agree on the first frame without this player. */
DETENT_API detent_status detent_session2_drop(detent_context* context, detent_handle session,
                                                uint32_t peer);

/** Stops (1) or goes on (0); the others see it. */
DETENT_API detent_status detent_session2_pause(detent_context* context, detent_handle session,
                                                 uint32_t is_paused);

/** Writes the replay of all final frames so far to `bytes` if `room` holds it, and its size to `size`.
 *  DETENT_NO if there is less room, or if the session records none: then the size is 0. One that came
 *  late records none. */
DETENT_API detent_status detent_session2_replay(const detent_context* context,
                                                  detent_handle session, void* bytes, uint32_t room,
                                                  uint32_t* size);

/** The words next to the world of a session or a replay: what else of the game a rollback restores, as
 *  many as its settings say. Zeros before the first frame. DETENT_NO for a world of its own. */
DETENT_API detent_status detent_world2_words(const detent_context* context, detent_handle world,
                                               uint32_t* words);

/** Sets them, in an open frame. */
DETENT_API detent_status detent_world2_set_words(detent_context* context, detent_handle world,
                                                   const uint32_t* words);

/** A replay to be simulated again, from a world with the same settings and fixed bodies as that of the
 *  session at its start, and with its settings of inputs and words. Any bytes are safe. DETENT_NO_SNAPSHOT
 *  if they are no replay, DETENT_OTHER_SCENE if it has other inputs, DETENT_OTHER_VERSION if its results
 *  are those of another version; otherwise what `detent_world2_restore` says of its start. */
DETENT_API detent_status detent_replay2_create(detent_context* context, const void* bytes,
                                                 uint32_t size, detent_handle world,
                                                 uint32_t input_size, uint32_t words,
                                                 detent_handle* replay);

/** Destroys a replay, and its world. */
DETENT_API detent_status detent_replay2_destroy(detent_context* context, detent_handle replay);

/** The world of a replay: as that of a session. */
DETENT_API detent_status detent_replay2_world(const detent_context* context, detent_handle replay,
                                                detent_handle* world);

/** Opens the next frame, to be simulated by you as in the session. DETENT_NO at the end, or once a digest
 *  differs. A frame that was not ended goes on. */
DETENT_API detent_status detent_replay2_begin_frame(detent_context* context, detent_handle replay,
                                                      detent_frame* frame, void* inputs);

/** The open frame is simulated. DETENT_NOT_NOW if none is open. */
DETENT_API detent_status detent_replay2_end_frame(detent_context* context, detent_handle replay);

/** What simulating it gave so far. */
DETENT_API detent_status detent_replay2_check(const detent_context* context, detent_handle replay,
                                                detent_replay_check* check);

/** Whether the ray touches the shape, and where. `hit` may be null. For the kinds from DETENT_SPHERE to
 *  DETENT_SEGMENT. Distance 0 if the ray starts inside. */
DETENT_API detent_status detent_raycast3(const detent_ray3* ray, const detent_shape3* shape,
                                           detent_hit3* hit);

/** The distances along `count` rays at which they touch one shape, -1 for none. Returns DETENT_OK
 *  after the last ray; the first wrong direction ends it with DETENT_NOT_UNIT. */
DETENT_API detent_status detent_raycast3_many(const detent_ray3* rays, uint32_t count,
                                                const detent_shape3* shape, int32_t* distances);

/** Whether the point is in the shape or on its surface, exactly. */
DETENT_API detent_status detent_contains3(const detent_shape3* shape, const detent_vec3* point);

/** Whether two shapes have a point in common, exactly. */
DETENT_API detent_status detent_overlaps3(const detent_shape3* a, const detent_shape3* b);

/** The point of the shape closest to `point`, each coordinate rounded to nearest. */
DETENT_API detent_status detent_closest_point3(const detent_shape3* shape,
                                                 const detent_vec3* point,
                                                 detent_vec3* closest);

/** The distance from the shape to `point`, rounded down; the greatest int32_t if the shape is empty. */
DETENT_API detent_status detent_distance_to_point3(const detent_shape3* shape,
                                                     const detent_vec3* point,
                                                     int32_t* distance);

/** The distance between two shapes, rounded down; 0 if they share a point. */
DETENT_API detent_status detent_distance3(const detent_shape3* a, const detent_shape3* b,
                                            int32_t* distance);

/** How two shapes that overlap are separated; touching counts. DETENT_NO if they do not. `contact` may
 *  be null. For the kinds from DETENT_SPHERE to DETENT_SEGMENT, but two planes. */
DETENT_API detent_status detent_contact3(const detent_shape3* a, const detent_shape3* b,
                                           detent_manifold3* contact);

/** The point of a closest to b and that of b closest to a, each coordinate rounded to nearest: the same
 *  point twice where they meet. Of several pairs it is the one whose point of a has the least x, then y,
 *  then z. The origin twice if a shape is empty. For the kinds from DETENT_SPHERE to DETENT_SEGMENT. */
DETENT_API detent_status detent_closest_points3(const detent_shape3* a,
                                                  const detent_shape3* b,
                                                  detent_vec3* point_a,
                                                  detent_vec3* point_b);

/** Where `shape`, moving along `direction` by at most `max_distance`, first touches `target`: how far it
 *  has moved, rounded down, the point of the target and the normal there, which faces the shape.
 *  DETENT_NO if it touches nothing. Distance 0 if they share a point at the start. `hit` may be null.
 *  For the kinds from DETENT_SPHERE to DETENT_SEGMENT, but planes do not move. */
DETENT_API detent_status detent_cast3(const detent_shape3* shape,
                                        const detent_direction3* direction, int32_t max_distance,
                                        const detent_shape3* target, detent_hit3* hit);

/** When two shapes, each given in the frame that its sweep moves, are first closer than `target` (a
 *  length; 8 is usual), rounded down. DETENT_NO if they stay apart. `sweep_b` may be null: b does not
 *  move; a plane must not. `impact` may be null. For the kinds from DETENT_SPHERE to DETENT_CAPSULE. */
DETENT_API detent_status detent_time_of_impact3(const detent_shape3* a,
                                                  const detent_sweep3* sweep_a,
                                                  const detent_shape3* b,
                                                  const detent_sweep3* sweep_b, int32_t target,
                                                  detent_impact* impact);

/** Whether the point is on the ray, exactly. */
DETENT_API detent_status detent_ray3_contains(const detent_ray3* ray, const detent_vec3* point);

/** The point of the ray closest to `point`, each coordinate rounded to nearest. */
DETENT_API detent_status detent_ray3_closest_point(const detent_ray3* ray,
                                                     const detent_vec3* point,
                                                     detent_vec3* closest);

/** The distance from the ray to `point`, rounded down. */
DETENT_API detent_status detent_ray3_distance_to_point(const detent_ray3* ray,
                                                         const detent_vec3* point,
                                                         int32_t* distance);

/** Where the ray first touches any of `count` shapes; of several at one distance the first in the list. The
 *  functions of `detent_shapes3` take the union of several shapes, which may be none: of the kinds from
 *  DETENT_SPHERE to DETENT_SEGMENT, and DETENT_HULL of `context`, whose transformed points are rounded to
 *  nearest. `context` may be null if there is no hull, and `hit` may be null. */
DETENT_API detent_status detent_shapes3_raycast(const detent_context* context,
                                                  const detent_ray3* ray,
                                                  const detent_shape3* shapes, uint32_t count,
                                                  detent_hit3* hit);

/** Whether the point is in any of the shapes, exactly. */
DETENT_API detent_status detent_shapes3_contains(const detent_context* context,
                                                   const detent_shape3* shapes, uint32_t count,
                                                   const detent_vec3* point);

/** Whether any of the shapes of one list has a point in common with one of the other, exactly. */
DETENT_API detent_status detent_shapes3_overlaps(const detent_context* context,
                                                   const detent_shape3* a, uint32_t a_count,
                                                   const detent_shape3* b, uint32_t b_count);

/** The closest point of the shape nearest to `point`, each coordinate rounded to nearest; of several at one
 *  distance, rounded down, the first. `point` itself for no shapes. */
DETENT_API detent_status detent_shapes3_closest_point(const detent_context* context,
                                                        const detent_shape3* shapes,
                                                        uint32_t count, const detent_vec3* point,
                                                        detent_vec3* closest);

/** The distance from the nearest shape to `point`, rounded down; the greatest int32_t for no shapes. */
DETENT_API detent_status detent_shapes3_distance_to_point(const detent_context* context,
                                                            const detent_shape3* shapes,
                                                            uint32_t count,
                                                            const detent_vec3* point,
                                                            int32_t* distance);

/** The least distance between a shape of one list and one of the other, rounded down; 0 if they share a
 *  point, the greatest int32_t if a list is empty. */
DETENT_API detent_status detent_shapes3_distance(const detent_context* context,
                                                   const detent_shape3* a, uint32_t a_count,
                                                   const detent_shape3* b, uint32_t b_count,
                                                   int32_t* distance);

/** The closest points of the two shapes that are nearest to each other, each coordinate rounded to nearest;
 *  of several shapes at one distance, rounded down, the first of a, then of b; of several pairs of points
 *  the one whose point of b has the least x, then y, then z. The origin twice if a list is empty. */
DETENT_API detent_status detent_shapes3_closest_points(const detent_context* context,
                                                         const detent_shape3* a, uint32_t a_count,
                                                         const detent_shape3* b, uint32_t b_count,
                                                         detent_vec3* point_a,
                                                         detent_vec3* point_b);

/** `detent_cast3` of one moving shape, which may be a hull, at any of `count` shapes; of several at one
 *  distance the first. `hit` may be null. */
DETENT_API detent_status detent_shapes3_cast(const detent_context* context,
                                               const detent_shape3* shape,
                                               const detent_direction3* direction,
                                               int32_t max_distance,
                                               const detent_shape3* targets, uint32_t count,
                                               detent_hit3* hit);

/** `detent_contact3` of two shapes of which each may be a hull. `contact` may be null. */
DETENT_API detent_status detent_shapes3_contact(const detent_context* context,
                                                  const detent_shape3* a,
                                                  const detent_shape3* b,
                                                  detent_manifold3* contact);

/** `detent_time_of_impact3` of two shapes of which each may be a hull. `sweep_b` and `impact` may be
 *  null. */
DETENT_API detent_status detent_shapes3_time_of_impact(const detent_context* context,
                                                         const detent_shape3* a,
                                                         const detent_sweep3* sweep_a,
                                                         const detent_shape3* b,
                                                         const detent_sweep3* sweep_b,
                                                         int32_t target, detent_impact* impact);

/** A convex hull of at most 64 points, in any order. Copies them. `id` as for meshes. */
DETENT_API detent_status detent_hull3_create(detent_context* context, uint32_t id,
                                               const detent_vec3* points, uint32_t count,
                                               detent_handle* hull);

/** A convex hull of at most 32 points with a volume, for bodies of worlds; its centre of mass is the
 *  place of such a body. At most 64 a context. DETENT_BAD_ARGUMENT without a volume. Copies the points.
 *  `id` as for meshes. */
DETENT_API detent_status detent_solid3_create(detent_context* context, uint32_t id,
                                                const detent_vec3* points, uint32_t count,
                                                detent_handle* solid);

/** A part that is a point without mass yet: density 1, friction 3/5, no restitution, no sensor. Set its
 *  shape. */
DETENT_API detent_status detent_part3_defaults(detent_part3* part);

/** A compound of 1 to 65536 parts, for bodies of worlds: they keep their places to each other, and their
 *  common centre of mass is the place of such a body. Where parts overlap, masses add. At most 256 a
 *  context. Copies the parts, and keeps their solid hulls in use. DETENT_NO_QUERY for other kinds of shape.
 *  `id` as for meshes. */
DETENT_API detent_status detent_compound3_create(detent_context* context, uint32_t id,
                                                   const detent_part3* parts, uint32_t count,
                                                   detent_handle* compound);

/** An empty scene, for all kinds of shape but segments and points. */
DETENT_API detent_status detent_scene3_create(detent_context* context, detent_handle* scene);

/** Destroys a scene. */
DETENT_API detent_status detent_scene3_destroy(detent_context* context, detent_handle scene);

/** Adds an object. `traits` may be null: layer 1, user 0, moving, in no frame. DETENT_FULL beyond 1,048,576
 *  objects, DETENT_NO if the frame does not exist, DETENT_BAD_ARGUMENT for a fixed object in a frame. */
DETENT_API detent_status detent_scene3_add(detent_context* context, detent_handle scene,
                                             const detent_shape3* shape,
                                             const detent_traits* traits, detent_id* id);

/** Adds an object with an id of the caller's. DETENT_NO if its index is taken or too large, or the
 *  generation 0 or 2^32 - 1. */
DETENT_API detent_status detent_scene3_add_as(detent_context* context, detent_handle scene,
                                                detent_id id, const detent_shape3* shape,
                                                const detent_traits* traits);

/** Removes an object. DETENT_NO if there is none with this id. */
DETENT_API detent_status detent_scene3_remove(detent_context* context, detent_handle scene,
                                                detent_id id);

/** Replaces the shape of an object, in its frame if it has one. DETENT_NO if there is none with this id. */
DETENT_API detent_status detent_scene3_replace(detent_context* context, detent_handle scene,
                                                 detent_id id, const detent_shape3* shape);

/** Moves an object by a vector; coordinates are clamped. DETENT_NO if there is none with this id. */
DETENT_API detent_status detent_scene3_move(detent_context* context, detent_handle scene,
                                              detent_id id, const detent_vec3* by);

/** The shape of an object in the world, and what is stored with it. Both may be null. DETENT_NO if there is none
 *  with this id. */
DETENT_API detent_status detent_scene3_object(const detent_context* context, detent_handle scene,
                                                detent_id id, detent_shape3* shape,
                                                detent_traits* traits);

/** Sets layers and user word of an object; its motion cannot change, and is ignored. */
DETENT_API detent_status detent_scene3_set_traits(detent_context* context, detent_handle scene,
                                                    detent_id id, const detent_traits* traits);

/** Adds a frame that objects can be in, inside `parent`; {0, 0}: the world. DETENT_NO if there is no such
 *  parent, DETENT_FULL if there is no room. */
DETENT_API detent_status detent_scene3_add_frame(detent_context* context, detent_handle scene,
                                                   const detent_transform3* transform,
                                                   detent_id parent, detent_id* frame);

/** Moves a frame in its parent, and everything in it. DETENT_NO if there is none with this id. */
DETENT_API detent_status detent_scene3_move_frame(detent_context* context, detent_handle scene,
                                                    detent_id frame,
                                                    const detent_transform3* transform);

/** Removes a frame. DETENT_NO if there is none with this id, or if anything is in it. */
DETENT_API detent_status detent_scene3_remove_frame(detent_context* context, detent_handle scene,
                                                      detent_id frame);

/** The transforms of a frame to its parent and to the world. Both may be null. DETENT_NO if there is
 *  none with this id. */
DETENT_API detent_status detent_scene3_frame(const detent_context* context, detent_handle scene,
                                               detent_id frame, detent_transform3* local,
                                               detent_transform3* world);

/** How many objects the scene has. */
DETENT_API detent_status detent_scene3_size(const detent_context* context, detent_handle scene,
                                              uint32_t* size);

/** Makes queries faster after many additions, such as loading a level. Never changes a result. */
DETENT_API detent_status detent_scene3_optimize(detent_context* context, detent_handle scene);

/** The object in `layers` that the ray touches first, and where; of several at one distance the least
 *  id. `hit` may be null. */
DETENT_API detent_status detent_scene3_raycast(const detent_context* context, detent_handle scene,
                                                 const detent_ray3* ray, uint32_t layers,
                                                 detent_object_hit3* hit);

/** Whether the ray touches any object in `layers`. */
DETENT_API detent_status detent_scene3_raycast_any(const detent_context* context,
                                                     detent_handle scene, const detent_ray3* ray,
                                                     uint32_t layers);

/** All objects in `layers` that the ray touches, by distance, then id. Writes the first `room` of them
 *  and their whole number to `count`. */
DETENT_API detent_status detent_scene3_raycast_all(const detent_context* context,
                                                     detent_handle scene, const detent_ray3* ray,
                                                     uint32_t layers, detent_object_hit3* hits,
                                                     uint32_t room, uint32_t* count);

/** `detent_scene3_raycast` for many rays; of a ray that hits nothing the id is {0, 0} and the distance
 *  -1. The first wrong direction ends it with DETENT_NOT_UNIT. */
DETENT_API detent_status detent_scene3_raycast_many(const detent_context* context,
                                                      detent_handle scene, const detent_ray3* rays,
                                                      uint32_t count, uint32_t layers,
                                                      detent_object_hit3* hits);

/** The object in `layers` nearest to a point, however far; or nearest to the center, start or end a
 *  of those that a sphere, AABB, OBB, capsule or segment overlaps. `found` may be null. */
DETENT_API detent_status detent_scene3_nearest(const detent_context* context, detent_handle scene,
                                                 const detent_shape3* question, uint32_t layers,
                                                 detent_found* found);

/** Whether the point, sphere, AABB, OBB, capsule or segment overlaps any object in `layers`. */
DETENT_API detent_status detent_scene3_any(const detent_context* context, detent_handle scene,
                                             const detent_shape3* question, uint32_t layers);

/** All objects in `layers` that the point, sphere, AABB, OBB, capsule or segment overlaps, by distance,
 *  then id. Writes the first `room` of them and their whole number to `count`. */
DETENT_API detent_status detent_scene3_all(const detent_context* context, detent_handle scene,
                                             const detent_shape3* question, uint32_t layers,
                                             detent_found* found, uint32_t room, uint32_t* count);

/** All pairs of overlapping objects of which one moves, sorted by id. Writes the first `room` of them
 *  and their whole number to `count`. */
DETENT_API detent_status detent_scene3_overlaps(const detent_context* context,
                                                  detent_handle scene, detent_pair* pairs,
                                                  uint32_t room, uint32_t* count);

/** The first object in `layers` that a moving shape touches: `detent_cast3` over all objects, for
 *  spheres, AABBs, OBBs, capsules and segments; of several at one distance the least id. DETENT_NO if there
 *  is none. `hit` may be null. */
DETENT_API detent_status detent_scene3_cast(const detent_context* context, detent_handle scene,
                                              const detent_shape3* shape,
                                              const detent_direction3* direction,
                                              int32_t max_distance, uint32_t layers,
                                              detent_object_hit3* hit);

/** Whether the moving shape touches any object in `layers`. */
DETENT_API detent_status detent_scene3_cast_any(const detent_context* context,
                                                  detent_handle scene,
                                                  const detent_shape3* shape,
                                                  const detent_direction3* direction,
                                                  int32_t max_distance, uint32_t layers);

/** All objects in `layers` that the moving shape touches, by distance, then id. Writes the first `room` of
 *  them and their whole number to `count`. */
DETENT_API detent_status detent_scene3_cast_all(const detent_context* context,
                                                  detent_handle scene,
                                                  const detent_shape3* shape,
                                                  const detent_direction3* direction,
                                                  int32_t max_distance, uint32_t layers,
                                                  detent_object_hit3* hits, uint32_t room,
                                                  uint32_t* count);

/** The settings of an ordinary character: up is y, skin 1/64, steps and snapping 1/3, slopes to 50
 *  degrees. */
DETENT_API detent_status detent_mover3_default_settings(detent_mover3_settings* settings);

/** Moves a character by `by`, gravity included, as far as the objects in `layers` other than `ignored`
 *  let it: carried by its ground, pushed out of what it overlaps, it walks and climbs steps, or flies,
 *  slides along what it meets and lands. It ends overlapping nothing that it did not overlap at the
 *  start. `settings` may be null: the ordinary ones. `result` may be null. DETENT_NO_QUERY for other shapes
 *  than capsules and AABBs. */
DETENT_API detent_status detent_mover3_move(const detent_context* context, detent_handle scene,
                                              detent_mover3* mover, const detent_vec3* by,
                                              const detent_mover3_settings* settings,
                                              uint32_t layers, detent_id ignored,
                                              detent_move3* result);

/** The part of a velocity that does not lead into what a character touched in a move: the closest one. */
DETENT_API detent_status detent_mover3_clip_velocity(const detent_vec3* velocity,
                                                       const detent_move3* result,
                                                       detent_vec3* clipped);

/** 64 bits of all objects: equal on every machine for equal scenes. */
DETENT_API detent_status detent_scene3_digest(const detent_context* context, detent_handle scene,
                                                uint64_t* digest);

/** Writes the canonical bytes of the moving objects to `bytes` if `room` holds them, and their number
 *  to `size`. DETENT_NO if there is less room: ask with room 0 first. */
DETENT_API detent_status detent_scene3_snapshot(const detent_context* context,
                                                  detent_handle scene, void* bytes, uint32_t room,
                                                  uint32_t* size);

/** Replaces the moving objects by those of a snapshot, whose assets the context has. Any bytes are
 *  safe; on an error the scene is unchanged. */
DETENT_API detent_status detent_scene3_restore(detent_context* context, detent_handle scene,
                                                 const void* bytes, uint32_t size);

/** The settings of an ordinary world: 60 ticks a second of 4 substeps, gravity -10 along y. */
DETENT_API detent_status detent_world3_default_settings(detent_world3_settings* settings);

/** The options of an ordinary body: dynamic, density 1, friction 3/5, at rest, in layer 1. */
DETENT_API detent_status detent_body3_default_options(detent_body3_options* options);

/** An empty world. `settings` may be null: the ordinary ones. */
DETENT_API detent_status detent_world3_create(detent_context* context,
                                                const detent_world3_settings* settings,
                                                detent_handle* world);

/** Destroys a world. */
DETENT_API detent_status detent_world3_destroy(detent_context* context, detent_handle world);

/** Adds a body: a sphere, AABB, OBB, capsule, solid hull or compound; in 3D also a mesh or height field,
 *  which are fixed or kinematic, whatever the options say. Where it has `placed`, the scale must be 65536.
 *  `options` may be null: the ordinary ones; density, friction and restitution of compounds are those of
 *  their parts. */
DETENT_API detent_status detent_world3_add(detent_context* context, detent_handle world,
                                             const detent_shape3* shape,
                                             const detent_body3_options* options, detent_id* id);

/** Adds a body with an id of the caller's, such as one that was removed. DETENT_NO if its index is taken or
 *  too large, or the generation 0 or 2^32 - 1. */
DETENT_API detent_status detent_world3_add_as(detent_context* context, detent_handle world,
                                                detent_id id, const detent_shape3* shape,
                                                const detent_body3_options* options);

/** Removes a body and wakes those that touched it. DETENT_NO if there is none with this id. */
DETENT_API detent_status detent_world3_remove(detent_context* context, detent_handle world,
                                                detent_id id);

/** One tick: all substeps. */
DETENT_API detent_status detent_world3_step(detent_context* context, detent_handle world);

/** Where a body is and how it moves. DETENT_NO if there is none with this id. */
DETENT_API detent_status detent_world3_body(const detent_context* context, detent_handle world,
                                              detent_id id, detent_body3* body);

/** The same for `count` bodies at once; zeros where there is none. */
DETENT_API detent_status detent_world3_bodies(const detent_context* context, detent_handle world,
                                                const detent_id* ids, uint32_t count,
                                                detent_body3* bodies);

/** Where the frame is in which the points of a hull, the parts of a compound or the triangles of a surface
 *  were given, rounded to nearest, with the scale 65536; of other shapes that of the body. DETENT_NO if
 *  there is none with this id. */
DETENT_API detent_status detent_world3_frame(const detent_context* context, detent_handle world,
                                               detent_id id, detent_transform3* frame);

/** Sets the velocity of a body, per second, and wakes it. Nothing happens to fixed bodies. */
DETENT_API detent_status detent_world3_set_velocity(detent_context* context, detent_handle world,
                                                      detent_id id, const detent_vec3* velocity);

/** Sets the angular velocity of a body (3 numbers, radians per second), and wakes it. */
DETENT_API detent_status detent_world3_set_angular_velocity(detent_context* context,
                                                              detent_handle world, detent_id id,
                                                              const int32_t* velocity);

/** Changes velocity and spin at once as an impulse (mass times units per second) at the point `at` of
 *  the world does, or at the centre if that is null, and wakes the body. Nothing happens to bodies that
 *  are not dynamic. DETENT_NO if there is none with this id. */
DETENT_API detent_status detent_world3_apply_impulse(detent_context* context, detent_handle world,
                                                       detent_id id, const detent_vec3* impulse,
                                                       const detent_vec3* at);

/** The same for a force (mass times units per second and second) that acts during the next step. */
DETENT_API detent_status detent_world3_apply_force(detent_context* context, detent_handle world,
                                                     detent_id id, const detent_vec3* force,
                                                     const detent_vec3* at);

/** A torque (3 numbers, mass times squared units per second and second) that acts during the next
 *  step, and wakes the body. DETENT_NO if there is none with this id. */
DETENT_API detent_status detent_world3_apply_torque(detent_context* context, detent_handle world,
                                                      detent_id id, const int32_t* torque);

/** A joint of a kind with all its fields as they are if you do not know better: bodies {0, 0}, anchors at
 *  the centres, no limits, motor or spring; a distance between 0 and 1. */
DETENT_API detent_status detent_joint3_defaults(uint32_t kind, detent_joint3* joint);

/** Adds a joint and wakes its bodies. DETENT_NO if one of them does not exist or both are the same,
 *  DETENT_FULL without room, DETENT_BAD_ARGUMENT for negative forces, frequencies or ratios. */
DETENT_API detent_status detent_world3_add_joint(detent_context* context, detent_handle world,
                                                   const detent_joint3* joint, detent_id* id);

/** Makes a joint another one of the same kind, such as one with another motor, and wakes its bodies; it
 *  keeps its impulses. DETENT_NO if there is none of this kind with this id, or not both bodies. */
DETENT_API detent_status detent_world3_change_joint(detent_context* context, detent_handle world,
                                                      detent_id id, const detent_joint3* joint);

/** Removes a joint and wakes its bodies. DETENT_NO if there is none with this id. */
DETENT_API detent_status detent_world3_remove_joint(detent_context* context, detent_handle world,
                                                      detent_id id);

/** A joint as it was added or last changed. DETENT_NO if there is none with this id. */
DETENT_API detent_status detent_world3_joint(const detent_context* context, detent_handle world,
                                               detent_id id, detent_joint3* joint);

/** How many joints the world has. */
DETENT_API detent_status detent_world3_joint_count(const detent_context* context,
                                                     detent_handle world, uint32_t* count);

/** The joints that broke in the last step, which are removed, by index. Writes the first `room` of them
 *  and their whole number to `count`. */
DETENT_API detent_status detent_world3_broken(const detent_context* context, detent_handle world,
                                                detent_id* joints, uint32_t room, uint32_t* count);

/** A point of the world in the frame of a body, rounded to nearest: an anchor of a joint. DETENT_NO if
 *  there is none with this id. */
DETENT_API detent_status detent_world3_local_point(const detent_context* context,
                                                     detent_handle world, detent_id id,
                                                     const detent_vec3* point,
                                                     detent_vec3* local);

/** Axes of the world in the frame of a body, rounded to nearest: a frame of a joint. DETENT_NO if there
 *  is none with this id. */
DETENT_API detent_status detent_world3_local_frame(const detent_context* context,
                                                     detent_handle world, detent_id id,
                                                     const detent_rotation3* frame,
                                                     detent_rotation3* local);

/** How many bodies the world has. */
DETENT_API detent_status detent_world3_size(const detent_context* context, detent_handle world,
                                              uint32_t* size);

/** The pairs that began or ended to touch in the last step, by id. Writes the first `room` of them and
 *  their whole number to `count`. */
DETENT_API detent_status detent_world3_events(const detent_context* context, detent_handle world,
                                                detent_touch* events, uint32_t room,
                                                uint32_t* count);

/** 64 bits of all bodies that are not fixed, their contacts and joints. */
DETENT_API detent_status detent_world3_digest(const detent_context* context, detent_handle world,
                                                uint64_t* digest);

/** 64 bits of one body. DETENT_NO if there is none with this id. */
DETENT_API detent_status detent_world3_digest_of(const detent_context* context,
                                                   detent_handle world, detent_id id,
                                                   uint64_t* digest);

/** Writes the canonical bytes of all bodies that are not fixed to `bytes` if `room` holds them, and
 *  their number to `size`. DETENT_NO if there is less room: ask with room 0 first. */
DETENT_API detent_status detent_world3_snapshot(const detent_context* context,
                                                  detent_handle world, void* bytes, uint32_t room,
                                                  uint32_t* size);

/** Makes the world the one of a snapshot taken with the same settings and fixed bodies, whose assets the
 *  context has. Any bytes are safe; on an error the world is unchanged. */
DETENT_API detent_status detent_world3_restore(detent_context* context, detent_handle world,
                                                 const void* bytes, uint32_t size);

/** Names the first fields in which two worlds differ, such as `body 3:17 (sphere) velocity.y`, at most
 *  `most` of them, each with a line feed behind it. Writes as much of that as `room` holds to `names`, and
 *  its whole size to `size`. DETENT_NO if all fields are equal. */
DETENT_API detent_status detent_world3_diff(const detent_context* context, detent_handle a,
                                              detent_handle b, uint32_t most, void* names,
                                              uint32_t room, uint32_t* size);

/** The same for two scenes: `object 1:2 (sphere) center.y`. */
DETENT_API detent_status detent_scene3_diff(const detent_context* context, detent_handle a,
                                              detent_handle b, uint32_t most, void* names,
                                              uint32_t room, uint32_t* size);

/** A session of a match that all peers start from equal worlds: copies of `world`. Until it is
 *  destroyed no asset that its bodies can have can be. */
DETENT_API detent_status detent_session3_create(detent_context* context,
                                                  const detent_session_settings* settings,
                                                  detent_handle world, detent_handle* session);

/** Destroys a session, and its world. */
DETENT_API detent_status detent_session3_destroy(detent_context* context, detent_handle session);

/** The world of a session, for all functions of worlds. It can be changed while a frame is open,
 *  otherwise only read: it is then the one after the last frame that is simulated. */
DETENT_API detent_status detent_session3_world(const detent_context* context,
                                                 detent_handle session, detent_handle* world);

/** Takes a packet that your transport got from `peer`, at the time `now`. Any bytes are safe. DETENT_NO if
 *  it was not used: of another match, broken, or from one who was dropped. */
DETENT_API detent_status detent_session3_receive(detent_context* context, detent_handle session,
                                                   uint32_t peer, const void* bytes, uint32_t size,
                                                   uint64_t now);

/** Opens the next frame that is due, to be simulated by you: change the world of the session by the
 *  inputs alone, step it, then call `detent_session3_end_frame`; and so on with the same input until
 *  there is none. Frames come again after inputs that were guessed wrong. `inputs` gets `input_size`
 *  bytes for each player. DETENT_NO if none is due now: `frame` says why. A frame that was not ended is
 *  opened again as it was at first. */
DETENT_API detent_status detent_session3_begin_frame(detent_context* context,
                                                       detent_handle session, const void* input,
                                                       detent_frame* frame, void* inputs);

/** The open frame is simulated. DETENT_NOT_NOW if none is open. */
DETENT_API detent_status detent_session3_end_frame(detent_context* context,
                                                     detent_handle session);

/** The next packet that is due at the time `now`, for your transport to send to `peer`, at most one for
 *  each: ask until there is none. `room` is DETENT_PACKET or more. */
DETENT_API detent_status detent_session3_packet(detent_context* context, detent_handle session,
                                                  uint64_t now, uint32_t* peer, void* bytes,
                                                  uint32_t room, uint32_t* size);

/** What happened since, oldest first; DETENT_NO if nothing else did. Writes as much of the name of a field
 *  as `room` holds; DETENT_NAME holds any. */
DETENT_API detent_status detent_session3_event(detent_context* context, detent_handle session,
                                                 detent_session_event* event, void* name,
                                                 uint32_t room);

/** How far the session is. */
DETENT_API detent_status detent_session3_status(const detent_context* context,
                                                  detent_handle session,
                                                  detent_session_status* status);

/** All frames before `frame` are known to be equal at `peer` and here. */
DETENT_API detent_status detent_session3_matched(const detent_context* context,
                                                   detent_handle session, uint32_t peer,
                                                   uint32_t* frame);

/** Whether this player keeps the session from going on. */
DETENT_API detent_status detent_session3_is_awaited(const detent_context* context,
                                                      detent_handle session, uint32_t player);

/** Goes on without a peer. All who go on agree on the first frame without this player. */
DETENT_API detent_status detent_session3_drop(detent_context* context, detent_handle session,
                                                uint32_t peer);

/** Stops (1) or goes on (0); the others see it. */
DETENT_API detent_status detent_session3_pause(detent_context* context, detent_handle session,
                                                 uint32_t is_paused);

/** Writes the replay of all final frames so far to `bytes` if `room` holds it, and its size to `size`.
 *  DETENT_NO if there is less room, or if the session records none: then the size is 0. One that came
 *  late records none. */
DETENT_API detent_status detent_session3_replay(const detent_context* context,
                                                  detent_handle session, void* bytes, uint32_t room,
                                                  uint32_t* size);

/** The words next to the world of a session or a replay: what else of the game a rollback restores, as
 *  many as its settings say. Zeros before the first frame. DETENT_NO for a world of its own. */
DETENT_API detent_status detent_world3_words(const detent_context* context, detent_handle world,
                                               uint32_t* words);

/** Sets them, in an open frame. */
DETENT_API detent_status detent_world3_set_words(detent_context* context, detent_handle world,
                                                   const uint32_t* words);

/** A replay to be simulated again, from a world with the same settings and fixed bodies as that of the
 *  session at its start, and with its settings of inputs and words. Any bytes are safe. DETENT_NO_SNAPSHOT
 *  if they are no replay, DETENT_OTHER_SCENE if it has other inputs, DETENT_OTHER_VERSION if its results
 *  are those of another version; otherwise what `detent_world3_restore` says of its start. */
DETENT_API detent_status detent_replay3_create(detent_context* context, const void* bytes,
                                                 uint32_t size, detent_handle world,
                                                 uint32_t input_size, uint32_t words,
                                                 detent_handle* replay);

/** Destroys a replay, and its world. */
DETENT_API detent_status detent_replay3_destroy(detent_context* context, detent_handle replay);

/** The world of a replay: as that of a session. */
DETENT_API detent_status detent_replay3_world(const detent_context* context, detent_handle replay,
                                                detent_handle* world);

/** Opens the next frame, to be simulated by you as in the session. DETENT_NO at the end, or once a digest
 *  differs. A frame that was not ended goes on. */
DETENT_API detent_status detent_replay3_begin_frame(detent_context* context, detent_handle replay,
                                                      detent_frame* frame, void* inputs);

/** The open frame is simulated. DETENT_NOT_NOW if none is open. */
DETENT_API detent_status detent_replay3_end_frame(detent_context* context, detent_handle replay);

/** What simulating it gave so far. */
DETENT_API detent_status detent_replay3_check(const detent_context* context, detent_handle replay,
                                                detent_replay_check* check);

/** The pose of a camera at `eye` that looks at `target`; `up` is upward in the image. Axes are rounded to
 *  nearest, the scale is 65536. DETENT_NO if eye and target are equal, or `up` is along the line of sight. */
DETENT_API detent_status detent_camera3_look_at(const detent_vec3* eye, const detent_vec3* target,
                                                const detent_vec3* up, detent_transform3* pose);

/** What the camera sees, each coordinate of a corner rounded to nearest. All functions of cameras return
 *  DETENT_BAD_ARGUMENT for a lens that sees nothing: a number is not as its comment says, or the greatest
 *  tangent of half an angle of view, rounded, is not above 0 and below 8. */
DETENT_API detent_status detent_camera3_frustum(const detent_camera3* camera,
                                                detent_frustum3* frustum);

/** The ray under the middle of a pixel of an image of `width` times `height` pixels, counted from the top
 *  left; outside the image too, and through its middle if it has no pixels. Its length is the greatest. */
DETENT_API detent_status detent_camera3_pick_ray(const detent_camera3* camera, int32_t width,
                                                 int32_t height, int32_t column, int32_t row,
                                                 detent_ray3* ray);

/** Where the camera sees a point, also outside the image; numbers are rounded to nearest and clamped.
 *  DETENT_NO if it is not in front of a perspective camera, or the axes lie in a plane. */
DETENT_API detent_status detent_camera3_project(const detent_camera3* camera, int32_t width,
                                                int32_t height, const detent_vec3* point,
                                                detent_screen_point3* seen);

/** The point under the middle of a pixel at `depth`, a length along the line of sight; rounded to nearest. */
DETENT_API detent_status detent_camera3_unproject(const detent_camera3* camera, int32_t width,
                                                  int32_t height, int32_t column, int32_t row,
                                                  int32_t depth, detent_vec3* point);

/** Whether the ray touches the frustum, and where. `hit` may be null. Distance 0 if it starts inside. */
DETENT_API detent_status detent_frustum3_raycast(const detent_ray3* ray,
                                                 const detent_frustum3* frustum, detent_hit3* hit);

/** Whether the point is in the frustum or on its surface, exactly. */
DETENT_API detent_status detent_frustum3_contains(const detent_frustum3* frustum,
                                                  const detent_vec3* point);

/** Whether the frustum has a point in common with any of `count` shapes, as for `detent_shapes3_raycast`. */
DETENT_API detent_status detent_frustum3_overlaps(const detent_context* context,
                                                  const detent_frustum3* frustum,
                                                  const detent_shape3* shapes, uint32_t count);

/** Whether two frusta have a point in common, exactly. */
DETENT_API detent_status detent_frustum3_overlaps_frustum(const detent_frustum3* a,
                                                          const detent_frustum3* b);

/** The point of the frustum closest to `point`, each coordinate rounded to nearest. */
DETENT_API detent_status detent_frustum3_closest_point(const detent_frustum3* frustum,
                                                       const detent_vec3* point,
                                                       detent_vec3* closest);

/** The distance from the frustum to `point`, rounded down. */
DETENT_API detent_status detent_frustum3_distance_to_point(const detent_frustum3* frustum,
                                                           const detent_vec3* point,
                                                           int32_t* distance);

/** Of the objects in `layers` that the frustum overlaps, the one nearest to the middle of its near corners.
 *  `found` may be null. */
DETENT_API detent_status detent_scene3_frustum_nearest(const detent_context* context,
                                                       detent_handle scene,
                                                       const detent_frustum3* frustum,
                                                       uint32_t layers, detent_found* found);

/** Whether the frustum overlaps any object in `layers`. */
DETENT_API detent_status detent_scene3_frustum_any(const detent_context* context,
                                                   detent_handle scene,
                                                   const detent_frustum3* frustum, uint32_t layers);

/** All objects in `layers` that the frustum overlaps, by distance from the middle of its near corners, then
 *  id. Writes the first `room` of them and their whole number to `count`. */
DETENT_API detent_status detent_scene3_frustum_all(const detent_context* context,
                                                   detent_handle scene,
                                                   const detent_frustum3* frustum, uint32_t layers,
                                                   detent_found* found, uint32_t room,
                                                   uint32_t* count);

/* Every field has a fixed size and place, the same in every compiler. */
typedef char detent_id_has_its_size[sizeof(detent_id) == 8 ? 1 : -1];
typedef char detent_pair_has_its_size[sizeof(detent_pair) == 16 ? 1 : -1];
typedef char detent_touch_has_its_size[sizeof(detent_touch) == 28 ? 1 : -1];
typedef char detent_found_has_its_size[sizeof(detent_found) == 12 ? 1 : -1];
typedef char detent_impact_has_its_size[sizeof(detent_impact) == 12 ? 1 : -1];
typedef char detent_session_settings_has_its_size[sizeof(detent_session_settings) == 72 ? 1 : -1];
typedef char detent_frame_has_its_size[sizeof(detent_frame) == 16 ? 1 : -1];
typedef char detent_session_event_has_its_size[sizeof(detent_session_event) == 28 ? 1 : -1];
typedef char detent_session_status_has_its_size[sizeof(detent_session_status) == 40 ? 1 : -1];
typedef char detent_replay_check_has_its_size[sizeof(detent_replay_check) == 20 ? 1 : -1];
typedef char detent_traits_has_its_size[sizeof(detent_traits) == 24 ? 1 : -1];
typedef char detent_context_has_its_size[sizeof(detent_context) == 32 ? 1 : -1];
typedef char detent_vec2_has_its_size[sizeof(detent_vec2) == 8 ? 1 : -1];
typedef char detent_direction2_has_its_size[sizeof(detent_direction2) == 8 ? 1 : -1];
typedef char detent_rotation2_has_its_size[sizeof(detent_rotation2) == 16 ? 1 : -1];
typedef char detent_transform2_has_its_size[sizeof(detent_transform2) == 28 ? 1 : -1];
typedef char detent_ray2_has_its_size[sizeof(detent_ray2) == 20 ? 1 : -1];
typedef char detent_sphere2_has_its_size[sizeof(detent_sphere2) == 12 ? 1 : -1];
typedef char detent_aabb2_has_its_size[sizeof(detent_aabb2) == 16 ? 1 : -1];
typedef char detent_obb2_has_its_size[sizeof(detent_obb2) == 32 ? 1 : -1];
typedef char detent_plane2_has_its_size[sizeof(detent_plane2) == 12 ? 1 : -1];
typedef char detent_triangle2_has_its_size[sizeof(detent_triangle2) == 24 ? 1 : -1];
typedef char detent_capsule2_has_its_size[sizeof(detent_capsule2) == 20 ? 1 : -1];
typedef char detent_segment2_has_its_size[sizeof(detent_segment2) == 16 ? 1 : -1];
typedef char detent_shape2_has_its_size[sizeof(detent_shape2) == 40 ? 1 : -1];
typedef char detent_hit2_has_its_size[sizeof(detent_hit2) == 20 ? 1 : -1];
typedef char detent_contact_point2_has_its_size[sizeof(detent_contact_point2) == 16 ? 1 : -1];
typedef char detent_manifold2_has_its_size[sizeof(detent_manifold2) == 48 ? 1 : -1];
typedef char detent_sweep2_has_its_size[sizeof(detent_sweep2) == 48 ? 1 : -1];
typedef char detent_object_hit2_has_its_size[sizeof(detent_object_hit2) == 36 ? 1 : -1];
typedef char detent_mover2_has_its_size[sizeof(detent_mover2) == 84 ? 1 : -1];
typedef char detent_mover2_settings_has_its_size[sizeof(detent_mover2_settings) == 24 ? 1 : -1];
typedef char detent_mover2_touch_has_its_size[sizeof(detent_mover2_touch) == 24 ? 1 : -1];
typedef char detent_move2_has_its_size[sizeof(detent_move2) == 224 ? 1 : -1];
typedef char detent_world2_settings_has_its_size[sizeof(detent_world2_settings) == 32 ? 1 : -1];
typedef char detent_body2_options_has_its_size[sizeof(detent_body2_options) == 72 ? 1 : -1];
typedef char detent_part2_has_its_size[sizeof(detent_part2) == 56 ? 1 : -1];
typedef char detent_joint2_has_its_size[sizeof(detent_joint2) == 108 ? 1 : -1];
typedef char detent_body2_has_its_size[sizeof(detent_body2) == 40 ? 1 : -1];
typedef char detent_vec3_has_its_size[sizeof(detent_vec3) == 12 ? 1 : -1];
typedef char detent_direction3_has_its_size[sizeof(detent_direction3) == 12 ? 1 : -1];
typedef char detent_rotation3_has_its_size[sizeof(detent_rotation3) == 36 ? 1 : -1];
typedef char detent_transform3_has_its_size[sizeof(detent_transform3) == 52 ? 1 : -1];
typedef char detent_ray3_has_its_size[sizeof(detent_ray3) == 28 ? 1 : -1];
typedef char detent_sphere3_has_its_size[sizeof(detent_sphere3) == 16 ? 1 : -1];
typedef char detent_aabb3_has_its_size[sizeof(detent_aabb3) == 24 ? 1 : -1];
typedef char detent_obb3_has_its_size[sizeof(detent_obb3) == 60 ? 1 : -1];
typedef char detent_plane3_has_its_size[sizeof(detent_plane3) == 16 ? 1 : -1];
typedef char detent_triangle3_has_its_size[sizeof(detent_triangle3) == 36 ? 1 : -1];
typedef char detent_capsule3_has_its_size[sizeof(detent_capsule3) == 28 ? 1 : -1];
typedef char detent_segment3_has_its_size[sizeof(detent_segment3) == 24 ? 1 : -1];
typedef char detent_shape3_has_its_size[sizeof(detent_shape3) == 68 ? 1 : -1];
typedef char detent_hit3_has_its_size[sizeof(detent_hit3) == 28 ? 1 : -1];
typedef char detent_contact_point3_has_its_size[sizeof(detent_contact_point3) == 20 ? 1 : -1];
typedef char detent_manifold3_has_its_size[sizeof(detent_manifold3) == 100 ? 1 : -1];
typedef char detent_sweep3_has_its_size[sizeof(detent_sweep3) == 96 ? 1 : -1];
typedef char detent_object_hit3_has_its_size[sizeof(detent_object_hit3) == 44 ? 1 : -1];
typedef char detent_mover3_has_its_size[sizeof(detent_mover3) == 124 ? 1 : -1];
typedef char detent_mover3_settings_has_its_size[sizeof(detent_mover3_settings) == 28 ? 1 : -1];
typedef char detent_mover3_touch_has_its_size[sizeof(detent_mover3_touch) == 32 ? 1 : -1];
typedef char detent_move3_has_its_size[sizeof(detent_move3) == 300 ? 1 : -1];
typedef char detent_world3_settings_has_its_size[sizeof(detent_world3_settings) == 36 ? 1 : -1];
typedef char detent_body3_options_has_its_size[sizeof(detent_body3_options) == 88 ? 1 : -1];
typedef char detent_part3_has_its_size[sizeof(detent_part3) == 84 ? 1 : -1];
typedef char detent_joint3_has_its_size[sizeof(detent_joint3) == 156 ? 1 : -1];
typedef char detent_body3_has_its_size[sizeof(detent_body3) == 76 ? 1 : -1];
typedef char detent_camera3_has_its_size[sizeof(detent_camera3) == 80 ? 1 : -1];
typedef char detent_frustum3_has_its_size[sizeof(detent_frustum3) == 96 ? 1 : -1];
typedef char detent_screen_point3_has_its_size[sizeof(detent_screen_point3) == 12 ? 1 : -1];

#ifdef __cplusplus
}
#endif

#endif
