// SPDX-License-Identifier: MIT
#pragma once

#include "detent/dynamics/record.hpp"

namespace detent::detail {

/// A change of velocity and spin, per substep.
template <Scalar S, int N>
struct Kick {
  using F = Formats<S>;

  Vec<typename F::Speed, N> velocity{};
  Axial<typename F::Spin, N> spin{};
};

/// The moment of a vector applied at `r` from the center, exactly.
template <Scalar S, int N>
[[nodiscard]] constexpr auto moment_of(const Vec<typename Formats<S>::Lever, N>& r,
                                       const Vec<S, N>& v) noexcept {
  const auto about = [&](int j, int k) { return r[j] * v[k] - r[k] * v[j]; };
  if constexpr (N == 2) {
    return std::array{about(0, 1)};
  } else {
    return std::array{about(1, 2), about(2, 0), about(0, 1)};
  }
}

/// The change of velocity of a movable body by `push` over `per`, each component rounded once.
template <Scalar S, int N, class Shape>
[[nodiscard]] constexpr auto velocity_of(const BodyRecord<S, N, Shape>& body, const Vec<S, N>& push,
                                         int per) noexcept {
  using Speed = typename Formats<S>::Speed;
  const auto mass = body.mass * as_operand<S>(per);
  return make_vec<N>([&](int i) {
    return is_locked(body.locked, i) ? Speed{} : quotient_nearest<Speed>(push[i], mass);
  });
}

/// The change of its spin by a moment over `per`: the inverse inertia in the world times the
/// moment, each component rounded once.
template <Scalar S, int N, class Shape, class Moment>
[[nodiscard]] constexpr auto spin_of(const BodyRecord<S, N, Shape>& body, const Moment& moment,
                                     int per) noexcept {
  using Spin = typename Formats<S>::Spin;
  const auto mass = body.mass * as_operand<S>(per);
  const auto spread = without_locked<S, N>(
      in_world<S, N>(body.inertia.inverse, axes_of<S, N>(body.state.orientation)), body.locked);
  if constexpr (N == 2) {
    return Axial<Spin, 2>{quotient_nearest<Spin>(spread[0] * moment[0], mass)};
  } else {
    Axial<Spin, 3> result{};
    for (int i = 0; i < 3; ++i) {
      const auto sum = spread[entry<3>(i, 0)] * moment[0] + spread[entry<3>(i, 1)] * moment[1] +
                       spread[entry<3>(i, 2)] * moment[2];
      result[static_cast<std::size_t>(i)] = quotient_nearest<Spin>(sum, mass);
    }
    return result;
  }
}

/// Adds a change, clamped.
template <Scalar S, int N>
constexpr void add(const Kick<S, N>& change, Vec<typename Formats<S>::Speed, N>& velocity,
                   Axial<typename Formats<S>::Spin, N>& spin) noexcept {
  for (int i = 0; i < N; ++i) {
    velocity[i] = saturate_to<typename Formats<S>::Speed>(velocity[i] + change.velocity[i]);
  }
  for (std::size_t i = 0; i < spin.size(); ++i) {
    spin[i] = saturate_to<typename Formats<S>::Spin>(spin[i] + change.spin[i]);
  }
}

}  // namespace detent::detail
