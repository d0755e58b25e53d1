// SPDX-License-Identifier: MIT
#pragma once

#include "detent/number/angle_range.hpp"
#include "detent/shape/camera.hpp"

namespace detent {

/// The range of distance and pitch of an `OrbitCamera`.
template <Scalar S>
struct OrbitLimits {
  S min_distance = S(1);
  S max_distance = largest<S>;
  Angle<S> min_pitch = Angle<S>::turn(-11, 45);
  Angle<S> max_pitch = Angle<S>::turn(11, 45);

  [[nodiscard]] friend constexpr bool operator==(const OrbitLimits&,
                                                 const OrbitLimits&) noexcept = default;
};

/// A camera that orbits a target and always looks at it.
///
/// At yaw 0 and pitch 0 it is on the target's +z side and looks along -z. Yaw turns it towards +x,
/// around the y axis; pitch lifts it. The operations keep distance and pitch within the limits, by
/// default 88 degrees up and down; fields set by the caller are used as they are.
template <Scalar S>
struct OrbitCamera {
  Lens<S> lens;
  Vec<S, 3> target{};
  S distance = S(1);
  Angle<S> yaw{};
  Angle<S> pitch{};
  OrbitLimits<S> limits{};

  /// Turns by `yaw_step` around the target, and by `pitch_step` up, within the limits.
  constexpr void rotate(Angle<S> yaw_step, Angle<S> pitch_step) noexcept {
    yaw += yaw_step;
    pitch = sum_within(pitch, pitch_step, limits.min_pitch, limits.max_pitch);
  }

  /// Multiplies the distance, rounded to nearest, within the limits.
  constexpr void zoom(const S& factor) noexcept {
    distance = nearest_to<S>(distance * factor);
    if (distance > limits.max_distance) distance = limits.max_distance;
    if (distance < limits.min_distance) distance = limits.min_distance;
  }

  /// Moves the target, and the camera with it, to the right and upward in the image. Each
  /// coordinate is the exact one rounded to nearest, ties to even, and clamped.
  constexpr void pan(const S& right, const S& up) noexcept {
    const auto frame = rotation();
    target = nearest_to<S>(target + right * frame.axis(0).vec() + up * frame.axis(1).vec());
  }

  /// exact: like `Rotation::from_euler`
  [[nodiscard]] constexpr Rotation<S, 3> rotation() const noexcept {
    return Rotation<S, 3>::from_euler(-pitch, yaw, Angle<S>());
  }

  /// The camera; its position is target + distance * axis(2), each coordinate rounded to nearest,
  /// ties to even, and clamped.                         (tests/shape/orbit_camera.test.cpp)
  [[nodiscard]] constexpr Camera<S> camera() const noexcept {
    const auto frame = rotation();
    const auto position = nearest_to<S>(target + distance * frame.axis(2).vec());
    return {Transform<S, 3>{position, frame, S(1)}, lens};
  }

  [[nodiscard]] friend constexpr bool operator==(const OrbitCamera&,
                                                 const OrbitCamera&) noexcept = default;
};

/// Appends to a digest: lens, target, distance, yaw, pitch, limits.
template <class D, Scalar S>
constexpr void append(D& digest, const OrbitCamera<S>& orbit) noexcept {
  const auto& limits = orbit.limits;
  digest.add(orbit.lens, orbit.target, orbit.distance, orbit.yaw, orbit.pitch, limits.min_distance,
             limits.max_distance, limits.min_pitch, limits.max_pitch);
}

}  // namespace detent
