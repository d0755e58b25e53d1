// SPDX-License-Identifier: MIT
#pragma once

#include "detent.h"

namespace detent::test_c {

/// The functions of one dimension, which is left out of their names.
template <int N>
struct Calls;
#define DETENT_TEST_CALL(prefix, N, suffix) \
  static constexpr auto prefix##suffix = detent_##prefix##N##suffix;
#define DETENT_TEST_CALLS(N)                          \
  template <>                                         \
  struct Calls<N> {                                   \
    DETENT_TEST_CALL(cast, N, )                       \
    DETENT_TEST_CALL(closest_point, N, )              \
    DETENT_TEST_CALL(closest_points, N, )             \
    DETENT_TEST_CALL(contact, N, )                    \
    DETENT_TEST_CALL(contains, N, )                   \
    DETENT_TEST_CALL(distance, N, )                   \
    DETENT_TEST_CALL(distance_to_point, N, )          \
    DETENT_TEST_CALL(overlaps, N, )                   \
    DETENT_TEST_CALL(raycast, N, )                    \
    DETENT_TEST_CALL(time_of_impact, N, )             \
    DETENT_TEST_CALL(body, N, _default_options)       \
    DETENT_TEST_CALL(compound, N, _create)            \
    DETENT_TEST_CALL(hull, N, _create)                \
    DETENT_TEST_CALL(joint, N, _defaults)             \
    DETENT_TEST_CALL(mover, N, _clip_velocity)        \
    DETENT_TEST_CALL(mover, N, _default_settings)     \
    DETENT_TEST_CALL(mover, N, _move)                 \
    DETENT_TEST_CALL(part, N, _defaults)              \
    DETENT_TEST_CALL(ray, N, _closest_point)          \
    DETENT_TEST_CALL(ray, N, _contains)               \
    DETENT_TEST_CALL(ray, N, _distance_to_point)      \
    DETENT_TEST_CALL(raycast, N, _many)               \
    DETENT_TEST_CALL(scene, N, _add)                  \
    DETENT_TEST_CALL(scene, N, _add_as)               \
    DETENT_TEST_CALL(scene, N, _add_frame)            \
    DETENT_TEST_CALL(scene, N, _all)                  \
    DETENT_TEST_CALL(scene, N, _any)                  \
    DETENT_TEST_CALL(scene, N, _cast)                 \
    DETENT_TEST_CALL(scene, N, _cast_all)             \
    DETENT_TEST_CALL(scene, N, _cast_any)             \
    DETENT_TEST_CALL(scene, N, _create)               \
    DETENT_TEST_CALL(scene, N, _destroy)              \
    DETENT_TEST_CALL(scene, N, _diff)                 \
    DETENT_TEST_CALL(scene, N, _digest)               \
    DETENT_TEST_CALL(scene, N, _follow)               \
    DETENT_TEST_CALL(scene, N, _frame)                \
    DETENT_TEST_CALL(scene, N, _move)                 \
    DETENT_TEST_CALL(scene, N, _move_frame)           \
    DETENT_TEST_CALL(scene, N, _nearest)              \
    DETENT_TEST_CALL(scene, N, _object)               \
    DETENT_TEST_CALL(scene, N, _optimize)             \
    DETENT_TEST_CALL(scene, N, _overlaps)             \
    DETENT_TEST_CALL(scene, N, _raycast)              \
    DETENT_TEST_CALL(scene, N, _raycast_all)          \
    DETENT_TEST_CALL(scene, N, _raycast_any)          \
    DETENT_TEST_CALL(scene, N, _raycast_many)         \
    DETENT_TEST_CALL(scene, N, _remove)               \
    DETENT_TEST_CALL(scene, N, _remove_frame)         \
    DETENT_TEST_CALL(scene, N, _replace)              \
    DETENT_TEST_CALL(scene, N, _restore)              \
    DETENT_TEST_CALL(scene, N, _set_traits)           \
    DETENT_TEST_CALL(scene, N, _size)                 \
    DETENT_TEST_CALL(scene, N, _snapshot)             \
    DETENT_TEST_CALL(session, N, _begin_frame)        \
    DETENT_TEST_CALL(session, N, _create)             \
    DETENT_TEST_CALL(session, N, _drop)               \
    DETENT_TEST_CALL(session, N, _end_frame)          \
    DETENT_TEST_CALL(session, N, _event)              \
    DETENT_TEST_CALL(session, N, _is_awaited)         \
    DETENT_TEST_CALL(session, N, _matched)            \
    DETENT_TEST_CALL(session, N, _packet)             \
    DETENT_TEST_CALL(session, N, _pause)              \
    DETENT_TEST_CALL(session, N, _receive)            \
    DETENT_TEST_CALL(session, N, _status)             \
    DETENT_TEST_CALL(session, N, _world)              \
    DETENT_TEST_CALL(shapes, N, _cast)                \
    DETENT_TEST_CALL(shapes, N, _closest_point)       \
    DETENT_TEST_CALL(shapes, N, _closest_points)      \
    DETENT_TEST_CALL(shapes, N, _contact)             \
    DETENT_TEST_CALL(shapes, N, _contains)            \
    DETENT_TEST_CALL(shapes, N, _distance)            \
    DETENT_TEST_CALL(shapes, N, _distance_to_point)   \
    DETENT_TEST_CALL(shapes, N, _overlaps)            \
    DETENT_TEST_CALL(shapes, N, _raycast)             \
    DETENT_TEST_CALL(shapes, N, _time_of_impact)      \
    DETENT_TEST_CALL(solid, N, _create)               \
    DETENT_TEST_CALL(world, N, _add)                  \
    DETENT_TEST_CALL(world, N, _add_as)               \
    DETENT_TEST_CALL(world, N, _add_joint)            \
    DETENT_TEST_CALL(world, N, _apply_force)          \
    DETENT_TEST_CALL(world, N, _apply_impulse)        \
    DETENT_TEST_CALL(world, N, _apply_torque)         \
    DETENT_TEST_CALL(world, N, _bodies)               \
    DETENT_TEST_CALL(world, N, _body)                 \
    DETENT_TEST_CALL(world, N, _body_ids)             \
    DETENT_TEST_CALL(world, N, _broken)               \
    DETENT_TEST_CALL(world, N, _change_joint)         \
    DETENT_TEST_CALL(world, N, _contacts)             \
    DETENT_TEST_CALL(world, N, _create)               \
    DETENT_TEST_CALL(world, N, _default_settings)     \
    DETENT_TEST_CALL(world, N, _destroy)              \
    DETENT_TEST_CALL(world, N, _digest)               \
    DETENT_TEST_CALL(world, N, _digest_of)            \
    DETENT_TEST_CALL(world, N, _events)               \
    DETENT_TEST_CALL(world, N, _frame)                \
    DETENT_TEST_CALL(world, N, _info)                 \
    DETENT_TEST_CALL(world, N, _joint)                \
    DETENT_TEST_CALL(world, N, _joint_count)          \
    DETENT_TEST_CALL(world, N, _joint_force)          \
    DETENT_TEST_CALL(world, N, _joint_ids)            \
    DETENT_TEST_CALL(world, N, _joint_torque)         \
    DETENT_TEST_CALL(world, N, _local_frame)          \
    DETENT_TEST_CALL(world, N, _local_point)          \
    DETENT_TEST_CALL(world, N, _part_of)              \
    DETENT_TEST_CALL(world, N, _remove)               \
    DETENT_TEST_CALL(world, N, _remove_joint)         \
    DETENT_TEST_CALL(world, N, _restore)              \
    DETENT_TEST_CALL(world, N, _set_angular_velocity) \
    DETENT_TEST_CALL(world, N, _set_damping)          \
    DETENT_TEST_CALL(world, N, _set_fast)             \
    DETENT_TEST_CALL(world, N, _set_filter)           \
    DETENT_TEST_CALL(world, N, _set_friction)         \
    DETENT_TEST_CALL(world, N, _set_gravity)          \
    DETENT_TEST_CALL(world, N, _set_gravity_scale)    \
    DETENT_TEST_CALL(world, N, _set_locked)           \
    DETENT_TEST_CALL(world, N, _set_position)         \
    DETENT_TEST_CALL(world, N, _set_restitution)      \
    DETENT_TEST_CALL(world, N, _set_rotation)         \
    DETENT_TEST_CALL(world, N, _set_sensor)           \
    DETENT_TEST_CALL(world, N, _set_user)             \
    DETENT_TEST_CALL(world, N, _set_velocity)         \
    DETENT_TEST_CALL(world, N, _size)                 \
    DETENT_TEST_CALL(world, N, _snapshot)             \
    DETENT_TEST_CALL(world, N, _step)                 \
    DETENT_TEST_CALL(world, N, _touching)             \
  };
DETENT_TEST_CALLS(2)
DETENT_TEST_CALLS(3)
#undef DETENT_TEST_CALLS
#undef DETENT_TEST_CALL

}  // namespace detent::test_c
