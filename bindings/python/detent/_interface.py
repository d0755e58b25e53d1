# SPDX-License-Identifier: MIT
# Written by bindings/generate from bindings/detent.h.in: change that file instead.
"""The C interface as it is: structures, constants and the signatures of functions."""
from ctypes import (POINTER, Union, c_char_p, c_int32, c_size_t, c_uint32, c_uint64,
                    c_void_p, sizeof)

from ._checked import Structure, argument

DETENT_OK = 1
DETENT_NO = 0
DETENT_BAD_ARGUMENT = -1
DETENT_BAD_CONTEXT = -2
DETENT_BAD_HANDLE = -3
DETENT_NOT_UNIT = -4
DETENT_NO_QUERY = -5
DETENT_NO_MEMORY = -6
DETENT_BROKEN = -7
DETENT_FULL = -8
DETENT_IN_USE = -9
DETENT_NOT_NOW = -10
DETENT_NO_SNAPSHOT = -20
DETENT_OTHER_VERSION = -21
DETENT_TRUNCATED = -22
DETENT_CORRUPTED = -23
DETENT_OTHER_SCENE = -24
DETENT_OTHER_FIXED_PART = -25
DETENT_NO_ROOM = -26
DETENT_UNKNOWN_ASSET = -27
DETENT_OTHER_ASSET = -28
DETENT_SPHERE = 1
DETENT_AABB = 2
DETENT_OBB = 3
DETENT_PLANE = 4
DETENT_TRIANGLE = 5
DETENT_CAPSULE = 6
DETENT_SEGMENT = 7
DETENT_POINT = 8
DETENT_HULL = 9
DETENT_MESH = 10
DETENT_HEIGHT_FIELD = 11
DETENT_COMPOUND = 12
DETENT_MOVING = 0
DETENT_FIXED = 1
DETENT_DYNAMIC_BODY = 0
DETENT_KINEMATIC_BODY = 1
DETENT_FIXED_BODY = 2
DETENT_DISTANCE_JOINT = 1
DETENT_BALL_JOINT = 2
DETENT_HINGE_JOINT = 3
DETENT_WELD_JOINT = 4
DETENT_SLIDER_JOINT = 5
DETENT_WHEEL_JOINT = 6
DETENT_CONE_JOINT = 7
DETENT_LOCK_X = 1
DETENT_LOCK_Y = 2
DETENT_LOCK_Z = 4
DETENT_LOCK_TURN_X = 8
DETENT_LOCK_TURN_Y = 16
DETENT_LOCK_TURN_Z = 32
DETENT_PLAYED = 0
DETENT_CONNECTING = 1
DETENT_CATCHING_UP = 2
DETENT_STARVED = 3
DETENT_AHEAD = 4
DETENT_PAUSED = 5
DETENT_OVER = 6
DETENT_JOINING = 7
DETENT_CONNECTED = 0
DETENT_SILENT = 1
DETENT_HEARD_AGAIN = 2
DETENT_PEER_PAUSED = 3
DETENT_PEER_RESUMED = 4
DETENT_DROPPED = 5
DETENT_EXPELLED = 6
DETENT_LEFT = 7
DETENT_TOO_SLOW = 8
DETENT_CONTRADICTION = 9
DETENT_DESYNC = 10
DETENT_DESYNC_FIELD = 11
DETENT_ARRIVED = 12
DETENT_LOADED = 13
DETENT_NO_SUCH_WORLD = 14
DETENT_JOINED = 15
DETENT_REPLAY_WHOLE = 0
DETENT_REPLAY_CUT = 1
DETENT_REPLAY_CORRUPTED = 2
DETENT_INPUT = 16
DETENT_PACKET = 1200
DETENT_LATE_SNAPSHOT = 65536
DETENT_NAME = 119
DETENT_WORDS = 256
DETENT_PLAYERS = 8


class detent_id(Structure):
    """The id of an object of a scene or a body of a world. Ids are never reused; {0, 0} is none."""
    _fields_ = [
        ('index', c_uint32),
        ('generation', c_uint32),
    ]


class detent_pair(Structure):
    """Two objects or bodies."""
    _fields_ = [
        ('first', detent_id),
        ('second', detent_id),
    ]


class detent_touch(Structure):
    """A pair of bodies that began (1) or ceased (0) to touch in the last step; for compounds, a pair of parts."""
    _fields_ = [
        ('a', detent_id),
        ('b', detent_id),
        ('begins', c_uint32),
        ('part_a', c_uint32),
        ('part_b', c_uint32),
    ]


class detent_body_info(Structure):
    """The properties of a body."""
    _fields_ = [
        ('user', c_uint64),
        ('layers', c_uint32),
        ('collides_with', c_uint32),
        ('motion', c_uint32),
        ('is_sensor', c_uint32),
        ('is_asleep', c_uint32),
        ('part_count', c_uint32),
    ]


class detent_found(Structure):
    """An object found by a query, and its distance in steps of 2^-16."""
    _fields_ = [
        ('distance', c_int32),
        ('id', detent_id),
    ]


class detent_impact(Structure):
    """When two moving shapes meet. They are disjoint before `time` (in steps of 2^-30) and at most `distance` apart at `time`. If `is_hit` is 0 the search ended early, and whether they meet later is unknown."""
    _fields_ = [
        ('time', c_int32),
        ('distance', c_int32),
        ('is_hit', c_uint32),
    ]


class detent_session_settings(Structure):
    """The settings of a match and of one peer. Times are in microseconds of this peer's own clock."""
    _fields_ = [
        ('match', c_uint64),
        ('send_interval', c_uint64),
        ('silence', c_uint64),
        ('self', c_uint32),
        ('players', c_uint32),
        ('spectators', c_uint32),
        ('delay', c_uint32),
        ('prediction', c_uint32),
        ('frames_per_call', c_uint32),
        ('absent', c_uint32),
        ('life', c_uint32),
        ('wants_seat', c_uint32),
        ('input_size', c_uint32),
        ('words', c_uint32),
        ('replay_every', c_uint32),
    ]


class detent_frame(Structure):
    """A frame to simulate, or the reason why there is none. Players whose bit in `present` is set take part."""
    _fields_ = [
        ('number', c_uint32),
        ('players', c_uint32),
        ('present', c_uint32),
        ('state', c_uint32),
    ]


class detent_session_event(Structure):
    """An event of a session."""
    _fields_ = [
        ('kind', c_uint32),
        ('peer', c_uint32),
        ('frame', c_uint32),
        ('name_size', c_uint32),
        ('has_object', c_uint32),
        ('object', detent_id),
    ]


class detent_session_status(Structure):
    """The progress of a session."""
    _fields_ = [
        ('digest', c_uint64),
        ('resimulated', c_uint64),
        ('frame', c_uint32),
        ('final_frame', c_uint32),
        ('checked_frame', c_uint32),
        ('start_frame', c_uint32),
        ('is_player', c_uint32),
        ('players', c_uint32),
    ]


class detent_replay_check(Structure):
    """The result of resimulating a replay so far."""
    _fields_ = [
        ('state', c_uint32),
        ('frames', c_uint32),
        ('equal', c_uint32),
        ('is_equal', c_uint32),
        ('players', c_uint32),
    ]


class detent_traits(Structure):
    """What a scene stores with an object, besides its shape."""
    _fields_ = [
        ('user', c_uint64),
        ('layers', c_uint32),
        ('motion', c_uint32),
        ('frame', detent_id),
    ]


class detent_allocator(Structure):
    """The allocator of a context. `allocate` returns memory for `size` bytes aligned for any type, or null. `release` receives the same size. If both are null, malloc and free are used."""
    _fields_ = [
        ('user', c_void_p),
        ('allocate', c_void_p),
        ('release', c_void_p),
    ]


class detent_context(Structure):
    """The owner of everything else. The caller provides its memory: zero it, open it and close it, and do not move it while it is open. Contexts share nothing. On one context, functions that only read (const detent_context*) may run in several threads at once; any other call needs exclusive access."""
    _fields_ = [
        ('words', c_uint64 * 4),
    ]


class detent_vec2(Structure):
    """A point or vector, in steps of 2^-16."""
    _fields_ = [
        ('x', c_int32),
        ('y', c_int32),
    ]


class detent_direction2(Structure):
    """A unit vector, in steps of 2^-30; used as stored, never normalised."""
    _fields_ = [
        ('x', c_int32),
        ('y', c_int32),
    ]


class detent_rotation2(Structure):
    """The axes of a frame in the world."""
    _fields_ = [
        ('axis', detent_direction2 * 2),
    ]


class detent_transform2(Structure):
    """p -> translation + scale * rotation * p; `scale` in steps of 2^-16."""
    _fields_ = [
        ('translation', detent_vec2),
        ('rotation', detent_rotation2),
        ('scale', c_int32),
    ]


class detent_ray2(Structure):
    """The points origin + t * direction with 0 <= t <= max_distance."""
    _fields_ = [
        ('origin', detent_vec2),
        ('direction', detent_direction2),
        ('max_distance', c_int32),
    ]


class detent_sphere2(Structure):
    """The points within `radius` of `center`; none if the radius is negative."""
    _fields_ = [
        ('center', detent_vec2),
        ('radius', c_int32),
    ]


class detent_aabb2(Structure):
    """The points between two corners, inclusive; none if min > max on an axis."""
    _fields_ = [
        ('min', detent_vec2),
        ('max', detent_vec2),
    ]


class detent_obb2(Structure):
    """A box rotated about its center; none if a half extent is negative."""
    _fields_ = [
        ('center', detent_vec2),
        ('half_extents', detent_vec2),
        ('rotation', detent_rotation2),
    ]


class detent_plane2(Structure):
    """The points x with dot(normal, x) = offset."""
    _fields_ = [
        ('normal', detent_direction2),
        ('offset', c_int32),
    ]


class detent_triangle2(Structure):
    """The points of the triangle with these corners."""
    _fields_ = [
        ('a', detent_vec2),
        ('b', detent_vec2),
        ('c', detent_vec2),
    ]


class detent_capsule2(Structure):
    """The points within `radius` of the segment from a to b; none if the radius is negative."""
    _fields_ = [
        ('a', detent_vec2),
        ('b', detent_vec2),
        ('radius', c_int32),
    ]


class detent_segment2(Structure):
    """The points between the two ends."""
    _fields_ = [
        ('start', detent_vec2),
        ('end', detent_vec2),
    ]


class detent_shape2_as(Union):
    _fields_ = [
        ('sphere', detent_sphere2),
        ('aabb', detent_aabb2),
        ('obb', detent_obb2),
        ('plane', detent_plane2),
        ('triangle', detent_triangle2),
        ('capsule', detent_capsule2),
        ('segment', detent_segment2),
        ('point', detent_vec2),
        ('placed', detent_transform2),
    ]


class detent_shape2(Structure):
    """A shape of any kind. `kind` selects the member of the union. `asset` is the handle of a hull, mesh or height field; other kinds ignore it."""
    _fields_ = [
        ('kind', c_uint32),
        ('asset', c_uint32),
        ('as_', detent_shape2_as),
    ]


class detent_hit2(Structure):
    """The first contact of a ray or moving shape with a shape. The distance is rounded down."""
    _fields_ = [
        ('distance', c_int32),
        ('point', detent_vec2),
        ('normal', detent_direction2),
    ]


class detent_contact_point2(Structure):
    """One contact point on the surface of the first shape. The second shape's surface is at point - depth * normal. `feature` identifies the corners, edges or faces that meet, and is stable while they do."""
    _fields_ = [
        ('point', detent_vec2),
        ('depth', c_int32),
        ('feature', c_uint32),
    ]


class detent_manifold2(Structure):
    """The least translation that separates two overlapping shapes a and b: move b by `depth`, rounded up, along `normal`, which points from a to b. The first `count` points are set, the others are zero."""
    _fields_ = [
        ('normal', detent_direction2),
        ('depth', c_int32),
        ('count', c_uint32),
        ('points', detent_contact_point2 * 2),
    ]


class detent_sweep2(Structure):
    """The motion of a frame between two poses over the time 0 to 1. The origin moves at constant velocity; the frame rotates about one axis by at most half a turn."""
    _fields_ = [
        ('start', detent_vec2),
        ('end', detent_vec2),
        ('start_rotation', detent_rotation2),
        ('end_rotation', detent_rotation2),
    ]


class detent_object_hit2(Structure):
    """The first point where a ray touches an object; for a mesh or height field also the triangle's index."""
    _fields_ = [
        ('distance', c_int32),
        ('id', detent_id),
        ('point', detent_vec2),
        ('normal', detent_direction2),
        ('triangle', c_uint32),
        ('has_triangle', c_uint32),
    ]


class detent_mover2(Structure):
    """A walking character: its capsule or AABB, and what it stands on. This is its whole state. Start with zeros and the shape in place. Setting `is_grounded` to 0 makes it leave the ground. A ball is a capsule with equal ends."""
    _fields_ = [
        ('shape', detent_shape2),
        ('is_grounded', c_uint32),
        ('object', detent_id),
        ('normal', detent_direction2),
        ('frame', detent_id),
        ('local', detent_vec2),
        ('point', detent_vec2),
    ]


class detent_mover2_settings(Structure):
    """Settings of a character's movement. Lengths in steps of 2^-16."""
    _fields_ = [
        ('up', detent_direction2),
        ('skin', c_int32),
        ('step_height', c_int32),
        ('snap_distance', c_int32),
        ('max_slope', c_uint32),
    ]


class detent_mover2_touch(Structure):
    """Something the character touched during a move. The normal points away from it."""
    _fields_ = [
        ('object', detent_id),
        ('point', detent_vec2),
        ('normal', detent_direction2),
    ]


class detent_move2(Structure):
    """The result of a move. The first `count` touches are set, the others are zero."""
    _fields_ = [
        ('moved', detent_vec2),
        ('carried', detent_vec2),
        ('pushed', detent_vec2),
        ('count', c_uint32),
        ('is_stuck', c_uint32),
        ('touched', detent_mover2_touch * 8),
    ]


class detent_world2_contact_point(Structure):
    """A point at which two bodies touch. Lengths and impulses in steps of 2^-16."""
    _fields_ = [
        ('point', detent_vec2),
        ('separation', c_int32),
        ('impulse', c_int32),
        ('feature', c_uint32),
    ]


class detent_world2_contact(Structure):
    """The contact of two bodies; for compounds that of two parts, for meshes and height fields that of one triangle. The first `count` points are set, the others are zero. Impulses act on b; a gets the opposite. They are those of the last substep, in units of mass times units per second."""
    _fields_ = [
        ('a', detent_id),
        ('b', detent_id),
        ('part_a', c_uint32),
        ('part_b', c_uint32),
        ('triangle', c_uint32),
        ('normal', detent_direction2),
        ('impulse', c_int32),
        ('friction', detent_vec2),
        ('count', c_uint32),
        ('points', detent_world2_contact_point * 2),
    ]


class detent_world2_settings(Structure):
    """Settings of a world. Lengths and speeds in steps of 2^-16."""
    _fields_ = [
        ('ticks_per_second', c_int32),
        ('substeps', c_int32),
        ('gravity', detent_vec2),
        ('margin', c_int32),
        ('push_speed', c_int32),
        ('bounce_threshold', c_int32),
        ('sleep_speed', c_int32),
        ('hold_distance', c_int32),
    ]


class detent_body2_options(Structure):
    """The material and initial state of a body. Ratios and densities in steps of 2^-16."""
    _fields_ = [
        ('user', c_uint64),
        ('layers', c_uint32),
        ('collides_with', c_uint32),
        ('motion', c_uint32),
        ('density', c_int32),
        ('friction', c_int32),
        ('restitution', c_int32),
        ('rolling_resistance', c_int32),
        ('linear_damping', c_int32),
        ('angular_damping', c_int32),
        ('velocity', detent_vec2),
        ('angular_velocity', c_int32 * 1),
        ('gravity_scale', c_int32),
        ('locked', c_uint32),
        ('is_sensor', c_uint32),
        ('is_fast', c_uint32),
        ('reserved', c_uint32 * 2),
    ]


class detent_part2(Structure):
    """A part of a compound: a sphere, AABB, OBB, capsule or solid hull in the compound's frame, and its material, in steps of 2^-16. Start from `detent_part2_defaults`."""
    _fields_ = [
        ('shape', detent_shape2),
        ('density', c_int32),
        ('friction', c_int32),
        ('restitution', c_int32),
        ('rolling_resistance', c_int32),
        ('is_sensor', c_uint32),
    ]


class detent_joint2(Structure):
    """A joint between two bodies a and b. Anchors and frames are in body space. Time is in the seconds of the world's settings, angles in radians, and all numbers are in steps of 2^-16. Fields that a kind does not have are ignored."""
    _fields_ = [
        ('kind', c_uint32),
        ('a', detent_id),
        ('b', detent_id),
        ('anchor_a', detent_vec2),
        ('anchor_b', detent_vec2),
        ('frame_a', detent_rotation2),
        ('frame_b', detent_rotation2),
        ('collide', c_uint32),
        ('break_force', c_int32),
        ('has_limits', c_uint32),
        ('lower', c_int32),
        ('upper', c_int32),
        ('motor_speed', c_int32),
        ('motor_force', c_int32),
        ('length', c_int32),
        ('frequency', c_int32),
        ('damping_ratio', c_int32),
        ('cone_angle', c_int32),
    ]


class detent_body2(Structure):
    """The state of a body, rounded to nearest."""
    _fields_ = [
        ('position', detent_vec2),
        ('rotation', detent_rotation2),
        ('velocity', detent_vec2),
        ('angular_velocity', c_int32 * 1),
        ('is_asleep', c_uint32),
    ]


class detent_vec3(Structure):
    """A point or vector, in steps of 2^-16."""
    _fields_ = [
        ('x', c_int32),
        ('y', c_int32),
        ('z', c_int32),
    ]


class detent_direction3(Structure):
    """A unit vector, in steps of 2^-30; used as stored, never normalised."""
    _fields_ = [
        ('x', c_int32),
        ('y', c_int32),
        ('z', c_int32),
    ]


class detent_rotation3(Structure):
    """The axes of a frame in the world."""
    _fields_ = [
        ('axis', detent_direction3 * 3),
    ]


class detent_transform3(Structure):
    """p -> translation + scale * rotation * p; `scale` in steps of 2^-16."""
    _fields_ = [
        ('translation', detent_vec3),
        ('rotation', detent_rotation3),
        ('scale', c_int32),
    ]


class detent_ray3(Structure):
    """The points origin + t * direction with 0 <= t <= max_distance."""
    _fields_ = [
        ('origin', detent_vec3),
        ('direction', detent_direction3),
        ('max_distance', c_int32),
    ]


class detent_sphere3(Structure):
    """The points within `radius` of `center`; none if the radius is negative."""
    _fields_ = [
        ('center', detent_vec3),
        ('radius', c_int32),
    ]


class detent_aabb3(Structure):
    """The points between two corners, inclusive; none if min > max on an axis."""
    _fields_ = [
        ('min', detent_vec3),
        ('max', detent_vec3),
    ]


class detent_obb3(Structure):
    """A box rotated about its center; none if a half extent is negative."""
    _fields_ = [
        ('center', detent_vec3),
        ('half_extents', detent_vec3),
        ('rotation', detent_rotation3),
    ]


class detent_plane3(Structure):
    """The points x with dot(normal, x) = offset."""
    _fields_ = [
        ('normal', detent_direction3),
        ('offset', c_int32),
    ]


class detent_triangle3(Structure):
    """The points of the triangle with these corners."""
    _fields_ = [
        ('a', detent_vec3),
        ('b', detent_vec3),
        ('c', detent_vec3),
    ]


class detent_capsule3(Structure):
    """The points within `radius` of the segment from a to b; none if the radius is negative."""
    _fields_ = [
        ('a', detent_vec3),
        ('b', detent_vec3),
        ('radius', c_int32),
    ]


class detent_segment3(Structure):
    """The points between the two ends."""
    _fields_ = [
        ('start', detent_vec3),
        ('end', detent_vec3),
    ]


class detent_shape3_as(Union):
    _fields_ = [
        ('sphere', detent_sphere3),
        ('aabb', detent_aabb3),
        ('obb', detent_obb3),
        ('plane', detent_plane3),
        ('triangle', detent_triangle3),
        ('capsule', detent_capsule3),
        ('segment', detent_segment3),
        ('point', detent_vec3),
        ('placed', detent_transform3),
    ]


class detent_shape3(Structure):
    """A shape of any kind. `kind` selects the member of the union. `asset` is the handle of a hull, mesh or height field; other kinds ignore it."""
    _fields_ = [
        ('kind', c_uint32),
        ('asset', c_uint32),
        ('as_', detent_shape3_as),
    ]


class detent_hit3(Structure):
    """The first contact of a ray or moving shape with a shape. The distance is rounded down."""
    _fields_ = [
        ('distance', c_int32),
        ('point', detent_vec3),
        ('normal', detent_direction3),
    ]


class detent_contact_point3(Structure):
    """One contact point on the surface of the first shape. The second shape's surface is at point - depth * normal. `feature` identifies the corners, edges or faces that meet, and is stable while they do."""
    _fields_ = [
        ('point', detent_vec3),
        ('depth', c_int32),
        ('feature', c_uint32),
    ]


class detent_manifold3(Structure):
    """The least translation that separates two overlapping shapes a and b: move b by `depth`, rounded up, along `normal`, which points from a to b. The first `count` points are set, the others are zero."""
    _fields_ = [
        ('normal', detent_direction3),
        ('depth', c_int32),
        ('count', c_uint32),
        ('points', detent_contact_point3 * 4),
    ]


class detent_sweep3(Structure):
    """The motion of a frame between two poses over the time 0 to 1. The origin moves at constant velocity; the frame rotates about one axis by at most half a turn."""
    _fields_ = [
        ('start', detent_vec3),
        ('end', detent_vec3),
        ('start_rotation', detent_rotation3),
        ('end_rotation', detent_rotation3),
    ]


class detent_object_hit3(Structure):
    """The first point where a ray touches an object; for a mesh or height field also the triangle's index."""
    _fields_ = [
        ('distance', c_int32),
        ('id', detent_id),
        ('point', detent_vec3),
        ('normal', detent_direction3),
        ('triangle', c_uint32),
        ('has_triangle', c_uint32),
    ]


class detent_mover3(Structure):
    """A walking character: its capsule or AABB, and what it stands on. This is its whole state. Start with zeros and the shape in place. Setting `is_grounded` to 0 makes it leave the ground. A ball is a capsule with equal ends."""
    _fields_ = [
        ('shape', detent_shape3),
        ('is_grounded', c_uint32),
        ('object', detent_id),
        ('normal', detent_direction3),
        ('frame', detent_id),
        ('local', detent_vec3),
        ('point', detent_vec3),
    ]


class detent_mover3_settings(Structure):
    """Settings of a character's movement. Lengths in steps of 2^-16."""
    _fields_ = [
        ('up', detent_direction3),
        ('skin', c_int32),
        ('step_height', c_int32),
        ('snap_distance', c_int32),
        ('max_slope', c_uint32),
    ]


class detent_mover3_touch(Structure):
    """Something the character touched during a move. The normal points away from it."""
    _fields_ = [
        ('object', detent_id),
        ('point', detent_vec3),
        ('normal', detent_direction3),
    ]


class detent_move3(Structure):
    """The result of a move. The first `count` touches are set, the others are zero."""
    _fields_ = [
        ('moved', detent_vec3),
        ('carried', detent_vec3),
        ('pushed', detent_vec3),
        ('count', c_uint32),
        ('is_stuck', c_uint32),
        ('touched', detent_mover3_touch * 8),
    ]


class detent_world3_contact_point(Structure):
    """A point at which two bodies touch. Lengths and impulses in steps of 2^-16."""
    _fields_ = [
        ('point', detent_vec3),
        ('separation', c_int32),
        ('impulse', c_int32),
        ('feature', c_uint32),
    ]


class detent_world3_contact(Structure):
    """The contact of two bodies; for compounds that of two parts, for meshes and height fields that of one triangle. The first `count` points are set, the others are zero. Impulses act on b; a gets the opposite. They are those of the last substep, in units of mass times units per second."""
    _fields_ = [
        ('a', detent_id),
        ('b', detent_id),
        ('part_a', c_uint32),
        ('part_b', c_uint32),
        ('triangle', c_uint32),
        ('normal', detent_direction3),
        ('impulse', c_int32),
        ('friction', detent_vec3),
        ('count', c_uint32),
        ('points', detent_world3_contact_point * 4),
    ]


class detent_world3_settings(Structure):
    """Settings of a world. Lengths and speeds in steps of 2^-16."""
    _fields_ = [
        ('ticks_per_second', c_int32),
        ('substeps', c_int32),
        ('gravity', detent_vec3),
        ('margin', c_int32),
        ('push_speed', c_int32),
        ('bounce_threshold', c_int32),
        ('sleep_speed', c_int32),
        ('hold_distance', c_int32),
    ]


class detent_body3_options(Structure):
    """The material and initial state of a body. Ratios and densities in steps of 2^-16."""
    _fields_ = [
        ('user', c_uint64),
        ('layers', c_uint32),
        ('collides_with', c_uint32),
        ('motion', c_uint32),
        ('density', c_int32),
        ('friction', c_int32),
        ('restitution', c_int32),
        ('rolling_resistance', c_int32),
        ('linear_damping', c_int32),
        ('angular_damping', c_int32),
        ('velocity', detent_vec3),
        ('angular_velocity', c_int32 * 3),
        ('gravity_scale', c_int32),
        ('locked', c_uint32),
        ('is_sensor', c_uint32),
        ('is_fast', c_uint32),
        ('reserved', c_uint32 * 3),
    ]


class detent_part3(Structure):
    """A part of a compound: a sphere, AABB, OBB, capsule or solid hull in the compound's frame, and its material, in steps of 2^-16. Start from `detent_part3_defaults`."""
    _fields_ = [
        ('shape', detent_shape3),
        ('density', c_int32),
        ('friction', c_int32),
        ('restitution', c_int32),
        ('rolling_resistance', c_int32),
        ('is_sensor', c_uint32),
    ]


class detent_joint3(Structure):
    """A joint between two bodies a and b. Anchors and frames are in body space. Time is in the seconds of the world's settings, angles in radians, and all numbers are in steps of 2^-16. Fields that a kind does not have are ignored."""
    _fields_ = [
        ('kind', c_uint32),
        ('a', detent_id),
        ('b', detent_id),
        ('anchor_a', detent_vec3),
        ('anchor_b', detent_vec3),
        ('frame_a', detent_rotation3),
        ('frame_b', detent_rotation3),
        ('collide', c_uint32),
        ('break_force', c_int32),
        ('has_limits', c_uint32),
        ('lower', c_int32),
        ('upper', c_int32),
        ('motor_speed', c_int32),
        ('motor_force', c_int32),
        ('length', c_int32),
        ('frequency', c_int32),
        ('damping_ratio', c_int32),
        ('cone_angle', c_int32),
    ]


class detent_body3(Structure):
    """The state of a body, rounded to nearest."""
    _fields_ = [
        ('position', detent_vec3),
        ('rotation', detent_rotation3),
        ('velocity', detent_vec3),
        ('angular_velocity', c_int32 * 3),
        ('is_asleep', c_uint32),
    ]


class detent_camera3(Structure):
    """A camera: its pose and lens. The pose is that of `detent_camera3_look_at`: axis 0 points right, axis 1 up, and it looks along -axis 2. The scale is ignored."""
    _fields_ = [
        ('pose', detent_transform3),
        ('has_perspective', c_uint32),
        ('fov', c_uint32),
        ('aspect', c_int32),
        ('half_width', c_int32),
        ('half_height', c_int32),
        ('near_distance', c_int32),
        ('far_distance', c_int32),
    ]


class detent_frustum3(Structure):
    """The view volume of a camera: the convex hull of eight corners. Corner i is right if i & 1, top if i & 2 and far if i & 4. Every query is exact for any eight points in any order."""
    _fields_ = [
        ('corners', detent_vec3 * 8),
    ]


class detent_screen_point3(Structure):
    """A screen point: pixels from the top left corner in steps of 2^-16, so that 32768 is the middle of the first pixel, and the depth along the line of sight, a length."""
    _fields_ = [
        ('x', c_int32),
        ('y', c_int32),
        ('depth', c_int32),
    ]


assert sizeof(detent_id) == 8
assert sizeof(detent_pair) == 16
assert sizeof(detent_touch) == 28
assert sizeof(detent_body_info) == 32
assert sizeof(detent_found) == 12
assert sizeof(detent_impact) == 12
assert sizeof(detent_session_settings) == 72
assert sizeof(detent_frame) == 16
assert sizeof(detent_session_event) == 28
assert sizeof(detent_session_status) == 40
assert sizeof(detent_replay_check) == 20
assert sizeof(detent_traits) == 24
assert sizeof(detent_context) == 32
assert sizeof(detent_vec2) == 8
assert sizeof(detent_direction2) == 8
assert sizeof(detent_rotation2) == 16
assert sizeof(detent_transform2) == 28
assert sizeof(detent_ray2) == 20
assert sizeof(detent_sphere2) == 12
assert sizeof(detent_aabb2) == 16
assert sizeof(detent_obb2) == 32
assert sizeof(detent_plane2) == 12
assert sizeof(detent_triangle2) == 24
assert sizeof(detent_capsule2) == 20
assert sizeof(detent_segment2) == 16
assert sizeof(detent_shape2) == 40
assert sizeof(detent_hit2) == 20
assert sizeof(detent_contact_point2) == 16
assert sizeof(detent_manifold2) == 48
assert sizeof(detent_sweep2) == 48
assert sizeof(detent_object_hit2) == 36
assert sizeof(detent_mover2) == 84
assert sizeof(detent_mover2_settings) == 24
assert sizeof(detent_mover2_touch) == 24
assert sizeof(detent_move2) == 224
assert sizeof(detent_world2_contact_point) == 20
assert sizeof(detent_world2_contact) == 92
assert sizeof(detent_world2_settings) == 36
assert sizeof(detent_body2_options) == 80
assert sizeof(detent_part2) == 60
assert sizeof(detent_joint2) == 112
assert sizeof(detent_body2) == 40
assert sizeof(detent_vec3) == 12
assert sizeof(detent_direction3) == 12
assert sizeof(detent_rotation3) == 36
assert sizeof(detent_transform3) == 52
assert sizeof(detent_ray3) == 28
assert sizeof(detent_sphere3) == 16
assert sizeof(detent_aabb3) == 24
assert sizeof(detent_obb3) == 60
assert sizeof(detent_plane3) == 16
assert sizeof(detent_triangle3) == 36
assert sizeof(detent_capsule3) == 28
assert sizeof(detent_segment3) == 24
assert sizeof(detent_shape3) == 68
assert sizeof(detent_hit3) == 28
assert sizeof(detent_contact_point3) == 20
assert sizeof(detent_manifold3) == 100
assert sizeof(detent_sweep3) == 96
assert sizeof(detent_object_hit3) == 44
assert sizeof(detent_mover3) == 124
assert sizeof(detent_mover3_settings) == 28
assert sizeof(detent_mover3_touch) == 32
assert sizeof(detent_move3) == 300
assert sizeof(detent_world3_contact_point) == 24
assert sizeof(detent_world3_contact) == 156
assert sizeof(detent_world3_settings) == 40
assert sizeof(detent_body3_options) == 96
assert sizeof(detent_part3) == 88
assert sizeof(detent_joint3) == 160
assert sizeof(detent_body3) == 76
assert sizeof(detent_camera3) == 80
assert sizeof(detent_frustum3) == 96
assert sizeof(detent_screen_point3) == 12


int32 = argument(c_int32)
uint32 = argument(c_uint32)
uint64 = argument(c_uint64)
size_t = argument(c_size_t)

FUNCTIONS = {
    'detent_version': (c_int32, [
    ]),
    'detent_results_version': (c_int32, [
    ]),
    'detent_describe': (c_char_p, [
        int32,
    ]),
    'detent_open': (c_int32, [
        POINTER(detent_context),
        POINTER(detent_allocator),
    ]),
    'detent_close': (c_int32, [
        POINTER(detent_context),
    ]),
    'detent_count': (c_int32, [
        POINTER(detent_context),
        POINTER(c_uint32),
    ]),
    'detent_session_default_settings': (c_int32, [
        POINTER(detent_session_settings),
    ]),
    'detent_mesh_create': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(detent_vec3),
        uint32,
        POINTER(c_uint32),
        uint32,
        POINTER(c_uint32),
    ]),
    'detent_height_field_create': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(detent_vec2),
        int32,
        uint32,
        uint32,
        POINTER(c_int32),
        POINTER(c_uint32),
    ]),
    'detent_asset_destroy': (c_int32, [
        POINTER(detent_context),
        uint32,
    ]),
    'detent_raycast2': (c_int32, [
        POINTER(detent_ray2),
        POINTER(detent_shape2),
        POINTER(detent_hit2),
    ]),
    'detent_raycast2_many': (c_int32, [
        POINTER(detent_ray2),
        uint32,
        POINTER(detent_shape2),
        POINTER(c_int32),
    ]),
    'detent_contains2': (c_int32, [
        POINTER(detent_shape2),
        POINTER(detent_vec2),
    ]),
    'detent_overlaps2': (c_int32, [
        POINTER(detent_shape2),
        POINTER(detent_shape2),
    ]),
    'detent_closest_point2': (c_int32, [
        POINTER(detent_shape2),
        POINTER(detent_vec2),
        POINTER(detent_vec2),
    ]),
    'detent_distance_to_point2': (c_int32, [
        POINTER(detent_shape2),
        POINTER(detent_vec2),
        POINTER(c_int32),
    ]),
    'detent_distance2': (c_int32, [
        POINTER(detent_shape2),
        POINTER(detent_shape2),
        POINTER(c_int32),
    ]),
    'detent_contact2': (c_int32, [
        POINTER(detent_shape2),
        POINTER(detent_shape2),
        POINTER(detent_manifold2),
    ]),
    'detent_closest_points2': (c_int32, [
        POINTER(detent_shape2),
        POINTER(detent_shape2),
        POINTER(detent_vec2),
        POINTER(detent_vec2),
    ]),
    'detent_cast2': (c_int32, [
        POINTER(detent_shape2),
        POINTER(detent_direction2),
        int32,
        POINTER(detent_shape2),
        POINTER(detent_hit2),
    ]),
    'detent_time_of_impact2': (c_int32, [
        POINTER(detent_shape2),
        POINTER(detent_sweep2),
        POINTER(detent_shape2),
        POINTER(detent_sweep2),
        int32,
        POINTER(detent_impact),
    ]),
    'detent_ray2_contains': (c_int32, [
        POINTER(detent_ray2),
        POINTER(detent_vec2),
    ]),
    'detent_ray2_closest_point': (c_int32, [
        POINTER(detent_ray2),
        POINTER(detent_vec2),
        POINTER(detent_vec2),
    ]),
    'detent_ray2_distance_to_point': (c_int32, [
        POINTER(detent_ray2),
        POINTER(detent_vec2),
        POINTER(c_int32),
    ]),
    'detent_shapes2_raycast': (c_int32, [
        POINTER(detent_context),
        POINTER(detent_ray2),
        POINTER(detent_shape2),
        uint32,
        POINTER(detent_hit2),
    ]),
    'detent_shapes2_contains': (c_int32, [
        POINTER(detent_context),
        POINTER(detent_shape2),
        uint32,
        POINTER(detent_vec2),
    ]),
    'detent_shapes2_overlaps': (c_int32, [
        POINTER(detent_context),
        POINTER(detent_shape2),
        uint32,
        POINTER(detent_shape2),
        uint32,
    ]),
    'detent_shapes2_closest_point': (c_int32, [
        POINTER(detent_context),
        POINTER(detent_shape2),
        uint32,
        POINTER(detent_vec2),
        POINTER(detent_vec2),
    ]),
    'detent_shapes2_distance_to_point': (c_int32, [
        POINTER(detent_context),
        POINTER(detent_shape2),
        uint32,
        POINTER(detent_vec2),
        POINTER(c_int32),
    ]),
    'detent_shapes2_distance': (c_int32, [
        POINTER(detent_context),
        POINTER(detent_shape2),
        uint32,
        POINTER(detent_shape2),
        uint32,
        POINTER(c_int32),
    ]),
    'detent_shapes2_closest_points': (c_int32, [
        POINTER(detent_context),
        POINTER(detent_shape2),
        uint32,
        POINTER(detent_shape2),
        uint32,
        POINTER(detent_vec2),
        POINTER(detent_vec2),
    ]),
    'detent_shapes2_cast': (c_int32, [
        POINTER(detent_context),
        POINTER(detent_shape2),
        POINTER(detent_direction2),
        int32,
        POINTER(detent_shape2),
        uint32,
        POINTER(detent_hit2),
    ]),
    'detent_shapes2_contact': (c_int32, [
        POINTER(detent_context),
        POINTER(detent_shape2),
        POINTER(detent_shape2),
        POINTER(detent_manifold2),
    ]),
    'detent_shapes2_time_of_impact': (c_int32, [
        POINTER(detent_context),
        POINTER(detent_shape2),
        POINTER(detent_sweep2),
        POINTER(detent_shape2),
        POINTER(detent_sweep2),
        int32,
        POINTER(detent_impact),
    ]),
    'detent_hull2_create': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(detent_vec2),
        uint32,
        POINTER(c_uint32),
    ]),
    'detent_solid2_create': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(detent_vec2),
        uint32,
        POINTER(c_uint32),
    ]),
    'detent_part2_defaults': (c_int32, [
        POINTER(detent_part2),
    ]),
    'detent_compound2_create': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(detent_part2),
        uint32,
        POINTER(c_uint32),
    ]),
    'detent_scene2_create': (c_int32, [
        POINTER(detent_context),
        POINTER(c_uint32),
    ]),
    'detent_scene2_destroy': (c_int32, [
        POINTER(detent_context),
        uint32,
    ]),
    'detent_scene2_add': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(detent_shape2),
        POINTER(detent_traits),
        POINTER(detent_id),
    ]),
    'detent_scene2_add_as': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
        POINTER(detent_shape2),
        POINTER(detent_traits),
    ]),
    'detent_scene2_remove': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
    ]),
    'detent_scene2_replace': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
        POINTER(detent_shape2),
    ]),
    'detent_scene2_move': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
        POINTER(detent_vec2),
    ]),
    'detent_scene2_object': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
        POINTER(detent_shape2),
        POINTER(detent_traits),
    ]),
    'detent_scene2_set_traits': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
        POINTER(detent_traits),
    ]),
    'detent_scene2_add_frame': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(detent_transform2),
        detent_id,
        POINTER(detent_id),
    ]),
    'detent_scene2_move_frame': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
        POINTER(detent_transform2),
    ]),
    'detent_scene2_remove_frame': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
    ]),
    'detent_scene2_frame': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
        POINTER(detent_transform2),
        POINTER(detent_transform2),
    ]),
    'detent_scene2_size': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(c_uint32),
    ]),
    'detent_scene2_optimize': (c_int32, [
        POINTER(detent_context),
        uint32,
    ]),
    'detent_scene2_raycast': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(detent_ray2),
        uint32,
        POINTER(detent_object_hit2),
    ]),
    'detent_scene2_raycast_any': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(detent_ray2),
        uint32,
    ]),
    'detent_scene2_raycast_all': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(detent_ray2),
        uint32,
        POINTER(detent_object_hit2),
        uint32,
        POINTER(c_uint32),
    ]),
    'detent_scene2_raycast_many': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(detent_ray2),
        uint32,
        uint32,
        POINTER(detent_object_hit2),
    ]),
    'detent_scene2_nearest': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(detent_shape2),
        uint32,
        POINTER(detent_found),
    ]),
    'detent_scene2_any': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(detent_shape2),
        uint32,
    ]),
    'detent_scene2_all': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(detent_shape2),
        uint32,
        POINTER(detent_found),
        uint32,
        POINTER(c_uint32),
    ]),
    'detent_scene2_overlaps': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(detent_pair),
        uint32,
        POINTER(c_uint32),
    ]),
    'detent_scene2_cast': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(detent_shape2),
        POINTER(detent_direction2),
        int32,
        uint32,
        POINTER(detent_object_hit2),
    ]),
    'detent_scene2_cast_any': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(detent_shape2),
        POINTER(detent_direction2),
        int32,
        uint32,
    ]),
    'detent_scene2_cast_all': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(detent_shape2),
        POINTER(detent_direction2),
        int32,
        uint32,
        POINTER(detent_object_hit2),
        uint32,
        POINTER(c_uint32),
    ]),
    'detent_mover2_default_settings': (c_int32, [
        POINTER(detent_mover2_settings),
    ]),
    'detent_mover2_move': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(detent_mover2),
        POINTER(detent_vec2),
        POINTER(detent_mover2_settings),
        uint32,
        detent_id,
        POINTER(detent_move2),
    ]),
    'detent_mover2_clip_velocity': (c_int32, [
        POINTER(detent_vec2),
        POINTER(detent_move2),
        POINTER(detent_vec2),
    ]),
    'detent_scene2_digest': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(c_uint64),
    ]),
    'detent_scene2_snapshot': (c_int32, [
        POINTER(detent_context),
        uint32,
        c_void_p,
        uint32,
        POINTER(c_uint32),
    ]),
    'detent_scene2_restore': (c_int32, [
        POINTER(detent_context),
        uint32,
        c_void_p,
        uint32,
    ]),
    'detent_world2_default_settings': (c_int32, [
        POINTER(detent_world2_settings),
    ]),
    'detent_body2_default_options': (c_int32, [
        POINTER(detent_body2_options),
    ]),
    'detent_world2_create': (c_int32, [
        POINTER(detent_context),
        POINTER(detent_world2_settings),
        POINTER(c_uint32),
    ]),
    'detent_world2_destroy': (c_int32, [
        POINTER(detent_context),
        uint32,
    ]),
    'detent_world2_add': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(detent_shape2),
        POINTER(detent_body2_options),
        POINTER(detent_id),
    ]),
    'detent_world2_add_as': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
        POINTER(detent_shape2),
        POINTER(detent_body2_options),
    ]),
    'detent_world2_remove': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
    ]),
    'detent_world2_step': (c_int32, [
        POINTER(detent_context),
        uint32,
    ]),
    'detent_scene2_follow': (c_int32, [
        POINTER(detent_context),
        uint32,
        uint32,
        uint32,
    ]),
    'detent_world2_part_of': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
        POINTER(detent_id),
        POINTER(c_uint32),
    ]),
    'detent_world2_body': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
        POINTER(detent_body2),
    ]),
    'detent_world2_bodies': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(detent_id),
        uint32,
        POINTER(detent_body2),
    ]),
    'detent_world2_frame': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
        POINTER(detent_transform2),
    ]),
    'detent_world2_info': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
        POINTER(detent_body_info),
    ]),
    'detent_world2_set_position': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
        POINTER(detent_vec2),
    ]),
    'detent_world2_set_rotation': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
        POINTER(detent_rotation2),
    ]),
    'detent_world2_set_filter': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
        uint32,
        uint32,
    ]),
    'detent_world2_set_friction': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
        int32,
    ]),
    'detent_world2_set_restitution': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
        int32,
    ]),
    'detent_world2_set_sensor': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
        uint32,
    ]),
    'detent_world2_set_gravity_scale': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
        int32,
    ]),
    'detent_world2_set_damping': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
        int32,
        int32,
    ]),
    'detent_world2_set_locked': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
        uint32,
    ]),
    'detent_world2_set_fast': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
        uint32,
    ]),
    'detent_world2_set_user': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
        uint64,
    ]),
    'detent_world2_set_gravity': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(detent_vec2),
    ]),
    'detent_world2_set_velocity': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
        POINTER(detent_vec2),
    ]),
    'detent_world2_set_angular_velocity': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
        POINTER(c_int32),
    ]),
    'detent_world2_apply_impulse': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
        POINTER(detent_vec2),
        POINTER(detent_vec2),
    ]),
    'detent_world2_apply_force': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
        POINTER(detent_vec2),
        POINTER(detent_vec2),
    ]),
    'detent_world2_apply_torque': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
        POINTER(c_int32),
    ]),
    'detent_joint2_defaults': (c_int32, [
        uint32,
        POINTER(detent_joint2),
    ]),
    'detent_world2_add_joint': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(detent_joint2),
        POINTER(detent_id),
    ]),
    'detent_world2_change_joint': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
        POINTER(detent_joint2),
    ]),
    'detent_world2_remove_joint': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
    ]),
    'detent_world2_joint': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
        POINTER(detent_joint2),
    ]),
    'detent_world2_joint_force': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
        POINTER(detent_vec2),
    ]),
    'detent_world2_joint_torque': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
        POINTER(c_int32),
    ]),
    'detent_world2_joint_count': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(c_uint32),
    ]),
    'detent_world2_joint_ids': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(detent_id),
        uint32,
        POINTER(c_uint32),
    ]),
    'detent_world2_broken': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(detent_id),
        uint32,
        POINTER(c_uint32),
    ]),
    'detent_world2_local_point': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
        POINTER(detent_vec2),
        POINTER(detent_vec2),
    ]),
    'detent_world2_local_frame': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
        POINTER(detent_rotation2),
        POINTER(detent_rotation2),
    ]),
    'detent_world2_size': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(c_uint32),
    ]),
    'detent_world2_body_ids': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(detent_id),
        uint32,
        POINTER(c_uint32),
    ]),
    'detent_world2_touching': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
        POINTER(detent_touch),
        uint32,
        POINTER(c_uint32),
    ]),
    'detent_world2_contacts': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
        POINTER(detent_world2_contact),
        uint32,
        POINTER(c_uint32),
    ]),
    'detent_world2_events': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(detent_touch),
        uint32,
        POINTER(c_uint32),
    ]),
    'detent_world2_digest': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(c_uint64),
    ]),
    'detent_world2_digest_of': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
        POINTER(c_uint64),
    ]),
    'detent_world2_snapshot': (c_int32, [
        POINTER(detent_context),
        uint32,
        c_void_p,
        uint32,
        POINTER(c_uint32),
    ]),
    'detent_world2_restore': (c_int32, [
        POINTER(detent_context),
        uint32,
        c_void_p,
        uint32,
    ]),
    'detent_world2_diff': (c_int32, [
        POINTER(detent_context),
        uint32,
        uint32,
        uint32,
        c_void_p,
        uint32,
        POINTER(c_uint32),
    ]),
    'detent_scene2_diff': (c_int32, [
        POINTER(detent_context),
        uint32,
        uint32,
        uint32,
        c_void_p,
        uint32,
        POINTER(c_uint32),
    ]),
    'detent_session2_create': (c_int32, [
        POINTER(detent_context),
        POINTER(detent_session_settings),
        uint32,
        POINTER(c_uint32),
    ]),
    'detent_session2_destroy': (c_int32, [
        POINTER(detent_context),
        uint32,
    ]),
    'detent_session2_world': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(c_uint32),
    ]),
    'detent_session2_receive': (c_int32, [
        POINTER(detent_context),
        uint32,
        uint32,
        c_void_p,
        uint32,
        uint64,
    ]),
    'detent_session2_begin_frame': (c_int32, [
        POINTER(detent_context),
        uint32,
        c_void_p,
        POINTER(detent_frame),
        c_void_p,
    ]),
    'detent_session2_end_frame': (c_int32, [
        POINTER(detent_context),
        uint32,
    ]),
    'detent_session2_packet': (c_int32, [
        POINTER(detent_context),
        uint32,
        uint64,
        POINTER(c_uint32),
        c_void_p,
        uint32,
        POINTER(c_uint32),
    ]),
    'detent_session2_event': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(detent_session_event),
        c_void_p,
        uint32,
    ]),
    'detent_session2_status': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(detent_session_status),
    ]),
    'detent_session2_matched': (c_int32, [
        POINTER(detent_context),
        uint32,
        uint32,
        POINTER(c_uint32),
    ]),
    'detent_session2_is_awaited': (c_int32, [
        POINTER(detent_context),
        uint32,
        uint32,
    ]),
    'detent_session2_drop': (c_int32, [
        POINTER(detent_context),
        uint32,
        uint32,
    ]),
    'detent_session2_pause': (c_int32, [
        POINTER(detent_context),
        uint32,
        uint32,
    ]),
    'detent_session2_replay': (c_int32, [
        POINTER(detent_context),
        uint32,
        c_void_p,
        uint32,
        POINTER(c_uint32),
    ]),
    'detent_world2_words': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(c_uint32),
    ]),
    'detent_world2_set_words': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(c_uint32),
    ]),
    'detent_replay2_create': (c_int32, [
        POINTER(detent_context),
        c_void_p,
        uint32,
        uint32,
        uint32,
        uint32,
        POINTER(c_uint32),
    ]),
    'detent_replay2_destroy': (c_int32, [
        POINTER(detent_context),
        uint32,
    ]),
    'detent_replay2_world': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(c_uint32),
    ]),
    'detent_replay2_begin_frame': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(detent_frame),
        c_void_p,
    ]),
    'detent_replay2_end_frame': (c_int32, [
        POINTER(detent_context),
        uint32,
    ]),
    'detent_replay2_check': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(detent_replay_check),
    ]),
    'detent_raycast3': (c_int32, [
        POINTER(detent_ray3),
        POINTER(detent_shape3),
        POINTER(detent_hit3),
    ]),
    'detent_raycast3_many': (c_int32, [
        POINTER(detent_ray3),
        uint32,
        POINTER(detent_shape3),
        POINTER(c_int32),
    ]),
    'detent_contains3': (c_int32, [
        POINTER(detent_shape3),
        POINTER(detent_vec3),
    ]),
    'detent_overlaps3': (c_int32, [
        POINTER(detent_shape3),
        POINTER(detent_shape3),
    ]),
    'detent_closest_point3': (c_int32, [
        POINTER(detent_shape3),
        POINTER(detent_vec3),
        POINTER(detent_vec3),
    ]),
    'detent_distance_to_point3': (c_int32, [
        POINTER(detent_shape3),
        POINTER(detent_vec3),
        POINTER(c_int32),
    ]),
    'detent_distance3': (c_int32, [
        POINTER(detent_shape3),
        POINTER(detent_shape3),
        POINTER(c_int32),
    ]),
    'detent_contact3': (c_int32, [
        POINTER(detent_shape3),
        POINTER(detent_shape3),
        POINTER(detent_manifold3),
    ]),
    'detent_closest_points3': (c_int32, [
        POINTER(detent_shape3),
        POINTER(detent_shape3),
        POINTER(detent_vec3),
        POINTER(detent_vec3),
    ]),
    'detent_cast3': (c_int32, [
        POINTER(detent_shape3),
        POINTER(detent_direction3),
        int32,
        POINTER(detent_shape3),
        POINTER(detent_hit3),
    ]),
    'detent_time_of_impact3': (c_int32, [
        POINTER(detent_shape3),
        POINTER(detent_sweep3),
        POINTER(detent_shape3),
        POINTER(detent_sweep3),
        int32,
        POINTER(detent_impact),
    ]),
    'detent_ray3_contains': (c_int32, [
        POINTER(detent_ray3),
        POINTER(detent_vec3),
    ]),
    'detent_ray3_closest_point': (c_int32, [
        POINTER(detent_ray3),
        POINTER(detent_vec3),
        POINTER(detent_vec3),
    ]),
    'detent_ray3_distance_to_point': (c_int32, [
        POINTER(detent_ray3),
        POINTER(detent_vec3),
        POINTER(c_int32),
    ]),
    'detent_shapes3_raycast': (c_int32, [
        POINTER(detent_context),
        POINTER(detent_ray3),
        POINTER(detent_shape3),
        uint32,
        POINTER(detent_hit3),
    ]),
    'detent_shapes3_contains': (c_int32, [
        POINTER(detent_context),
        POINTER(detent_shape3),
        uint32,
        POINTER(detent_vec3),
    ]),
    'detent_shapes3_overlaps': (c_int32, [
        POINTER(detent_context),
        POINTER(detent_shape3),
        uint32,
        POINTER(detent_shape3),
        uint32,
    ]),
    'detent_shapes3_closest_point': (c_int32, [
        POINTER(detent_context),
        POINTER(detent_shape3),
        uint32,
        POINTER(detent_vec3),
        POINTER(detent_vec3),
    ]),
    'detent_shapes3_distance_to_point': (c_int32, [
        POINTER(detent_context),
        POINTER(detent_shape3),
        uint32,
        POINTER(detent_vec3),
        POINTER(c_int32),
    ]),
    'detent_shapes3_distance': (c_int32, [
        POINTER(detent_context),
        POINTER(detent_shape3),
        uint32,
        POINTER(detent_shape3),
        uint32,
        POINTER(c_int32),
    ]),
    'detent_shapes3_closest_points': (c_int32, [
        POINTER(detent_context),
        POINTER(detent_shape3),
        uint32,
        POINTER(detent_shape3),
        uint32,
        POINTER(detent_vec3),
        POINTER(detent_vec3),
    ]),
    'detent_shapes3_cast': (c_int32, [
        POINTER(detent_context),
        POINTER(detent_shape3),
        POINTER(detent_direction3),
        int32,
        POINTER(detent_shape3),
        uint32,
        POINTER(detent_hit3),
    ]),
    'detent_shapes3_contact': (c_int32, [
        POINTER(detent_context),
        POINTER(detent_shape3),
        POINTER(detent_shape3),
        POINTER(detent_manifold3),
    ]),
    'detent_shapes3_time_of_impact': (c_int32, [
        POINTER(detent_context),
        POINTER(detent_shape3),
        POINTER(detent_sweep3),
        POINTER(detent_shape3),
        POINTER(detent_sweep3),
        int32,
        POINTER(detent_impact),
    ]),
    'detent_hull3_create': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(detent_vec3),
        uint32,
        POINTER(c_uint32),
    ]),
    'detent_solid3_create': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(detent_vec3),
        uint32,
        POINTER(c_uint32),
    ]),
    'detent_part3_defaults': (c_int32, [
        POINTER(detent_part3),
    ]),
    'detent_compound3_create': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(detent_part3),
        uint32,
        POINTER(c_uint32),
    ]),
    'detent_scene3_create': (c_int32, [
        POINTER(detent_context),
        POINTER(c_uint32),
    ]),
    'detent_scene3_destroy': (c_int32, [
        POINTER(detent_context),
        uint32,
    ]),
    'detent_scene3_add': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(detent_shape3),
        POINTER(detent_traits),
        POINTER(detent_id),
    ]),
    'detent_scene3_add_as': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
        POINTER(detent_shape3),
        POINTER(detent_traits),
    ]),
    'detent_scene3_remove': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
    ]),
    'detent_scene3_replace': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
        POINTER(detent_shape3),
    ]),
    'detent_scene3_move': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
        POINTER(detent_vec3),
    ]),
    'detent_scene3_object': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
        POINTER(detent_shape3),
        POINTER(detent_traits),
    ]),
    'detent_scene3_set_traits': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
        POINTER(detent_traits),
    ]),
    'detent_scene3_add_frame': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(detent_transform3),
        detent_id,
        POINTER(detent_id),
    ]),
    'detent_scene3_move_frame': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
        POINTER(detent_transform3),
    ]),
    'detent_scene3_remove_frame': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
    ]),
    'detent_scene3_frame': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
        POINTER(detent_transform3),
        POINTER(detent_transform3),
    ]),
    'detent_scene3_size': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(c_uint32),
    ]),
    'detent_scene3_optimize': (c_int32, [
        POINTER(detent_context),
        uint32,
    ]),
    'detent_scene3_raycast': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(detent_ray3),
        uint32,
        POINTER(detent_object_hit3),
    ]),
    'detent_scene3_raycast_any': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(detent_ray3),
        uint32,
    ]),
    'detent_scene3_raycast_all': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(detent_ray3),
        uint32,
        POINTER(detent_object_hit3),
        uint32,
        POINTER(c_uint32),
    ]),
    'detent_scene3_raycast_many': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(detent_ray3),
        uint32,
        uint32,
        POINTER(detent_object_hit3),
    ]),
    'detent_scene3_nearest': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(detent_shape3),
        uint32,
        POINTER(detent_found),
    ]),
    'detent_scene3_any': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(detent_shape3),
        uint32,
    ]),
    'detent_scene3_all': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(detent_shape3),
        uint32,
        POINTER(detent_found),
        uint32,
        POINTER(c_uint32),
    ]),
    'detent_scene3_overlaps': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(detent_pair),
        uint32,
        POINTER(c_uint32),
    ]),
    'detent_scene3_cast': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(detent_shape3),
        POINTER(detent_direction3),
        int32,
        uint32,
        POINTER(detent_object_hit3),
    ]),
    'detent_scene3_cast_any': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(detent_shape3),
        POINTER(detent_direction3),
        int32,
        uint32,
    ]),
    'detent_scene3_cast_all': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(detent_shape3),
        POINTER(detent_direction3),
        int32,
        uint32,
        POINTER(detent_object_hit3),
        uint32,
        POINTER(c_uint32),
    ]),
    'detent_mover3_default_settings': (c_int32, [
        POINTER(detent_mover3_settings),
    ]),
    'detent_mover3_move': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(detent_mover3),
        POINTER(detent_vec3),
        POINTER(detent_mover3_settings),
        uint32,
        detent_id,
        POINTER(detent_move3),
    ]),
    'detent_mover3_clip_velocity': (c_int32, [
        POINTER(detent_vec3),
        POINTER(detent_move3),
        POINTER(detent_vec3),
    ]),
    'detent_scene3_digest': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(c_uint64),
    ]),
    'detent_scene3_snapshot': (c_int32, [
        POINTER(detent_context),
        uint32,
        c_void_p,
        uint32,
        POINTER(c_uint32),
    ]),
    'detent_scene3_restore': (c_int32, [
        POINTER(detent_context),
        uint32,
        c_void_p,
        uint32,
    ]),
    'detent_world3_default_settings': (c_int32, [
        POINTER(detent_world3_settings),
    ]),
    'detent_body3_default_options': (c_int32, [
        POINTER(detent_body3_options),
    ]),
    'detent_world3_create': (c_int32, [
        POINTER(detent_context),
        POINTER(detent_world3_settings),
        POINTER(c_uint32),
    ]),
    'detent_world3_destroy': (c_int32, [
        POINTER(detent_context),
        uint32,
    ]),
    'detent_world3_add': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(detent_shape3),
        POINTER(detent_body3_options),
        POINTER(detent_id),
    ]),
    'detent_world3_add_as': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
        POINTER(detent_shape3),
        POINTER(detent_body3_options),
    ]),
    'detent_world3_remove': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
    ]),
    'detent_world3_step': (c_int32, [
        POINTER(detent_context),
        uint32,
    ]),
    'detent_scene3_follow': (c_int32, [
        POINTER(detent_context),
        uint32,
        uint32,
        uint32,
    ]),
    'detent_world3_part_of': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
        POINTER(detent_id),
        POINTER(c_uint32),
    ]),
    'detent_world3_body': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
        POINTER(detent_body3),
    ]),
    'detent_world3_bodies': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(detent_id),
        uint32,
        POINTER(detent_body3),
    ]),
    'detent_world3_frame': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
        POINTER(detent_transform3),
    ]),
    'detent_world3_info': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
        POINTER(detent_body_info),
    ]),
    'detent_world3_set_position': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
        POINTER(detent_vec3),
    ]),
    'detent_world3_set_rotation': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
        POINTER(detent_rotation3),
    ]),
    'detent_world3_set_filter': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
        uint32,
        uint32,
    ]),
    'detent_world3_set_friction': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
        int32,
    ]),
    'detent_world3_set_restitution': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
        int32,
    ]),
    'detent_world3_set_sensor': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
        uint32,
    ]),
    'detent_world3_set_gravity_scale': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
        int32,
    ]),
    'detent_world3_set_damping': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
        int32,
        int32,
    ]),
    'detent_world3_set_locked': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
        uint32,
    ]),
    'detent_world3_set_fast': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
        uint32,
    ]),
    'detent_world3_set_user': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
        uint64,
    ]),
    'detent_world3_set_gravity': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(detent_vec3),
    ]),
    'detent_world3_set_velocity': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
        POINTER(detent_vec3),
    ]),
    'detent_world3_set_angular_velocity': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
        POINTER(c_int32),
    ]),
    'detent_world3_apply_impulse': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
        POINTER(detent_vec3),
        POINTER(detent_vec3),
    ]),
    'detent_world3_apply_force': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
        POINTER(detent_vec3),
        POINTER(detent_vec3),
    ]),
    'detent_world3_apply_torque': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
        POINTER(c_int32),
    ]),
    'detent_joint3_defaults': (c_int32, [
        uint32,
        POINTER(detent_joint3),
    ]),
    'detent_world3_add_joint': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(detent_joint3),
        POINTER(detent_id),
    ]),
    'detent_world3_change_joint': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
        POINTER(detent_joint3),
    ]),
    'detent_world3_remove_joint': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
    ]),
    'detent_world3_joint': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
        POINTER(detent_joint3),
    ]),
    'detent_world3_joint_force': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
        POINTER(detent_vec3),
    ]),
    'detent_world3_joint_torque': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
        POINTER(c_int32),
    ]),
    'detent_world3_joint_count': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(c_uint32),
    ]),
    'detent_world3_joint_ids': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(detent_id),
        uint32,
        POINTER(c_uint32),
    ]),
    'detent_world3_broken': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(detent_id),
        uint32,
        POINTER(c_uint32),
    ]),
    'detent_world3_local_point': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
        POINTER(detent_vec3),
        POINTER(detent_vec3),
    ]),
    'detent_world3_local_frame': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
        POINTER(detent_rotation3),
        POINTER(detent_rotation3),
    ]),
    'detent_world3_size': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(c_uint32),
    ]),
    'detent_world3_body_ids': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(detent_id),
        uint32,
        POINTER(c_uint32),
    ]),
    'detent_world3_touching': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
        POINTER(detent_touch),
        uint32,
        POINTER(c_uint32),
    ]),
    'detent_world3_contacts': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
        POINTER(detent_world3_contact),
        uint32,
        POINTER(c_uint32),
    ]),
    'detent_world3_events': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(detent_touch),
        uint32,
        POINTER(c_uint32),
    ]),
    'detent_world3_digest': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(c_uint64),
    ]),
    'detent_world3_digest_of': (c_int32, [
        POINTER(detent_context),
        uint32,
        detent_id,
        POINTER(c_uint64),
    ]),
    'detent_world3_snapshot': (c_int32, [
        POINTER(detent_context),
        uint32,
        c_void_p,
        uint32,
        POINTER(c_uint32),
    ]),
    'detent_world3_restore': (c_int32, [
        POINTER(detent_context),
        uint32,
        c_void_p,
        uint32,
    ]),
    'detent_world3_diff': (c_int32, [
        POINTER(detent_context),
        uint32,
        uint32,
        uint32,
        c_void_p,
        uint32,
        POINTER(c_uint32),
    ]),
    'detent_scene3_diff': (c_int32, [
        POINTER(detent_context),
        uint32,
        uint32,
        uint32,
        c_void_p,
        uint32,
        POINTER(c_uint32),
    ]),
    'detent_session3_create': (c_int32, [
        POINTER(detent_context),
        POINTER(detent_session_settings),
        uint32,
        POINTER(c_uint32),
    ]),
    'detent_session3_destroy': (c_int32, [
        POINTER(detent_context),
        uint32,
    ]),
    'detent_session3_world': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(c_uint32),
    ]),
    'detent_session3_receive': (c_int32, [
        POINTER(detent_context),
        uint32,
        uint32,
        c_void_p,
        uint32,
        uint64,
    ]),
    'detent_session3_begin_frame': (c_int32, [
        POINTER(detent_context),
        uint32,
        c_void_p,
        POINTER(detent_frame),
        c_void_p,
    ]),
    'detent_session3_end_frame': (c_int32, [
        POINTER(detent_context),
        uint32,
    ]),
    'detent_session3_packet': (c_int32, [
        POINTER(detent_context),
        uint32,
        uint64,
        POINTER(c_uint32),
        c_void_p,
        uint32,
        POINTER(c_uint32),
    ]),
    'detent_session3_event': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(detent_session_event),
        c_void_p,
        uint32,
    ]),
    'detent_session3_status': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(detent_session_status),
    ]),
    'detent_session3_matched': (c_int32, [
        POINTER(detent_context),
        uint32,
        uint32,
        POINTER(c_uint32),
    ]),
    'detent_session3_is_awaited': (c_int32, [
        POINTER(detent_context),
        uint32,
        uint32,
    ]),
    'detent_session3_drop': (c_int32, [
        POINTER(detent_context),
        uint32,
        uint32,
    ]),
    'detent_session3_pause': (c_int32, [
        POINTER(detent_context),
        uint32,
        uint32,
    ]),
    'detent_session3_replay': (c_int32, [
        POINTER(detent_context),
        uint32,
        c_void_p,
        uint32,
        POINTER(c_uint32),
    ]),
    'detent_world3_words': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(c_uint32),
    ]),
    'detent_world3_set_words': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(c_uint32),
    ]),
    'detent_replay3_create': (c_int32, [
        POINTER(detent_context),
        c_void_p,
        uint32,
        uint32,
        uint32,
        uint32,
        POINTER(c_uint32),
    ]),
    'detent_replay3_destroy': (c_int32, [
        POINTER(detent_context),
        uint32,
    ]),
    'detent_replay3_world': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(c_uint32),
    ]),
    'detent_replay3_begin_frame': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(detent_frame),
        c_void_p,
    ]),
    'detent_replay3_end_frame': (c_int32, [
        POINTER(detent_context),
        uint32,
    ]),
    'detent_replay3_check': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(detent_replay_check),
    ]),
    'detent_camera3_look_at': (c_int32, [
        POINTER(detent_vec3),
        POINTER(detent_vec3),
        POINTER(detent_vec3),
        POINTER(detent_transform3),
    ]),
    'detent_camera3_frustum': (c_int32, [
        POINTER(detent_camera3),
        POINTER(detent_frustum3),
    ]),
    'detent_camera3_pick_ray': (c_int32, [
        POINTER(detent_camera3),
        int32,
        int32,
        int32,
        int32,
        POINTER(detent_ray3),
    ]),
    'detent_camera3_project': (c_int32, [
        POINTER(detent_camera3),
        int32,
        int32,
        POINTER(detent_vec3),
        POINTER(detent_screen_point3),
    ]),
    'detent_camera3_unproject': (c_int32, [
        POINTER(detent_camera3),
        int32,
        int32,
        int32,
        int32,
        int32,
        POINTER(detent_vec3),
    ]),
    'detent_frustum3_raycast': (c_int32, [
        POINTER(detent_ray3),
        POINTER(detent_frustum3),
        POINTER(detent_hit3),
    ]),
    'detent_frustum3_contains': (c_int32, [
        POINTER(detent_frustum3),
        POINTER(detent_vec3),
    ]),
    'detent_frustum3_overlaps': (c_int32, [
        POINTER(detent_context),
        POINTER(detent_frustum3),
        POINTER(detent_shape3),
        uint32,
    ]),
    'detent_frustum3_overlaps_frustum': (c_int32, [
        POINTER(detent_frustum3),
        POINTER(detent_frustum3),
    ]),
    'detent_frustum3_closest_point': (c_int32, [
        POINTER(detent_frustum3),
        POINTER(detent_vec3),
        POINTER(detent_vec3),
    ]),
    'detent_frustum3_distance_to_point': (c_int32, [
        POINTER(detent_frustum3),
        POINTER(detent_vec3),
        POINTER(c_int32),
    ]),
    'detent_scene3_frustum_nearest': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(detent_frustum3),
        uint32,
        POINTER(detent_found),
    ]),
    'detent_scene3_frustum_any': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(detent_frustum3),
        uint32,
    ]),
    'detent_scene3_frustum_all': (c_int32, [
        POINTER(detent_context),
        uint32,
        POINTER(detent_frustum3),
        uint32,
        POINTER(detent_found),
        uint32,
        POINTER(c_uint32),
    ]),
}
