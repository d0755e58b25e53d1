// SPDX-License-Identifier: MIT
// Written by bindings/generate from bindings/detent.h.in: change that file instead.

export const OK = 1;
export const NO = 0;
export const BAD_ARGUMENT = -1;
export const BAD_CONTEXT = -2;
export const BAD_HANDLE = -3;
export const NOT_UNIT = -4;
export const NO_QUERY = -5;
export const NO_MEMORY = -6;
export const BROKEN = -7;
export const FULL = -8;
export const IN_USE = -9;
export const NOT_NOW = -10;
export const NO_SNAPSHOT = -20;
export const OTHER_VERSION = -21;
export const TRUNCATED = -22;
export const CORRUPTED = -23;
export const OTHER_SCENE = -24;
export const OTHER_FIXED_PART = -25;
export const NO_ROOM = -26;
export const UNKNOWN_ASSET = -27;
export const OTHER_ASSET = -28;
export const SPHERE = 1;
export const AABB = 2;
export const OBB = 3;
export const PLANE = 4;
export const TRIANGLE = 5;
export const CAPSULE = 6;
export const SEGMENT = 7;
export const POINT = 8;
export const HULL = 9;
export const MESH = 10;
export const HEIGHT_FIELD = 11;
export const COMPOUND = 12;
export const MOVING = 0;
export const FIXED = 1;
export const DYNAMIC_BODY = 0;
export const KINEMATIC_BODY = 1;
export const FIXED_BODY = 2;
export const DISTANCE_JOINT = 1;
export const BALL_JOINT = 2;
export const HINGE_JOINT = 3;
export const WELD_JOINT = 4;
export const SLIDER_JOINT = 5;
export const WHEEL_JOINT = 6;
export const CONE_JOINT = 7;
export const LOCK_X = 1;
export const LOCK_Y = 2;
export const LOCK_Z = 4;
export const LOCK_TURN_X = 8;
export const LOCK_TURN_Y = 16;
export const LOCK_TURN_Z = 32;
export const PLAYED = 0;
export const CONNECTING = 1;
export const CATCHING_UP = 2;
export const STARVED = 3;
export const AHEAD = 4;
export const PAUSED = 5;
export const OVER = 6;
export const JOINING = 7;
export const CONNECTED = 0;
export const SILENT = 1;
export const HEARD_AGAIN = 2;
export const PEER_PAUSED = 3;
export const PEER_RESUMED = 4;
export const DROPPED = 5;
export const EXPELLED = 6;
export const LEFT = 7;
export const TOO_SLOW = 8;
export const CONTRADICTION = 9;
export const DESYNC = 10;
export const DESYNC_FIELD = 11;
export const ARRIVED = 12;
export const LOADED = 13;
export const NO_SUCH_WORLD = 14;
export const JOINED = 15;
export const REPLAY_WHOLE = 0;
export const REPLAY_CUT = 1;
export const REPLAY_CORRUPTED = 2;
export const INPUT = 16;
export const PACKET = 1200;
export const LATE_SNAPSHOT = 65536;
export const NAME = 119;
export const WORDS = 256;
export const PLAYERS = 8;

// The size of each structure, whether it is a vector, its fields (name, type, offset,
// elements) and the members of its union.
export const layouts = {
  detent_id: { size: 8, isVector: false,
    fields: [['index', 'uint32_t', 0, 0], ['generation', 'uint32_t', 4, 0]],
    union: [] },
  detent_pair: { size: 16, isVector: false,
    fields: [['first', 'detent_id', 0, 0], ['second', 'detent_id', 8, 0]],
    union: [] },
  detent_touch: { size: 28, isVector: false,
    fields: [['a', 'detent_id', 0, 0], ['b', 'detent_id', 8, 0], ['begins', 'uint32_t', 16, 0], ['part_a', 'uint32_t', 20, 0], ['part_b', 'uint32_t', 24, 0]],
    union: [] },
  detent_body_info: { size: 32, isVector: false,
    fields: [['user', 'uint64_t', 0, 0], ['layers', 'uint32_t', 8, 0], ['collides_with', 'uint32_t', 12, 0], ['motion', 'uint32_t', 16, 0], ['is_sensor', 'uint32_t', 20, 0], ['is_asleep', 'uint32_t', 24, 0], ['part_count', 'uint32_t', 28, 0]],
    union: [] },
  detent_found: { size: 12, isVector: false,
    fields: [['distance', 'int32_t', 0, 0], ['id', 'detent_id', 4, 0]],
    union: [] },
  detent_impact: { size: 12, isVector: false,
    fields: [['time', 'int32_t', 0, 0], ['distance', 'int32_t', 4, 0], ['is_hit', 'uint32_t', 8, 0]],
    union: [] },
  detent_session_settings: { size: 72, isVector: false,
    fields: [['match', 'uint64_t', 0, 0], ['send_interval', 'uint64_t', 8, 0], ['silence', 'uint64_t', 16, 0], ['self', 'uint32_t', 24, 0], ['players', 'uint32_t', 28, 0], ['spectators', 'uint32_t', 32, 0], ['delay', 'uint32_t', 36, 0], ['prediction', 'uint32_t', 40, 0], ['frames_per_call', 'uint32_t', 44, 0], ['absent', 'uint32_t', 48, 0], ['life', 'uint32_t', 52, 0], ['wants_seat', 'uint32_t', 56, 0], ['input_size', 'uint32_t', 60, 0], ['words', 'uint32_t', 64, 0], ['replay_every', 'uint32_t', 68, 0]],
    union: [] },
  detent_frame: { size: 16, isVector: false,
    fields: [['number', 'uint32_t', 0, 0], ['players', 'uint32_t', 4, 0], ['present', 'uint32_t', 8, 0], ['state', 'uint32_t', 12, 0]],
    union: [] },
  detent_session_event: { size: 28, isVector: false,
    fields: [['kind', 'uint32_t', 0, 0], ['peer', 'uint32_t', 4, 0], ['frame', 'uint32_t', 8, 0], ['name_size', 'uint32_t', 12, 0], ['has_object', 'uint32_t', 16, 0], ['object', 'detent_id', 20, 0]],
    union: [] },
  detent_session_status: { size: 40, isVector: false,
    fields: [['digest', 'uint64_t', 0, 0], ['resimulated', 'uint64_t', 8, 0], ['frame', 'uint32_t', 16, 0], ['final_frame', 'uint32_t', 20, 0], ['checked_frame', 'uint32_t', 24, 0], ['start_frame', 'uint32_t', 28, 0], ['is_player', 'uint32_t', 32, 0], ['players', 'uint32_t', 36, 0]],
    union: [] },
  detent_replay_check: { size: 20, isVector: false,
    fields: [['state', 'uint32_t', 0, 0], ['frames', 'uint32_t', 4, 0], ['equal', 'uint32_t', 8, 0], ['is_equal', 'uint32_t', 12, 0], ['players', 'uint32_t', 16, 0]],
    union: [] },
  detent_traits: { size: 24, isVector: false,
    fields: [['user', 'uint64_t', 0, 0], ['layers', 'uint32_t', 8, 0], ['motion', 'uint32_t', 12, 0], ['frame', 'detent_id', 16, 0]],
    union: [] },
  detent_context: { size: 32, isVector: false,
    fields: [['words', 'uint64_t', 0, 4]],
    union: [] },
  detent_vec2: { size: 8, isVector: true,
    fields: [['x', 'int32_t', 0, 0], ['y', 'int32_t', 4, 0]],
    union: [] },
  detent_direction2: { size: 8, isVector: true,
    fields: [['x', 'int32_t', 0, 0], ['y', 'int32_t', 4, 0]],
    union: [] },
  detent_rotation2: { size: 16, isVector: false,
    fields: [['axis', 'detent_direction2', 0, 2]],
    union: [] },
  detent_transform2: { size: 28, isVector: false,
    fields: [['translation', 'detent_vec2', 0, 0], ['rotation', 'detent_rotation2', 8, 0], ['scale', 'int32_t', 24, 0]],
    union: [] },
  detent_ray2: { size: 20, isVector: false,
    fields: [['origin', 'detent_vec2', 0, 0], ['direction', 'detent_direction2', 8, 0], ['max_distance', 'int32_t', 16, 0]],
    union: [] },
  detent_sphere2: { size: 12, isVector: false,
    fields: [['center', 'detent_vec2', 0, 0], ['radius', 'int32_t', 8, 0]],
    union: [] },
  detent_aabb2: { size: 16, isVector: false,
    fields: [['min', 'detent_vec2', 0, 0], ['max', 'detent_vec2', 8, 0]],
    union: [] },
  detent_obb2: { size: 32, isVector: false,
    fields: [['center', 'detent_vec2', 0, 0], ['half_extents', 'detent_vec2', 8, 0], ['rotation', 'detent_rotation2', 16, 0]],
    union: [] },
  detent_plane2: { size: 12, isVector: false,
    fields: [['normal', 'detent_direction2', 0, 0], ['offset', 'int32_t', 8, 0]],
    union: [] },
  detent_triangle2: { size: 24, isVector: false,
    fields: [['a', 'detent_vec2', 0, 0], ['b', 'detent_vec2', 8, 0], ['c', 'detent_vec2', 16, 0]],
    union: [] },
  detent_capsule2: { size: 20, isVector: false,
    fields: [['a', 'detent_vec2', 0, 0], ['b', 'detent_vec2', 8, 0], ['radius', 'int32_t', 16, 0]],
    union: [] },
  detent_segment2: { size: 16, isVector: false,
    fields: [['start', 'detent_vec2', 0, 0], ['end', 'detent_vec2', 8, 0]],
    union: [] },
  detent_shape2: { size: 40, isVector: false,
    fields: [['kind', 'uint32_t', 0, 0], ['asset', 'uint32_t', 4, 0]],
    union: [['sphere', 'detent_sphere2', 8, 0], ['aabb', 'detent_aabb2', 8, 0], ['obb', 'detent_obb2', 8, 0], ['plane', 'detent_plane2', 8, 0], ['triangle', 'detent_triangle2', 8, 0], ['capsule', 'detent_capsule2', 8, 0], ['segment', 'detent_segment2', 8, 0], ['point', 'detent_vec2', 8, 0], ['placed', 'detent_transform2', 8, 0]] },
  detent_hit2: { size: 20, isVector: false,
    fields: [['distance', 'int32_t', 0, 0], ['point', 'detent_vec2', 4, 0], ['normal', 'detent_direction2', 12, 0]],
    union: [] },
  detent_contact_point2: { size: 16, isVector: false,
    fields: [['point', 'detent_vec2', 0, 0], ['depth', 'int32_t', 8, 0], ['feature', 'uint32_t', 12, 0]],
    union: [] },
  detent_manifold2: { size: 48, isVector: false,
    fields: [['normal', 'detent_direction2', 0, 0], ['depth', 'int32_t', 8, 0], ['count', 'uint32_t', 12, 0], ['points', 'detent_contact_point2', 16, 2]],
    union: [] },
  detent_sweep2: { size: 48, isVector: false,
    fields: [['start', 'detent_vec2', 0, 0], ['end', 'detent_vec2', 8, 0], ['start_rotation', 'detent_rotation2', 16, 0], ['end_rotation', 'detent_rotation2', 32, 0]],
    union: [] },
  detent_object_hit2: { size: 36, isVector: false,
    fields: [['distance', 'int32_t', 0, 0], ['id', 'detent_id', 4, 0], ['point', 'detent_vec2', 12, 0], ['normal', 'detent_direction2', 20, 0], ['triangle', 'uint32_t', 28, 0], ['has_triangle', 'uint32_t', 32, 0]],
    union: [] },
  detent_mover2: { size: 84, isVector: false,
    fields: [['shape', 'detent_shape2', 0, 0], ['is_grounded', 'uint32_t', 40, 0], ['object', 'detent_id', 44, 0], ['normal', 'detent_direction2', 52, 0], ['frame', 'detent_id', 60, 0], ['local', 'detent_vec2', 68, 0], ['point', 'detent_vec2', 76, 0]],
    union: [] },
  detent_mover2_settings: { size: 24, isVector: false,
    fields: [['up', 'detent_direction2', 0, 0], ['skin', 'int32_t', 8, 0], ['step_height', 'int32_t', 12, 0], ['snap_distance', 'int32_t', 16, 0], ['max_slope', 'uint32_t', 20, 0]],
    union: [] },
  detent_mover2_touch: { size: 24, isVector: false,
    fields: [['object', 'detent_id', 0, 0], ['point', 'detent_vec2', 8, 0], ['normal', 'detent_direction2', 16, 0]],
    union: [] },
  detent_move2: { size: 224, isVector: false,
    fields: [['moved', 'detent_vec2', 0, 0], ['carried', 'detent_vec2', 8, 0], ['pushed', 'detent_vec2', 16, 0], ['count', 'uint32_t', 24, 0], ['is_stuck', 'uint32_t', 28, 0], ['touched', 'detent_mover2_touch', 32, 8]],
    union: [] },
  detent_world2_contact_point: { size: 20, isVector: false,
    fields: [['point', 'detent_vec2', 0, 0], ['separation', 'int32_t', 8, 0], ['impulse', 'int32_t', 12, 0], ['feature', 'uint32_t', 16, 0]],
    union: [] },
  detent_world2_contact: { size: 92, isVector: false,
    fields: [['a', 'detent_id', 0, 0], ['b', 'detent_id', 8, 0], ['part_a', 'uint32_t', 16, 0], ['part_b', 'uint32_t', 20, 0], ['triangle', 'uint32_t', 24, 0], ['normal', 'detent_direction2', 28, 0], ['impulse', 'int32_t', 36, 0], ['friction', 'detent_vec2', 40, 0], ['count', 'uint32_t', 48, 0], ['points', 'detent_world2_contact_point', 52, 2]],
    union: [] },
  detent_world2_settings: { size: 36, isVector: false,
    fields: [['ticks_per_second', 'int32_t', 0, 0], ['substeps', 'int32_t', 4, 0], ['gravity', 'detent_vec2', 8, 0], ['margin', 'int32_t', 16, 0], ['push_speed', 'int32_t', 20, 0], ['bounce_threshold', 'int32_t', 24, 0], ['sleep_speed', 'int32_t', 28, 0], ['hold_distance', 'int32_t', 32, 0]],
    union: [] },
  detent_body2_options: { size: 80, isVector: false,
    fields: [['user', 'uint64_t', 0, 0], ['layers', 'uint32_t', 8, 0], ['collides_with', 'uint32_t', 12, 0], ['motion', 'uint32_t', 16, 0], ['density', 'int32_t', 20, 0], ['friction', 'int32_t', 24, 0], ['restitution', 'int32_t', 28, 0], ['rolling_resistance', 'int32_t', 32, 0], ['linear_damping', 'int32_t', 36, 0], ['angular_damping', 'int32_t', 40, 0], ['velocity', 'detent_vec2', 44, 0], ['angular_velocity', 'int32_t', 52, 1], ['gravity_scale', 'int32_t', 56, 0], ['locked', 'uint32_t', 60, 0], ['is_sensor', 'uint32_t', 64, 0], ['is_fast', 'uint32_t', 68, 0], ['reserved', 'uint32_t', 72, 2]],
    union: [] },
  detent_part2: { size: 60, isVector: false,
    fields: [['shape', 'detent_shape2', 0, 0], ['density', 'int32_t', 40, 0], ['friction', 'int32_t', 44, 0], ['restitution', 'int32_t', 48, 0], ['rolling_resistance', 'int32_t', 52, 0], ['is_sensor', 'uint32_t', 56, 0]],
    union: [] },
  detent_joint2: { size: 112, isVector: false,
    fields: [['kind', 'uint32_t', 0, 0], ['a', 'detent_id', 4, 0], ['b', 'detent_id', 12, 0], ['anchor_a', 'detent_vec2', 20, 0], ['anchor_b', 'detent_vec2', 28, 0], ['frame_a', 'detent_rotation2', 36, 0], ['frame_b', 'detent_rotation2', 52, 0], ['collide', 'uint32_t', 68, 0], ['break_force', 'int32_t', 72, 0], ['has_limits', 'uint32_t', 76, 0], ['lower', 'int32_t', 80, 0], ['upper', 'int32_t', 84, 0], ['motor_speed', 'int32_t', 88, 0], ['motor_force', 'int32_t', 92, 0], ['length', 'int32_t', 96, 0], ['frequency', 'int32_t', 100, 0], ['damping_ratio', 'int32_t', 104, 0], ['cone_angle', 'int32_t', 108, 0]],
    union: [] },
  detent_body2: { size: 40, isVector: false,
    fields: [['position', 'detent_vec2', 0, 0], ['rotation', 'detent_rotation2', 8, 0], ['velocity', 'detent_vec2', 24, 0], ['angular_velocity', 'int32_t', 32, 1], ['is_asleep', 'uint32_t', 36, 0]],
    union: [] },
  detent_vec3: { size: 12, isVector: true,
    fields: [['x', 'int32_t', 0, 0], ['y', 'int32_t', 4, 0], ['z', 'int32_t', 8, 0]],
    union: [] },
  detent_direction3: { size: 12, isVector: true,
    fields: [['x', 'int32_t', 0, 0], ['y', 'int32_t', 4, 0], ['z', 'int32_t', 8, 0]],
    union: [] },
  detent_rotation3: { size: 36, isVector: false,
    fields: [['axis', 'detent_direction3', 0, 3]],
    union: [] },
  detent_transform3: { size: 52, isVector: false,
    fields: [['translation', 'detent_vec3', 0, 0], ['rotation', 'detent_rotation3', 12, 0], ['scale', 'int32_t', 48, 0]],
    union: [] },
  detent_ray3: { size: 28, isVector: false,
    fields: [['origin', 'detent_vec3', 0, 0], ['direction', 'detent_direction3', 12, 0], ['max_distance', 'int32_t', 24, 0]],
    union: [] },
  detent_sphere3: { size: 16, isVector: false,
    fields: [['center', 'detent_vec3', 0, 0], ['radius', 'int32_t', 12, 0]],
    union: [] },
  detent_aabb3: { size: 24, isVector: false,
    fields: [['min', 'detent_vec3', 0, 0], ['max', 'detent_vec3', 12, 0]],
    union: [] },
  detent_obb3: { size: 60, isVector: false,
    fields: [['center', 'detent_vec3', 0, 0], ['half_extents', 'detent_vec3', 12, 0], ['rotation', 'detent_rotation3', 24, 0]],
    union: [] },
  detent_plane3: { size: 16, isVector: false,
    fields: [['normal', 'detent_direction3', 0, 0], ['offset', 'int32_t', 12, 0]],
    union: [] },
  detent_triangle3: { size: 36, isVector: false,
    fields: [['a', 'detent_vec3', 0, 0], ['b', 'detent_vec3', 12, 0], ['c', 'detent_vec3', 24, 0]],
    union: [] },
  detent_capsule3: { size: 28, isVector: false,
    fields: [['a', 'detent_vec3', 0, 0], ['b', 'detent_vec3', 12, 0], ['radius', 'int32_t', 24, 0]],
    union: [] },
  detent_segment3: { size: 24, isVector: false,
    fields: [['start', 'detent_vec3', 0, 0], ['end', 'detent_vec3', 12, 0]],
    union: [] },
  detent_shape3: { size: 68, isVector: false,
    fields: [['kind', 'uint32_t', 0, 0], ['asset', 'uint32_t', 4, 0]],
    union: [['sphere', 'detent_sphere3', 8, 0], ['aabb', 'detent_aabb3', 8, 0], ['obb', 'detent_obb3', 8, 0], ['plane', 'detent_plane3', 8, 0], ['triangle', 'detent_triangle3', 8, 0], ['capsule', 'detent_capsule3', 8, 0], ['segment', 'detent_segment3', 8, 0], ['point', 'detent_vec3', 8, 0], ['placed', 'detent_transform3', 8, 0]] },
  detent_hit3: { size: 28, isVector: false,
    fields: [['distance', 'int32_t', 0, 0], ['point', 'detent_vec3', 4, 0], ['normal', 'detent_direction3', 16, 0]],
    union: [] },
  detent_contact_point3: { size: 20, isVector: false,
    fields: [['point', 'detent_vec3', 0, 0], ['depth', 'int32_t', 12, 0], ['feature', 'uint32_t', 16, 0]],
    union: [] },
  detent_manifold3: { size: 100, isVector: false,
    fields: [['normal', 'detent_direction3', 0, 0], ['depth', 'int32_t', 12, 0], ['count', 'uint32_t', 16, 0], ['points', 'detent_contact_point3', 20, 4]],
    union: [] },
  detent_sweep3: { size: 96, isVector: false,
    fields: [['start', 'detent_vec3', 0, 0], ['end', 'detent_vec3', 12, 0], ['start_rotation', 'detent_rotation3', 24, 0], ['end_rotation', 'detent_rotation3', 60, 0]],
    union: [] },
  detent_object_hit3: { size: 44, isVector: false,
    fields: [['distance', 'int32_t', 0, 0], ['id', 'detent_id', 4, 0], ['point', 'detent_vec3', 12, 0], ['normal', 'detent_direction3', 24, 0], ['triangle', 'uint32_t', 36, 0], ['has_triangle', 'uint32_t', 40, 0]],
    union: [] },
  detent_mover3: { size: 124, isVector: false,
    fields: [['shape', 'detent_shape3', 0, 0], ['is_grounded', 'uint32_t', 68, 0], ['object', 'detent_id', 72, 0], ['normal', 'detent_direction3', 80, 0], ['frame', 'detent_id', 92, 0], ['local', 'detent_vec3', 100, 0], ['point', 'detent_vec3', 112, 0]],
    union: [] },
  detent_mover3_settings: { size: 28, isVector: false,
    fields: [['up', 'detent_direction3', 0, 0], ['skin', 'int32_t', 12, 0], ['step_height', 'int32_t', 16, 0], ['snap_distance', 'int32_t', 20, 0], ['max_slope', 'uint32_t', 24, 0]],
    union: [] },
  detent_mover3_touch: { size: 32, isVector: false,
    fields: [['object', 'detent_id', 0, 0], ['point', 'detent_vec3', 8, 0], ['normal', 'detent_direction3', 20, 0]],
    union: [] },
  detent_move3: { size: 300, isVector: false,
    fields: [['moved', 'detent_vec3', 0, 0], ['carried', 'detent_vec3', 12, 0], ['pushed', 'detent_vec3', 24, 0], ['count', 'uint32_t', 36, 0], ['is_stuck', 'uint32_t', 40, 0], ['touched', 'detent_mover3_touch', 44, 8]],
    union: [] },
  detent_world3_contact_point: { size: 24, isVector: false,
    fields: [['point', 'detent_vec3', 0, 0], ['separation', 'int32_t', 12, 0], ['impulse', 'int32_t', 16, 0], ['feature', 'uint32_t', 20, 0]],
    union: [] },
  detent_world3_contact: { size: 156, isVector: false,
    fields: [['a', 'detent_id', 0, 0], ['b', 'detent_id', 8, 0], ['part_a', 'uint32_t', 16, 0], ['part_b', 'uint32_t', 20, 0], ['triangle', 'uint32_t', 24, 0], ['normal', 'detent_direction3', 28, 0], ['impulse', 'int32_t', 40, 0], ['friction', 'detent_vec3', 44, 0], ['count', 'uint32_t', 56, 0], ['points', 'detent_world3_contact_point', 60, 4]],
    union: [] },
  detent_world3_settings: { size: 40, isVector: false,
    fields: [['ticks_per_second', 'int32_t', 0, 0], ['substeps', 'int32_t', 4, 0], ['gravity', 'detent_vec3', 8, 0], ['margin', 'int32_t', 20, 0], ['push_speed', 'int32_t', 24, 0], ['bounce_threshold', 'int32_t', 28, 0], ['sleep_speed', 'int32_t', 32, 0], ['hold_distance', 'int32_t', 36, 0]],
    union: [] },
  detent_body3_options: { size: 96, isVector: false,
    fields: [['user', 'uint64_t', 0, 0], ['layers', 'uint32_t', 8, 0], ['collides_with', 'uint32_t', 12, 0], ['motion', 'uint32_t', 16, 0], ['density', 'int32_t', 20, 0], ['friction', 'int32_t', 24, 0], ['restitution', 'int32_t', 28, 0], ['rolling_resistance', 'int32_t', 32, 0], ['linear_damping', 'int32_t', 36, 0], ['angular_damping', 'int32_t', 40, 0], ['velocity', 'detent_vec3', 44, 0], ['angular_velocity', 'int32_t', 56, 3], ['gravity_scale', 'int32_t', 68, 0], ['locked', 'uint32_t', 72, 0], ['is_sensor', 'uint32_t', 76, 0], ['is_fast', 'uint32_t', 80, 0], ['reserved', 'uint32_t', 84, 3]],
    union: [] },
  detent_part3: { size: 88, isVector: false,
    fields: [['shape', 'detent_shape3', 0, 0], ['density', 'int32_t', 68, 0], ['friction', 'int32_t', 72, 0], ['restitution', 'int32_t', 76, 0], ['rolling_resistance', 'int32_t', 80, 0], ['is_sensor', 'uint32_t', 84, 0]],
    union: [] },
  detent_joint3: { size: 160, isVector: false,
    fields: [['kind', 'uint32_t', 0, 0], ['a', 'detent_id', 4, 0], ['b', 'detent_id', 12, 0], ['anchor_a', 'detent_vec3', 20, 0], ['anchor_b', 'detent_vec3', 32, 0], ['frame_a', 'detent_rotation3', 44, 0], ['frame_b', 'detent_rotation3', 80, 0], ['collide', 'uint32_t', 116, 0], ['break_force', 'int32_t', 120, 0], ['has_limits', 'uint32_t', 124, 0], ['lower', 'int32_t', 128, 0], ['upper', 'int32_t', 132, 0], ['motor_speed', 'int32_t', 136, 0], ['motor_force', 'int32_t', 140, 0], ['length', 'int32_t', 144, 0], ['frequency', 'int32_t', 148, 0], ['damping_ratio', 'int32_t', 152, 0], ['cone_angle', 'int32_t', 156, 0]],
    union: [] },
  detent_body3: { size: 76, isVector: false,
    fields: [['position', 'detent_vec3', 0, 0], ['rotation', 'detent_rotation3', 12, 0], ['velocity', 'detent_vec3', 48, 0], ['angular_velocity', 'int32_t', 60, 3], ['is_asleep', 'uint32_t', 72, 0]],
    union: [] },
  detent_camera3: { size: 80, isVector: false,
    fields: [['pose', 'detent_transform3', 0, 0], ['has_perspective', 'uint32_t', 52, 0], ['fov', 'uint32_t', 56, 0], ['aspect', 'int32_t', 60, 0], ['half_width', 'int32_t', 64, 0], ['half_height', 'int32_t', 68, 0], ['near_distance', 'int32_t', 72, 0], ['far_distance', 'int32_t', 76, 0]],
    union: [] },
  detent_frustum3: { size: 96, isVector: false,
    fields: [['corners', 'detent_vec3', 0, 8]],
    union: [] },
  detent_screen_point3: { size: 12, isVector: false,
    fields: [['x', 'int32_t', 0, 0], ['y', 'int32_t', 4, 0], ['depth', 'int32_t', 8, 0]],
    union: [] },
};
