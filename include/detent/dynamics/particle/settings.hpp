// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "detent/dynamics/record.hpp"

namespace detent {

/// Where the velocity of a particle comes from.
enum class Integrator : std::uint8_t {
  verlet,  // the change of position: constraints and shapes change it by moving the particle
  euler,   // separate state: forces and impacts change it, constraints do not
};

/// How a `ParticleSystem` steps.
///
/// domain: ticks per second and substeps as for `WorldSettings`
template <Scalar S, int N>
struct ParticleSettings {
  int ticks_per_second = 60;
  int substeps = 4;
  int iterations = 1;  // passes over the constraints in each substep
  Integrator integrator = Integrator::verlet;
  Vec<S, N> gravity = detail::standard_gravity<S, N>();
  S damping = S(0);                        // share of the velocity lost per second, for small ones
  S friction = detail::fraction<S>(3, 5);  // with shapes
  S restitution = S(0);                    // of impacts faster than the bounce threshold
  S bounce_threshold = S(1);
};

/// How a particle starts.
template <Scalar S, int N>
struct ParticleOptions {
  Vec<S, N> velocity{};                   // units per second
  S mass = S(1);                          // a particle without mass is held, like a pinned one
  S radius = detail::fraction<S>(1, 20);  // for collisions with shapes; particles do not collide
  bool is_pinned = false;                 // moves only by `move_to`
};

namespace detail {

/// The numbers of the settings in the formats of a step, each rounded to nearest once.
template <Scalar S, int N>
struct ParticlePace {
  using F = Formats<S>;

  int rate;  // substeps per second
  Vec<typename F::Speed, N> gravity;
  typename F::Speed bounce;
  typename F::Ratio kept, friction, restitution;
};

template <Scalar S, int N>
[[nodiscard]] constexpr ParticlePace<S, N> pace_of(
    const ParticleSettings<S, N>& settings) noexcept {
  using F = Formats<S>;
  using Speed = typename F::Speed;
  using Ratio = typename F::Ratio;
  const auto rate = settings.ticks_per_second * settings.substeps;
  return {rate,
          quotient_nearest<Speed>(settings.gravity, as_operand<S>(rate * rate)),
          quotient_nearest<Speed>(settings.bounce_threshold, as_operand<S>(rate)),
          kept<S>(settings.damping, rate),
          saturate_to<Ratio>(settings.friction),
          saturate_to<Ratio>(settings.restitution)};
}

/// A particle: its position and motion, then its properties.
template <Scalar S, int N>
struct ParticleRecord {
  Vec<typename Formats<S>::Place, N> place{};
  Vec<typename Formats<S>::Speed, N> velocity{};  // per substep
  S mass{}, radius{};
  bool is_pinned = false;

  [[nodiscard]] constexpr bool is_held() const noexcept { return is_pinned || !(mass > 0); }
  [[nodiscard]] friend constexpr bool operator==(const ParticleRecord&,
                                                 const ParticleRecord&) noexcept = default;
};

}  // namespace detail

}  // namespace detent
