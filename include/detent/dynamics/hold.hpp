// SPDX-License-Identifier: MIT
#pragma once

#include "detent/dynamics/flight.hpp"

// Held bodies (`WorldSettings::hold_distance`). A body is held at a pose while it moves and turns
// little: its contacts have the normals, points and levers of that pose, and their separations
// follow from the motion since then. A stack whose contacts followed each small lean would buckle
// once it is high enough, since contacts are springs: at 4 substeps 16 cubes are too many, in
// double too (a column of stiffness k per contact and spacing 1 buckles under its own weight at the
// height (7.84 k / 4 w)^(1/3): A. G. Greenhill, 1881).

namespace detent::detail {

/// Sets a support to the pose at which its body is held.
template <Scalar S, int N, class Shape>
constexpr void hold_back(Support<S, N>& support, const BodyRecord<S, N, Shape>& body) noexcept {
  using F = Formats<S>;
  for (int i = 0; i < N; ++i) {
    support.place[i] = saturate_to<typename F::Place>(body.state.place[i] - body.drift[i]);
  }
  auto back = body.lean;
  for (auto& w : back) w = saturate_to<typename F::Spin>(-w);
  support.axes = axes_of<S, N>(turned<S, N>(body.state.orientation, back));
}

/// Sets a support to the current pose of its body.
template <Scalar S, int N, class Shape>
constexpr void let_go(Support<S, N>& support, const BodyRecord<S, N, Shape>& body) noexcept {
  support.place = body.state.place;
  support.axes = axes_of<S, N>(body.state.orientation);
}

/// The place and axes at which a body is held, without the rest of a support.
template <Scalar S, int N, class Shape>
[[nodiscard]] constexpr Support<S, N> held_support(const BodyRecord<S, N, Shape>& body) noexcept {
  Support<S, N> support;
  body.is_held() ? hold_back(support, body) : let_go(support, body);
  return support;
}

/// The sum of the magnitudes of a vector's components.
template <Number T>
[[nodiscard]] constexpr auto sum_of_magnitudes(const Vec<T, 2>& v) noexcept {
  return abs(v.x) + abs(v.y);
}
template <Number T>
[[nodiscard]] constexpr auto sum_of_magnitudes(const Vec<T, 3>& v) noexcept {
  return abs(v.x) + abs(v.y) + abs(v.z);
}

/// A bound, rounded to nearest, on how far any point of the body is from where it is held.
template <Scalar S, int N, class Shape>
[[nodiscard]] constexpr typename Formats<S>::Lever slack_of(
    const BodyRecord<S, N, Shape>& body) noexcept {
  using Lever = typename Formats<S>::Lever;
  if (!body.is_held()) return {};
  const auto reach =
      saturate_to<Lever>(abs(body.reach.radius) + sum_of_magnitudes(body.reach.half_extents));
  const auto way = sum_of_magnitudes(body.drift);
  if constexpr (N == 2) {
    return saturate_to<Lever>(way + reach * abs(body.lean[0]));
  } else {
    return saturate_to<Lever>(way + reach * sum_of_magnitudes(from_array(body.lean)));
  }
}

/// Whether a body has moved and turned so little that it stays held.
template <Scalar S, int N, class Shape>
[[nodiscard]] constexpr bool is_within_hold(const BodyRecord<S, N, Shape>& body,
                                            const Pace<S, N>& pace) noexcept {
  if (!body.is_held()) return true;
  for (int i = 0; i < N; ++i) {
    if (abs(body.drift[i]) > pace.hold) return false;
  }
  for (const auto& w : body.lean) {
    if (abs(w) > pace.hold_turn) return false;
  }
  return pace.hold > 0;
}

/// Records how far an awake body has moved and turned since it was held; if that is too far, holds
/// it at its current pose.
template <Scalar S, int N, class Shape>
constexpr void note_hold(BodyRecord<S, N, Shape>& body, const Moving<S, N>& moving,
                         const Pace<S, N>& pace) noexcept {
  body.drift = moving.shift;
  body.lean = moving.turn;
  if (!is_within_hold(body, pace)) body.hold_here();
}

}  // namespace detent::detail
