// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "detent/dynamics/compound.hpp"
#include "detent/dynamics/local.hpp"
#include "detent/dynamics/mass.hpp"
#include "detent/dynamics/settings.hpp"
#include "detent/dynamics/spin.hpp"
#include "detent/number/grid.hpp"

namespace detent::detail {

/// The numbers of a world's settings in its own formats, each rounded to nearest once.
template <Scalar S, int N>
struct Pace {
  using F = Formats<S>;

  int rate = 240;        // substeps per second
  int quiet_ticks = 30;  // half a second
  Vec<typename F::Speed, N> gravity{};
  typename F::Speed push{}, bounce{}, sleep{};
  typename F::Spin sleep_spin{};
  typename F::Lever margin{};
  typename F::Speed hold{};
  int hold_grid = 0;  // held positions are multiples of 2^hold_grid steps of Place
};

/// The exponent of the least power of two of which 1,023 are at least `hold`, in steps.
template <Number T>
[[nodiscard]] constexpr int hold_grid_of(const T& hold) noexcept {
  int exponent = 0;
  if constexpr (is_fixed<T>) {
    const Fixed<10, 0> most(1023);
    while (of_steps<Fixed<40, T::frac>>(most, exponent) < hold) ++exponent;
  }
  return exponent;
}

template <Scalar S, int N>
[[nodiscard]] constexpr Pace<S, N> pace_of(const WorldSettings<S, N>& settings) noexcept {
  using F = Formats<S>;
  using Speed = typename F::Speed;
  const auto rate = settings.ticks_per_second * settings.substeps;
  const auto hold = saturate_to<Speed>(settings.hold_distance);
  const auto per_substep = [&](const S& x) {
    return quotient_nearest<Speed>(x, as_operand<S>(rate));
  };
  return {rate,
          (std::max)(settings.ticks_per_second / 2, 1),
          make_vec<N>([&](int i) {
            return quotient_nearest<Speed>(settings.gravity[i], as_operand<S>(rate * rate));
          }),
          per_substep(settings.push_speed),
          per_substep(settings.bounce_threshold),
          per_substep(settings.sleep_speed),
          quotient_nearest<typename F::Spin>(settings.sleep_speed, as_operand<S>(rate)),
          nearest_to<typename F::Lever>(settings.margin),
          hold,
          hold_grid_of(hold)};
}

/// Whether a body is locked along an axis, by the bits of `AxisLock`.
[[nodiscard]] constexpr bool is_locked(std::uint8_t locked, int axis) noexcept {
  return ((locked >> axis) & 1) != 0;
}
/// Whether a body is locked against turning about an axis; in 2D there is only one.
template <int N>
[[nodiscard]] constexpr bool is_turn_locked(std::uint8_t locked, int axis) noexcept {
  return N == 2 ? (locked & AxisLock::turn) != 0 : is_locked(locked, axis + 3);
}
/// Velocity and spin without the locked components.
template <Scalar S, int N>
constexpr void lock(std::uint8_t locked, Vec<typename Formats<S>::Speed, N>& velocity,
                    Axial<typename Formats<S>::Spin, N>& spin) noexcept {
  if (locked == 0) return;
  for (int i = 0; i < N; ++i) {
    if (is_locked(locked, i)) velocity[i] = {};
  }
  for (std::size_t i = 0; i < spin.size(); ++i) {
    if (is_turn_locked<N>(locked, static_cast<int>(i))) spin[i] = {};
  }
}
/// The matrix `m` without the rows and columns of locked turns.
template <Scalar S, int N>
[[nodiscard]] constexpr Spread<typename Formats<S>::Gyration, N> without_locked(
    Spread<typename Formats<S>::Gyration, N> m, std::uint8_t locked) noexcept {
  constexpr int axes = N == 2 ? 1 : 3;
  for (int i = 0; locked != 0 && i < axes; ++i) {
    if (!is_turn_locked<N>(locked, i)) continue;
    for (int j = 0; j < axes; ++j) m[entry<N>(i, j)] = {};
  }
  return m;
}

/// A body of a world.
template <Scalar S, int N, class Shape>
struct BodyRecord {
  using F = Formats<S>;

  // Mass, inertia, reach and what damping leaves are derived from the others. What every step reads
  // comes first, in few lines of the cache.
  std::uint32_t generation = 0;  // 0 for an unused index
  BodyMotion motion = BodyMotion::fixed;
  bool sleeps = false;
  std::uint8_t quiet = 0;  // consecutive ticks in which it was slow, up to 255
  std::uint8_t locked = 0;
  typename MassProperties<S, N>::Formats::Mass mass{};
  bool is_sensor = false;
  bool is_fast = false;
  std::uint32_t layers = 0, collides_with = 0;
  S friction{}, restitution{}, rolling_resistance{};
  S gravity_scale = S(1);
  typename F::Ratio kept_velocity{}, kept_spin{};  // by damping, per substep
  Vec<typename F::Speed, N> push{};  // gained from forces in each substep of the next tick
  Axial<typename F::Spin, N> twist{};
  BodyState<S, N> state{};
  Vec<typename F::Speed, N> drift{};                                    // from where it is held
  Vec<typename F::Anchor, BodyState<S, N>::orientation_size> anchor{};  // held so; 0: not held
  Inertia<S, N> inertia{};
  BodyExtent<S, N> reach{};
  Shape shape{};  // in the body's frame
  S density{}, linear_damping{}, angular_damping{};
  std::uint64_t user = 0;

  [[nodiscard]] constexpr bool can_move() const noexcept {
    return motion == BodyMotion::dynamic && mass > 0;
  }
  [[nodiscard]] constexpr bool is_pushed() const noexcept {
    return !(push == Vec<typename F::Speed, N>() && twist == Axial<typename F::Spin, N>());
  }
  /// Whether its contacts have the geometry of an earlier pose.
  [[nodiscard]] constexpr bool is_held() const noexcept { return !(anchor == decltype(anchor)()); }
  constexpr void let_go() noexcept {
    drift = {};
    anchor = {};
  }
};

template <Scalar S, int N, class Shape>
[[nodiscard]] constexpr bool is_awake(const BodyRecord<S, N, Shape>& body) noexcept {
  return body.generation != 0 && body.can_move() && !body.sleeps;
}
/// Whether a body is kinematic and moves.
template <Scalar S, int N, class Shape>
[[nodiscard]] constexpr bool is_driven(const BodyRecord<S, N, Shape>& body) noexcept {
  using F = Formats<S>;
  return body.generation != 0 && body.motion == BodyMotion::kinematic &&
         !(body.state.velocity == Vec<typename F::Speed, N>() &&
           body.state.spin == Axial<typename F::Spin, N>());
}
/// Whether two bodies are in layers that meet.
template <Scalar S, int N, class Shape>
[[nodiscard]] constexpr bool layers_meet(const BodyRecord<S, N, Shape>& a,
                                         const BodyRecord<S, N, Shape>& b) noexcept {
  return (a.layers & b.collides_with) != 0 && (b.layers & a.collides_with) != 0;
}

/// The number of parts of a compound; 0 for other bodies.
template <Scalar S, int N, class Shape>
[[nodiscard]] constexpr std::size_t part_count(const BodyRecord<S, N, Shape>& body) noexcept {
  const auto* compound = compound_of<S, N>(body.shape);
  return compound == nullptr ? 0 : compound->parts().size();
}
/// 1 - damping / rate, at least 0, rounded to nearest.
template <Scalar S>
[[nodiscard]] constexpr typename Formats<S>::Ratio kept(const S& damping, int rate) noexcept {
  using Ratio = typename Formats<S>::Ratio;
  if (damping <= 0) return Ratio(1);
  const auto lost = quotient_nearest<Ratio>(damping, as_operand<S>(rate));
  return lost >= Ratio(1) ? Ratio{} : nearest_to<Ratio>(Ratio(1) - lost);
}

/// The inertia of a body whose squared gyration and inverse are these.
template <Scalar S>
[[nodiscard]] constexpr Inertia<S, 2> inertia_of(
    const typename MassFormats<S>::Gyration&,
    const typename MassFormats<S>::InverseGyration& inverse) noexcept {
  Inertia<S, 2> inertia;
  inertia.inverse = {inverse};
  return inertia;
}
template <Scalar S>
[[nodiscard]] constexpr Inertia<S, 3> inertia_of(
    const Symmetric<typename MassFormats<S>::Gyration>& squared,
    const Symmetric<typename MassFormats<S>::InverseGyration>& inverse) noexcept {
  using F = Formats<S>;
  const auto entries = [](const auto& m) {
    return std::array{m.diagonal[0], m.diagonal[1], m.diagonal[2],
                      m.mixed[0],    m.mixed[1],    m.mixed[2]};
  };
  const auto greatest = (max)((max)(squared.diagonal[0], squared.diagonal[1]), squared.diagonal[2]);
  Inertia<S, 3> inertia;
  inertia.inverse = entries(inverse);
  for (std::size_t i = 0; i < 6; ++i) {
    inertia.share[i] = quotient_nearest<typename F::Ratio>(entries(squared)[i], greatest);
    inertia.inverse_share[i] = nearest_to<typename F::Stretch>(entries(inverse)[i] * greatest);
  }
  inertia.is_round = squared.diagonal[0] == squared.diagonal[1] &&
                     squared.diagonal[1] == squared.diagonal[2] && squared.mixed[0] == 0 &&
                     squared.mixed[1] == 0 && squared.mixed[2] == 0;
  return inertia;
}

/// Computes the fields derived from the damping.
template <Scalar S, int N, class Shape>
constexpr void derive_kept(BodyRecord<S, N, Shape>& body, int rate) noexcept {
  body.kept_velocity = kept<S>(body.linear_damping, rate);
  body.kept_spin = kept<S>(body.angular_damping, rate);
}

/// Computes the fields derived from the shape, the density and the damping.
template <Scalar S, int N, class Shape>
constexpr void derive(BodyRecord<S, N, Shape>& body, int rate) noexcept {
  body.shape.visit([&](const auto& shape) {
    const auto properties = mass_properties(shape, body.density);
    body.mass = properties.mass;
    body.reach = extent_of(shape);
    if (body.can_move()) {
      body.inertia = inertia_of<S>(properties.gyration, properties.inverse_gyration);
    }
  });
  derive_kept(body, rate);
}

}  // namespace detent::detail
