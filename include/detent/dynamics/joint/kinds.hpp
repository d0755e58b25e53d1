// SPDX-License-Identifier: MIT
#pragma once

#include <type_traits>

#include "detent/dynamics/settings.hpp"
#include "detent/math/rotation.hpp"

// The joints of a world: name them with its shapes, `World<q16_16, 2, Sphere, Obb, HingeJoint>`.
//
// Anchors and frames are in the frames of their bodies, so a joint does not depend on where the
// bodies are when it is added; `world.local_point` and `world.local_frame` convert from the world.
// Time is in the seconds of the world's settings, forces are in units of density times length^N
// times length per second squared, torques in forces times lengths, angles in radians.

namespace detent {

/// The id of a joint of a world: as for bodies.
using JointId = detail::Id<struct JointTag>;

/// The id of no joint, for `value_or` where an addition may fail.
inline constexpr JointId no_joint{};

/// The fields that all joints have.
template <Scalar S, int N>
struct JointEnds {
  BodyId a{}, b{};
  Vec<S, N> anchor_a{}, anchor_b{};  // in the frames of a and b, less than 512 units away (Q16.16)
  bool collide = false;              // whether a and b may collide
  S break_force = S(0);              // a greater force breaks the joint; 0: never

  [[nodiscard]] friend constexpr bool operator==(const JointEnds&,
                                                 const JointEnds&) noexcept = default;
};

/// Joints with directions: a slider moves along axis 0 of `frame_a`; in 3D a hinge and the axle of
/// a wheel turn about axis 2, which is also the axis of a cone. Angles are from axis 0 of `frame_a`
/// to axis 0 of `frame_b`.
template <Scalar S, int N>
struct FramedEnds : JointEnds<S, N> {
  Rotation<S, N> frame_a{}, frame_b{};  // in the frames of a and b

  [[nodiscard]] friend constexpr bool operator==(const FramedEnds&,
                                                 const FramedEnds&) noexcept = default;
};

/// Keeps the distance of two points between `least` and `most`: a rod if they are equal, a rope if
/// `least` is 0. With a frequency it is also a spring of the given length.
///
/// units:  frequency in oscillations per second, damping_ratio 1 for critical damping
/// domain: `least` greater than `most` is a rod of length `most`
/// exact:  as docs/dynamics.md says                            (tests/dynamics/joint/joint.test.cpp)
template <Scalar S, int N>
struct DistanceJoint : JointEnds<S, N> {
  S least = S(0), most = S(1);
  S length = S(1), frequency = S(0), damping_ratio = S(1);

  [[nodiscard]] friend constexpr bool operator==(const DistanceJoint&,
                                                 const DistanceJoint&) noexcept = default;
};

/// Keeps two points together; the bodies can turn about them. With a frequency the joint is soft:
/// if one body is fixed, it drags the other one to a point.
///
/// units:  frequency in oscillations per second; max_force is the most along each axis of the world
/// domain: a frequency of 0 is a rigid joint, a max_force of 0 has no limit
/// exact:  as docs/dynamics.md says                            (tests/dynamics/joint/joint.test.cpp)
template <Scalar S, int N>
struct BallJoint : JointEnds<S, N> {
  S frequency = S(0), damping_ratio = S(1);
  S max_force = S(0);

  [[nodiscard]] friend constexpr bool operator==(const BallJoint&,
                                                 const BallJoint&) noexcept = default;
};

/// Keeps two points together, in 3D, like a shoulder: axis 2 of `frame_b` stays in a cone about that
/// of `frame_a`, and b twists about it between limits.
///
/// units:  cone_angle, the greatest angle between both axes 2, lower and upper in radians
/// domain: a cone_angle of 0 is no cone; the twist is in [-pi, pi), its limits count only if
///         `has_limits`, and they give way as the swing nears pi
/// exact:  as docs/joints.md says                               (tests/dynamics/joint/cone.test.cpp)
template <Scalar S, int N>
struct ConeJoint : FramedEnds<S, N> {
  static_assert(N == 3, "detent: in 2D use a HingeJoint with limits");
  S cone_angle = S(0);
  bool has_limits = false;
  S lower = S(0), upper = S(0);

  [[nodiscard]] friend constexpr bool operator==(const ConeJoint&,
                                                 const ConeJoint&) noexcept = default;
};

/// Keeps two points together and, in 3D, axis 2 of both frames aligned. Limits of the angle are
/// within half a turn, and count only if `has_limits`; the motor turns b relative to a at
/// `motor_speed`, counter-clockwise, with at most `motor_torque`, if that is not 0. With a frequency
/// it is instead a spring that turns b to `angle`, with at most `motor_torque`, if that is not 0.
///
/// units:  lower, upper and angle in radians, motor_speed in radians per second, frequency in
///         oscillations per second
/// domain: angles are in [-pi, pi); a body that turns farther wraps from one end to the other
/// exact:  as docs/dynamics.md says                            (tests/dynamics/joint/joint.test.cpp)
template <Scalar S, int N>
struct HingeJoint : FramedEnds<S, N> {
  bool has_limits = false;
  S lower = S(0), upper = S(0);
  S motor_speed = S(0), motor_torque = S(0);
  S angle = S(0), frequency = S(0), damping_ratio = S(1);

  [[nodiscard]] friend constexpr bool operator==(const HingeJoint&,
                                                 const HingeJoint&) noexcept = default;
};

/// Keeps two points together and the frames of both bodies aligned. With a frequency it bends: a
/// spring aligns the frames.
///
/// units:  frequency in oscillations per second, damping_ratio 1 for critical damping
/// exact:  as docs/dynamics.md says                            (tests/dynamics/joint/joint.test.cpp)
template <Scalar S, int N>
struct WeldJoint : FramedEnds<S, N> {
  S frequency = S(0), damping_ratio = S(1);

  [[nodiscard]] friend constexpr bool operator==(const WeldJoint&,
                                                 const WeldJoint&) noexcept = default;
};

/// Keeps the frames of both bodies aligned, and the point of b on the line along axis 0 through the
/// point of a. It may be a spring about `length`, and have limits and a motor like a hinge.
///
/// units:  lower, upper and length in world units, motor_speed in units per second
/// domain: translations of less than 512 units
/// exact:  as docs/dynamics.md says                            (tests/dynamics/joint/joint.test.cpp)
template <Scalar S, int N>
struct SliderJoint : FramedEnds<S, N> {
  bool has_limits = false;
  S lower = S(0), upper = S(0);
  S motor_speed = S(0), motor_force = S(0);
  S length = S(0), frequency = S(0), damping_ratio = S(1);

  [[nodiscard]] friend constexpr bool operator==(const SliderJoint&,
                                                 const SliderJoint&) noexcept = default;
};

/// A wheel b on a car a: it slides along axis 0 with a spring about `length`, and turns, in 3D
/// about axis 2 of both frames. The motor turns it.
///
/// units:  lower, upper and length in world units, motor_speed in radians per second
/// domain: translations of less than 512 units
/// exact:  as docs/dynamics.md says                            (tests/dynamics/joint/joint.test.cpp)
template <Scalar S, int N>
struct WheelJoint : FramedEnds<S, N> {
  bool has_limits = false;
  S lower = S(0), upper = S(0);
  S motor_speed = S(0), motor_torque = S(0);
  S length = S(0), frequency = S(0), damping_ratio = S(1);

  [[nodiscard]] friend constexpr bool operator==(const WheelJoint&,
                                                 const WheelJoint&) noexcept = default;
};

namespace detail {

/// The number of a joint's kind in snapshots and digests, 0 for other types. It never changes.
template <class T>
inline constexpr std::uint8_t joint_tag = 0;
template <Scalar S, int N>
inline constexpr std::uint8_t joint_tag<DistanceJoint<S, N>> = 1;
template <Scalar S, int N>
inline constexpr std::uint8_t joint_tag<BallJoint<S, N>> = 2;
template <Scalar S, int N>
inline constexpr std::uint8_t joint_tag<HingeJoint<S, N>> = 3;
template <Scalar S, int N>
inline constexpr std::uint8_t joint_tag<WeldJoint<S, N>> = 4;
template <Scalar S, int N>
inline constexpr std::uint8_t joint_tag<SliderJoint<S, N>> = 5;
template <Scalar S, int N>
inline constexpr std::uint8_t joint_tag<WheelJoint<S, N>> = 6;
template <Scalar S, int N>
inline constexpr std::uint8_t joint_tag<ConeJoint<S, N>> = 7;

template <class T>
concept IsJoint = (joint_tag<T> != 0);

/// Whether the header of a snapshot lists this kind, if the world names it. Later kinds are not
/// listed, so that the snapshots of a world stay valid when its type gets such a kind.
inline constexpr std::uint32_t last_listed_joint = 6;
template <class T>
inline constexpr bool is_listed_joint = joint_tag<T> != 0 && joint_tag<T> <= last_listed_joint;

/// Whether a joint has the numbers of a spring in snapshots only if it has the spring.
template <class T>
inline constexpr bool has_optional_spring = false;
template <Scalar S, int N>
inline constexpr bool has_optional_spring<HingeJoint<S, N>> = true;
template <Scalar S, int N>
inline constexpr bool has_optional_spring<WeldJoint<S, N>> = true;
template <class T>
inline constexpr bool has_optional_spring<const T> = has_optional_spring<T>;

template <class... Ts>
struct Types {
  template <template <class...> class List>
  using In = List<Ts...>;
};
template <class... Ts, class... Us>
constexpr Types<Ts..., Us...> operator+(Types<Ts...>, Types<Us...>) noexcept {
  return {};
}

/// The joints among the types that a world names, or the other types.
template <bool Joints, class... Parts>
using Select = decltype((Types<>() + ... +
                         std::conditional_t<IsJoint<Parts> == Joints, Types<Parts>, Types<>>()));

}  // namespace detail

}  // namespace detent
