/* SPDX-License-Identifier: MIT */
/* The C interface (C99) of detent: Q16.16 in two and three dimensions. See docs/bindings.md. */
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
 * direction is in steps of 2^-30: 1073741824 is 1. Speeds are lengths per second and angular
 * velocities radians per second, both in steps of 2^-16. Every int32_t is a valid length.
 *
 * Every function returns the same bits as the C++ function of the same name, on every machine. */

/** Status codes. DETENT_OK and DETENT_NO are answers; errors are negative and change nothing. */
enum {
  DETENT_OK = 1,                 /**< done, or yes */
  DETENT_NO = 0,                 /**< no, or none found, such as a ray that misses */
  DETENT_BAD_ARGUMENT = -1,      /**< a null pointer, an unknown kind or a number out of range */
  DETENT_BAD_CONTEXT = -2,       /**< a context that is null, not open, closed or a copy */
  DETENT_BAD_HANDLE = -3,        /**< a handle of another type, stale or never issued */
  DETENT_NOT_UNIT = -4,          /**< a direction whose length is not 1 within 2^-29 */
  DETENT_NO_QUERY = -5,          /**< these kinds of shape have no such query */
  DETENT_NO_MEMORY = -6,         /**< an allocation failed */
  DETENT_BROKEN = -7,            /**< memory ran out during a change: destroy the scene or world */
  DETENT_FULL = -8,              /**< no room for more objects, bodies, handles or assets */
  DETENT_IN_USE = -9,            /**< the asset is still referenced, or its id is taken */
  DETENT_NOT_NOW = -10,          /**< the world changes only in an open frame, or none is open */
  DETENT_NO_SNAPSHOT = -20,      /**< the bytes are not a snapshot */
  DETENT_OTHER_VERSION = -21,    /**< the snapshot has a version that this library cannot read */
  DETENT_TRUNCATED = -22,        /**< the snapshot is cut off */
  DETENT_CORRUPTED = -23,        /**< the snapshot's bytes were altered */
  DETENT_OTHER_SCENE = -24,      /**< another dimension, set of shapes or settings */
  DETENT_OTHER_FIXED_PART = -25, /**< fixed objects or bodies differ from the snapshot's */
  DETENT_NO_ROOM = -26,          /**< the snapshot exceeds the capacity of a scene or world */
  DETENT_UNKNOWN_ASSET = -27,    /**< the snapshot refers to an asset missing from the context */
  DETENT_OTHER_ASSET = -28       /**< this asset id has other triangles, points or heights */
};

/** The kind of a shape: selects the member of its union. */
enum {
  DETENT_SPHERE = 1,
  DETENT_AABB = 2,
  DETENT_OBB = 3,
  DETENT_PLANE = 4,
  DETENT_TRIANGLE = 5,
  DETENT_CAPSULE = 6,
  DETENT_SEGMENT = 7,     /**< queries only: scenes do not store it */
  DETENT_POINT = 8,       /**< queries of scenes only */
  DETENT_HULL = 9,        /**< scenes: a hull transformed by `placed`; worlds: a solid hull */
  DETENT_MESH = 10,       /**< 3D scenes and worlds */
  DETENT_HEIGHT_FIELD = 11, /**< 3D scenes and worlds: moved by `point`, not rotated */
  DETENT_COMPOUND = 12    /**< worlds only: several shapes that move as one, placed by `placed` */
};

/** The role of an object in a scene. Fixed objects form the level and are not in snapshots. */
enum { DETENT_MOVING = 0, DETENT_FIXED = 1 };

/** How a body moves: by forces and contacts, by its velocity only, or never. */
enum { DETENT_DYNAMIC_BODY = 0, DETENT_KINEMATIC_BODY = 1, DETENT_FIXED_BODY = 2 };

/** The kind of a joint, and what it constrains. */
enum {
  DETENT_DISTANCE_JOINT = 1, /**< two points `lower` to `upper` apart; optional spring */
  DETENT_BALL_JOINT = 2,     /**< keeps two points together; soft if `frequency` is set */
  DETENT_HINGE_JOINT = 3,    /**< two points, in 3D also axis 2 of both frames; limits, motor */
  DETENT_WELD_JOINT = 4,     /**< two points and two frames */
  DETENT_SLIDER_JOINT = 5,   /**< two frames, and b's point on axis 0; limits, motor, spring */
  DETENT_WHEEL_JOINT = 6,    /**< b's point on axis 0; limits, spring, motor that spins it */
  DETENT_CONE_JOINT = 7      /**< 3D: two points; a cone for axis 2 of b, limits of the twist */
};

/** The world axes that a body cannot move along or rotate about. In 2D any of the last three
 *  prevents rotation. */
enum {
  DETENT_LOCK_X = 1,
  DETENT_LOCK_Y = 2,
  DETENT_LOCK_Z = 4,
  DETENT_LOCK_TURN_X = 8,
  DETENT_LOCK_TURN_Y = 16,
  DETENT_LOCK_TURN_Z = 32
};

/** The state of a session that has no frame left to simulate. */
enum {
  DETENT_PLAYED = 0,      /**< it simulated a new frame with the given input */
  DETENT_CONNECTING = 1,  /**< some player has not been heard from yet */
  DETENT_CATCHING_UP = 2, /**< frames remain to be resimulated in later calls */
  DETENT_STARVED = 3,     /**< it waits for another player's input */
  DETENT_AHEAD = 4,       /**< it is ahead of the others and waits one frame */
  DETENT_PAUSED = 5,      /**< a player paused */
  DETENT_OVER = 6,        /**< a spectator without players, or 2^31 frames played */
  DETENT_JOINING = 7      /**< the snapshot of the match has not arrived yet */
};

/** The events of a session. "The peer" is the event's `peer`. */
enum {
  DETENT_CONNECTED = 0,      /**< the peer's first packet arrived */
  DETENT_SILENT = 1,         /**< the peer sent nothing for `silence`; you may drop it */
  DETENT_HEARD_AGAIN = 2,    /**< the peer is no longer silent */
  DETENT_PEER_PAUSED = 3,    /**< the peer paused */
  DETENT_PEER_RESUMED = 4,   /**< the peer resumed */
  DETENT_DROPPED = 5,        /**< this player was dropped by one of the remaining peers */
  DETENT_EXPELLED = 6,       /**< the peer dropped us; we play on alone */
  DETENT_LEFT = 7,           /**< agreed: `frame` is the first without this player's input */
  DETENT_TOO_SLOW = 8,       /**< a spectator fell behind further than inputs are kept */
  DETENT_CONTRADICTION = 9,  /**< the peer's second input for `frame` differs; the first stays */
  DETENT_DESYNC = 10,        /**< the peer's result of `frame` is the first to differ from ours */
  DETENT_DESYNC_FIELD = 11,  /**< the name of the first field that differs in that result */
  DETENT_ARRIVED = 12,       /**< the peer joins late or rejoins, and is sent a snapshot */
  DETENT_LOADED = 13,        /**< we joined late and loaded the peer's world before `frame` */
  DETENT_NO_SUCH_WORLD = 14, /**< its snapshot does not fit our world; another is requested */
  DETENT_JOINED = 15         /**< this player takes part from `frame` on */
};

/** How a replay ends. */
enum {
  DETENT_REPLAY_WHOLE = 0,    /**< every byte was read */
  DETENT_REPLAY_CUT = 1,      /**< the last block is incomplete: the writer was stopped */
  DETENT_REPLAY_CORRUPTED = 2 /**< a byte was altered; the frames before it were read */
};

/** Maximum sizes: bytes of a player's input, of a packet, of a snapshot sent to a late joiner and
 *  of a field name; words next to a session's world; players. */
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

/** A scene, world or asset of a context; 0 is none. A context never reuses a handle. A handle is
 *  meaningless in any other context. */
typedef uint32_t detent_handle;

/** The id of an object of a scene or a body of a world. Ids are never reused; {0, 0} is none. */
typedef struct detent_id {
  uint32_t index;
  uint32_t generation;
} detent_id;

/** Two objects or bodies. */
typedef struct detent_pair {
  detent_id first;
  detent_id second;
} detent_pair;

/** A pair of bodies that began (1) or ceased (0) to touch in the last step; for compounds, a pair
 *  of parts. */
typedef struct detent_touch {
  detent_id a;
  detent_id b;
  uint32_t begins;
  uint32_t part_a; /**< the index of the compound's part; 0 for other bodies */
  uint32_t part_b;
} detent_touch;

/** The properties of a body. */
typedef struct detent_body_info {
  uint64_t user;
  uint32_t layers;
  uint32_t collides_with;
  uint32_t motion;     /**< DETENT_DYNAMIC_BODY, DETENT_KINEMATIC_BODY or DETENT_FIXED_BODY */
  uint32_t is_sensor;
  uint32_t is_asleep;
  uint32_t part_count; /**< the number of parts of a compound; 0 for other bodies */
} detent_body_info;

/** An object found by a query, and its distance in steps of 2^-16. */
typedef struct detent_found {
  int32_t distance;
  detent_id id;
} detent_found;

/** When two moving shapes meet. They are disjoint before `time` (in steps of 2^-30) and at most
 *  `distance` apart at `time`. If `is_hit` is 0 the search ended early, and whether they meet later
 *  is unknown. */
typedef struct detent_impact {
  int32_t time;
  int32_t distance;
  uint32_t is_hit;
} detent_impact;

/** The settings of a match and of one peer. Times are in microseconds of this peer's own clock. */
typedef struct detent_session_settings {
  uint64_t match;           /**< the same for all peers: a random number chosen by the host */
  uint64_t send_interval;   /**< least time between two packets to a peer */
  uint64_t silence;         /**< a peer that sends nothing for this long is silent */
  uint32_t self;            /**< this peer's number: players come first, then spectators */
  uint32_t players;         /**< 1 to 8 */
  uint32_t spectators;      /**< at most 16 peers in all */
  uint32_t delay;           /**< frames between an input and its effect, 0 to 8 */
  uint32_t prediction;      /**< 0 to 16; 0: every frame waits for all inputs and delay is >= 1 */
  uint32_t frames_per_call; /**< most frames simulated in one tick, at least 1 */
  uint32_t absent;          /**< seats free at the start, one bit each: the same for all peers */
  uint32_t life;            /**< 0; a peer that rejoins passes more than in its earlier sessions */
  uint32_t wants_seat;      /**< 0 or 1: whether a player that joins late wants a seat */
  uint32_t input_size;      /**< bytes of a player's input, 1 to 16: the same for all peers */
  uint32_t words;           /**< 32-bit words next to the world, 0 to 256: the same for all peers */
  uint32_t replay_every;    /**< 0, or records a replay with a digest every 1 to 255 frames */
} detent_session_settings;

/** A frame to simulate, or the reason why there is none. Players whose bit in `present` is set take
 *  part. */
typedef struct detent_frame {
  uint32_t number;   /**< from 0 */
  uint32_t players;
  uint32_t present;
  uint32_t state;    /**< if there is none: DETENT_PLAYED and so on */
} detent_frame;

/** An event of a session. */
typedef struct detent_session_event {
  uint32_t kind;       /**< DETENT_CONNECTED and so on */
  uint32_t peer;
  uint32_t frame;
  uint32_t name_size;  /**< length of the field's name in bytes */
  uint32_t has_object;
  detent_id object;    /**< the body that the field belongs to, if any */
} detent_session_event;

/** The progress of a session. */
typedef struct detent_session_status {
  uint64_t digest;        /**< of the results of all frames before `checked_frame` */
  uint64_t resimulated;   /**< frames simulated again, each time counted */
  uint32_t frame;         /**< frames played */
  uint32_t final_frame;   /**< frames whose results no packet can change any more */
  uint32_t checked_frame;
  uint32_t start_frame;   /**< 0, or the frame of the snapshot it started from */
  uint32_t is_player;     /**< whether it plays; a late joiner does once it has its seat */
  uint32_t players;
} detent_session_status;

/** The result of resimulating a replay so far. */
typedef struct detent_replay_check {
  uint32_t state;    /**< DETENT_REPLAY_WHOLE and so on */
  uint32_t frames;   /**< frames simulated */
  uint32_t equal;    /**< this many frames reproduced the recorded digests */
  uint32_t is_equal; /**< if 0, the first difference is in a frame from `equal` to `frames` */
  uint32_t players;
} detent_replay_check;

/** What a scene stores with an object, besides its shape. */
typedef struct detent_traits {
  uint64_t user;    /**< free for the caller; saved, never interpreted */
  uint32_t layers;  /**< a bit mask; a query names the layers it searches */
  uint32_t motion;  /**< DETENT_MOVING or DETENT_FIXED */
  detent_id frame;  /**< the parent frame of a moving object; {0, 0} is the world */
} detent_traits;

/** The allocator of a context. `allocate` returns memory for `size` bytes aligned for any type, or
 *  null. `release` receives the same size. If both are null, malloc and free are used. */
typedef struct detent_allocator {
  void* user;
  void* (*allocate)(void* user, size_t size);
  void (*release)(void* user, void* memory, size_t size);
} detent_allocator;

/** The owner of everything else. The caller provides its memory: zero it, open it and close it, and
 *  do not move it while it is open. Contexts share nothing. On one context, functions that only
 *  read (const detent_context*) may run in several threads at once; any other call needs exclusive
 *  access. */
typedef struct detent_context {
  uint64_t words[4];
} detent_context;

/** A point or vector, in steps of 2^-16. */
typedef struct detent_vec2 {
  int32_t x, y;
} detent_vec2;

/** A unit vector, in steps of 2^-30; used as stored, never normalised. */
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

/** The points between two corners, inclusive; none if min > max on an axis. */
typedef struct detent_aabb2 {
  detent_vec2 min;
  detent_vec2 max;
} detent_aabb2;

/** A box rotated about its center; none if a half extent is negative. */
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

/** The points of the triangle with these corners. */
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

/** The points between the two ends. */
typedef struct detent_segment2 {
  detent_vec2 start;
  detent_vec2 end;
} detent_segment2;

/** A shape of any kind. `kind` selects the member of the union. `asset` is the handle of a hull,
 *  mesh or height field; other kinds ignore it. */
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

/** The first contact of a ray or moving shape with a shape. The distance is rounded down. */
typedef struct detent_hit2 {
  int32_t distance;
  detent_vec2 point;
  detent_direction2 normal;
} detent_hit2;

/** One contact point on the surface of the first shape. The second shape's surface is at point -
 *  depth * normal. `feature` identifies the corners, edges or faces that meet, and is stable while
 *  they do. */
typedef struct detent_contact_point2 {
  detent_vec2 point;
  int32_t depth;
  uint32_t feature;
} detent_contact_point2;

/** The least translation that separates two overlapping shapes a and b: move b by `depth`, rounded
 *  up, along `normal`, which points from a to b. The first `count` points are set, the others are
 *  zero. */
typedef struct detent_manifold2 {
  detent_direction2 normal;
  int32_t depth;
  uint32_t count;
  detent_contact_point2 points[2];
} detent_manifold2;

/** The motion of a frame between two poses over the time 0 to 1. The origin moves at constant
 *  velocity; the frame rotates about one axis by at most half a turn. */
typedef struct detent_sweep2 {
  detent_vec2 start;
  detent_vec2 end;
  detent_rotation2 start_rotation;
  detent_rotation2 end_rotation;
} detent_sweep2;

/** The first point where a ray touches an object; for a mesh or height field also the triangle's
 *  index. */
typedef struct detent_object_hit2 {
  int32_t distance;
  detent_id id;
  detent_vec2 point;
  detent_direction2 normal;
  uint32_t triangle;
  uint32_t has_triangle; /**< 1 or 0 */
} detent_object_hit2;

/** A walking character: its capsule or AABB, and what it stands on. This is its whole state. Start
 *  with zeros and the shape in place. Setting `is_grounded` to 0 makes it leave the ground. A ball
 *  is a capsule with equal ends. */
typedef struct detent_mover2 {
  detent_shape2 shape;
  uint32_t is_grounded; /**< 1 or 0; if 0, the fields below are ignored */
  detent_id object;
  detent_direction2 normal;
  detent_id frame;      /**< the object's frame, which carries the character */
  detent_vec2 local;  /**< the ground point under the character, in the frame */
  detent_vec2 point;  /**< the same point in the world */
} detent_mover2;

/** Settings of a character's movement. Lengths in steps of 2^-16. */
typedef struct detent_mover2_settings {
  detent_direction2 up;
  int32_t skin;          /**< gap kept to everything it moves along; at least 32 */
  int32_t step_height;   /**< highest step it climbs; 0: none */
  int32_t snap_distance; /**< how far down it follows the ground; 0: not at all */
  uint32_t max_slope;    /**< steepest slope it can stand on, in 2^-32 of a turn */
} detent_mover2_settings;

/** Something the character touched during a move. The normal points away from it. */
typedef struct detent_mover2_touch {
  detent_id object;
  detent_vec2 point;
  detent_direction2 normal;
} detent_mover2_touch;

/** The result of a move. The first `count` touches are set, the others are zero. */
typedef struct detent_move2 {
  detent_vec2 moved;   /**< the whole displacement */
  detent_vec2 carried; /**< the part due to the ground's frame */
  detent_vec2 pushed;  /**< the part due to leaving overlaps */
  uint32_t count;
  uint32_t is_stuck;     /**< 1: it still overlaps something it could not be pushed out of */
  detent_mover2_touch touched[8];
} detent_move2;

/** A point at which two bodies touch. Lengths and impulses in steps of 2^-16. */
typedef struct detent_world2_contact_point {
  detent_vec2 point; /**< in the world, midway between the surfaces */
  int32_t separation;  /**< negative where they overlap */
  int32_t impulse;     /**< along the normal */
  uint32_t feature;    /**< identifies the corners, edges or faces that meet */
} detent_world2_contact_point;

/** The contact of two bodies; for compounds that of two parts, for meshes and height fields that of
 *  one triangle. The first `count` points are set, the others are zero. Impulses act on b; a gets
 *  the opposite. They are those of the last substep, in units of mass times units per second. */
typedef struct detent_world2_contact {
  detent_id a;
  detent_id b;
  uint32_t part_a;   /**< the index of the compound's part; 0 for other bodies */
  uint32_t part_b;
  uint32_t triangle; /**< of a mesh or height field */
  detent_direction2 normal; /**< from a to b */
  int32_t impulse;            /**< along the normal, of all points */
  detent_vec2 friction;     /**< the impulse of friction, across the normal */
  uint32_t count;
  detent_world2_contact_point points[2];
} detent_world2_contact;

/** Settings of a world. Lengths and speeds in steps of 2^-16. */
typedef struct detent_world2_settings {
  int32_t ticks_per_second;
  int32_t substeps; /**< ticks_per_second * substeps must be in [1, 32767] */
  detent_vec2 gravity;
  int32_t margin;           /**< bodies within this distance are in contact */
  int32_t push_speed;       /**< greatest speed at which overlaps are resolved */
  int32_t bounce_threshold; /**< slower impacts do not bounce */
  int32_t sleep_speed;      /**< slower bodies may sleep; 0: none ever does */
  int32_t hold_distance;    /**< bodies that move less keep the geometry of their contacts; 0: none */
} detent_world2_settings;

/** The material and initial state of a body. Ratios and densities in steps of 2^-16. */
typedef struct detent_body2_options {
  uint64_t user; /**< free for the caller; saved, never interpreted */
  uint32_t layers;
  uint32_t collides_with; /**< layers it collides with; both bodies must agree */
  uint32_t motion;        /**< DETENT_DYNAMIC_BODY and so on */
  int32_t density;
  int32_t friction;
  int32_t restitution;
  int32_t rolling_resistance; /**< stops balls and capsules from rolling; 0: they roll on */
  int32_t linear_damping;
  int32_t angular_damping;
  detent_vec2 velocity;
  int32_t angular_velocity[1];
  int32_t gravity_scale; /**< factor on the world's gravity; 65536 is 1 */
  uint32_t locked;       /**< DETENT_LOCK_X | ... */
  uint32_t is_sensor;    /**< 1: touches are reported but exert no force */
  uint32_t is_fast;      /**< 1: never tunnels through other bodies */
  uint32_t reserved[2]; /**< ignored; keeps the layout free of padding */
} detent_body2_options;

/** A part of a compound: a sphere, AABB, OBB, capsule or solid hull in the compound's frame, and
 *  its material, in steps of 2^-16. Start from `detent_part2_defaults`. */
typedef struct detent_part2 {
  detent_shape2 shape;
  int32_t density;     /**< 0: the part has no mass */
  int32_t friction;
  int32_t restitution;
  int32_t rolling_resistance; /**< of balls and capsules */
  uint32_t is_sensor;  /**< 1: touches are reported but exert no force */
} detent_part2;

/** A joint between two bodies a and b. Anchors and frames are in body space. Time is in the seconds
 *  of the world's settings, angles in radians, and all numbers are in steps of 2^-16. Fields that a
 *  kind does not have are ignored. */
typedef struct detent_joint2 {
  uint32_t kind;
  detent_id a;
  detent_id b;
  detent_vec2 anchor_a;       /**< less than 512 units from the center */
  detent_vec2 anchor_b;
  detent_rotation2 frame_a;   /**< cone, hinge, weld, slider, wheel */
  detent_rotation2 frame_b;
  uint32_t collide;             /**< 1: a and b can collide with each other */
  int32_t break_force;          /**< a greater force breaks the joint; 0: unbreakable */
  uint32_t has_limits;          /**< cone, hinge, slider, wheel: 1 or 0; distance: always limited */
  int32_t lower;                /**< an angle for a hinge or a cone, otherwise a length */
  int32_t upper;
  int32_t motor_speed;          /**< hinge, slider, wheel */
  int32_t motor_force;          /**< greatest force, or torque of hinge and wheel */
  int32_t length;               /**< of the spring at rest: distance, slider, wheel; hinge: its angle */
  int32_t frequency;            /**< of the spring, in Hz; 0: none. Not for cones */
  int32_t damping_ratio;        /**< 65536 is critical damping */
  int32_t cone_angle;           /**< cone: greatest angle between both axes 2; 0: any */
} detent_joint2;

/** The state of a body, rounded to nearest. */
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

/** A unit vector, in steps of 2^-30; used as stored, never normalised. */
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

/** The points between two corners, inclusive; none if min > max on an axis. */
typedef struct detent_aabb3 {
  detent_vec3 min;
  detent_vec3 max;
} detent_aabb3;

/** A box rotated about its center; none if a half extent is negative. */
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

/** The points of the triangle with these corners. */
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

/** The points between the two ends. */
typedef struct detent_segment3 {
  detent_vec3 start;
  detent_vec3 end;
} detent_segment3;

/** A shape of any kind. `kind` selects the member of the union. `asset` is the handle of a hull,
 *  mesh or height field; other kinds ignore it. */
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

/** The first contact of a ray or moving shape with a shape. The distance is rounded down. */
typedef struct detent_hit3 {
  int32_t distance;
  detent_vec3 point;
  detent_direction3 normal;
} detent_hit3;

/** One contact point on the surface of the first shape. The second shape's surface is at point -
 *  depth * normal. `feature` identifies the corners, edges or faces that meet, and is stable while
 *  they do. */
typedef struct detent_contact_point3 {
  detent_vec3 point;
  int32_t depth;
  uint32_t feature;
} detent_contact_point3;

/** The least translation that separates two overlapping shapes a and b: move b by `depth`, rounded
 *  up, along `normal`, which points from a to b. The first `count` points are set, the others are
 *  zero. */
typedef struct detent_manifold3 {
  detent_direction3 normal;
  int32_t depth;
  uint32_t count;
  detent_contact_point3 points[4];
} detent_manifold3;

/** The motion of a frame between two poses over the time 0 to 1. The origin moves at constant
 *  velocity; the frame rotates about one axis by at most half a turn. */
typedef struct detent_sweep3 {
  detent_vec3 start;
  detent_vec3 end;
  detent_rotation3 start_rotation;
  detent_rotation3 end_rotation;
} detent_sweep3;

/** The first point where a ray touches an object; for a mesh or height field also the triangle's
 *  index. */
typedef struct detent_object_hit3 {
  int32_t distance;
  detent_id id;
  detent_vec3 point;
  detent_direction3 normal;
  uint32_t triangle;
  uint32_t has_triangle; /**< 1 or 0 */
} detent_object_hit3;

/** A walking character: its capsule or AABB, and what it stands on. This is its whole state. Start
 *  with zeros and the shape in place. Setting `is_grounded` to 0 makes it leave the ground. A ball
 *  is a capsule with equal ends. */
typedef struct detent_mover3 {
  detent_shape3 shape;
  uint32_t is_grounded; /**< 1 or 0; if 0, the fields below are ignored */
  detent_id object;
  detent_direction3 normal;
  detent_id frame;      /**< the object's frame, which carries the character */
  detent_vec3 local;  /**< the ground point under the character, in the frame */
  detent_vec3 point;  /**< the same point in the world */
} detent_mover3;

/** Settings of a character's movement. Lengths in steps of 2^-16. */
typedef struct detent_mover3_settings {
  detent_direction3 up;
  int32_t skin;          /**< gap kept to everything it moves along; at least 32 */
  int32_t step_height;   /**< highest step it climbs; 0: none */
  int32_t snap_distance; /**< how far down it follows the ground; 0: not at all */
  uint32_t max_slope;    /**< steepest slope it can stand on, in 2^-32 of a turn */
} detent_mover3_settings;

/** Something the character touched during a move. The normal points away from it. */
typedef struct detent_mover3_touch {
  detent_id object;
  detent_vec3 point;
  detent_direction3 normal;
} detent_mover3_touch;

/** The result of a move. The first `count` touches are set, the others are zero. */
typedef struct detent_move3 {
  detent_vec3 moved;   /**< the whole displacement */
  detent_vec3 carried; /**< the part due to the ground's frame */
  detent_vec3 pushed;  /**< the part due to leaving overlaps */
  uint32_t count;
  uint32_t is_stuck;     /**< 1: it still overlaps something it could not be pushed out of */
  detent_mover3_touch touched[8];
} detent_move3;

/** A point at which two bodies touch. Lengths and impulses in steps of 2^-16. */
typedef struct detent_world3_contact_point {
  detent_vec3 point; /**< in the world, midway between the surfaces */
  int32_t separation;  /**< negative where they overlap */
  int32_t impulse;     /**< along the normal */
  uint32_t feature;    /**< identifies the corners, edges or faces that meet */
} detent_world3_contact_point;

/** The contact of two bodies; for compounds that of two parts, for meshes and height fields that of
 *  one triangle. The first `count` points are set, the others are zero. Impulses act on b; a gets
 *  the opposite. They are those of the last substep, in units of mass times units per second. */
typedef struct detent_world3_contact {
  detent_id a;
  detent_id b;
  uint32_t part_a;   /**< the index of the compound's part; 0 for other bodies */
  uint32_t part_b;
  uint32_t triangle; /**< of a mesh or height field */
  detent_direction3 normal; /**< from a to b */
  int32_t impulse;            /**< along the normal, of all points */
  detent_vec3 friction;     /**< the impulse of friction, across the normal */
  uint32_t count;
  detent_world3_contact_point points[4];
} detent_world3_contact;

/** Settings of a world. Lengths and speeds in steps of 2^-16. */
typedef struct detent_world3_settings {
  int32_t ticks_per_second;
  int32_t substeps; /**< ticks_per_second * substeps must be in [1, 32767] */
  detent_vec3 gravity;
  int32_t margin;           /**< bodies within this distance are in contact */
  int32_t push_speed;       /**< greatest speed at which overlaps are resolved */
  int32_t bounce_threshold; /**< slower impacts do not bounce */
  int32_t sleep_speed;      /**< slower bodies may sleep; 0: none ever does */
  int32_t hold_distance;    /**< bodies that move less keep the geometry of their contacts; 0: none */
} detent_world3_settings;

/** The material and initial state of a body. Ratios and densities in steps of 2^-16. */
typedef struct detent_body3_options {
  uint64_t user; /**< free for the caller; saved, never interpreted */
  uint32_t layers;
  uint32_t collides_with; /**< layers it collides with; both bodies must agree */
  uint32_t motion;        /**< DETENT_DYNAMIC_BODY and so on */
  int32_t density;
  int32_t friction;
  int32_t restitution;
  int32_t rolling_resistance; /**< stops balls and capsules from rolling; 0: they roll on */
  int32_t linear_damping;
  int32_t angular_damping;
  detent_vec3 velocity;
  int32_t angular_velocity[3];
  int32_t gravity_scale; /**< factor on the world's gravity; 65536 is 1 */
  uint32_t locked;       /**< DETENT_LOCK_X | ... */
  uint32_t is_sensor;    /**< 1: touches are reported but exert no force */
  uint32_t is_fast;      /**< 1: never tunnels through other bodies */
  uint32_t reserved[3]; /**< ignored; keeps the layout free of padding */
} detent_body3_options;

/** A part of a compound: a sphere, AABB, OBB, capsule or solid hull in the compound's frame, and
 *  its material, in steps of 2^-16. Start from `detent_part3_defaults`. */
typedef struct detent_part3 {
  detent_shape3 shape;
  int32_t density;     /**< 0: the part has no mass */
  int32_t friction;
  int32_t restitution;
  int32_t rolling_resistance; /**< of balls and capsules */
  uint32_t is_sensor;  /**< 1: touches are reported but exert no force */
} detent_part3;

/** A joint between two bodies a and b. Anchors and frames are in body space. Time is in the seconds
 *  of the world's settings, angles in radians, and all numbers are in steps of 2^-16. Fields that a
 *  kind does not have are ignored. */
typedef struct detent_joint3 {
  uint32_t kind;
  detent_id a;
  detent_id b;
  detent_vec3 anchor_a;       /**< less than 512 units from the center */
  detent_vec3 anchor_b;
  detent_rotation3 frame_a;   /**< cone, hinge, weld, slider, wheel */
  detent_rotation3 frame_b;
  uint32_t collide;             /**< 1: a and b can collide with each other */
  int32_t break_force;          /**< a greater force breaks the joint; 0: unbreakable */
  uint32_t has_limits;          /**< cone, hinge, slider, wheel: 1 or 0; distance: always limited */
  int32_t lower;                /**< an angle for a hinge or a cone, otherwise a length */
  int32_t upper;
  int32_t motor_speed;          /**< hinge, slider, wheel */
  int32_t motor_force;          /**< greatest force, or torque of hinge and wheel */
  int32_t length;               /**< of the spring at rest: distance, slider, wheel; hinge: its angle */
  int32_t frequency;            /**< of the spring, in Hz; 0: none. Not for cones */
  int32_t damping_ratio;        /**< 65536 is critical damping */
  int32_t cone_angle;           /**< cone: greatest angle between both axes 2; 0: any */
} detent_joint3;

/** The state of a body, rounded to nearest. */
typedef struct detent_body3 {
  detent_vec3 position;
  detent_rotation3 rotation;
  detent_vec3 velocity;
  int32_t angular_velocity[3];
  uint32_t is_asleep;
} detent_body3;

/** A camera: its pose and lens. The pose is that of `detent_camera3_look_at`: axis 0 points right,
 *  axis 1 up, and it looks along -axis 2. The scale is ignored. */
typedef struct detent_camera3 {
  detent_transform3 pose;
  uint32_t has_perspective; /**< 1 or 0 (orthographic) */
  uint32_t fov;             /**< perspective: vertical, in 2^-32 of a turn; < 165.7 degrees */
  int32_t aspect;           /**< perspective: width / height in steps of 2^-16; above 0 */
  int32_t half_width;       /**< orthographic: a length above 0 */
  int32_t half_height;      /**< orthographic: a length above 0 */
  int32_t near_distance;    /**< less than `far_distance`; above 0 with perspective */
  int32_t far_distance;
} detent_camera3;

/** The view volume of a camera: the convex hull of eight corners. Corner i is right if i & 1, top
 *  if i & 2 and far if i & 4. Every query is exact for any eight points in any order. */
typedef struct detent_frustum3 {
  detent_vec3 corners[8];
} detent_frustum3;

/** A screen point: pixels from the top left corner in steps of 2^-16, so that 32768 is the middle
 *  of the first pixel, and the depth along the line of sight, a length. */
typedef struct detent_screen_point3 {
  int32_t x;
  int32_t y;
  int32_t depth;
} detent_screen_point3;

/** The version of the library: major * 10000 + minor * 100 + patch. */
DETENT_API int32_t detent_version(void);

/** The version of the results. It changes whenever any result changes by a bit; recorded matches of
 *  another version do not replay. */
DETENT_API int32_t detent_results_version(void);

/** A description of a status in words; never null. */
DETENT_API const char* detent_describe(detent_status status);

/** Opens a context. `allocator` may be null. It supplies the memory of the context itself, its
 *  objects and copies of triangles, points and heights; lists inside scenes and worlds use C++'s
 *  operator new. Returns DETENT_BAD_CONTEXT if the context is already open, and DETENT_BAD_ARGUMENT
 *  if only one of the two functions is given. */
DETENT_API detent_status detent_open(detent_context* context, const detent_allocator* allocator);

/** Destroys everything in the context and closes it. All its handles become stale. */
DETENT_API detent_status detent_close(detent_context* context);

/** The number of scenes, worlds and assets in the context. */
DETENT_API detent_status detent_count(const detent_context* context, uint32_t* count);

/** The default settings: two players, delay 2, prediction 8, inputs of one byte. */
DETENT_API detent_status detent_session_default_settings(detent_session_settings* settings);

/** A mesh of `face_count` triangles, each three indices into `vertices`. Copies its input. `id`
 *  identifies the mesh in snapshots: it must not be 0, and DETENT_IN_USE is returned if another
 *  mesh has it. DETENT_BAD_ARGUMENT if an index is out of range. A context holds 256 meshes; beyond
 *  that DETENT_FULL. */
DETENT_API detent_status detent_mesh_create(detent_context* context, uint32_t id,
                                            const detent_vec3* vertices, uint32_t vertex_count,
                                            const uint32_t* faces, uint32_t face_count,
                                            detent_handle* mesh);

/** A height field. Sample (column, row) is at x = corner.x + column * cell, z = corner.y + row *
 *  cell and y = heights[row * columns + column]. Copies the heights. `id` as for meshes.
 *  DETENT_BAD_ARGUMENT for fewer than two columns or rows, a cell size that is not positive, or a
 *  far corner out of range. */
DETENT_API detent_status detent_height_field_create(detent_context* context, uint32_t id,
                                                    const detent_vec2* corner, int32_t cell,
                                                    uint32_t columns, uint32_t rows,
                                                    const int32_t* heights, detent_handle* field);

/** Destroys a mesh, hull, height field or compound. DETENT_IN_USE while an object, body or compound
 *  refers to it, or a session might. */
DETENT_API detent_status detent_asset_destroy(detent_context* context, detent_handle asset);

/** Whether the ray touches the shape, and where. `hit` may be null. The distance is 0 if the ray
 *  starts inside. For the kinds DETENT_SPHERE to DETENT_SEGMENT. */
DETENT_API detent_status detent_raycast2(const detent_ray2* ray, const detent_shape2* shape,
                                           detent_hit2* hit);

/** Raycasts `count` rays against one shape and writes their distances, -1 for a miss. The first
 *  direction that is not unit length stops it with DETENT_NOT_UNIT. */
DETENT_API detent_status detent_raycast2_many(const detent_ray2* rays, uint32_t count,
                                                const detent_shape2* shape, int32_t* distances);

/** Whether the point is in the shape or on its surface. Exact. */
DETENT_API detent_status detent_contains2(const detent_shape2* shape, const detent_vec2* point);

/** Whether two shapes share a point. Exact. */
DETENT_API detent_status detent_overlaps2(const detent_shape2* a, const detent_shape2* b);

/** The closest point of the shape to `point`, each coordinate rounded to nearest. */
DETENT_API detent_status detent_closest_point2(const detent_shape2* shape,
                                                 const detent_vec2* point,
                                                 detent_vec2* closest);

/** The distance from the shape to `point`, rounded down; INT32_MAX if the shape is empty. */
DETENT_API detent_status detent_distance_to_point2(const detent_shape2* shape,
                                                     const detent_vec2* point,
                                                     int32_t* distance);

/** The distance between two shapes, rounded down; 0 if they share a point. */
DETENT_API detent_status detent_distance2(const detent_shape2* a, const detent_shape2* b,
                                            int32_t* distance);

/** The contact of two overlapping shapes; touching counts. DETENT_NO if they are disjoint.
 *  `contact` may be null. For the kinds DETENT_SPHERE to DETENT_SEGMENT, except two planes. */
DETENT_API detent_status detent_contact2(const detent_shape2* a, const detent_shape2* b,
                                           detent_manifold2* contact);

/** The closest points of a and b to each other, each coordinate rounded to nearest: the same point
 *  twice where they meet. Among several pairs, the one whose point of a has the least x, then y,
 *  then z. Both are the origin if a shape is empty. For the kinds DETENT_SPHERE to DETENT_SEGMENT.
 *  */
DETENT_API detent_status detent_closest_points2(const detent_shape2* a,
                                                  const detent_shape2* b,
                                                  detent_vec2* point_a,
                                                  detent_vec2* point_b);

/** The first contact of `shape`, moving along `direction` by at most `max_distance`, with `target`:
 *  the distance moved, rounded down, the point of the target, and the normal there, facing the
 *  shape. DETENT_NO if it touches nothing. The distance is 0 if they share a point at the start.
 *  `hit` may be null. For the kinds DETENT_SPHERE to DETENT_SEGMENT; a plane cannot be the moving
 *  shape. */
DETENT_API detent_status detent_cast2(const detent_shape2* shape,
                                        const detent_direction2* direction, int32_t max_distance,
                                        const detent_shape2* target, detent_hit2* hit);

/** The time, rounded down, at which two moving shapes first come closer than `target` (a length;
 *  usually 8). Each shape is given in the frame that its sweep moves. DETENT_NO if they stay apart.
 *  `sweep_b` may be null if b does not move, and must be null for a plane. `impact` may be null.
 *  For the kinds DETENT_SPHERE to DETENT_CAPSULE. */
DETENT_API detent_status detent_time_of_impact2(const detent_shape2* a,
                                                  const detent_sweep2* sweep_a,
                                                  const detent_shape2* b,
                                                  const detent_sweep2* sweep_b, int32_t target,
                                                  detent_impact* impact);

/** Whether the point is on the ray. Exact. */
DETENT_API detent_status detent_ray2_contains(const detent_ray2* ray, const detent_vec2* point);

/** The closest point of the ray to `point`, each coordinate rounded to nearest. */
DETENT_API detent_status detent_ray2_closest_point(const detent_ray2* ray,
                                                     const detent_vec2* point,
                                                     detent_vec2* closest);

/** The distance from the ray to `point`, rounded down. */
DETENT_API detent_status detent_ray2_distance_to_point(const detent_ray2* ray,
                                                         const detent_vec2* point,
                                                         int32_t* distance);

/** The first point where the ray touches any of `count` shapes; among equal distances, the first in
 *  the list. Functions of `detent_shapes2` treat a list of shapes, possibly empty, as their
 *  union. They take the kinds DETENT_SPHERE to DETENT_SEGMENT and DETENT_HULL of `context`, whose
 *  transformed points are rounded to nearest. `context` may be null if there is no hull. `hit` may
 *  be null. */
DETENT_API detent_status detent_shapes2_raycast(const detent_context* context,
                                                  const detent_ray2* ray,
                                                  const detent_shape2* shapes, uint32_t count,
                                                  detent_hit2* hit);

/** Whether the point is in any of the shapes. Exact. */
DETENT_API detent_status detent_shapes2_contains(const detent_context* context,
                                                   const detent_shape2* shapes, uint32_t count,
                                                   const detent_vec2* point);

/** Whether any shape of one list shares a point with any shape of the other. Exact. */
DETENT_API detent_status detent_shapes2_overlaps(const detent_context* context,
                                                   const detent_shape2* a, uint32_t a_count,
                                                   const detent_shape2* b, uint32_t b_count);

/** The closest point of the nearest shape to `point`, each coordinate rounded to nearest. Among
 *  equal distances, rounded down, the first shape. `point` itself if there are no shapes. */
DETENT_API detent_status detent_shapes2_closest_point(const detent_context* context,
                                                        const detent_shape2* shapes,
                                                        uint32_t count, const detent_vec2* point,
                                                        detent_vec2* closest);

/** The distance from the nearest shape to `point`, rounded down; INT32_MAX if there are no shapes.
 *  */
DETENT_API detent_status detent_shapes2_distance_to_point(const detent_context* context,
                                                            const detent_shape2* shapes,
                                                            uint32_t count,
                                                            const detent_vec2* point,
                                                            int32_t* distance);

/** The least distance between a shape of one list and one of the other, rounded down; 0 if they
 *  share a point, INT32_MAX if a list is empty. */
DETENT_API detent_status detent_shapes2_distance(const detent_context* context,
                                                   const detent_shape2* a, uint32_t a_count,
                                                   const detent_shape2* b, uint32_t b_count,
                                                   int32_t* distance);

/** The closest points of the nearest two shapes, each coordinate rounded to nearest. Among equal
 *  distances, rounded down, the first shape of a, then of b; among several pairs of points, the one
 *  whose point of b has the least x, then y, then z. Both are the origin if a list is empty. */
DETENT_API detent_status detent_shapes2_closest_points(const detent_context* context,
                                                         const detent_shape2* a, uint32_t a_count,
                                                         const detent_shape2* b, uint32_t b_count,
                                                         detent_vec2* point_a,
                                                         detent_vec2* point_b);

/** `detent_cast2` of one moving shape, possibly a hull, against `count` shapes; among equal
 *  distances, the first. `hit` may be null. */
DETENT_API detent_status detent_shapes2_cast(const detent_context* context,
                                               const detent_shape2* shape,
                                               const detent_direction2* direction,
                                               int32_t max_distance,
                                               const detent_shape2* targets, uint32_t count,
                                               detent_hit2* hit);

/** `detent_contact2` of two shapes, each possibly a hull. `contact` may be null. */
DETENT_API detent_status detent_shapes2_contact(const detent_context* context,
                                                  const detent_shape2* a,
                                                  const detent_shape2* b,
                                                  detent_manifold2* contact);

/** `detent_time_of_impact2` of two shapes, each possibly a hull. `sweep_b` and `impact` may be
 *  null. */
DETENT_API detent_status detent_shapes2_time_of_impact(const detent_context* context,
                                                         const detent_shape2* a,
                                                         const detent_sweep2* sweep_a,
                                                         const detent_shape2* b,
                                                         const detent_sweep2* sweep_b,
                                                         int32_t target, detent_impact* impact);

/** The convex hull of at most 64 points in any order. Copies them. `id` as for meshes. */
DETENT_API detent_status detent_hull2_create(detent_context* context, uint32_t id,
                                               const detent_vec2* points, uint32_t count,
                                               detent_handle* hull);

/** The convex hull of at most 32 points, for bodies. A body's position is the hull's center of
 *  mass. A context holds 64. DETENT_BAD_ARGUMENT if the hull has no volume. Copies the points. `id`
 *  as for meshes. */
DETENT_API detent_status detent_solid2_create(detent_context* context, uint32_t id,
                                                const detent_vec2* points, uint32_t count,
                                                detent_handle* solid);

/** A part with defaults: density 1, friction 3/5, no restitution, no rolling resistance, not a
 *  sensor. Its shape is a point without mass; set it. */
DETENT_API detent_status detent_part2_defaults(detent_part2* part);

/** A compound of 1 to 65536 parts that are fixed to each other, for bodies. A body's position is
 *  the common center of mass. Masses add where parts overlap. A context holds 256. Copies the
 *  parts; their solid hulls stay in use. DETENT_NO_QUERY for other kinds of shape. `id` as for
 *  meshes. */
DETENT_API detent_status detent_compound2_create(detent_context* context, uint32_t id,
                                                   const detent_part2* parts, uint32_t count,
                                                   detent_handle* compound);

/** An empty scene. Scenes store every kind of shape except segments and points. */
DETENT_API detent_status detent_scene2_create(detent_context* context, detent_handle* scene);

/** Destroys a scene. */
DETENT_API detent_status detent_scene2_destroy(detent_context* context, detent_handle scene);

/** Adds an object. `traits` may be null: layer 1, user 0, moving, in no frame. DETENT_FULL beyond
 *  1,048,576 objects, DETENT_NO if the frame does not exist, DETENT_BAD_ARGUMENT for a fixed object
 *  in a frame. */
DETENT_API detent_status detent_scene2_add(detent_context* context, detent_handle scene,
                                             const detent_shape2* shape,
                                             const detent_traits* traits, detent_id* id);

/** Adds an object with an id chosen by the caller. DETENT_NO if its index is taken or too large, or
 *  its generation is 0 or 2^32 - 1. */
DETENT_API detent_status detent_scene2_add_as(detent_context* context, detent_handle scene,
                                                detent_id id, const detent_shape2* shape,
                                                const detent_traits* traits);

/** Removes an object. DETENT_NO if no object has this id. */
DETENT_API detent_status detent_scene2_remove(detent_context* context, detent_handle scene,
                                                detent_id id);

/** Replaces the shape of an object, given in its frame. DETENT_NO if no object has this id. */
DETENT_API detent_status detent_scene2_replace(detent_context* context, detent_handle scene,
                                                 detent_id id, const detent_shape2* shape);

/** Translates an object, clamping its coordinates. DETENT_NO if no object has this id. */
DETENT_API detent_status detent_scene2_move(detent_context* context, detent_handle scene,
                                              detent_id id, const detent_vec2* by);

/** The shape of an object in world space, and its traits. Both may be null. DETENT_NO if no object
 *  has this id. */
DETENT_API detent_status detent_scene2_object(const detent_context* context, detent_handle scene,
                                                detent_id id, detent_shape2* shape,
                                                detent_traits* traits);

/** Sets layers and user word of an object. Its motion cannot change; that field is ignored. */
DETENT_API detent_status detent_scene2_set_traits(detent_context* context, detent_handle scene,
                                                    detent_id id, const detent_traits* traits);

/** Adds a frame for objects, inside `parent`; {0, 0} is the world. DETENT_NO if the parent does not
 *  exist, DETENT_FULL if there is no room. */
DETENT_API detent_status detent_scene2_add_frame(detent_context* context, detent_handle scene,
                                                   const detent_transform2* transform,
                                                   detent_id parent, detent_id* frame);

/** Moves a frame within its parent, with everything in it. DETENT_NO if no frame has this id. */
DETENT_API detent_status detent_scene2_move_frame(detent_context* context, detent_handle scene,
                                                    detent_id frame,
                                                    const detent_transform2* transform);

/** Removes a frame. DETENT_NO if no frame has this id, or the frame is not empty. */
DETENT_API detent_status detent_scene2_remove_frame(detent_context* context, detent_handle scene,
                                                      detent_id frame);

/** The transforms from a frame to its parent and to the world. Both may be null. DETENT_NO if no
 *  frame has this id. */
DETENT_API detent_status detent_scene2_frame(const detent_context* context, detent_handle scene,
                                               detent_id frame, detent_transform2* local,
                                               detent_transform2* world);

/** The number of objects in the scene. */
DETENT_API detent_status detent_scene2_size(const detent_context* context, detent_handle scene,
                                              uint32_t* size);

/** Speeds up queries after many additions, such as loading a level. Never changes a result. */
DETENT_API detent_status detent_scene2_optimize(detent_context* context, detent_handle scene);

/** The first object in `layers` that the ray touches; among equal distances, the least id. `hit`
 *  may be null. */
DETENT_API detent_status detent_scene2_raycast(const detent_context* context, detent_handle scene,
                                                 const detent_ray2* ray, uint32_t layers,
                                                 detent_object_hit2* hit);

/** Whether the ray touches any object in `layers`. */
DETENT_API detent_status detent_scene2_raycast_any(const detent_context* context,
                                                     detent_handle scene, const detent_ray2* ray,
                                                     uint32_t layers);

/** All objects in `layers` that the ray touches, sorted by distance, then id. Writes the first
 *  `room` of them, and their total number to `count`. */
DETENT_API detent_status detent_scene2_raycast_all(const detent_context* context,
                                                     detent_handle scene, const detent_ray2* ray,
                                                     uint32_t layers, detent_object_hit2* hits,
                                                     uint32_t room, uint32_t* count);

/** `detent_scene2_raycast` for many rays. A miss has id {0, 0} and distance -1. The first
 *  direction that is not unit length stops it with DETENT_NOT_UNIT. */
DETENT_API detent_status detent_scene2_raycast_many(const detent_context* context,
                                                      detent_handle scene, const detent_ray2* rays,
                                                      uint32_t count, uint32_t layers,
                                                      detent_object_hit2* hits);

/** The object in `layers` nearest to a point, however far. For a sphere, AABB, OBB, capsule or
 *  segment: of the objects that it overlaps, the nearest to its center, start or end a. `found` may
 *  be null. */
DETENT_API detent_status detent_scene2_nearest(const detent_context* context, detent_handle scene,
                                                 const detent_shape2* question, uint32_t layers,
                                                 detent_found* found);

/** Whether the point, sphere, AABB, OBB, capsule or segment overlaps any object in `layers`. */
DETENT_API detent_status detent_scene2_any(const detent_context* context, detent_handle scene,
                                             const detent_shape2* question, uint32_t layers);

/** All objects in `layers` that the point, sphere, AABB, OBB, capsule or segment overlaps, sorted
 *  by distance, then id. Writes the first `room` of them, and their total number to `count`. */
DETENT_API detent_status detent_scene2_all(const detent_context* context, detent_handle scene,
                                             const detent_shape2* question, uint32_t layers,
                                             detent_found* found, uint32_t room, uint32_t* count);

/** All pairs of overlapping objects of which at least one moves, sorted by id. Writes the first
 *  `room` of them, and their total number to `count`. */
DETENT_API detent_status detent_scene2_overlaps(const detent_context* context,
                                                  detent_handle scene, detent_pair* pairs,
                                                  uint32_t room, uint32_t* count);

/** The first object in `layers` that a moving shape touches: `detent_cast2` over all objects, for
 *  spheres, AABBs, OBBs, capsules and segments. Among equal distances, the least id. DETENT_NO if
 *  there is none. `hit` may be null. */
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

/** All objects in `layers` that the moving shape touches, sorted by distance, then id. Writes the
 *  first `room` of them, and their total number to `count`. */
DETENT_API detent_status detent_scene2_cast_all(const detent_context* context,
                                                  detent_handle scene,
                                                  const detent_shape2* shape,
                                                  const detent_direction2* direction,
                                                  int32_t max_distance, uint32_t layers,
                                                  detent_object_hit2* hits, uint32_t room,
                                                  uint32_t* count);

/** The default settings: up is y, skin 1/64, step height and snap distance 1/3, slopes up to 50
 *  degrees. */
DETENT_API detent_status detent_mover2_default_settings(detent_mover2_settings* settings);

/** Moves a character by `by`, gravity included, as far as the objects in `layers` other than
 *  `ignored` allow. Its ground carries it and overlaps push it out. On the ground it walks and
 *  climbs steps; in the air it flies and lands; it slides along obstacles. It never ends in a new
 *  overlap. `settings` may be null for the defaults. `result` may be null. DETENT_NO_QUERY for
 *  shapes other than capsules and AABBs. */
DETENT_API detent_status detent_mover2_move(const detent_context* context, detent_handle scene,
                                              detent_mover2* mover, const detent_vec2* by,
                                              const detent_mover2_settings* settings,
                                              uint32_t layers, detent_id ignored,
                                              detent_move2* result);

/** The closest velocity that does not lead into anything the character touched in a move. */
DETENT_API detent_status detent_mover2_clip_velocity(const detent_vec2* velocity,
                                                       const detent_move2* result,
                                                       detent_vec2* clipped);

/** A 64-bit digest of all objects: equal for equal scenes, on every machine. */
DETENT_API detent_status detent_scene2_digest(const detent_context* context, detent_handle scene,
                                                uint64_t* digest);

/** Writes the moving objects as canonical bytes to `bytes` if `room` suffices, and the number of
 *  bytes to `size`. DETENT_NO if it does not: call with room 0 to get the size. */
DETENT_API detent_status detent_scene2_snapshot(const detent_context* context,
                                                  detent_handle scene, void* bytes, uint32_t room,
                                                  uint32_t* size);

/** Replaces the moving objects by those of a snapshot. The context must have its assets. Any bytes
 *  are safe; an error leaves the scene unchanged. */
DETENT_API detent_status detent_scene2_restore(detent_context* context, detent_handle scene,
                                                 const void* bytes, uint32_t size);

/** The default settings: 60 ticks per second with 4 substeps each, gravity -10 along y. */
DETENT_API detent_status detent_world2_default_settings(detent_world2_settings* settings);

/** The default options: dynamic, density 1, friction 3/5, at rest, in layer 1. */
DETENT_API detent_status detent_body2_default_options(detent_body2_options* options);

/** An empty world. `settings` may be null for the defaults. */
DETENT_API detent_status detent_world2_create(detent_context* context,
                                                const detent_world2_settings* settings,
                                                detent_handle* world);

/** Destroys a world. */
DETENT_API detent_status detent_world2_destroy(detent_context* context, detent_handle world);

/** Adds a body: a sphere, AABB, OBB, capsule, solid hull or compound; in 3D also a mesh or height
 *  field, which can only be fixed or kinematic. The scale of `placed` must be 65536. `options` may
 *  be null for the defaults. A compound takes density, friction, restitution and rolling resistance
 *  from its parts. */
DETENT_API detent_status detent_world2_add(detent_context* context, detent_handle world,
                                             const detent_shape2* shape,
                                             const detent_body2_options* options, detent_id* id);

/** Adds a body with an id chosen by the caller, such as that of a removed body. DETENT_NO if its
 *  index is taken or too large, or its generation is 0 or 2^32 - 1. */
DETENT_API detent_status detent_world2_add_as(detent_context* context, detent_handle world,
                                                detent_id id, const detent_shape2* shape,
                                                const detent_body2_options* options);

/** Removes a body and wakes those touching it. DETENT_NO if no body has this id. */
DETENT_API detent_status detent_world2_remove(detent_context* context, detent_handle world,
                                                detent_id id);

/** Simulates one tick: all its substeps. */
DETENT_API detent_status detent_world2_step(detent_context* context, detent_handle world);

/** Makes a scene hold the shapes of the bodies of a world, with their ids, layers and user words, and
 *  nothing else, so that rays, casts, regions and characters find bodies. Call it after each step, or
 *  whenever queries are due. A compound has an object for each part: see `detent_world2_part_of`.
 *  A hull has the handle of its solid hull. Sensors are left out unless `sensors` is 1. DETENT_FULL
 *  if parts of compounds have no room; they are left out. */
DETENT_API detent_status detent_scene2_follow(detent_context* context, detent_handle scene,
                                                detent_handle world, uint32_t sensors);

/** The body, and the index of its part (0 for other bodies than compounds), of an object of a scene
 *  that follows the world. Both may be null. DETENT_NO if it belongs to no body. */
DETENT_API detent_status detent_world2_part_of(const detent_context* context,
                                                 detent_handle world, detent_id object,
                                                 detent_id* body, uint32_t* part);

/** The state of a body. DETENT_NO if no body has this id. */
DETENT_API detent_status detent_world2_body(const detent_context* context, detent_handle world,
                                              detent_id id, detent_body2* body);

/** The states of `count` bodies; zeros for ids that do not exist. */
DETENT_API detent_status detent_world2_bodies(const detent_context* context, detent_handle world,
                                                const detent_id* ids, uint32_t count,
                                                detent_body2* bodies);

/** The pose of the frame in which a hull's points, a compound's parts or a surface's triangles were
 *  given, rounded to nearest, with scale 65536. For other shapes, the body's pose. DETENT_NO if no
 *  body has this id. */
DETENT_API detent_status detent_world2_frame(const detent_context* context, detent_handle world,
                                               detent_id id, detent_transform2* frame);

/** The properties of a body. DETENT_NO if no body has this id. */
DETENT_API detent_status detent_world2_info(const detent_context* context, detent_handle world,
                                              detent_id id, detent_body_info* info);

/** Puts the center of a body elsewhere at once, whatever is between, and wakes it and the bodies that
 *  it touched or is joined to. It keeps its joints, velocity and orientation. Snapshots taken before
 *  a fixed body was moved cannot be restored afterwards. DETENT_NO if no body has this id. */
DETENT_API detent_status detent_world2_set_position(detent_context* context, detent_handle world,
                                                      detent_id id, const detent_vec2* position);

/** Turns a body about its center at once, otherwise like `detent_world2_set_position`. Height
 *  fields stay upright. */
DETENT_API detent_status detent_world2_set_rotation(detent_context* context, detent_handle world,
                                                      detent_id id,
                                                      const detent_rotation2* rotation);

/** Sets the layers of a body and those it collides with, and wakes it and the bodies it touched.
 *  Contacts begin and end in the next step. Snapshots contain what is set; those taken before a fixed
 *  body was changed cannot be restored afterwards. DETENT_NO if no body has this id. */
DETENT_API detent_status detent_world2_set_filter(detent_context* context, detent_handle world,
                                                    detent_id id, uint32_t layers,
                                                    uint32_t collides_with);

/** Sets the friction of a body, in steps of 2^-16 and at least 0, otherwise like
 *  `detent_world2_set_filter`. Compounds use that of their parts. */
DETENT_API detent_status detent_world2_set_friction(detent_context* context, detent_handle world,
                                                      detent_id id, int32_t friction);

/** Sets the restitution of a body, otherwise like `detent_world2_set_friction`. */
DETENT_API detent_status detent_world2_set_restitution(detent_context* context,
                                                         detent_handle world, detent_id id,
                                                         int32_t restitution);

/** Makes a body a sensor (1) or solid (0), otherwise like `detent_world2_set_filter`. */
DETENT_API detent_status detent_world2_set_sensor(detent_context* context, detent_handle world,
                                                    detent_id id, uint32_t is_sensor);

/** Sets a body's factor on the world's gravity, in steps of 2^-16, otherwise like
 *  `detent_world2_set_filter`. */
DETENT_API detent_status detent_world2_set_gravity_scale(detent_context* context,
                                                           detent_handle world, detent_id id,
                                                           int32_t scale);

/** Sets the damping of a body's velocity and of its spin, in steps of 2^-16 and at least 0, otherwise
 *  like `detent_world2_set_filter`. */
DETENT_API detent_status detent_world2_set_damping(detent_context* context, detent_handle world,
                                                     detent_id id, int32_t linear, int32_t angular);

/** Sets the locked axes of a body, DETENT_LOCK_X | ..., otherwise like
 *  `detent_world2_set_filter`. */
DETENT_API detent_status detent_world2_set_locked(detent_context* context, detent_handle world,
                                                    detent_id id, uint32_t locked);

/** Makes a body fast (1) or not (0), otherwise like `detent_world2_set_filter`. */
DETENT_API detent_status detent_world2_set_fast(detent_context* context, detent_handle world,
                                                  detent_id id, uint32_t is_fast);

/** Sets the user word of a body, otherwise like `detent_world2_set_filter`, but wakes nothing. */
DETENT_API detent_status detent_world2_set_user(detent_context* context, detent_handle world,
                                                  detent_id id, uint64_t user);

/** Sets the gravity of the world, in units per second squared, from the next step on, and wakes all
 *  bodies. Snapshots contain it. */
DETENT_API detent_status detent_world2_set_gravity(detent_context* context, detent_handle world,
                                                     const detent_vec2* gravity);

/** Sets the velocity of a body, in units per second, and wakes it. Does nothing to fixed bodies. */
DETENT_API detent_status detent_world2_set_velocity(detent_context* context, detent_handle world,
                                                      detent_id id, const detent_vec2* velocity);

/** Sets the angular velocity of a body (1 numbers, radians per second) and wakes it. */
DETENT_API detent_status detent_world2_set_angular_velocity(detent_context* context,
                                                              detent_handle world, detent_id id,
                                                              const int32_t* velocity);

/** Applies an impulse (mass times units per second) at the world point `at`, or at the center of
 *  mass if null, and wakes the body. Does nothing to bodies that are not dynamic. DETENT_NO if no
 *  body has this id. */
DETENT_API detent_status detent_world2_apply_impulse(detent_context* context, detent_handle world,
                                                       detent_id id, const detent_vec2* impulse,
                                                       const detent_vec2* at);

/** Applies a force (mass times units per second squared) during the next step, otherwise like an
 *  impulse. */
DETENT_API detent_status detent_world2_apply_force(detent_context* context, detent_handle world,
                                                     detent_id id, const detent_vec2* force,
                                                     const detent_vec2* at);

/** Applies a torque (1 numbers, mass times square units per second squared) during the next step
 *  and wakes the body. DETENT_NO if no body has this id. */
DETENT_API detent_status detent_world2_apply_torque(detent_context* context, detent_handle world,
                                                      detent_id id, const int32_t* torque);

/** A joint with the defaults of its kind: bodies {0, 0}, anchors at the centers, no limits, motor
 *  or spring; a distance joint has the limits 0 and 1. */
DETENT_API detent_status detent_joint2_defaults(uint32_t kind, detent_joint2* joint);

/** Adds a joint and wakes its bodies. DETENT_NO if a body does not exist or both are the same,
 *  DETENT_FULL if there is no room, DETENT_BAD_ARGUMENT for a negative force, frequency or ratio.
 *  */
DETENT_API detent_status detent_world2_add_joint(detent_context* context, detent_handle world,
                                                   const detent_joint2* joint, detent_id* id);

/** Replaces a joint by another of the same kind, for example with another motor, and wakes its
 *  bodies. Its impulses are kept. DETENT_NO if no joint of this kind has this id, or a body does
 *  not exist. */
DETENT_API detent_status detent_world2_change_joint(detent_context* context, detent_handle world,
                                                      detent_id id, const detent_joint2* joint);

/** Removes a joint and wakes its bodies. DETENT_NO if no joint has this id. */
DETENT_API detent_status detent_world2_remove_joint(detent_context* context, detent_handle world,
                                                      detent_id id);

/** A joint as it was added or last replaced. DETENT_NO if no joint has this id. */
DETENT_API detent_status detent_world2_joint(const detent_context* context, detent_handle world,
                                               detent_id id, detent_joint2* joint);

/** The force of a joint on body b, in mass times units per second squared; on body a it is the
 *  opposite. It comes from the impulses of the last substep that solved the joint, along their
 *  directions now, and is zero before the first step. The joint breaks when it is longer than
 *  `break_force`. DETENT_NO if no joint has this id. */
DETENT_API detent_status detent_world2_joint_force(const detent_context* context,
                                                     detent_handle world, detent_id id,
                                                     detent_vec2* force);

/** The torque of a joint on body b (1 numbers, mass times square units per second squared) by its
 *  motor, limits and alignment, without that of its force; otherwise like
 *  `detent_world2_joint_force`. It breaks no joint. DETENT_NO if no joint has this id. */
DETENT_API detent_status detent_world2_joint_torque(const detent_context* context,
                                                      detent_handle world, detent_id id,
                                                      int32_t* torque);

/** The number of joints in the world. */
DETENT_API detent_status detent_world2_joint_count(const detent_context* context,
                                                     detent_handle world, uint32_t* count);

/** The ids of all joints, by index. Writes the first `room` of them, and their total number to
 *  `count`. */
DETENT_API detent_status detent_world2_joint_ids(const detent_context* context,
                                                   detent_handle world, detent_id* joints,
                                                   uint32_t room, uint32_t* count);

/** The joints that broke in the last step, by index. They have been removed. Writes the first
 *  `room` of them, and their total number to `count`. */
DETENT_API detent_status detent_world2_broken(const detent_context* context, detent_handle world,
                                                detent_id* joints, uint32_t room, uint32_t* count);

/** Converts a world point to the body's frame, rounded to nearest, for the anchor of a joint.
 *  DETENT_NO if no body has this id. */
DETENT_API detent_status detent_world2_local_point(const detent_context* context,
                                                     detent_handle world, detent_id id,
                                                     const detent_vec2* point,
                                                     detent_vec2* local);

/** Converts world axes to the body's frame, rounded to nearest, for the frame of a joint. DETENT_NO
 *  if no body has this id. */
DETENT_API detent_status detent_world2_local_frame(const detent_context* context,
                                                     detent_handle world, detent_id id,
                                                     const detent_rotation2* frame,
                                                     detent_rotation2* local);

/** The number of bodies in the world. */
DETENT_API detent_status detent_world2_size(const detent_context* context, detent_handle world,
                                              uint32_t* size);

/** The ids of all bodies, by index. Writes the first `room` of them, and their total number to
 *  `count`. */
DETENT_API detent_status detent_world2_body_ids(const detent_context* context,
                                                  detent_handle world, detent_id* ids,
                                                  uint32_t room, uint32_t* count);

/** The pairs that touch: those that began to in some step and have not ceased, sorted by id; of one
 *  body, or of all if `body` is {0, 0}. Their `begins` is 1. Writes the first `room` of them, and
 *  their total number to `count`. */
DETENT_API detent_status detent_world2_touching(const detent_context* context,
                                                  detent_handle world, detent_id body,
                                                  detent_touch* touches, uint32_t room,
                                                  uint32_t* count);

/** The contacts that touch, sorted by id, part and triangle; of one body, or of all if `body` is
 *  {0, 0}; none of sensors. Their normals and points are computed from the current poses, as the next
 *  step would find them. Writes the first `room` of them, and their number to `count`. */
DETENT_API detent_status detent_world2_contacts(const detent_context* context,
                                                  detent_handle world, detent_id body,
                                                  detent_world2_contact* contacts, uint32_t room,
                                                  uint32_t* count);

/** The pairs that began or ceased to touch in the last step, sorted by id. A pair of a sensor and a
 *  fast body that passed it within the step has both events. Writes the first `room` of them, and
 *  their total number to `count`. */
DETENT_API detent_status detent_world2_events(const detent_context* context, detent_handle world,
                                                detent_touch* events, uint32_t room,
                                                uint32_t* count);

/** A 64-bit digest of gravity and all bodies that are not fixed, their contacts and joints. */
DETENT_API detent_status detent_world2_digest(const detent_context* context, detent_handle world,
                                                uint64_t* digest);

/** A 64-bit digest of one body. DETENT_NO if no body has this id. */
DETENT_API detent_status detent_world2_digest_of(const detent_context* context,
                                                   detent_handle world, detent_id id,
                                                   uint64_t* digest);

/** Writes all bodies that are not fixed as canonical bytes to `bytes` if `room` suffices, and the
 *  number of bytes to `size`. DETENT_NO if it does not: call with room 0 to get the size. */
DETENT_API detent_status detent_world2_snapshot(const detent_context* context,
                                                  detent_handle world, void* bytes, uint32_t room,
                                                  uint32_t* size);

/** Restores a snapshot taken from a world with the same fixed bodies and settings; only its gravity
 *  may differ, and is restored. The context must have its assets. Any bytes are safe; an error leaves
 *  the world unchanged. */
DETENT_API detent_status detent_world2_restore(detent_context* context, detent_handle world,
                                                 const void* bytes, uint32_t size);

/** Names the first fields in which two worlds differ, at most `most`, such as `body 3:17 (sphere)
 *  velocity.y`, each followed by a line feed. Writes as much as `room` holds to `names`, and the
 *  total size to `size`. DETENT_NO if all fields are equal. */
DETENT_API detent_status detent_world2_diff(const detent_context* context, detent_handle a,
                                              detent_handle b, uint32_t most, void* names,
                                              uint32_t room, uint32_t* size);

/** `detent_world2_diff` for two scenes: `object 1:2 (sphere) center.y`. */
DETENT_API detent_status detent_scene2_diff(const detent_context* context, detent_handle a,
                                              detent_handle b, uint32_t most, void* names,
                                              uint32_t room, uint32_t* size);

/** A session of a match. Every peer starts it from an equal `world`, which is copied. No asset that
 *  a body of it could use can be destroyed before the session is. */
DETENT_API detent_status detent_session2_create(detent_context* context,
                                                  const detent_session_settings* settings,
                                                  detent_handle world, detent_handle* session);

/** Destroys a session and its world. */
DETENT_API detent_status detent_session2_destroy(detent_context* context, detent_handle session);

/** The world of a session, for all functions of worlds. It can be changed only while a frame is
 *  open; between frames it is the world after the last simulated frame. */
DETENT_API detent_status detent_session2_world(const detent_context* context,
                                                 detent_handle session, detent_handle* world);

/** Takes a packet that your transport received from `peer` at the time `now`. Any bytes are safe.
 *  DETENT_NO if it was not used: another match, malformed, or from a dropped peer. */
DETENT_API detent_status detent_session2_receive(detent_context* context, detent_handle session,
                                                   uint32_t peer, const void* bytes, uint32_t size,
                                                   uint64_t now);

/** Opens the next frame that is due. Simulate it: change the session's world depending only on the
 *  inputs, step it, and call `detent_session2_end_frame`. Repeat with the same input until no
 *  frame is due. Frames come again after a wrong prediction of inputs. `inputs` receives
 *  `input_size` bytes for each player. DETENT_NO if no frame is due; `frame` says why. A frame that
 *  was opened but not ended is opened again in its original state. */
DETENT_API detent_status detent_session2_begin_frame(detent_context* context,
                                                       detent_handle session, const void* input,
                                                       detent_frame* frame, void* inputs);

/** Ends the open frame. DETENT_NOT_NOW if none is open. */
DETENT_API detent_status detent_session2_end_frame(detent_context* context,
                                                     detent_handle session);

/** The next packet due at the time `now`, at most one per peer, to be sent to `peer`. Repeat until
 *  there is none. `room` must be at least DETENT_PACKET. */
DETENT_API detent_status detent_session2_packet(detent_context* context, detent_handle session,
                                                  uint64_t now, uint32_t* peer, void* bytes,
                                                  uint32_t room, uint32_t* size);

/** The next event, oldest first; DETENT_NO if there is none. Writes as much of the field's name as
 *  `room` holds; DETENT_NAME bytes hold any name. */
DETENT_API detent_status detent_session2_event(detent_context* context, detent_handle session,
                                                 detent_session_event* event, void* name,
                                                 uint32_t room);

/** The progress of the session. */
DETENT_API detent_status detent_session2_status(const detent_context* context,
                                                  detent_handle session,
                                                  detent_session_status* status);

/** The number of frames known to be equal at `peer` and here: all frames before `frame`. */
DETENT_API detent_status detent_session2_matched(const detent_context* context,
                                                   detent_handle session, uint32_t peer,
                                                   uint32_t* frame);

/** Whether the session waits for this player. */
DETENT_API detent_status detent_session2_is_awaited(const detent_context* context,
                                                      detent_handle session, uint32_t player);

/** Continues without a peer. All remaining peers agree on the first frame without that player. */
DETENT_API detent_status detent_session2_drop(detent_context* context, detent_handle session,
                                                uint32_t peer);

/** Pauses (1) or resumes (0) the match for all peers. */
DETENT_API detent_status detent_session2_pause(detent_context* context, detent_handle session,
                                                 uint32_t is_paused);

/** Writes the replay of all final frames so far to `bytes` if `room` suffices, and its size to
 *  `size`. DETENT_NO if it does not, or if the session records none, as after joining late: then
 *  the size is 0. */
DETENT_API detent_status detent_session2_replay(const detent_context* context,
                                                  detent_handle session, void* bytes, uint32_t room,
                                                  uint32_t* size);

/** The words next to the world of a session or replay: other game state that a rollback restores.
 *  Their number is in the settings. All are 0 before the first frame. DETENT_NO for a world outside
 *  sessions and replays. */
DETENT_API detent_status detent_world2_words(const detent_context* context, detent_handle world,
                                               uint32_t* words);

/** Sets the words, in an open frame. */
DETENT_API detent_status detent_world2_set_words(detent_context* context, detent_handle world,
                                                   const uint32_t* words);

/** A replay to be resimulated. `world` must have the settings and fixed bodies of the session's
 *  world at its start; `input_size` and `words` are the session's. Any bytes are safe.
 *  DETENT_NO_SNAPSHOT if they are not a replay, DETENT_OTHER_SCENE if the inputs have another size,
 *  DETENT_OTHER_VERSION if it was recorded with another version of the results; otherwise the
 *  status of `detent_world2_restore` for its start. */
DETENT_API detent_status detent_replay2_create(detent_context* context, const void* bytes,
                                                 uint32_t size, detent_handle world,
                                                 uint32_t input_size, uint32_t words,
                                                 detent_handle* replay);

/** Destroys a replay and its world. */
DETENT_API detent_status detent_replay2_destroy(detent_context* context, detent_handle replay);

/** The world of a replay, used like that of a session. */
DETENT_API detent_status detent_replay2_world(const detent_context* context, detent_handle replay,
                                                detent_handle* world);

/** Opens the next frame; simulate it as in a session. DETENT_NO at the end, or once a digest
 *  differs. A frame that was opened but not ended continues. */
DETENT_API detent_status detent_replay2_begin_frame(detent_context* context, detent_handle replay,
                                                      detent_frame* frame, void* inputs);

/** Ends the open frame. DETENT_NOT_NOW if none is open. */
DETENT_API detent_status detent_replay2_end_frame(detent_context* context, detent_handle replay);

/** The result of the resimulation so far. */
DETENT_API detent_status detent_replay2_check(const detent_context* context, detent_handle replay,
                                                detent_replay_check* check);

/** Whether the ray touches the shape, and where. `hit` may be null. The distance is 0 if the ray
 *  starts inside. For the kinds DETENT_SPHERE to DETENT_SEGMENT. */
DETENT_API detent_status detent_raycast3(const detent_ray3* ray, const detent_shape3* shape,
                                           detent_hit3* hit);

/** Raycasts `count` rays against one shape and writes their distances, -1 for a miss. The first
 *  direction that is not unit length stops it with DETENT_NOT_UNIT. */
DETENT_API detent_status detent_raycast3_many(const detent_ray3* rays, uint32_t count,
                                                const detent_shape3* shape, int32_t* distances);

/** Whether the point is in the shape or on its surface. Exact. */
DETENT_API detent_status detent_contains3(const detent_shape3* shape, const detent_vec3* point);

/** Whether two shapes share a point. Exact. */
DETENT_API detent_status detent_overlaps3(const detent_shape3* a, const detent_shape3* b);

/** The closest point of the shape to `point`, each coordinate rounded to nearest. */
DETENT_API detent_status detent_closest_point3(const detent_shape3* shape,
                                                 const detent_vec3* point,
                                                 detent_vec3* closest);

/** The distance from the shape to `point`, rounded down; INT32_MAX if the shape is empty. */
DETENT_API detent_status detent_distance_to_point3(const detent_shape3* shape,
                                                     const detent_vec3* point,
                                                     int32_t* distance);

/** The distance between two shapes, rounded down; 0 if they share a point. */
DETENT_API detent_status detent_distance3(const detent_shape3* a, const detent_shape3* b,
                                            int32_t* distance);

/** The contact of two overlapping shapes; touching counts. DETENT_NO if they are disjoint.
 *  `contact` may be null. For the kinds DETENT_SPHERE to DETENT_SEGMENT, except two planes. */
DETENT_API detent_status detent_contact3(const detent_shape3* a, const detent_shape3* b,
                                           detent_manifold3* contact);

/** The closest points of a and b to each other, each coordinate rounded to nearest: the same point
 *  twice where they meet. Among several pairs, the one whose point of a has the least x, then y,
 *  then z. Both are the origin if a shape is empty. For the kinds DETENT_SPHERE to DETENT_SEGMENT.
 *  */
DETENT_API detent_status detent_closest_points3(const detent_shape3* a,
                                                  const detent_shape3* b,
                                                  detent_vec3* point_a,
                                                  detent_vec3* point_b);

/** The first contact of `shape`, moving along `direction` by at most `max_distance`, with `target`:
 *  the distance moved, rounded down, the point of the target, and the normal there, facing the
 *  shape. DETENT_NO if it touches nothing. The distance is 0 if they share a point at the start.
 *  `hit` may be null. For the kinds DETENT_SPHERE to DETENT_SEGMENT; a plane cannot be the moving
 *  shape. */
DETENT_API detent_status detent_cast3(const detent_shape3* shape,
                                        const detent_direction3* direction, int32_t max_distance,
                                        const detent_shape3* target, detent_hit3* hit);

/** The time, rounded down, at which two moving shapes first come closer than `target` (a length;
 *  usually 8). Each shape is given in the frame that its sweep moves. DETENT_NO if they stay apart.
 *  `sweep_b` may be null if b does not move, and must be null for a plane. `impact` may be null.
 *  For the kinds DETENT_SPHERE to DETENT_CAPSULE. */
DETENT_API detent_status detent_time_of_impact3(const detent_shape3* a,
                                                  const detent_sweep3* sweep_a,
                                                  const detent_shape3* b,
                                                  const detent_sweep3* sweep_b, int32_t target,
                                                  detent_impact* impact);

/** Whether the point is on the ray. Exact. */
DETENT_API detent_status detent_ray3_contains(const detent_ray3* ray, const detent_vec3* point);

/** The closest point of the ray to `point`, each coordinate rounded to nearest. */
DETENT_API detent_status detent_ray3_closest_point(const detent_ray3* ray,
                                                     const detent_vec3* point,
                                                     detent_vec3* closest);

/** The distance from the ray to `point`, rounded down. */
DETENT_API detent_status detent_ray3_distance_to_point(const detent_ray3* ray,
                                                         const detent_vec3* point,
                                                         int32_t* distance);

/** The first point where the ray touches any of `count` shapes; among equal distances, the first in
 *  the list. Functions of `detent_shapes3` treat a list of shapes, possibly empty, as their
 *  union. They take the kinds DETENT_SPHERE to DETENT_SEGMENT and DETENT_HULL of `context`, whose
 *  transformed points are rounded to nearest. `context` may be null if there is no hull. `hit` may
 *  be null. */
DETENT_API detent_status detent_shapes3_raycast(const detent_context* context,
                                                  const detent_ray3* ray,
                                                  const detent_shape3* shapes, uint32_t count,
                                                  detent_hit3* hit);

/** Whether the point is in any of the shapes. Exact. */
DETENT_API detent_status detent_shapes3_contains(const detent_context* context,
                                                   const detent_shape3* shapes, uint32_t count,
                                                   const detent_vec3* point);

/** Whether any shape of one list shares a point with any shape of the other. Exact. */
DETENT_API detent_status detent_shapes3_overlaps(const detent_context* context,
                                                   const detent_shape3* a, uint32_t a_count,
                                                   const detent_shape3* b, uint32_t b_count);

/** The closest point of the nearest shape to `point`, each coordinate rounded to nearest. Among
 *  equal distances, rounded down, the first shape. `point` itself if there are no shapes. */
DETENT_API detent_status detent_shapes3_closest_point(const detent_context* context,
                                                        const detent_shape3* shapes,
                                                        uint32_t count, const detent_vec3* point,
                                                        detent_vec3* closest);

/** The distance from the nearest shape to `point`, rounded down; INT32_MAX if there are no shapes.
 *  */
DETENT_API detent_status detent_shapes3_distance_to_point(const detent_context* context,
                                                            const detent_shape3* shapes,
                                                            uint32_t count,
                                                            const detent_vec3* point,
                                                            int32_t* distance);

/** The least distance between a shape of one list and one of the other, rounded down; 0 if they
 *  share a point, INT32_MAX if a list is empty. */
DETENT_API detent_status detent_shapes3_distance(const detent_context* context,
                                                   const detent_shape3* a, uint32_t a_count,
                                                   const detent_shape3* b, uint32_t b_count,
                                                   int32_t* distance);

/** The closest points of the nearest two shapes, each coordinate rounded to nearest. Among equal
 *  distances, rounded down, the first shape of a, then of b; among several pairs of points, the one
 *  whose point of b has the least x, then y, then z. Both are the origin if a list is empty. */
DETENT_API detent_status detent_shapes3_closest_points(const detent_context* context,
                                                         const detent_shape3* a, uint32_t a_count,
                                                         const detent_shape3* b, uint32_t b_count,
                                                         detent_vec3* point_a,
                                                         detent_vec3* point_b);

/** `detent_cast3` of one moving shape, possibly a hull, against `count` shapes; among equal
 *  distances, the first. `hit` may be null. */
DETENT_API detent_status detent_shapes3_cast(const detent_context* context,
                                               const detent_shape3* shape,
                                               const detent_direction3* direction,
                                               int32_t max_distance,
                                               const detent_shape3* targets, uint32_t count,
                                               detent_hit3* hit);

/** `detent_contact3` of two shapes, each possibly a hull. `contact` may be null. */
DETENT_API detent_status detent_shapes3_contact(const detent_context* context,
                                                  const detent_shape3* a,
                                                  const detent_shape3* b,
                                                  detent_manifold3* contact);

/** `detent_time_of_impact3` of two shapes, each possibly a hull. `sweep_b` and `impact` may be
 *  null. */
DETENT_API detent_status detent_shapes3_time_of_impact(const detent_context* context,
                                                         const detent_shape3* a,
                                                         const detent_sweep3* sweep_a,
                                                         const detent_shape3* b,
                                                         const detent_sweep3* sweep_b,
                                                         int32_t target, detent_impact* impact);

/** The convex hull of at most 64 points in any order. Copies them. `id` as for meshes. */
DETENT_API detent_status detent_hull3_create(detent_context* context, uint32_t id,
                                               const detent_vec3* points, uint32_t count,
                                               detent_handle* hull);

/** The convex hull of at most 32 points, for bodies. A body's position is the hull's center of
 *  mass. A context holds 64. DETENT_BAD_ARGUMENT if the hull has no volume. Copies the points. `id`
 *  as for meshes. */
DETENT_API detent_status detent_solid3_create(detent_context* context, uint32_t id,
                                                const detent_vec3* points, uint32_t count,
                                                detent_handle* solid);

/** A part with defaults: density 1, friction 3/5, no restitution, no rolling resistance, not a
 *  sensor. Its shape is a point without mass; set it. */
DETENT_API detent_status detent_part3_defaults(detent_part3* part);

/** A compound of 1 to 65536 parts that are fixed to each other, for bodies. A body's position is
 *  the common center of mass. Masses add where parts overlap. A context holds 256. Copies the
 *  parts; their solid hulls stay in use. DETENT_NO_QUERY for other kinds of shape. `id` as for
 *  meshes. */
DETENT_API detent_status detent_compound3_create(detent_context* context, uint32_t id,
                                                   const detent_part3* parts, uint32_t count,
                                                   detent_handle* compound);

/** An empty scene. Scenes store every kind of shape except segments and points. */
DETENT_API detent_status detent_scene3_create(detent_context* context, detent_handle* scene);

/** Destroys a scene. */
DETENT_API detent_status detent_scene3_destroy(detent_context* context, detent_handle scene);

/** Adds an object. `traits` may be null: layer 1, user 0, moving, in no frame. DETENT_FULL beyond
 *  1,048,576 objects, DETENT_NO if the frame does not exist, DETENT_BAD_ARGUMENT for a fixed object
 *  in a frame. */
DETENT_API detent_status detent_scene3_add(detent_context* context, detent_handle scene,
                                             const detent_shape3* shape,
                                             const detent_traits* traits, detent_id* id);

/** Adds an object with an id chosen by the caller. DETENT_NO if its index is taken or too large, or
 *  its generation is 0 or 2^32 - 1. */
DETENT_API detent_status detent_scene3_add_as(detent_context* context, detent_handle scene,
                                                detent_id id, const detent_shape3* shape,
                                                const detent_traits* traits);

/** Removes an object. DETENT_NO if no object has this id. */
DETENT_API detent_status detent_scene3_remove(detent_context* context, detent_handle scene,
                                                detent_id id);

/** Replaces the shape of an object, given in its frame. DETENT_NO if no object has this id. */
DETENT_API detent_status detent_scene3_replace(detent_context* context, detent_handle scene,
                                                 detent_id id, const detent_shape3* shape);

/** Translates an object, clamping its coordinates. DETENT_NO if no object has this id. */
DETENT_API detent_status detent_scene3_move(detent_context* context, detent_handle scene,
                                              detent_id id, const detent_vec3* by);

/** The shape of an object in world space, and its traits. Both may be null. DETENT_NO if no object
 *  has this id. */
DETENT_API detent_status detent_scene3_object(const detent_context* context, detent_handle scene,
                                                detent_id id, detent_shape3* shape,
                                                detent_traits* traits);

/** Sets layers and user word of an object. Its motion cannot change; that field is ignored. */
DETENT_API detent_status detent_scene3_set_traits(detent_context* context, detent_handle scene,
                                                    detent_id id, const detent_traits* traits);

/** Adds a frame for objects, inside `parent`; {0, 0} is the world. DETENT_NO if the parent does not
 *  exist, DETENT_FULL if there is no room. */
DETENT_API detent_status detent_scene3_add_frame(detent_context* context, detent_handle scene,
                                                   const detent_transform3* transform,
                                                   detent_id parent, detent_id* frame);

/** Moves a frame within its parent, with everything in it. DETENT_NO if no frame has this id. */
DETENT_API detent_status detent_scene3_move_frame(detent_context* context, detent_handle scene,
                                                    detent_id frame,
                                                    const detent_transform3* transform);

/** Removes a frame. DETENT_NO if no frame has this id, or the frame is not empty. */
DETENT_API detent_status detent_scene3_remove_frame(detent_context* context, detent_handle scene,
                                                      detent_id frame);

/** The transforms from a frame to its parent and to the world. Both may be null. DETENT_NO if no
 *  frame has this id. */
DETENT_API detent_status detent_scene3_frame(const detent_context* context, detent_handle scene,
                                               detent_id frame, detent_transform3* local,
                                               detent_transform3* world);

/** The number of objects in the scene. */
DETENT_API detent_status detent_scene3_size(const detent_context* context, detent_handle scene,
                                              uint32_t* size);

/** Speeds up queries after many additions, such as loading a level. Never changes a result. */
DETENT_API detent_status detent_scene3_optimize(detent_context* context, detent_handle scene);

/** The first object in `layers` that the ray touches; among equal distances, the least id. `hit`
 *  may be null. */
DETENT_API detent_status detent_scene3_raycast(const detent_context* context, detent_handle scene,
                                                 const detent_ray3* ray, uint32_t layers,
                                                 detent_object_hit3* hit);

/** Whether the ray touches any object in `layers`. */
DETENT_API detent_status detent_scene3_raycast_any(const detent_context* context,
                                                     detent_handle scene, const detent_ray3* ray,
                                                     uint32_t layers);

/** All objects in `layers` that the ray touches, sorted by distance, then id. Writes the first
 *  `room` of them, and their total number to `count`. */
DETENT_API detent_status detent_scene3_raycast_all(const detent_context* context,
                                                     detent_handle scene, const detent_ray3* ray,
                                                     uint32_t layers, detent_object_hit3* hits,
                                                     uint32_t room, uint32_t* count);

/** `detent_scene3_raycast` for many rays. A miss has id {0, 0} and distance -1. The first
 *  direction that is not unit length stops it with DETENT_NOT_UNIT. */
DETENT_API detent_status detent_scene3_raycast_many(const detent_context* context,
                                                      detent_handle scene, const detent_ray3* rays,
                                                      uint32_t count, uint32_t layers,
                                                      detent_object_hit3* hits);

/** The object in `layers` nearest to a point, however far. For a sphere, AABB, OBB, capsule or
 *  segment: of the objects that it overlaps, the nearest to its center, start or end a. `found` may
 *  be null. */
DETENT_API detent_status detent_scene3_nearest(const detent_context* context, detent_handle scene,
                                                 const detent_shape3* question, uint32_t layers,
                                                 detent_found* found);

/** Whether the point, sphere, AABB, OBB, capsule or segment overlaps any object in `layers`. */
DETENT_API detent_status detent_scene3_any(const detent_context* context, detent_handle scene,
                                             const detent_shape3* question, uint32_t layers);

/** All objects in `layers` that the point, sphere, AABB, OBB, capsule or segment overlaps, sorted
 *  by distance, then id. Writes the first `room` of them, and their total number to `count`. */
DETENT_API detent_status detent_scene3_all(const detent_context* context, detent_handle scene,
                                             const detent_shape3* question, uint32_t layers,
                                             detent_found* found, uint32_t room, uint32_t* count);

/** All pairs of overlapping objects of which at least one moves, sorted by id. Writes the first
 *  `room` of them, and their total number to `count`. */
DETENT_API detent_status detent_scene3_overlaps(const detent_context* context,
                                                  detent_handle scene, detent_pair* pairs,
                                                  uint32_t room, uint32_t* count);

/** The first object in `layers` that a moving shape touches: `detent_cast3` over all objects, for
 *  spheres, AABBs, OBBs, capsules and segments. Among equal distances, the least id. DETENT_NO if
 *  there is none. `hit` may be null. */
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

/** All objects in `layers` that the moving shape touches, sorted by distance, then id. Writes the
 *  first `room` of them, and their total number to `count`. */
DETENT_API detent_status detent_scene3_cast_all(const detent_context* context,
                                                  detent_handle scene,
                                                  const detent_shape3* shape,
                                                  const detent_direction3* direction,
                                                  int32_t max_distance, uint32_t layers,
                                                  detent_object_hit3* hits, uint32_t room,
                                                  uint32_t* count);

/** The default settings: up is y, skin 1/64, step height and snap distance 1/3, slopes up to 50
 *  degrees. */
DETENT_API detent_status detent_mover3_default_settings(detent_mover3_settings* settings);

/** Moves a character by `by`, gravity included, as far as the objects in `layers` other than
 *  `ignored` allow. Its ground carries it and overlaps push it out. On the ground it walks and
 *  climbs steps; in the air it flies and lands; it slides along obstacles. It never ends in a new
 *  overlap. `settings` may be null for the defaults. `result` may be null. DETENT_NO_QUERY for
 *  shapes other than capsules and AABBs. */
DETENT_API detent_status detent_mover3_move(const detent_context* context, detent_handle scene,
                                              detent_mover3* mover, const detent_vec3* by,
                                              const detent_mover3_settings* settings,
                                              uint32_t layers, detent_id ignored,
                                              detent_move3* result);

/** The closest velocity that does not lead into anything the character touched in a move. */
DETENT_API detent_status detent_mover3_clip_velocity(const detent_vec3* velocity,
                                                       const detent_move3* result,
                                                       detent_vec3* clipped);

/** A 64-bit digest of all objects: equal for equal scenes, on every machine. */
DETENT_API detent_status detent_scene3_digest(const detent_context* context, detent_handle scene,
                                                uint64_t* digest);

/** Writes the moving objects as canonical bytes to `bytes` if `room` suffices, and the number of
 *  bytes to `size`. DETENT_NO if it does not: call with room 0 to get the size. */
DETENT_API detent_status detent_scene3_snapshot(const detent_context* context,
                                                  detent_handle scene, void* bytes, uint32_t room,
                                                  uint32_t* size);

/** Replaces the moving objects by those of a snapshot. The context must have its assets. Any bytes
 *  are safe; an error leaves the scene unchanged. */
DETENT_API detent_status detent_scene3_restore(detent_context* context, detent_handle scene,
                                                 const void* bytes, uint32_t size);

/** The default settings: 60 ticks per second with 4 substeps each, gravity -10 along y. */
DETENT_API detent_status detent_world3_default_settings(detent_world3_settings* settings);

/** The default options: dynamic, density 1, friction 3/5, at rest, in layer 1. */
DETENT_API detent_status detent_body3_default_options(detent_body3_options* options);

/** An empty world. `settings` may be null for the defaults. */
DETENT_API detent_status detent_world3_create(detent_context* context,
                                                const detent_world3_settings* settings,
                                                detent_handle* world);

/** Destroys a world. */
DETENT_API detent_status detent_world3_destroy(detent_context* context, detent_handle world);

/** Adds a body: a sphere, AABB, OBB, capsule, solid hull or compound; in 3D also a mesh or height
 *  field, which can only be fixed or kinematic. The scale of `placed` must be 65536. `options` may
 *  be null for the defaults. A compound takes density, friction, restitution and rolling resistance
 *  from its parts. */
DETENT_API detent_status detent_world3_add(detent_context* context, detent_handle world,
                                             const detent_shape3* shape,
                                             const detent_body3_options* options, detent_id* id);

/** Adds a body with an id chosen by the caller, such as that of a removed body. DETENT_NO if its
 *  index is taken or too large, or its generation is 0 or 2^32 - 1. */
DETENT_API detent_status detent_world3_add_as(detent_context* context, detent_handle world,
                                                detent_id id, const detent_shape3* shape,
                                                const detent_body3_options* options);

/** Removes a body and wakes those touching it. DETENT_NO if no body has this id. */
DETENT_API detent_status detent_world3_remove(detent_context* context, detent_handle world,
                                                detent_id id);

/** Simulates one tick: all its substeps. */
DETENT_API detent_status detent_world3_step(detent_context* context, detent_handle world);

/** Makes a scene hold the shapes of the bodies of a world, with their ids, layers and user words, and
 *  nothing else, so that rays, casts, regions and characters find bodies. Call it after each step, or
 *  whenever queries are due. A compound has an object for each part: see `detent_world3_part_of`.
 *  A hull has the handle of its solid hull. Sensors are left out unless `sensors` is 1. DETENT_FULL
 *  if parts of compounds have no room; they are left out. */
DETENT_API detent_status detent_scene3_follow(detent_context* context, detent_handle scene,
                                                detent_handle world, uint32_t sensors);

/** The body, and the index of its part (0 for other bodies than compounds), of an object of a scene
 *  that follows the world. Both may be null. DETENT_NO if it belongs to no body. */
DETENT_API detent_status detent_world3_part_of(const detent_context* context,
                                                 detent_handle world, detent_id object,
                                                 detent_id* body, uint32_t* part);

/** The state of a body. DETENT_NO if no body has this id. */
DETENT_API detent_status detent_world3_body(const detent_context* context, detent_handle world,
                                              detent_id id, detent_body3* body);

/** The states of `count` bodies; zeros for ids that do not exist. */
DETENT_API detent_status detent_world3_bodies(const detent_context* context, detent_handle world,
                                                const detent_id* ids, uint32_t count,
                                                detent_body3* bodies);

/** The pose of the frame in which a hull's points, a compound's parts or a surface's triangles were
 *  given, rounded to nearest, with scale 65536. For other shapes, the body's pose. DETENT_NO if no
 *  body has this id. */
DETENT_API detent_status detent_world3_frame(const detent_context* context, detent_handle world,
                                               detent_id id, detent_transform3* frame);

/** The properties of a body. DETENT_NO if no body has this id. */
DETENT_API detent_status detent_world3_info(const detent_context* context, detent_handle world,
                                              detent_id id, detent_body_info* info);

/** Puts the center of a body elsewhere at once, whatever is between, and wakes it and the bodies that
 *  it touched or is joined to. It keeps its joints, velocity and orientation. Snapshots taken before
 *  a fixed body was moved cannot be restored afterwards. DETENT_NO if no body has this id. */
DETENT_API detent_status detent_world3_set_position(detent_context* context, detent_handle world,
                                                      detent_id id, const detent_vec3* position);

/** Turns a body about its center at once, otherwise like `detent_world3_set_position`. Height
 *  fields stay upright. */
DETENT_API detent_status detent_world3_set_rotation(detent_context* context, detent_handle world,
                                                      detent_id id,
                                                      const detent_rotation3* rotation);

/** Sets the layers of a body and those it collides with, and wakes it and the bodies it touched.
 *  Contacts begin and end in the next step. Snapshots contain what is set; those taken before a fixed
 *  body was changed cannot be restored afterwards. DETENT_NO if no body has this id. */
DETENT_API detent_status detent_world3_set_filter(detent_context* context, detent_handle world,
                                                    detent_id id, uint32_t layers,
                                                    uint32_t collides_with);

/** Sets the friction of a body, in steps of 2^-16 and at least 0, otherwise like
 *  `detent_world3_set_filter`. Compounds use that of their parts. */
DETENT_API detent_status detent_world3_set_friction(detent_context* context, detent_handle world,
                                                      detent_id id, int32_t friction);

/** Sets the restitution of a body, otherwise like `detent_world3_set_friction`. */
DETENT_API detent_status detent_world3_set_restitution(detent_context* context,
                                                         detent_handle world, detent_id id,
                                                         int32_t restitution);

/** Makes a body a sensor (1) or solid (0), otherwise like `detent_world3_set_filter`. */
DETENT_API detent_status detent_world3_set_sensor(detent_context* context, detent_handle world,
                                                    detent_id id, uint32_t is_sensor);

/** Sets a body's factor on the world's gravity, in steps of 2^-16, otherwise like
 *  `detent_world3_set_filter`. */
DETENT_API detent_status detent_world3_set_gravity_scale(detent_context* context,
                                                           detent_handle world, detent_id id,
                                                           int32_t scale);

/** Sets the damping of a body's velocity and of its spin, in steps of 2^-16 and at least 0, otherwise
 *  like `detent_world3_set_filter`. */
DETENT_API detent_status detent_world3_set_damping(detent_context* context, detent_handle world,
                                                     detent_id id, int32_t linear, int32_t angular);

/** Sets the locked axes of a body, DETENT_LOCK_X | ..., otherwise like
 *  `detent_world3_set_filter`. */
DETENT_API detent_status detent_world3_set_locked(detent_context* context, detent_handle world,
                                                    detent_id id, uint32_t locked);

/** Makes a body fast (1) or not (0), otherwise like `detent_world3_set_filter`. */
DETENT_API detent_status detent_world3_set_fast(detent_context* context, detent_handle world,
                                                  detent_id id, uint32_t is_fast);

/** Sets the user word of a body, otherwise like `detent_world3_set_filter`, but wakes nothing. */
DETENT_API detent_status detent_world3_set_user(detent_context* context, detent_handle world,
                                                  detent_id id, uint64_t user);

/** Sets the gravity of the world, in units per second squared, from the next step on, and wakes all
 *  bodies. Snapshots contain it. */
DETENT_API detent_status detent_world3_set_gravity(detent_context* context, detent_handle world,
                                                     const detent_vec3* gravity);

/** Sets the velocity of a body, in units per second, and wakes it. Does nothing to fixed bodies. */
DETENT_API detent_status detent_world3_set_velocity(detent_context* context, detent_handle world,
                                                      detent_id id, const detent_vec3* velocity);

/** Sets the angular velocity of a body (3 numbers, radians per second) and wakes it. */
DETENT_API detent_status detent_world3_set_angular_velocity(detent_context* context,
                                                              detent_handle world, detent_id id,
                                                              const int32_t* velocity);

/** Applies an impulse (mass times units per second) at the world point `at`, or at the center of
 *  mass if null, and wakes the body. Does nothing to bodies that are not dynamic. DETENT_NO if no
 *  body has this id. */
DETENT_API detent_status detent_world3_apply_impulse(detent_context* context, detent_handle world,
                                                       detent_id id, const detent_vec3* impulse,
                                                       const detent_vec3* at);

/** Applies a force (mass times units per second squared) during the next step, otherwise like an
 *  impulse. */
DETENT_API detent_status detent_world3_apply_force(detent_context* context, detent_handle world,
                                                     detent_id id, const detent_vec3* force,
                                                     const detent_vec3* at);

/** Applies a torque (3 numbers, mass times square units per second squared) during the next step
 *  and wakes the body. DETENT_NO if no body has this id. */
DETENT_API detent_status detent_world3_apply_torque(detent_context* context, detent_handle world,
                                                      detent_id id, const int32_t* torque);

/** A joint with the defaults of its kind: bodies {0, 0}, anchors at the centers, no limits, motor
 *  or spring; a distance joint has the limits 0 and 1. */
DETENT_API detent_status detent_joint3_defaults(uint32_t kind, detent_joint3* joint);

/** Adds a joint and wakes its bodies. DETENT_NO if a body does not exist or both are the same,
 *  DETENT_FULL if there is no room, DETENT_BAD_ARGUMENT for a negative force, frequency or ratio.
 *  */
DETENT_API detent_status detent_world3_add_joint(detent_context* context, detent_handle world,
                                                   const detent_joint3* joint, detent_id* id);

/** Replaces a joint by another of the same kind, for example with another motor, and wakes its
 *  bodies. Its impulses are kept. DETENT_NO if no joint of this kind has this id, or a body does
 *  not exist. */
DETENT_API detent_status detent_world3_change_joint(detent_context* context, detent_handle world,
                                                      detent_id id, const detent_joint3* joint);

/** Removes a joint and wakes its bodies. DETENT_NO if no joint has this id. */
DETENT_API detent_status detent_world3_remove_joint(detent_context* context, detent_handle world,
                                                      detent_id id);

/** A joint as it was added or last replaced. DETENT_NO if no joint has this id. */
DETENT_API detent_status detent_world3_joint(const detent_context* context, detent_handle world,
                                               detent_id id, detent_joint3* joint);

/** The force of a joint on body b, in mass times units per second squared; on body a it is the
 *  opposite. It comes from the impulses of the last substep that solved the joint, along their
 *  directions now, and is zero before the first step. The joint breaks when it is longer than
 *  `break_force`. DETENT_NO if no joint has this id. */
DETENT_API detent_status detent_world3_joint_force(const detent_context* context,
                                                     detent_handle world, detent_id id,
                                                     detent_vec3* force);

/** The torque of a joint on body b (3 numbers, mass times square units per second squared) by its
 *  motor, limits and alignment, without that of its force; otherwise like
 *  `detent_world3_joint_force`. It breaks no joint. DETENT_NO if no joint has this id. */
DETENT_API detent_status detent_world3_joint_torque(const detent_context* context,
                                                      detent_handle world, detent_id id,
                                                      int32_t* torque);

/** The number of joints in the world. */
DETENT_API detent_status detent_world3_joint_count(const detent_context* context,
                                                     detent_handle world, uint32_t* count);

/** The ids of all joints, by index. Writes the first `room` of them, and their total number to
 *  `count`. */
DETENT_API detent_status detent_world3_joint_ids(const detent_context* context,
                                                   detent_handle world, detent_id* joints,
                                                   uint32_t room, uint32_t* count);

/** The joints that broke in the last step, by index. They have been removed. Writes the first
 *  `room` of them, and their total number to `count`. */
DETENT_API detent_status detent_world3_broken(const detent_context* context, detent_handle world,
                                                detent_id* joints, uint32_t room, uint32_t* count);

/** Converts a world point to the body's frame, rounded to nearest, for the anchor of a joint.
 *  DETENT_NO if no body has this id. */
DETENT_API detent_status detent_world3_local_point(const detent_context* context,
                                                     detent_handle world, detent_id id,
                                                     const detent_vec3* point,
                                                     detent_vec3* local);

/** Converts world axes to the body's frame, rounded to nearest, for the frame of a joint. DETENT_NO
 *  if no body has this id. */
DETENT_API detent_status detent_world3_local_frame(const detent_context* context,
                                                     detent_handle world, detent_id id,
                                                     const detent_rotation3* frame,
                                                     detent_rotation3* local);

/** The number of bodies in the world. */
DETENT_API detent_status detent_world3_size(const detent_context* context, detent_handle world,
                                              uint32_t* size);

/** The ids of all bodies, by index. Writes the first `room` of them, and their total number to
 *  `count`. */
DETENT_API detent_status detent_world3_body_ids(const detent_context* context,
                                                  detent_handle world, detent_id* ids,
                                                  uint32_t room, uint32_t* count);

/** The pairs that touch: those that began to in some step and have not ceased, sorted by id; of one
 *  body, or of all if `body` is {0, 0}. Their `begins` is 1. Writes the first `room` of them, and
 *  their total number to `count`. */
DETENT_API detent_status detent_world3_touching(const detent_context* context,
                                                  detent_handle world, detent_id body,
                                                  detent_touch* touches, uint32_t room,
                                                  uint32_t* count);

/** The contacts that touch, sorted by id, part and triangle; of one body, or of all if `body` is
 *  {0, 0}; none of sensors. Their normals and points are computed from the current poses, as the next
 *  step would find them. Writes the first `room` of them, and their number to `count`. */
DETENT_API detent_status detent_world3_contacts(const detent_context* context,
                                                  detent_handle world, detent_id body,
                                                  detent_world3_contact* contacts, uint32_t room,
                                                  uint32_t* count);

/** The pairs that began or ceased to touch in the last step, sorted by id. A pair of a sensor and a
 *  fast body that passed it within the step has both events. Writes the first `room` of them, and
 *  their total number to `count`. */
DETENT_API detent_status detent_world3_events(const detent_context* context, detent_handle world,
                                                detent_touch* events, uint32_t room,
                                                uint32_t* count);

/** A 64-bit digest of gravity and all bodies that are not fixed, their contacts and joints. */
DETENT_API detent_status detent_world3_digest(const detent_context* context, detent_handle world,
                                                uint64_t* digest);

/** A 64-bit digest of one body. DETENT_NO if no body has this id. */
DETENT_API detent_status detent_world3_digest_of(const detent_context* context,
                                                   detent_handle world, detent_id id,
                                                   uint64_t* digest);

/** Writes all bodies that are not fixed as canonical bytes to `bytes` if `room` suffices, and the
 *  number of bytes to `size`. DETENT_NO if it does not: call with room 0 to get the size. */
DETENT_API detent_status detent_world3_snapshot(const detent_context* context,
                                                  detent_handle world, void* bytes, uint32_t room,
                                                  uint32_t* size);

/** Restores a snapshot taken from a world with the same fixed bodies and settings; only its gravity
 *  may differ, and is restored. The context must have its assets. Any bytes are safe; an error leaves
 *  the world unchanged. */
DETENT_API detent_status detent_world3_restore(detent_context* context, detent_handle world,
                                                 const void* bytes, uint32_t size);

/** Names the first fields in which two worlds differ, at most `most`, such as `body 3:17 (sphere)
 *  velocity.y`, each followed by a line feed. Writes as much as `room` holds to `names`, and the
 *  total size to `size`. DETENT_NO if all fields are equal. */
DETENT_API detent_status detent_world3_diff(const detent_context* context, detent_handle a,
                                              detent_handle b, uint32_t most, void* names,
                                              uint32_t room, uint32_t* size);

/** `detent_world3_diff` for two scenes: `object 1:2 (sphere) center.y`. */
DETENT_API detent_status detent_scene3_diff(const detent_context* context, detent_handle a,
                                              detent_handle b, uint32_t most, void* names,
                                              uint32_t room, uint32_t* size);

/** A session of a match. Every peer starts it from an equal `world`, which is copied. No asset that
 *  a body of it could use can be destroyed before the session is. */
DETENT_API detent_status detent_session3_create(detent_context* context,
                                                  const detent_session_settings* settings,
                                                  detent_handle world, detent_handle* session);

/** Destroys a session and its world. */
DETENT_API detent_status detent_session3_destroy(detent_context* context, detent_handle session);

/** The world of a session, for all functions of worlds. It can be changed only while a frame is
 *  open; between frames it is the world after the last simulated frame. */
DETENT_API detent_status detent_session3_world(const detent_context* context,
                                                 detent_handle session, detent_handle* world);

/** Takes a packet that your transport received from `peer` at the time `now`. Any bytes are safe.
 *  DETENT_NO if it was not used: another match, malformed, or from a dropped peer. */
DETENT_API detent_status detent_session3_receive(detent_context* context, detent_handle session,
                                                   uint32_t peer, const void* bytes, uint32_t size,
                                                   uint64_t now);

/** Opens the next frame that is due. Simulate it: change the session's world depending only on the
 *  inputs, step it, and call `detent_session3_end_frame`. Repeat with the same input until no
 *  frame is due. Frames come again after a wrong prediction of inputs. `inputs` receives
 *  `input_size` bytes for each player. DETENT_NO if no frame is due; `frame` says why. A frame that
 *  was opened but not ended is opened again in its original state. */
DETENT_API detent_status detent_session3_begin_frame(detent_context* context,
                                                       detent_handle session, const void* input,
                                                       detent_frame* frame, void* inputs);

/** Ends the open frame. DETENT_NOT_NOW if none is open. */
DETENT_API detent_status detent_session3_end_frame(detent_context* context,
                                                     detent_handle session);

/** The next packet due at the time `now`, at most one per peer, to be sent to `peer`. Repeat until
 *  there is none. `room` must be at least DETENT_PACKET. */
DETENT_API detent_status detent_session3_packet(detent_context* context, detent_handle session,
                                                  uint64_t now, uint32_t* peer, void* bytes,
                                                  uint32_t room, uint32_t* size);

/** The next event, oldest first; DETENT_NO if there is none. Writes as much of the field's name as
 *  `room` holds; DETENT_NAME bytes hold any name. */
DETENT_API detent_status detent_session3_event(detent_context* context, detent_handle session,
                                                 detent_session_event* event, void* name,
                                                 uint32_t room);

/** The progress of the session. */
DETENT_API detent_status detent_session3_status(const detent_context* context,
                                                  detent_handle session,
                                                  detent_session_status* status);

/** The number of frames known to be equal at `peer` and here: all frames before `frame`. */
DETENT_API detent_status detent_session3_matched(const detent_context* context,
                                                   detent_handle session, uint32_t peer,
                                                   uint32_t* frame);

/** Whether the session waits for this player. */
DETENT_API detent_status detent_session3_is_awaited(const detent_context* context,
                                                      detent_handle session, uint32_t player);

/** Continues without a peer. All remaining peers agree on the first frame without that player. */
DETENT_API detent_status detent_session3_drop(detent_context* context, detent_handle session,
                                                uint32_t peer);

/** Pauses (1) or resumes (0) the match for all peers. */
DETENT_API detent_status detent_session3_pause(detent_context* context, detent_handle session,
                                                 uint32_t is_paused);

/** Writes the replay of all final frames so far to `bytes` if `room` suffices, and its size to
 *  `size`. DETENT_NO if it does not, or if the session records none, as after joining late: then
 *  the size is 0. */
DETENT_API detent_status detent_session3_replay(const detent_context* context,
                                                  detent_handle session, void* bytes, uint32_t room,
                                                  uint32_t* size);

/** The words next to the world of a session or replay: other game state that a rollback restores.
 *  Their number is in the settings. All are 0 before the first frame. DETENT_NO for a world outside
 *  sessions and replays. */
DETENT_API detent_status detent_world3_words(const detent_context* context, detent_handle world,
                                               uint32_t* words);

/** Sets the words, in an open frame. */
DETENT_API detent_status detent_world3_set_words(detent_context* context, detent_handle world,
                                                   const uint32_t* words);

/** A replay to be resimulated. `world` must have the settings and fixed bodies of the session's
 *  world at its start; `input_size` and `words` are the session's. Any bytes are safe.
 *  DETENT_NO_SNAPSHOT if they are not a replay, DETENT_OTHER_SCENE if the inputs have another size,
 *  DETENT_OTHER_VERSION if it was recorded with another version of the results; otherwise the
 *  status of `detent_world3_restore` for its start. */
DETENT_API detent_status detent_replay3_create(detent_context* context, const void* bytes,
                                                 uint32_t size, detent_handle world,
                                                 uint32_t input_size, uint32_t words,
                                                 detent_handle* replay);

/** Destroys a replay and its world. */
DETENT_API detent_status detent_replay3_destroy(detent_context* context, detent_handle replay);

/** The world of a replay, used like that of a session. */
DETENT_API detent_status detent_replay3_world(const detent_context* context, detent_handle replay,
                                                detent_handle* world);

/** Opens the next frame; simulate it as in a session. DETENT_NO at the end, or once a digest
 *  differs. A frame that was opened but not ended continues. */
DETENT_API detent_status detent_replay3_begin_frame(detent_context* context, detent_handle replay,
                                                      detent_frame* frame, void* inputs);

/** Ends the open frame. DETENT_NOT_NOW if none is open. */
DETENT_API detent_status detent_replay3_end_frame(detent_context* context, detent_handle replay);

/** The result of the resimulation so far. */
DETENT_API detent_status detent_replay3_check(const detent_context* context, detent_handle replay,
                                                detent_replay_check* check);

/** The pose of a camera at `eye` that looks at `target`, with `up` upward in the image. Axes are
 *  rounded to nearest; the scale is 65536. DETENT_NO if eye equals target, or `up` is parallel to
 *  the line of sight. */
DETENT_API detent_status detent_camera3_look_at(const detent_vec3* eye, const detent_vec3* target,
                                                const detent_vec3* up, detent_transform3* pose);

/** The view volume, each coordinate of a corner rounded to nearest. Functions of cameras return
 *  DETENT_BAD_ARGUMENT if a field violates its comment, or if the larger tangent of half the angle
 *  of view, rounded, is not above 0 and below 8. */
DETENT_API detent_status detent_camera3_frustum(const detent_camera3* camera,
                                                detent_frustum3* frustum);

/** The ray through the middle of a pixel, with the greatest possible length. Pixels of the `width`
 *  x `height` image are counted from the top left; those outside it are valid. If the image has no
 *  pixels, the ray goes through its middle. */
DETENT_API detent_status detent_camera3_pick_ray(const detent_camera3* camera, int32_t width,
                                                 int32_t height, int32_t column, int32_t row,
                                                 detent_ray3* ray);

/** The screen position of a point, inside the image or not; numbers are rounded to nearest and
 *  clamped. DETENT_NO if the point is not in front of a perspective camera, or the camera's axes
 *  are coplanar. */
DETENT_API detent_status detent_camera3_project(const detent_camera3* camera, int32_t width,
                                                int32_t height, const detent_vec3* point,
                                                detent_screen_point3* seen);

/** The point seen in the middle of a pixel at `depth`, a length along the line of sight, rounded to
 *  nearest. */
DETENT_API detent_status detent_camera3_unproject(const detent_camera3* camera, int32_t width,
                                                  int32_t height, int32_t column, int32_t row,
                                                  int32_t depth, detent_vec3* point);

/** Whether the ray touches the frustum, and where. `hit` may be null. The distance is 0 if it
 *  starts inside. */
DETENT_API detent_status detent_frustum3_raycast(const detent_ray3* ray,
                                                 const detent_frustum3* frustum, detent_hit3* hit);

/** Whether the point is in the frustum or on its surface. Exact. */
DETENT_API detent_status detent_frustum3_contains(const detent_frustum3* frustum,
                                                  const detent_vec3* point);

/** Whether the frustum shares a point with any of `count` shapes, given as for
 *  `detent_shapes3_raycast`. */
DETENT_API detent_status detent_frustum3_overlaps(const detent_context* context,
                                                  const detent_frustum3* frustum,
                                                  const detent_shape3* shapes, uint32_t count);

/** Whether two frusta share a point. Exact. */
DETENT_API detent_status detent_frustum3_overlaps_frustum(const detent_frustum3* a,
                                                          const detent_frustum3* b);

/** The closest point of the frustum to `point`, each coordinate rounded to nearest. */
DETENT_API detent_status detent_frustum3_closest_point(const detent_frustum3* frustum,
                                                       const detent_vec3* point,
                                                       detent_vec3* closest);

/** The distance from the frustum to `point`, rounded down. */
DETENT_API detent_status detent_frustum3_distance_to_point(const detent_frustum3* frustum,
                                                           const detent_vec3* point,
                                                           int32_t* distance);

/** Of the objects in `layers` that the frustum overlaps, the nearest to the center of its near
 *  corners. `found` may be null. */
DETENT_API detent_status detent_scene3_frustum_nearest(const detent_context* context,
                                                       detent_handle scene,
                                                       const detent_frustum3* frustum,
                                                       uint32_t layers, detent_found* found);

/** Whether the frustum overlaps any object in `layers`. */
DETENT_API detent_status detent_scene3_frustum_any(const detent_context* context,
                                                   detent_handle scene,
                                                   const detent_frustum3* frustum, uint32_t layers);

/** All objects in `layers` that the frustum overlaps, sorted by distance from the center of its
 *  near corners, then id. Writes the first `room` of them, and their total number to `count`. */
DETENT_API detent_status detent_scene3_frustum_all(const detent_context* context,
                                                   detent_handle scene,
                                                   const detent_frustum3* frustum, uint32_t layers,
                                                   detent_found* found, uint32_t room,
                                                   uint32_t* count);

/* Every field has a fixed size and place, the same in every compiler. */
typedef char detent_id_has_its_size[sizeof(detent_id) == 8 ? 1 : -1];
typedef char detent_pair_has_its_size[sizeof(detent_pair) == 16 ? 1 : -1];
typedef char detent_touch_has_its_size[sizeof(detent_touch) == 28 ? 1 : -1];
typedef char detent_body_info_has_its_size[sizeof(detent_body_info) == 32 ? 1 : -1];
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
typedef char detent_world2_contact_point_has_its_size[sizeof(detent_world2_contact_point) == 20 ? 1 : -1];
typedef char detent_world2_contact_has_its_size[sizeof(detent_world2_contact) == 92 ? 1 : -1];
typedef char detent_world2_settings_has_its_size[sizeof(detent_world2_settings) == 36 ? 1 : -1];
typedef char detent_body2_options_has_its_size[sizeof(detent_body2_options) == 80 ? 1 : -1];
typedef char detent_part2_has_its_size[sizeof(detent_part2) == 60 ? 1 : -1];
typedef char detent_joint2_has_its_size[sizeof(detent_joint2) == 112 ? 1 : -1];
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
typedef char detent_world3_contact_point_has_its_size[sizeof(detent_world3_contact_point) == 24 ? 1 : -1];
typedef char detent_world3_contact_has_its_size[sizeof(detent_world3_contact) == 156 ? 1 : -1];
typedef char detent_world3_settings_has_its_size[sizeof(detent_world3_settings) == 40 ? 1 : -1];
typedef char detent_body3_options_has_its_size[sizeof(detent_body3_options) == 96 ? 1 : -1];
typedef char detent_part3_has_its_size[sizeof(detent_part3) == 88 ? 1 : -1];
typedef char detent_joint3_has_its_size[sizeof(detent_joint3) == 160 ? 1 : -1];
typedef char detent_body3_has_its_size[sizeof(detent_body3) == 76 ? 1 : -1];
typedef char detent_camera3_has_its_size[sizeof(detent_camera3) == 80 ? 1 : -1];
typedef char detent_frustum3_has_its_size[sizeof(detent_frustum3) == 96 ? 1 : -1];
typedef char detent_screen_point3_has_its_size[sizeof(detent_screen_point3) == 12 ? 1 : -1];

#ifdef __cplusplus
}
#endif

#endif
