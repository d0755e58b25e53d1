-- SPDX-License-Identifier: MIT
-- Written by bindings/generate from bindings/detent.h.in: change that file instead.
-- The C interface as it is.
local ffi = require('ffi')
ffi.cdef[[
enum {
  DETENT_OK = 1,
  DETENT_NO = 0,
  DETENT_BAD_ARGUMENT = -1,
  DETENT_BAD_CONTEXT = -2,
  DETENT_BAD_HANDLE = -3,
  DETENT_NOT_UNIT = -4,
  DETENT_NO_QUERY = -5,
  DETENT_NO_MEMORY = -6,
  DETENT_BROKEN = -7,
  DETENT_FULL = -8,
  DETENT_IN_USE = -9,
  DETENT_NOT_NOW = -10,
  DETENT_NO_SNAPSHOT = -20,
  DETENT_OTHER_VERSION = -21,
  DETENT_TRUNCATED = -22,
  DETENT_CORRUPTED = -23,
  DETENT_OTHER_SCENE = -24,
  DETENT_OTHER_FIXED_PART = -25,
  DETENT_NO_ROOM = -26,
  DETENT_UNKNOWN_ASSET = -27,
  DETENT_OTHER_ASSET = -28
};
enum {
  DETENT_SPHERE = 1,
  DETENT_AABB = 2,
  DETENT_OBB = 3,
  DETENT_PLANE = 4,
  DETENT_TRIANGLE = 5,
  DETENT_CAPSULE = 6,
  DETENT_SEGMENT = 7,
  DETENT_POINT = 8,
  DETENT_HULL = 9,
  DETENT_MESH = 10,
  DETENT_HEIGHT_FIELD = 11,
  DETENT_COMPOUND = 12
};
enum { DETENT_MOVING = 0, DETENT_FIXED = 1 };
enum { DETENT_DYNAMIC_BODY = 0, DETENT_KINEMATIC_BODY = 1, DETENT_FIXED_BODY = 2 };
enum {
  DETENT_DISTANCE_JOINT = 1,
  DETENT_BALL_JOINT = 2,
  DETENT_HINGE_JOINT = 3,
  DETENT_WELD_JOINT = 4,
  DETENT_SLIDER_JOINT = 5,
  DETENT_WHEEL_JOINT = 6,
  DETENT_CONE_JOINT = 7
};
enum {
  DETENT_LOCK_X = 1,
  DETENT_LOCK_Y = 2,
  DETENT_LOCK_Z = 4,
  DETENT_LOCK_TURN_X = 8,
  DETENT_LOCK_TURN_Y = 16,
  DETENT_LOCK_TURN_Z = 32
};
enum {
  DETENT_PLAYED = 0,
  DETENT_CONNECTING = 1,
  DETENT_CATCHING_UP = 2,
  DETENT_STARVED = 3,
  DETENT_AHEAD = 4,
  DETENT_PAUSED = 5,
  DETENT_OVER = 6,
  DETENT_JOINING = 7
};
enum {
  DETENT_CONNECTED = 0,
  DETENT_SILENT = 1,
  DETENT_HEARD_AGAIN = 2,
  DETENT_PEER_PAUSED = 3,
  DETENT_PEER_RESUMED = 4,
  DETENT_DROPPED = 5,
  DETENT_EXPELLED = 6,
  DETENT_LEFT = 7,
  DETENT_TOO_SLOW = 8,
  DETENT_CONTRADICTION = 9,
  DETENT_DESYNC = 10,
  DETENT_DESYNC_FIELD = 11,
  DETENT_ARRIVED = 12,
  DETENT_LOADED = 13,
  DETENT_NO_SUCH_WORLD = 14,
  DETENT_JOINED = 15
};
enum {
  DETENT_REPLAY_WHOLE = 0,
  DETENT_REPLAY_CUT = 1,
  DETENT_REPLAY_CORRUPTED = 2
};
enum {
  DETENT_INPUT = 16,
  DETENT_PACKET = 1200,
  DETENT_LATE_SNAPSHOT = 65536,
  DETENT_NAME = 119,
  DETENT_WORDS = 256,
  DETENT_PLAYERS = 8
};
typedef int32_t detent_status;
typedef uint32_t detent_handle;
typedef struct detent_id {
  uint32_t index;
  uint32_t generation;
} detent_id;
typedef struct detent_pair {
  detent_id first;
  detent_id second;
} detent_pair;
typedef struct detent_touch {
  detent_id a;
  detent_id b;
  uint32_t begins;
  uint32_t part_a;
  uint32_t part_b;
} detent_touch;
typedef struct detent_body_info {
  uint64_t user;
  uint32_t layers;
  uint32_t collides_with;
  uint32_t motion;
  uint32_t is_sensor;
  uint32_t is_asleep;
  uint32_t part_count;
} detent_body_info;
typedef struct detent_found {
  int32_t distance;
  detent_id id;
} detent_found;
typedef struct detent_impact {
  int32_t time;
  int32_t distance;
  uint32_t is_hit;
} detent_impact;
typedef struct detent_session_settings {
  uint64_t match;
  uint64_t send_interval;
  uint64_t silence;
  uint32_t self;
  uint32_t players;
  uint32_t spectators;
  uint32_t delay;
  uint32_t prediction;
  uint32_t frames_per_call;
  uint32_t absent;
  uint32_t life;
  uint32_t wants_seat;
  uint32_t input_size;
  uint32_t words;
  uint32_t replay_every;
} detent_session_settings;
typedef struct detent_frame {
  uint32_t number;
  uint32_t players;
  uint32_t present;
  uint32_t state;
} detent_frame;
typedef struct detent_session_event {
  uint32_t kind;
  uint32_t peer;
  uint32_t frame;
  uint32_t name_size;
  uint32_t has_object;
  detent_id object;
} detent_session_event;
typedef struct detent_session_status {
  uint64_t digest;
  uint64_t resimulated;
  uint32_t frame;
  uint32_t final_frame;
  uint32_t checked_frame;
  uint32_t start_frame;
  uint32_t is_player;
  uint32_t players;
} detent_session_status;
typedef struct detent_replay_check {
  uint32_t state;
  uint32_t frames;
  uint32_t equal;
  uint32_t is_equal;
  uint32_t players;
} detent_replay_check;
typedef struct detent_traits {
  uint64_t user;
  uint32_t layers;
  uint32_t motion;
  detent_id frame;
} detent_traits;
typedef struct detent_allocator {
  void* user;
  void* (*allocate)(void* user, size_t size);
  void (*release)(void* user, void* memory, size_t size);
} detent_allocator;
typedef struct detent_context {
  uint64_t words[4];
} detent_context;
typedef struct detent_vec2 {
  int32_t x, y;
} detent_vec2;
typedef struct detent_direction2 {
  int32_t x, y;
} detent_direction2;
typedef struct detent_rotation2 {
  detent_direction2 axis[2];
} detent_rotation2;
typedef struct detent_transform2 {
  detent_vec2 translation;
  detent_rotation2 rotation;
  int32_t scale;
} detent_transform2;
typedef struct detent_ray2 {
  detent_vec2 origin;
  detent_direction2 direction;
  int32_t max_distance;
} detent_ray2;
typedef struct detent_sphere2 {
  detent_vec2 center;
  int32_t radius;
} detent_sphere2;
typedef struct detent_aabb2 {
  detent_vec2 min;
  detent_vec2 max;
} detent_aabb2;
typedef struct detent_obb2 {
  detent_vec2 center;
  detent_vec2 half_extents;
  detent_rotation2 rotation;
} detent_obb2;
typedef struct detent_plane2 {
  detent_direction2 normal;
  int32_t offset;
} detent_plane2;
typedef struct detent_triangle2 {
  detent_vec2 a;
  detent_vec2 b;
  detent_vec2 c;
} detent_triangle2;
typedef struct detent_capsule2 {
  detent_vec2 a;
  detent_vec2 b;
  int32_t radius;
} detent_capsule2;
typedef struct detent_segment2 {
  detent_vec2 start;
  detent_vec2 end;
} detent_segment2;
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
typedef struct detent_hit2 {
  int32_t distance;
  detent_vec2 point;
  detent_direction2 normal;
} detent_hit2;
typedef struct detent_contact_point2 {
  detent_vec2 point;
  int32_t depth;
  uint32_t feature;
} detent_contact_point2;
typedef struct detent_manifold2 {
  detent_direction2 normal;
  int32_t depth;
  uint32_t count;
  detent_contact_point2 points[2];
} detent_manifold2;
typedef struct detent_sweep2 {
  detent_vec2 start;
  detent_vec2 end;
  detent_rotation2 start_rotation;
  detent_rotation2 end_rotation;
} detent_sweep2;
typedef struct detent_object_hit2 {
  int32_t distance;
  detent_id id;
  detent_vec2 point;
  detent_direction2 normal;
  uint32_t triangle;
  uint32_t has_triangle;
} detent_object_hit2;
typedef struct detent_mover2 {
  detent_shape2 shape;
  uint32_t is_grounded;
  detent_id object;
  detent_direction2 normal;
  detent_id frame;
  detent_vec2 local;
  detent_vec2 point;
} detent_mover2;
typedef struct detent_mover2_settings {
  detent_direction2 up;
  int32_t skin;
  int32_t step_height;
  int32_t snap_distance;
  uint32_t max_slope;
} detent_mover2_settings;
typedef struct detent_mover2_touch {
  detent_id object;
  detent_vec2 point;
  detent_direction2 normal;
} detent_mover2_touch;
typedef struct detent_move2 {
  detent_vec2 moved;
  detent_vec2 carried;
  detent_vec2 pushed;
  uint32_t count;
  uint32_t is_stuck;
  detent_mover2_touch touched[8];
} detent_move2;
typedef struct detent_world2_contact_point {
  detent_vec2 point;
  int32_t separation;
  int32_t impulse;
  uint32_t feature;
} detent_world2_contact_point;
typedef struct detent_world2_contact {
  detent_id a;
  detent_id b;
  uint32_t part_a;
  uint32_t part_b;
  uint32_t triangle;
  detent_direction2 normal;
  int32_t impulse;
  detent_vec2 friction;
  uint32_t count;
  detent_world2_contact_point points[2];
} detent_world2_contact;
typedef struct detent_world2_settings {
  int32_t ticks_per_second;
  int32_t substeps;
  detent_vec2 gravity;
  int32_t margin;
  int32_t push_speed;
  int32_t bounce_threshold;
  int32_t sleep_speed;
  int32_t hold_distance;
} detent_world2_settings;
typedef struct detent_body2_options {
  uint64_t user;
  uint32_t layers;
  uint32_t collides_with;
  uint32_t motion;
  int32_t density;
  int32_t friction;
  int32_t restitution;
  int32_t rolling_resistance;
  int32_t linear_damping;
  int32_t angular_damping;
  detent_vec2 velocity;
  int32_t angular_velocity[1];
  int32_t gravity_scale;
  uint32_t locked;
  uint32_t is_sensor;
  uint32_t is_fast;
  uint32_t reserved[2];
} detent_body2_options;
typedef struct detent_part2 {
  detent_shape2 shape;
  int32_t density;
  int32_t friction;
  int32_t restitution;
  int32_t rolling_resistance;
  uint32_t is_sensor;
} detent_part2;
typedef struct detent_joint2 {
  uint32_t kind;
  detent_id a;
  detent_id b;
  detent_vec2 anchor_a;
  detent_vec2 anchor_b;
  detent_rotation2 frame_a;
  detent_rotation2 frame_b;
  uint32_t collide;
  int32_t break_force;
  uint32_t has_limits;
  int32_t lower;
  int32_t upper;
  int32_t motor_speed;
  int32_t motor_force;
  int32_t length;
  int32_t frequency;
  int32_t damping_ratio;
  int32_t cone_angle;
} detent_joint2;
typedef struct detent_body2 {
  detent_vec2 position;
  detent_rotation2 rotation;
  detent_vec2 velocity;
  int32_t angular_velocity[1];
  uint32_t is_asleep;
} detent_body2;
typedef struct detent_vec3 {
  int32_t x, y, z;
} detent_vec3;
typedef struct detent_direction3 {
  int32_t x, y, z;
} detent_direction3;
typedef struct detent_rotation3 {
  detent_direction3 axis[3];
} detent_rotation3;
typedef struct detent_transform3 {
  detent_vec3 translation;
  detent_rotation3 rotation;
  int32_t scale;
} detent_transform3;
typedef struct detent_ray3 {
  detent_vec3 origin;
  detent_direction3 direction;
  int32_t max_distance;
} detent_ray3;
typedef struct detent_sphere3 {
  detent_vec3 center;
  int32_t radius;
} detent_sphere3;
typedef struct detent_aabb3 {
  detent_vec3 min;
  detent_vec3 max;
} detent_aabb3;
typedef struct detent_obb3 {
  detent_vec3 center;
  detent_vec3 half_extents;
  detent_rotation3 rotation;
} detent_obb3;
typedef struct detent_plane3 {
  detent_direction3 normal;
  int32_t offset;
} detent_plane3;
typedef struct detent_triangle3 {
  detent_vec3 a;
  detent_vec3 b;
  detent_vec3 c;
} detent_triangle3;
typedef struct detent_capsule3 {
  detent_vec3 a;
  detent_vec3 b;
  int32_t radius;
} detent_capsule3;
typedef struct detent_segment3 {
  detent_vec3 start;
  detent_vec3 end;
} detent_segment3;
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
typedef struct detent_hit3 {
  int32_t distance;
  detent_vec3 point;
  detent_direction3 normal;
} detent_hit3;
typedef struct detent_contact_point3 {
  detent_vec3 point;
  int32_t depth;
  uint32_t feature;
} detent_contact_point3;
typedef struct detent_manifold3 {
  detent_direction3 normal;
  int32_t depth;
  uint32_t count;
  detent_contact_point3 points[4];
} detent_manifold3;
typedef struct detent_sweep3 {
  detent_vec3 start;
  detent_vec3 end;
  detent_rotation3 start_rotation;
  detent_rotation3 end_rotation;
} detent_sweep3;
typedef struct detent_object_hit3 {
  int32_t distance;
  detent_id id;
  detent_vec3 point;
  detent_direction3 normal;
  uint32_t triangle;
  uint32_t has_triangle;
} detent_object_hit3;
typedef struct detent_mover3 {
  detent_shape3 shape;
  uint32_t is_grounded;
  detent_id object;
  detent_direction3 normal;
  detent_id frame;
  detent_vec3 local;
  detent_vec3 point;
} detent_mover3;
typedef struct detent_mover3_settings {
  detent_direction3 up;
  int32_t skin;
  int32_t step_height;
  int32_t snap_distance;
  uint32_t max_slope;
} detent_mover3_settings;
typedef struct detent_mover3_touch {
  detent_id object;
  detent_vec3 point;
  detent_direction3 normal;
} detent_mover3_touch;
typedef struct detent_move3 {
  detent_vec3 moved;
  detent_vec3 carried;
  detent_vec3 pushed;
  uint32_t count;
  uint32_t is_stuck;
  detent_mover3_touch touched[8];
} detent_move3;
typedef struct detent_world3_contact_point {
  detent_vec3 point;
  int32_t separation;
  int32_t impulse;
  uint32_t feature;
} detent_world3_contact_point;
typedef struct detent_world3_contact {
  detent_id a;
  detent_id b;
  uint32_t part_a;
  uint32_t part_b;
  uint32_t triangle;
  detent_direction3 normal;
  int32_t impulse;
  detent_vec3 friction;
  uint32_t count;
  detent_world3_contact_point points[4];
} detent_world3_contact;
typedef struct detent_world3_settings {
  int32_t ticks_per_second;
  int32_t substeps;
  detent_vec3 gravity;
  int32_t margin;
  int32_t push_speed;
  int32_t bounce_threshold;
  int32_t sleep_speed;
  int32_t hold_distance;
} detent_world3_settings;
typedef struct detent_body3_options {
  uint64_t user;
  uint32_t layers;
  uint32_t collides_with;
  uint32_t motion;
  int32_t density;
  int32_t friction;
  int32_t restitution;
  int32_t rolling_resistance;
  int32_t linear_damping;
  int32_t angular_damping;
  detent_vec3 velocity;
  int32_t angular_velocity[3];
  int32_t gravity_scale;
  uint32_t locked;
  uint32_t is_sensor;
  uint32_t is_fast;
  uint32_t reserved[3];
} detent_body3_options;
typedef struct detent_part3 {
  detent_shape3 shape;
  int32_t density;
  int32_t friction;
  int32_t restitution;
  int32_t rolling_resistance;
  uint32_t is_sensor;
} detent_part3;
typedef struct detent_joint3 {
  uint32_t kind;
  detent_id a;
  detent_id b;
  detent_vec3 anchor_a;
  detent_vec3 anchor_b;
  detent_rotation3 frame_a;
  detent_rotation3 frame_b;
  uint32_t collide;
  int32_t break_force;
  uint32_t has_limits;
  int32_t lower;
  int32_t upper;
  int32_t motor_speed;
  int32_t motor_force;
  int32_t length;
  int32_t frequency;
  int32_t damping_ratio;
  int32_t cone_angle;
} detent_joint3;
typedef struct detent_body3 {
  detent_vec3 position;
  detent_rotation3 rotation;
  detent_vec3 velocity;
  int32_t angular_velocity[3];
  uint32_t is_asleep;
} detent_body3;
typedef struct detent_camera3 {
  detent_transform3 pose;
  uint32_t has_perspective;
  uint32_t fov;
  int32_t aspect;
  int32_t half_width;
  int32_t half_height;
  int32_t near_distance;
  int32_t far_distance;
} detent_camera3;
typedef struct detent_frustum3 {
  detent_vec3 corners[8];
} detent_frustum3;
typedef struct detent_screen_point3 {
  int32_t x;
  int32_t y;
  int32_t depth;
} detent_screen_point3;
int32_t detent_version(void);
int32_t detent_results_version(void);
const char* detent_describe(detent_status status);
detent_status detent_open(detent_context* context, const detent_allocator* allocator);
detent_status detent_close(detent_context* context);
detent_status detent_count(const detent_context* context, uint32_t* count);
detent_status detent_session_default_settings(detent_session_settings* settings);
detent_status detent_mesh_create(detent_context* context, uint32_t id,
                                            const detent_vec3* vertices, uint32_t vertex_count,
                                            const uint32_t* faces, uint32_t face_count,
                                            detent_handle* mesh);
detent_status detent_height_field_create(detent_context* context, uint32_t id,
                                                    const detent_vec2* corner, int32_t cell,
                                                    uint32_t columns, uint32_t rows,
                                                    const int32_t* heights, detent_handle* field);
detent_status detent_asset_destroy(detent_context* context, detent_handle asset);
detent_status detent_raycast2(const detent_ray2* ray, const detent_shape2* shape,
                                           detent_hit2* hit);
detent_status detent_raycast2_many(const detent_ray2* rays, uint32_t count,
                                                const detent_shape2* shape, int32_t* distances);
detent_status detent_contains2(const detent_shape2* shape, const detent_vec2* point);
detent_status detent_overlaps2(const detent_shape2* a, const detent_shape2* b);
detent_status detent_closest_point2(const detent_shape2* shape,
                                                 const detent_vec2* point,
                                                 detent_vec2* closest);
detent_status detent_distance_to_point2(const detent_shape2* shape,
                                                     const detent_vec2* point,
                                                     int32_t* distance);
detent_status detent_distance2(const detent_shape2* a, const detent_shape2* b,
                                            int32_t* distance);
detent_status detent_contact2(const detent_shape2* a, const detent_shape2* b,
                                           detent_manifold2* contact);
detent_status detent_closest_points2(const detent_shape2* a,
                                                  const detent_shape2* b,
                                                  detent_vec2* point_a,
                                                  detent_vec2* point_b);
detent_status detent_cast2(const detent_shape2* shape,
                                        const detent_direction2* direction, int32_t max_distance,
                                        const detent_shape2* target, detent_hit2* hit);
detent_status detent_time_of_impact2(const detent_shape2* a,
                                                  const detent_sweep2* sweep_a,
                                                  const detent_shape2* b,
                                                  const detent_sweep2* sweep_b, int32_t target,
                                                  detent_impact* impact);
detent_status detent_ray2_contains(const detent_ray2* ray, const detent_vec2* point);
detent_status detent_ray2_closest_point(const detent_ray2* ray,
                                                     const detent_vec2* point,
                                                     detent_vec2* closest);
detent_status detent_ray2_distance_to_point(const detent_ray2* ray,
                                                         const detent_vec2* point,
                                                         int32_t* distance);
detent_status detent_shapes2_raycast(const detent_context* context,
                                                  const detent_ray2* ray,
                                                  const detent_shape2* shapes, uint32_t count,
                                                  detent_hit2* hit);
detent_status detent_shapes2_contains(const detent_context* context,
                                                   const detent_shape2* shapes, uint32_t count,
                                                   const detent_vec2* point);
detent_status detent_shapes2_overlaps(const detent_context* context,
                                                   const detent_shape2* a, uint32_t a_count,
                                                   const detent_shape2* b, uint32_t b_count);
detent_status detent_shapes2_closest_point(const detent_context* context,
                                                        const detent_shape2* shapes,
                                                        uint32_t count, const detent_vec2* point,
                                                        detent_vec2* closest);
detent_status detent_shapes2_distance_to_point(const detent_context* context,
                                                            const detent_shape2* shapes,
                                                            uint32_t count,
                                                            const detent_vec2* point,
                                                            int32_t* distance);
detent_status detent_shapes2_distance(const detent_context* context,
                                                   const detent_shape2* a, uint32_t a_count,
                                                   const detent_shape2* b, uint32_t b_count,
                                                   int32_t* distance);
detent_status detent_shapes2_closest_points(const detent_context* context,
                                                         const detent_shape2* a, uint32_t a_count,
                                                         const detent_shape2* b, uint32_t b_count,
                                                         detent_vec2* point_a,
                                                         detent_vec2* point_b);
detent_status detent_shapes2_cast(const detent_context* context,
                                               const detent_shape2* shape,
                                               const detent_direction2* direction,
                                               int32_t max_distance,
                                               const detent_shape2* targets, uint32_t count,
                                               detent_hit2* hit);
detent_status detent_shapes2_contact(const detent_context* context,
                                                  const detent_shape2* a,
                                                  const detent_shape2* b,
                                                  detent_manifold2* contact);
detent_status detent_shapes2_time_of_impact(const detent_context* context,
                                                         const detent_shape2* a,
                                                         const detent_sweep2* sweep_a,
                                                         const detent_shape2* b,
                                                         const detent_sweep2* sweep_b,
                                                         int32_t target, detent_impact* impact);
detent_status detent_hull2_create(detent_context* context, uint32_t id,
                                               const detent_vec2* points, uint32_t count,
                                               detent_handle* hull);
detent_status detent_solid2_create(detent_context* context, uint32_t id,
                                                const detent_vec2* points, uint32_t count,
                                                detent_handle* solid);
detent_status detent_part2_defaults(detent_part2* part);
detent_status detent_compound2_create(detent_context* context, uint32_t id,
                                                   const detent_part2* parts, uint32_t count,
                                                   detent_handle* compound);
detent_status detent_scene2_create(detent_context* context, detent_handle* scene);
detent_status detent_scene2_destroy(detent_context* context, detent_handle scene);
detent_status detent_scene2_add(detent_context* context, detent_handle scene,
                                             const detent_shape2* shape,
                                             const detent_traits* traits, detent_id* id);
detent_status detent_scene2_add_as(detent_context* context, detent_handle scene,
                                                detent_id id, const detent_shape2* shape,
                                                const detent_traits* traits);
detent_status detent_scene2_remove(detent_context* context, detent_handle scene,
                                                detent_id id);
detent_status detent_scene2_replace(detent_context* context, detent_handle scene,
                                                 detent_id id, const detent_shape2* shape);
detent_status detent_scene2_move(detent_context* context, detent_handle scene,
                                              detent_id id, const detent_vec2* by);
detent_status detent_scene2_object(const detent_context* context, detent_handle scene,
                                                detent_id id, detent_shape2* shape,
                                                detent_traits* traits);
detent_status detent_scene2_set_traits(detent_context* context, detent_handle scene,
                                                    detent_id id, const detent_traits* traits);
detent_status detent_scene2_add_frame(detent_context* context, detent_handle scene,
                                                   const detent_transform2* transform,
                                                   detent_id parent, detent_id* frame);
detent_status detent_scene2_move_frame(detent_context* context, detent_handle scene,
                                                    detent_id frame,
                                                    const detent_transform2* transform);
detent_status detent_scene2_remove_frame(detent_context* context, detent_handle scene,
                                                      detent_id frame);
detent_status detent_scene2_frame(const detent_context* context, detent_handle scene,
                                               detent_id frame, detent_transform2* local,
                                               detent_transform2* world);
detent_status detent_scene2_size(const detent_context* context, detent_handle scene,
                                              uint32_t* size);
detent_status detent_scene2_optimize(detent_context* context, detent_handle scene);
detent_status detent_scene2_raycast(const detent_context* context, detent_handle scene,
                                                 const detent_ray2* ray, uint32_t layers,
                                                 detent_object_hit2* hit);
detent_status detent_scene2_raycast_any(const detent_context* context,
                                                     detent_handle scene, const detent_ray2* ray,
                                                     uint32_t layers);
detent_status detent_scene2_raycast_all(const detent_context* context,
                                                     detent_handle scene, const detent_ray2* ray,
                                                     uint32_t layers, detent_object_hit2* hits,
                                                     uint32_t room, uint32_t* count);
detent_status detent_scene2_raycast_many(const detent_context* context,
                                                      detent_handle scene, const detent_ray2* rays,
                                                      uint32_t count, uint32_t layers,
                                                      detent_object_hit2* hits);
detent_status detent_scene2_nearest(const detent_context* context, detent_handle scene,
                                                 const detent_shape2* question, uint32_t layers,
                                                 detent_found* found);
detent_status detent_scene2_any(const detent_context* context, detent_handle scene,
                                             const detent_shape2* question, uint32_t layers);
detent_status detent_scene2_all(const detent_context* context, detent_handle scene,
                                             const detent_shape2* question, uint32_t layers,
                                             detent_found* found, uint32_t room, uint32_t* count);
detent_status detent_scene2_overlaps(const detent_context* context,
                                                  detent_handle scene, detent_pair* pairs,
                                                  uint32_t room, uint32_t* count);
detent_status detent_scene2_cast(const detent_context* context, detent_handle scene,
                                              const detent_shape2* shape,
                                              const detent_direction2* direction,
                                              int32_t max_distance, uint32_t layers,
                                              detent_object_hit2* hit);
detent_status detent_scene2_cast_any(const detent_context* context,
                                                  detent_handle scene,
                                                  const detent_shape2* shape,
                                                  const detent_direction2* direction,
                                                  int32_t max_distance, uint32_t layers);
detent_status detent_scene2_cast_all(const detent_context* context,
                                                  detent_handle scene,
                                                  const detent_shape2* shape,
                                                  const detent_direction2* direction,
                                                  int32_t max_distance, uint32_t layers,
                                                  detent_object_hit2* hits, uint32_t room,
                                                  uint32_t* count);
detent_status detent_mover2_default_settings(detent_mover2_settings* settings);
detent_status detent_mover2_move(const detent_context* context, detent_handle scene,
                                              detent_mover2* mover, const detent_vec2* by,
                                              const detent_mover2_settings* settings,
                                              uint32_t layers, detent_id ignored,
                                              detent_move2* result);
detent_status detent_mover2_clip_velocity(const detent_vec2* velocity,
                                                       const detent_move2* result,
                                                       detent_vec2* clipped);
detent_status detent_scene2_digest(const detent_context* context, detent_handle scene,
                                                uint64_t* digest);
detent_status detent_scene2_snapshot(const detent_context* context,
                                                  detent_handle scene, void* bytes, uint32_t room,
                                                  uint32_t* size);
detent_status detent_scene2_restore(detent_context* context, detent_handle scene,
                                                 const void* bytes, uint32_t size);
detent_status detent_world2_default_settings(detent_world2_settings* settings);
detent_status detent_body2_default_options(detent_body2_options* options);
detent_status detent_world2_create(detent_context* context,
                                                const detent_world2_settings* settings,
                                                detent_handle* world);
detent_status detent_world2_destroy(detent_context* context, detent_handle world);
detent_status detent_world2_add(detent_context* context, detent_handle world,
                                             const detent_shape2* shape,
                                             const detent_body2_options* options, detent_id* id);
detent_status detent_world2_add_as(detent_context* context, detent_handle world,
                                                detent_id id, const detent_shape2* shape,
                                                const detent_body2_options* options);
detent_status detent_world2_remove(detent_context* context, detent_handle world,
                                                detent_id id);
detent_status detent_world2_step(detent_context* context, detent_handle world);
detent_status detent_scene2_follow(detent_context* context, detent_handle scene,
                                                detent_handle world, uint32_t sensors);
detent_status detent_world2_part_of(const detent_context* context,
                                                 detent_handle world, detent_id object,
                                                 detent_id* body, uint32_t* part);
detent_status detent_world2_body(const detent_context* context, detent_handle world,
                                              detent_id id, detent_body2* body);
detent_status detent_world2_bodies(const detent_context* context, detent_handle world,
                                                const detent_id* ids, uint32_t count,
                                                detent_body2* bodies);
detent_status detent_world2_frame(const detent_context* context, detent_handle world,
                                               detent_id id, detent_transform2* frame);
detent_status detent_world2_info(const detent_context* context, detent_handle world,
                                              detent_id id, detent_body_info* info);
detent_status detent_world2_set_position(detent_context* context, detent_handle world,
                                                      detent_id id, const detent_vec2* position);
detent_status detent_world2_set_rotation(detent_context* context, detent_handle world,
                                                      detent_id id,
                                                      const detent_rotation2* rotation);
detent_status detent_world2_set_filter(detent_context* context, detent_handle world,
                                                    detent_id id, uint32_t layers,
                                                    uint32_t collides_with);
detent_status detent_world2_set_friction(detent_context* context, detent_handle world,
                                                      detent_id id, int32_t friction);
detent_status detent_world2_set_restitution(detent_context* context,
                                                         detent_handle world, detent_id id,
                                                         int32_t restitution);
detent_status detent_world2_set_sensor(detent_context* context, detent_handle world,
                                                    detent_id id, uint32_t is_sensor);
detent_status detent_world2_set_gravity_scale(detent_context* context,
                                                           detent_handle world, detent_id id,
                                                           int32_t scale);
detent_status detent_world2_set_damping(detent_context* context, detent_handle world,
                                                     detent_id id, int32_t linear, int32_t angular);
detent_status detent_world2_set_locked(detent_context* context, detent_handle world,
                                                    detent_id id, uint32_t locked);
detent_status detent_world2_set_fast(detent_context* context, detent_handle world,
                                                  detent_id id, uint32_t is_fast);
detent_status detent_world2_set_user(detent_context* context, detent_handle world,
                                                  detent_id id, uint64_t user);
detent_status detent_world2_set_gravity(detent_context* context, detent_handle world,
                                                     const detent_vec2* gravity);
detent_status detent_world2_set_velocity(detent_context* context, detent_handle world,
                                                      detent_id id, const detent_vec2* velocity);
detent_status detent_world2_set_angular_velocity(detent_context* context,
                                                              detent_handle world, detent_id id,
                                                              const int32_t* velocity);
detent_status detent_world2_apply_impulse(detent_context* context, detent_handle world,
                                                       detent_id id, const detent_vec2* impulse,
                                                       const detent_vec2* at);
detent_status detent_world2_apply_force(detent_context* context, detent_handle world,
                                                     detent_id id, const detent_vec2* force,
                                                     const detent_vec2* at);
detent_status detent_world2_apply_torque(detent_context* context, detent_handle world,
                                                      detent_id id, const int32_t* torque);
detent_status detent_joint2_defaults(uint32_t kind, detent_joint2* joint);
detent_status detent_world2_add_joint(detent_context* context, detent_handle world,
                                                   const detent_joint2* joint, detent_id* id);
detent_status detent_world2_change_joint(detent_context* context, detent_handle world,
                                                      detent_id id, const detent_joint2* joint);
detent_status detent_world2_remove_joint(detent_context* context, detent_handle world,
                                                      detent_id id);
detent_status detent_world2_joint(const detent_context* context, detent_handle world,
                                               detent_id id, detent_joint2* joint);
detent_status detent_world2_joint_force(const detent_context* context,
                                                     detent_handle world, detent_id id,
                                                     detent_vec2* force);
detent_status detent_world2_joint_torque(const detent_context* context,
                                                      detent_handle world, detent_id id,
                                                      int32_t* torque);
detent_status detent_world2_joint_count(const detent_context* context,
                                                     detent_handle world, uint32_t* count);
detent_status detent_world2_joint_ids(const detent_context* context,
                                                   detent_handle world, detent_id* joints,
                                                   uint32_t room, uint32_t* count);
detent_status detent_world2_broken(const detent_context* context, detent_handle world,
                                                detent_id* joints, uint32_t room, uint32_t* count);
detent_status detent_world2_local_point(const detent_context* context,
                                                     detent_handle world, detent_id id,
                                                     const detent_vec2* point,
                                                     detent_vec2* local);
detent_status detent_world2_local_frame(const detent_context* context,
                                                     detent_handle world, detent_id id,
                                                     const detent_rotation2* frame,
                                                     detent_rotation2* local);
detent_status detent_world2_size(const detent_context* context, detent_handle world,
                                              uint32_t* size);
detent_status detent_world2_body_ids(const detent_context* context,
                                                  detent_handle world, detent_id* ids,
                                                  uint32_t room, uint32_t* count);
detent_status detent_world2_touching(const detent_context* context,
                                                  detent_handle world, detent_id body,
                                                  detent_touch* touches, uint32_t room,
                                                  uint32_t* count);
detent_status detent_world2_contacts(const detent_context* context,
                                                  detent_handle world, detent_id body,
                                                  detent_world2_contact* contacts, uint32_t room,
                                                  uint32_t* count);
detent_status detent_world2_events(const detent_context* context, detent_handle world,
                                                detent_touch* events, uint32_t room,
                                                uint32_t* count);
detent_status detent_world2_digest(const detent_context* context, detent_handle world,
                                                uint64_t* digest);
detent_status detent_world2_digest_of(const detent_context* context,
                                                   detent_handle world, detent_id id,
                                                   uint64_t* digest);
detent_status detent_world2_snapshot(const detent_context* context,
                                                  detent_handle world, void* bytes, uint32_t room,
                                                  uint32_t* size);
detent_status detent_world2_restore(detent_context* context, detent_handle world,
                                                 const void* bytes, uint32_t size);
detent_status detent_world2_diff(const detent_context* context, detent_handle a,
                                              detent_handle b, uint32_t most, void* names,
                                              uint32_t room, uint32_t* size);
detent_status detent_scene2_diff(const detent_context* context, detent_handle a,
                                              detent_handle b, uint32_t most, void* names,
                                              uint32_t room, uint32_t* size);
detent_status detent_session2_create(detent_context* context,
                                                  const detent_session_settings* settings,
                                                  detent_handle world, detent_handle* session);
detent_status detent_session2_destroy(detent_context* context, detent_handle session);
detent_status detent_session2_world(const detent_context* context,
                                                 detent_handle session, detent_handle* world);
detent_status detent_session2_receive(detent_context* context, detent_handle session,
                                                   uint32_t peer, const void* bytes, uint32_t size,
                                                   uint64_t now);
detent_status detent_session2_begin_frame(detent_context* context,
                                                       detent_handle session, const void* input,
                                                       detent_frame* frame, void* inputs);
detent_status detent_session2_end_frame(detent_context* context,
                                                     detent_handle session);
detent_status detent_session2_packet(detent_context* context, detent_handle session,
                                                  uint64_t now, uint32_t* peer, void* bytes,
                                                  uint32_t room, uint32_t* size);
detent_status detent_session2_event(detent_context* context, detent_handle session,
                                                 detent_session_event* event, void* name,
                                                 uint32_t room);
detent_status detent_session2_status(const detent_context* context,
                                                  detent_handle session,
                                                  detent_session_status* status);
detent_status detent_session2_matched(const detent_context* context,
                                                   detent_handle session, uint32_t peer,
                                                   uint32_t* frame);
detent_status detent_session2_is_awaited(const detent_context* context,
                                                      detent_handle session, uint32_t player);
detent_status detent_session2_drop(detent_context* context, detent_handle session,
                                                uint32_t peer);
detent_status detent_session2_pause(detent_context* context, detent_handle session,
                                                 uint32_t is_paused);
detent_status detent_session2_replay(const detent_context* context,
                                                  detent_handle session, void* bytes, uint32_t room,
                                                  uint32_t* size);
detent_status detent_world2_words(const detent_context* context, detent_handle world,
                                               uint32_t* words);
detent_status detent_world2_set_words(detent_context* context, detent_handle world,
                                                   const uint32_t* words);
detent_status detent_replay2_create(detent_context* context, const void* bytes,
                                                 uint32_t size, detent_handle world,
                                                 uint32_t input_size, uint32_t words,
                                                 detent_handle* replay);
detent_status detent_replay2_destroy(detent_context* context, detent_handle replay);
detent_status detent_replay2_world(const detent_context* context, detent_handle replay,
                                                detent_handle* world);
detent_status detent_replay2_begin_frame(detent_context* context, detent_handle replay,
                                                      detent_frame* frame, void* inputs);
detent_status detent_replay2_end_frame(detent_context* context, detent_handle replay);
detent_status detent_replay2_check(const detent_context* context, detent_handle replay,
                                                detent_replay_check* check);
detent_status detent_raycast3(const detent_ray3* ray, const detent_shape3* shape,
                                           detent_hit3* hit);
detent_status detent_raycast3_many(const detent_ray3* rays, uint32_t count,
                                                const detent_shape3* shape, int32_t* distances);
detent_status detent_contains3(const detent_shape3* shape, const detent_vec3* point);
detent_status detent_overlaps3(const detent_shape3* a, const detent_shape3* b);
detent_status detent_closest_point3(const detent_shape3* shape,
                                                 const detent_vec3* point,
                                                 detent_vec3* closest);
detent_status detent_distance_to_point3(const detent_shape3* shape,
                                                     const detent_vec3* point,
                                                     int32_t* distance);
detent_status detent_distance3(const detent_shape3* a, const detent_shape3* b,
                                            int32_t* distance);
detent_status detent_contact3(const detent_shape3* a, const detent_shape3* b,
                                           detent_manifold3* contact);
detent_status detent_closest_points3(const detent_shape3* a,
                                                  const detent_shape3* b,
                                                  detent_vec3* point_a,
                                                  detent_vec3* point_b);
detent_status detent_cast3(const detent_shape3* shape,
                                        const detent_direction3* direction, int32_t max_distance,
                                        const detent_shape3* target, detent_hit3* hit);
detent_status detent_time_of_impact3(const detent_shape3* a,
                                                  const detent_sweep3* sweep_a,
                                                  const detent_shape3* b,
                                                  const detent_sweep3* sweep_b, int32_t target,
                                                  detent_impact* impact);
detent_status detent_ray3_contains(const detent_ray3* ray, const detent_vec3* point);
detent_status detent_ray3_closest_point(const detent_ray3* ray,
                                                     const detent_vec3* point,
                                                     detent_vec3* closest);
detent_status detent_ray3_distance_to_point(const detent_ray3* ray,
                                                         const detent_vec3* point,
                                                         int32_t* distance);
detent_status detent_shapes3_raycast(const detent_context* context,
                                                  const detent_ray3* ray,
                                                  const detent_shape3* shapes, uint32_t count,
                                                  detent_hit3* hit);
detent_status detent_shapes3_contains(const detent_context* context,
                                                   const detent_shape3* shapes, uint32_t count,
                                                   const detent_vec3* point);
detent_status detent_shapes3_overlaps(const detent_context* context,
                                                   const detent_shape3* a, uint32_t a_count,
                                                   const detent_shape3* b, uint32_t b_count);
detent_status detent_shapes3_closest_point(const detent_context* context,
                                                        const detent_shape3* shapes,
                                                        uint32_t count, const detent_vec3* point,
                                                        detent_vec3* closest);
detent_status detent_shapes3_distance_to_point(const detent_context* context,
                                                            const detent_shape3* shapes,
                                                            uint32_t count,
                                                            const detent_vec3* point,
                                                            int32_t* distance);
detent_status detent_shapes3_distance(const detent_context* context,
                                                   const detent_shape3* a, uint32_t a_count,
                                                   const detent_shape3* b, uint32_t b_count,
                                                   int32_t* distance);
detent_status detent_shapes3_closest_points(const detent_context* context,
                                                         const detent_shape3* a, uint32_t a_count,
                                                         const detent_shape3* b, uint32_t b_count,
                                                         detent_vec3* point_a,
                                                         detent_vec3* point_b);
detent_status detent_shapes3_cast(const detent_context* context,
                                               const detent_shape3* shape,
                                               const detent_direction3* direction,
                                               int32_t max_distance,
                                               const detent_shape3* targets, uint32_t count,
                                               detent_hit3* hit);
detent_status detent_shapes3_contact(const detent_context* context,
                                                  const detent_shape3* a,
                                                  const detent_shape3* b,
                                                  detent_manifold3* contact);
detent_status detent_shapes3_time_of_impact(const detent_context* context,
                                                         const detent_shape3* a,
                                                         const detent_sweep3* sweep_a,
                                                         const detent_shape3* b,
                                                         const detent_sweep3* sweep_b,
                                                         int32_t target, detent_impact* impact);
detent_status detent_hull3_create(detent_context* context, uint32_t id,
                                               const detent_vec3* points, uint32_t count,
                                               detent_handle* hull);
detent_status detent_solid3_create(detent_context* context, uint32_t id,
                                                const detent_vec3* points, uint32_t count,
                                                detent_handle* solid);
detent_status detent_part3_defaults(detent_part3* part);
detent_status detent_compound3_create(detent_context* context, uint32_t id,
                                                   const detent_part3* parts, uint32_t count,
                                                   detent_handle* compound);
detent_status detent_scene3_create(detent_context* context, detent_handle* scene);
detent_status detent_scene3_destroy(detent_context* context, detent_handle scene);
detent_status detent_scene3_add(detent_context* context, detent_handle scene,
                                             const detent_shape3* shape,
                                             const detent_traits* traits, detent_id* id);
detent_status detent_scene3_add_as(detent_context* context, detent_handle scene,
                                                detent_id id, const detent_shape3* shape,
                                                const detent_traits* traits);
detent_status detent_scene3_remove(detent_context* context, detent_handle scene,
                                                detent_id id);
detent_status detent_scene3_replace(detent_context* context, detent_handle scene,
                                                 detent_id id, const detent_shape3* shape);
detent_status detent_scene3_move(detent_context* context, detent_handle scene,
                                              detent_id id, const detent_vec3* by);
detent_status detent_scene3_object(const detent_context* context, detent_handle scene,
                                                detent_id id, detent_shape3* shape,
                                                detent_traits* traits);
detent_status detent_scene3_set_traits(detent_context* context, detent_handle scene,
                                                    detent_id id, const detent_traits* traits);
detent_status detent_scene3_add_frame(detent_context* context, detent_handle scene,
                                                   const detent_transform3* transform,
                                                   detent_id parent, detent_id* frame);
detent_status detent_scene3_move_frame(detent_context* context, detent_handle scene,
                                                    detent_id frame,
                                                    const detent_transform3* transform);
detent_status detent_scene3_remove_frame(detent_context* context, detent_handle scene,
                                                      detent_id frame);
detent_status detent_scene3_frame(const detent_context* context, detent_handle scene,
                                               detent_id frame, detent_transform3* local,
                                               detent_transform3* world);
detent_status detent_scene3_size(const detent_context* context, detent_handle scene,
                                              uint32_t* size);
detent_status detent_scene3_optimize(detent_context* context, detent_handle scene);
detent_status detent_scene3_raycast(const detent_context* context, detent_handle scene,
                                                 const detent_ray3* ray, uint32_t layers,
                                                 detent_object_hit3* hit);
detent_status detent_scene3_raycast_any(const detent_context* context,
                                                     detent_handle scene, const detent_ray3* ray,
                                                     uint32_t layers);
detent_status detent_scene3_raycast_all(const detent_context* context,
                                                     detent_handle scene, const detent_ray3* ray,
                                                     uint32_t layers, detent_object_hit3* hits,
                                                     uint32_t room, uint32_t* count);
detent_status detent_scene3_raycast_many(const detent_context* context,
                                                      detent_handle scene, const detent_ray3* rays,
                                                      uint32_t count, uint32_t layers,
                                                      detent_object_hit3* hits);
detent_status detent_scene3_nearest(const detent_context* context, detent_handle scene,
                                                 const detent_shape3* question, uint32_t layers,
                                                 detent_found* found);
detent_status detent_scene3_any(const detent_context* context, detent_handle scene,
                                             const detent_shape3* question, uint32_t layers);
detent_status detent_scene3_all(const detent_context* context, detent_handle scene,
                                             const detent_shape3* question, uint32_t layers,
                                             detent_found* found, uint32_t room, uint32_t* count);
detent_status detent_scene3_overlaps(const detent_context* context,
                                                  detent_handle scene, detent_pair* pairs,
                                                  uint32_t room, uint32_t* count);
detent_status detent_scene3_cast(const detent_context* context, detent_handle scene,
                                              const detent_shape3* shape,
                                              const detent_direction3* direction,
                                              int32_t max_distance, uint32_t layers,
                                              detent_object_hit3* hit);
detent_status detent_scene3_cast_any(const detent_context* context,
                                                  detent_handle scene,
                                                  const detent_shape3* shape,
                                                  const detent_direction3* direction,
                                                  int32_t max_distance, uint32_t layers);
detent_status detent_scene3_cast_all(const detent_context* context,
                                                  detent_handle scene,
                                                  const detent_shape3* shape,
                                                  const detent_direction3* direction,
                                                  int32_t max_distance, uint32_t layers,
                                                  detent_object_hit3* hits, uint32_t room,
                                                  uint32_t* count);
detent_status detent_mover3_default_settings(detent_mover3_settings* settings);
detent_status detent_mover3_move(const detent_context* context, detent_handle scene,
                                              detent_mover3* mover, const detent_vec3* by,
                                              const detent_mover3_settings* settings,
                                              uint32_t layers, detent_id ignored,
                                              detent_move3* result);
detent_status detent_mover3_clip_velocity(const detent_vec3* velocity,
                                                       const detent_move3* result,
                                                       detent_vec3* clipped);
detent_status detent_scene3_digest(const detent_context* context, detent_handle scene,
                                                uint64_t* digest);
detent_status detent_scene3_snapshot(const detent_context* context,
                                                  detent_handle scene, void* bytes, uint32_t room,
                                                  uint32_t* size);
detent_status detent_scene3_restore(detent_context* context, detent_handle scene,
                                                 const void* bytes, uint32_t size);
detent_status detent_world3_default_settings(detent_world3_settings* settings);
detent_status detent_body3_default_options(detent_body3_options* options);
detent_status detent_world3_create(detent_context* context,
                                                const detent_world3_settings* settings,
                                                detent_handle* world);
detent_status detent_world3_destroy(detent_context* context, detent_handle world);
detent_status detent_world3_add(detent_context* context, detent_handle world,
                                             const detent_shape3* shape,
                                             const detent_body3_options* options, detent_id* id);
detent_status detent_world3_add_as(detent_context* context, detent_handle world,
                                                detent_id id, const detent_shape3* shape,
                                                const detent_body3_options* options);
detent_status detent_world3_remove(detent_context* context, detent_handle world,
                                                detent_id id);
detent_status detent_world3_step(detent_context* context, detent_handle world);
detent_status detent_scene3_follow(detent_context* context, detent_handle scene,
                                                detent_handle world, uint32_t sensors);
detent_status detent_world3_part_of(const detent_context* context,
                                                 detent_handle world, detent_id object,
                                                 detent_id* body, uint32_t* part);
detent_status detent_world3_body(const detent_context* context, detent_handle world,
                                              detent_id id, detent_body3* body);
detent_status detent_world3_bodies(const detent_context* context, detent_handle world,
                                                const detent_id* ids, uint32_t count,
                                                detent_body3* bodies);
detent_status detent_world3_frame(const detent_context* context, detent_handle world,
                                               detent_id id, detent_transform3* frame);
detent_status detent_world3_info(const detent_context* context, detent_handle world,
                                              detent_id id, detent_body_info* info);
detent_status detent_world3_set_position(detent_context* context, detent_handle world,
                                                      detent_id id, const detent_vec3* position);
detent_status detent_world3_set_rotation(detent_context* context, detent_handle world,
                                                      detent_id id,
                                                      const detent_rotation3* rotation);
detent_status detent_world3_set_filter(detent_context* context, detent_handle world,
                                                    detent_id id, uint32_t layers,
                                                    uint32_t collides_with);
detent_status detent_world3_set_friction(detent_context* context, detent_handle world,
                                                      detent_id id, int32_t friction);
detent_status detent_world3_set_restitution(detent_context* context,
                                                         detent_handle world, detent_id id,
                                                         int32_t restitution);
detent_status detent_world3_set_sensor(detent_context* context, detent_handle world,
                                                    detent_id id, uint32_t is_sensor);
detent_status detent_world3_set_gravity_scale(detent_context* context,
                                                           detent_handle world, detent_id id,
                                                           int32_t scale);
detent_status detent_world3_set_damping(detent_context* context, detent_handle world,
                                                     detent_id id, int32_t linear, int32_t angular);
detent_status detent_world3_set_locked(detent_context* context, detent_handle world,
                                                    detent_id id, uint32_t locked);
detent_status detent_world3_set_fast(detent_context* context, detent_handle world,
                                                  detent_id id, uint32_t is_fast);
detent_status detent_world3_set_user(detent_context* context, detent_handle world,
                                                  detent_id id, uint64_t user);
detent_status detent_world3_set_gravity(detent_context* context, detent_handle world,
                                                     const detent_vec3* gravity);
detent_status detent_world3_set_velocity(detent_context* context, detent_handle world,
                                                      detent_id id, const detent_vec3* velocity);
detent_status detent_world3_set_angular_velocity(detent_context* context,
                                                              detent_handle world, detent_id id,
                                                              const int32_t* velocity);
detent_status detent_world3_apply_impulse(detent_context* context, detent_handle world,
                                                       detent_id id, const detent_vec3* impulse,
                                                       const detent_vec3* at);
detent_status detent_world3_apply_force(detent_context* context, detent_handle world,
                                                     detent_id id, const detent_vec3* force,
                                                     const detent_vec3* at);
detent_status detent_world3_apply_torque(detent_context* context, detent_handle world,
                                                      detent_id id, const int32_t* torque);
detent_status detent_joint3_defaults(uint32_t kind, detent_joint3* joint);
detent_status detent_world3_add_joint(detent_context* context, detent_handle world,
                                                   const detent_joint3* joint, detent_id* id);
detent_status detent_world3_change_joint(detent_context* context, detent_handle world,
                                                      detent_id id, const detent_joint3* joint);
detent_status detent_world3_remove_joint(detent_context* context, detent_handle world,
                                                      detent_id id);
detent_status detent_world3_joint(const detent_context* context, detent_handle world,
                                               detent_id id, detent_joint3* joint);
detent_status detent_world3_joint_force(const detent_context* context,
                                                     detent_handle world, detent_id id,
                                                     detent_vec3* force);
detent_status detent_world3_joint_torque(const detent_context* context,
                                                      detent_handle world, detent_id id,
                                                      int32_t* torque);
detent_status detent_world3_joint_count(const detent_context* context,
                                                     detent_handle world, uint32_t* count);
detent_status detent_world3_joint_ids(const detent_context* context,
                                                   detent_handle world, detent_id* joints,
                                                   uint32_t room, uint32_t* count);
detent_status detent_world3_broken(const detent_context* context, detent_handle world,
                                                detent_id* joints, uint32_t room, uint32_t* count);
detent_status detent_world3_local_point(const detent_context* context,
                                                     detent_handle world, detent_id id,
                                                     const detent_vec3* point,
                                                     detent_vec3* local);
detent_status detent_world3_local_frame(const detent_context* context,
                                                     detent_handle world, detent_id id,
                                                     const detent_rotation3* frame,
                                                     detent_rotation3* local);
detent_status detent_world3_size(const detent_context* context, detent_handle world,
                                              uint32_t* size);
detent_status detent_world3_body_ids(const detent_context* context,
                                                  detent_handle world, detent_id* ids,
                                                  uint32_t room, uint32_t* count);
detent_status detent_world3_touching(const detent_context* context,
                                                  detent_handle world, detent_id body,
                                                  detent_touch* touches, uint32_t room,
                                                  uint32_t* count);
detent_status detent_world3_contacts(const detent_context* context,
                                                  detent_handle world, detent_id body,
                                                  detent_world3_contact* contacts, uint32_t room,
                                                  uint32_t* count);
detent_status detent_world3_events(const detent_context* context, detent_handle world,
                                                detent_touch* events, uint32_t room,
                                                uint32_t* count);
detent_status detent_world3_digest(const detent_context* context, detent_handle world,
                                                uint64_t* digest);
detent_status detent_world3_digest_of(const detent_context* context,
                                                   detent_handle world, detent_id id,
                                                   uint64_t* digest);
detent_status detent_world3_snapshot(const detent_context* context,
                                                  detent_handle world, void* bytes, uint32_t room,
                                                  uint32_t* size);
detent_status detent_world3_restore(detent_context* context, detent_handle world,
                                                 const void* bytes, uint32_t size);
detent_status detent_world3_diff(const detent_context* context, detent_handle a,
                                              detent_handle b, uint32_t most, void* names,
                                              uint32_t room, uint32_t* size);
detent_status detent_scene3_diff(const detent_context* context, detent_handle a,
                                              detent_handle b, uint32_t most, void* names,
                                              uint32_t room, uint32_t* size);
detent_status detent_session3_create(detent_context* context,
                                                  const detent_session_settings* settings,
                                                  detent_handle world, detent_handle* session);
detent_status detent_session3_destroy(detent_context* context, detent_handle session);
detent_status detent_session3_world(const detent_context* context,
                                                 detent_handle session, detent_handle* world);
detent_status detent_session3_receive(detent_context* context, detent_handle session,
                                                   uint32_t peer, const void* bytes, uint32_t size,
                                                   uint64_t now);
detent_status detent_session3_begin_frame(detent_context* context,
                                                       detent_handle session, const void* input,
                                                       detent_frame* frame, void* inputs);
detent_status detent_session3_end_frame(detent_context* context,
                                                     detent_handle session);
detent_status detent_session3_packet(detent_context* context, detent_handle session,
                                                  uint64_t now, uint32_t* peer, void* bytes,
                                                  uint32_t room, uint32_t* size);
detent_status detent_session3_event(detent_context* context, detent_handle session,
                                                 detent_session_event* event, void* name,
                                                 uint32_t room);
detent_status detent_session3_status(const detent_context* context,
                                                  detent_handle session,
                                                  detent_session_status* status);
detent_status detent_session3_matched(const detent_context* context,
                                                   detent_handle session, uint32_t peer,
                                                   uint32_t* frame);
detent_status detent_session3_is_awaited(const detent_context* context,
                                                      detent_handle session, uint32_t player);
detent_status detent_session3_drop(detent_context* context, detent_handle session,
                                                uint32_t peer);
detent_status detent_session3_pause(detent_context* context, detent_handle session,
                                                 uint32_t is_paused);
detent_status detent_session3_replay(const detent_context* context,
                                                  detent_handle session, void* bytes, uint32_t room,
                                                  uint32_t* size);
detent_status detent_world3_words(const detent_context* context, detent_handle world,
                                               uint32_t* words);
detent_status detent_world3_set_words(detent_context* context, detent_handle world,
                                                   const uint32_t* words);
detent_status detent_replay3_create(detent_context* context, const void* bytes,
                                                 uint32_t size, detent_handle world,
                                                 uint32_t input_size, uint32_t words,
                                                 detent_handle* replay);
detent_status detent_replay3_destroy(detent_context* context, detent_handle replay);
detent_status detent_replay3_world(const detent_context* context, detent_handle replay,
                                                detent_handle* world);
detent_status detent_replay3_begin_frame(detent_context* context, detent_handle replay,
                                                      detent_frame* frame, void* inputs);
detent_status detent_replay3_end_frame(detent_context* context, detent_handle replay);
detent_status detent_replay3_check(const detent_context* context, detent_handle replay,
                                                detent_replay_check* check);
detent_status detent_camera3_look_at(const detent_vec3* eye, const detent_vec3* target,
                                                const detent_vec3* up, detent_transform3* pose);
detent_status detent_camera3_frustum(const detent_camera3* camera,
                                                detent_frustum3* frustum);
detent_status detent_camera3_pick_ray(const detent_camera3* camera, int32_t width,
                                                 int32_t height, int32_t column, int32_t row,
                                                 detent_ray3* ray);
detent_status detent_camera3_project(const detent_camera3* camera, int32_t width,
                                                int32_t height, const detent_vec3* point,
                                                detent_screen_point3* seen);
detent_status detent_camera3_unproject(const detent_camera3* camera, int32_t width,
                                                  int32_t height, int32_t column, int32_t row,
                                                  int32_t depth, detent_vec3* point);
detent_status detent_frustum3_raycast(const detent_ray3* ray,
                                                 const detent_frustum3* frustum, detent_hit3* hit);
detent_status detent_frustum3_contains(const detent_frustum3* frustum,
                                                  const detent_vec3* point);
detent_status detent_frustum3_overlaps(const detent_context* context,
                                                  const detent_frustum3* frustum,
                                                  const detent_shape3* shapes, uint32_t count);
detent_status detent_frustum3_overlaps_frustum(const detent_frustum3* a,
                                                          const detent_frustum3* b);
detent_status detent_frustum3_closest_point(const detent_frustum3* frustum,
                                                       const detent_vec3* point,
                                                       detent_vec3* closest);
detent_status detent_frustum3_distance_to_point(const detent_frustum3* frustum,
                                                           const detent_vec3* point,
                                                           int32_t* distance);
detent_status detent_scene3_frustum_nearest(const detent_context* context,
                                                       detent_handle scene,
                                                       const detent_frustum3* frustum,
                                                       uint32_t layers, detent_found* found);
detent_status detent_scene3_frustum_any(const detent_context* context,
                                                   detent_handle scene,
                                                   const detent_frustum3* frustum, uint32_t layers);
detent_status detent_scene3_frustum_all(const detent_context* context,
                                                   detent_handle scene,
                                                   const detent_frustum3* frustum, uint32_t layers,
                                                   detent_found* found, uint32_t room,
                                                   uint32_t* count);
]]
local sizes = {
  detent_id = 8,
  detent_pair = 16,
  detent_touch = 28,
  detent_body_info = 32,
  detent_found = 12,
  detent_impact = 12,
  detent_session_settings = 72,
  detent_frame = 16,
  detent_session_event = 28,
  detent_session_status = 40,
  detent_replay_check = 20,
  detent_traits = 24,
  detent_context = 32,
  detent_vec2 = 8,
  detent_direction2 = 8,
  detent_rotation2 = 16,
  detent_transform2 = 28,
  detent_ray2 = 20,
  detent_sphere2 = 12,
  detent_aabb2 = 16,
  detent_obb2 = 32,
  detent_plane2 = 12,
  detent_triangle2 = 24,
  detent_capsule2 = 20,
  detent_segment2 = 16,
  detent_shape2 = 40,
  detent_hit2 = 20,
  detent_contact_point2 = 16,
  detent_manifold2 = 48,
  detent_sweep2 = 48,
  detent_object_hit2 = 36,
  detent_mover2 = 84,
  detent_mover2_settings = 24,
  detent_mover2_touch = 24,
  detent_move2 = 224,
  detent_world2_contact_point = 20,
  detent_world2_contact = 92,
  detent_world2_settings = 36,
  detent_body2_options = 80,
  detent_part2 = 60,
  detent_joint2 = 112,
  detent_body2 = 40,
  detent_vec3 = 12,
  detent_direction3 = 12,
  detent_rotation3 = 36,
  detent_transform3 = 52,
  detent_ray3 = 28,
  detent_sphere3 = 16,
  detent_aabb3 = 24,
  detent_obb3 = 60,
  detent_plane3 = 16,
  detent_triangle3 = 36,
  detent_capsule3 = 28,
  detent_segment3 = 24,
  detent_shape3 = 68,
  detent_hit3 = 28,
  detent_contact_point3 = 20,
  detent_manifold3 = 100,
  detent_sweep3 = 96,
  detent_object_hit3 = 44,
  detent_mover3 = 124,
  detent_mover3_settings = 28,
  detent_mover3_touch = 32,
  detent_move3 = 300,
  detent_world3_contact_point = 24,
  detent_world3_contact = 156,
  detent_world3_settings = 40,
  detent_body3_options = 96,
  detent_part3 = 88,
  detent_joint3 = 160,
  detent_body3 = 76,
  detent_camera3 = 80,
  detent_frustum3 = 96,
  detent_screen_point3 = 12,
}
for name, size in pairs(sizes) do assert(ffi.sizeof(name) == size, name) end
return sizes
