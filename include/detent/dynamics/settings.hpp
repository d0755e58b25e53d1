// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

#include "detent/dynamics/axial.hpp"
#include "detent/scene/object.hpp"

namespace detent {

/// The id of a body of a world: as for objects of scenes.
using BodyId = ObjectId;

/// How a body moves.
enum class BodyMotion : std::uint8_t {
  dynamic,    // by gravity, contacts and its velocity
  kinematic,  // only by its velocity: nothing stops it
  fixed,      // never
};

namespace detail {

/// n / d in the scalar, rounded to nearest.
template <Scalar S>
[[nodiscard]] constexpr S fraction(int n, int d) noexcept {
  return quotient_nearest<S>(as_operand<S>(n), as_operand<S>(d));
}

/// 10 units per second squared, down the y axis in 2D and in 3D.
template <Scalar S, int N>
[[nodiscard]] constexpr Vec<S, N> standard_gravity() noexcept {
  Vec<S, N> gravity{};
  gravity.y = S(-10);
  return gravity;
}

/// Settings with at least one tick per second and one substep, and at most 32,767 substeps per
/// second: other values are clamped.
template <class Settings>
[[nodiscard]] constexpr Settings with_valid_rate(Settings settings) noexcept {
  constexpr int most = 32767;
  int &ticks = settings.ticks_per_second, &substeps = settings.substeps;
  ticks = ticks < 1 ? 1 : ticks > most ? most : ticks;
  substeps = substeps < 1 ? 1 : substeps > most / ticks ? most / ticks : substeps;
  return settings;
}

}  // namespace detail

/// Bits of `BodyOptions::locked`: the axes of the world that a body does not move along or turn
/// about. In 2D each of the last three stops it from turning.
struct AxisLock {
  static constexpr std::uint8_t x = 1, y = 2, z = 4;
  static constexpr std::uint8_t turn_x = 8, turn_y = 16, turn_z = 32;
  static constexpr std::uint8_t turn = turn_x | turn_y | turn_z;
};

/// The properties of a body and its initial motion. Seconds are those of the world's settings.
template <Scalar S, int N>
struct BodyOptions {
  BodyMotion motion = BodyMotion::dynamic;
  S density = S(1);                                 // mass per area or volume
  S friction = detail::fraction<S>(3, 5);           // two bodies: the root of the product
  S restitution = S(0);                             // two bodies: the greater one
  S linear_damping = S(0), angular_damping = S(0);  // share lost per second, if small
  Vec<S, N> velocity{};                             // units per second
  detail::Axial<S, N> angular_velocity{};           // radians per second
  S gravity_scale = S(1);                           // of the world's gravity
  std::uint8_t locked = 0;                          // bits of `AxisLock`
  bool is_sensor = false;                           // touches are reported, and push nothing
  bool is_fast = false;                       // never passes through others: continuous collision
  std::uint32_t layers = 1;                   // the layers that it is in
  std::uint32_t collides_with = 0xffffffffu;  // layers it collides with; both bodies must agree
  std::uint64_t user = 0;                     // any word; saved, never read
  /// Stops balls and capsules from rolling and spinning: the greatest torque of a contact against
  /// it, as a share of its pressure times the radius. Two bodies: the greater one; 0.05 is a lot.
  S rolling_resistance = S(0);
};

/// How a world steps.
///
/// domain: ticks per second and substeps at least 1, their product at most 32,767; a world clamps
///         the former, then the latter
template <Scalar S, int N>
struct WorldSettings {
  int ticks_per_second = 60;
  int substeps = 4;
  Vec<S, N> gravity = detail::standard_gravity<S, N>();
  S margin = detail::fraction<S>(1, 50);       // distance at which bodies are in contact
  S push_speed = S(3);                         // greatest speed at which an overlap is undone
  S bounce_threshold = S(1);                   // slower impacts do not bounce
  S sleep_speed = detail::fraction<S>(1, 20);  // slower bodies may sleep; 0: never
  /// Bodies keep the geometry of their contacts while they move no more than this and turn by no
  /// more than 1/128, so that tall stacks stand. 0: never.
  S hold_distance = detail::fraction<S>(1, 10);
};

}  // namespace detent
