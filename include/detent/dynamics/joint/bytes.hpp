// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "detent/dynamics/joint/table.hpp"
#include "detent/scene/bytes.hpp"
#include "detent/scene/header.hpp"

namespace detent::detail {

/// Calls f(name, number) for each number of a joint that is not in `for_each_spring_number`, in the
/// order of snapshots.
template <class Joint, class F>
constexpr void for_each_number(Joint& joint, const F& f) {
  f("anchor_a", joint.anchor_a);
  f("anchor_b", joint.anchor_b);
  f("break_force", joint.break_force);
  if constexpr (requires { joint.frame_a; }) {
    f("frame_a", joint.frame_a);
    f("frame_b", joint.frame_b);
  }
  if constexpr (requires { joint.least; }) {
    f("least", joint.least);
    f("most", joint.most);
  }
  if constexpr (requires { joint.cone_angle; }) f("cone_angle", joint.cone_angle);
  if constexpr (requires { joint.lower; }) {
    f("lower", joint.lower);
    f("upper", joint.upper);
  }
  if constexpr (requires { joint.motor_speed; }) f("motor_speed", joint.motor_speed);
  if constexpr (requires { joint.motor_torque; }) f("motor_torque", joint.motor_torque);
  if constexpr (requires { joint.motor_force; }) f("motor_force", joint.motor_force);
  if constexpr (requires { joint.length; }) f("length", joint.length);
  if constexpr (requires { joint.frequency; } && !has_optional_spring<Joint>) {
    f("frequency", joint.frequency);
    f("damping_ratio", joint.damping_ratio);
  }
  if constexpr (requires { joint.max_force; }) f("max_force", joint.max_force);
}

/// The same for those of a spring that a snapshot omits if all are the defaults.
template <class Joint, class F>
constexpr void for_each_spring_number(Joint& joint, const F& f) {
  if constexpr (has_optional_spring<Joint>) {
    if constexpr (requires { joint.angle; }) f("angle", joint.angle);
    f("frequency", joint.frequency);
    f("damping_ratio", joint.damping_ratio);
  }
}

/// Whether a snapshot has the numbers of an optional spring.
template <class Joint>
[[nodiscard]] constexpr bool has_spring(const Joint& joint) noexcept {
  if constexpr (has_optional_spring<Joint>) {
    const Joint rigid;
    bool is_default =
        joint.frequency == rigid.frequency && joint.damping_ratio == rigid.damping_ratio;
    if constexpr (requires { joint.angle; }) is_default = is_default && joint.angle == rigid.angle;
    return !is_default;
  } else {
    return false;
  }
}

template <class Joint>
[[nodiscard]] constexpr bool has_limits(const Joint& joint) noexcept {
  if constexpr (requires { joint.has_limits; }) {
    return joint.has_limits;
  } else {
    return false;
  }
}

template <class D, class Record>
constexpr void describe_joint(D& out, const Record& record, std::uint32_t index) noexcept {
  record.joint.visit([&]<class Joint>(const Joint& joint) {
    out.add(index | (joint.collide ? std::uint32_t{1} << 21 : 0u) |
                (has_limits(joint) ? std::uint32_t{1} << 22 : 0u) |
                (has_spring(joint) ? std::uint32_t{1} << 23 : 0u) |
                std::uint32_t{joint_tag<Joint>} << 24,
            record.generation, joint.a.index, joint.b.index);
    const auto add = [&](const char*, const auto& x) { out.add(x); };
    for_each_number(joint, add);
    if (has_spring(joint)) for_each_spring_number(joint, add);
    for (std::size_t i = 0; i < RowsOf<Joint>::push; ++i) out.add(record.push[i]);
    for (std::size_t i = 0; i < RowsOf<Joint>::turn; ++i) out.add(record.turn[i]);
  });
}
template <class D, class List>
constexpr void describe_joints(D& out, const List& joints) noexcept {
  for (std::size_t i = 0; i < joints.size(); ++i) {
    if (joints[i].generation != 0) describe_joint(out, joints[i], static_cast<std::uint32_t>(i));
  }
}

/// Reads a joint of this kind, whose first word is `word`. False for invalid bytes.
template <class Joint, class Record, class Bodies>
[[nodiscard]] constexpr bool read_joint(Reader& in, Record& record, std::uint32_t word,
                                        const Bodies& bodies) noexcept {
  Joint joint;
  const auto read_body = [&](BodyId& id) {
    id.index = in.number<std::uint32_t>();
    if (id.index < bodies.size()) id.generation = bodies[id.index].generation;
  };
  in.get(record.generation);
  read_body(joint.a);
  read_body(joint.b);
  joint.collide = (word >> 21 & 1) != 0;
  if constexpr (requires { joint.has_limits; }) joint.has_limits = (word >> 22 & 1) != 0;
  const bool springs = (word >> 23 & 1) != 0;
  const auto get = [&](const char*, auto& x) { in.get(x); };
  for_each_number(joint, get);
  if (springs) for_each_spring_number(joint, get);
  for (std::size_t i = 0; i < RowsOf<Joint>::push; ++i) in.get(record.push[i]);
  for (std::size_t i = 0; i < RowsOf<Joint>::turn; ++i) in.get(record.turn[i]);
  record.joint = decltype(record.joint)(joint);
  return !in.has_failed() && joint.a.generation != 0 && joint.b.generation != 0 &&
         joint.a.index != joint.b.index && has_limits(joint) == ((word >> 22 & 1) != 0) &&
         has_spring(joint) == springs;
}

/// Reads the joints of a snapshot into an empty table.
template <class Storage, Scalar S, int N, class... Joints, class Bodies>
[[nodiscard]] constexpr Restored read_joints(
    Reader& in, JointTable<JointGroup<Storage, S, N, Joints...>>& table, std::uint32_t count,
    std::uint32_t next, const Bodies& bodies) {
  if constexpr (sizeof...(Joints) == 0) {
    return count == 0 && next == table.next ? Restored::yes : Restored::corrupted;
  } else {
    table.next = next;
    std::size_t lowest = 0;
    for (std::uint32_t k = 0; k < count; ++k) {
      const auto word = in.number<std::uint32_t>();
      const std::size_t i = word & 0x1fffffu;
      if (in.has_failed() || i < lowest) return Restored::corrupted;
      if (i >= JointGroup<Storage, S, N, Joints...>::room) return Restored::no_room;
      const auto kind = word >> 24;
      if (kind > last_listed_joint && ((joint_tag<Joints> != kind) && ...)) {
        return Restored::other_scene;
      }
      typename JointGroup<Storage, S, N, Joints...>::Record record;
      const bool known =
          ((joint_tag<Joints> == kind && read_joint<Joints>(in, record, word, bodies)) || ...);
      if (!known || record.generation == 0 || record.generation >= next) {
        return Restored::corrupted;
      }
      table.list.resize(i + 1);
      table.list[i] = record;
      ++table.size;
      lowest = i + 1;
    }
    return Restored::yes;
  }
}

}  // namespace detent::detail
