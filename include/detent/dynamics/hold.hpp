// SPDX-License-Identifier: MIT
#pragma once

#include "detent/dynamics/flight.hpp"
#include "detent/math/components.hpp"
#include "detent/number/grid.hpp"

// Held bodies (`WorldSettings::hold_distance`). A body is held at a pose while it moves and turns
// little: its contacts have the normals, points and levers of that pose, and their separations
// follow from the motion since then. A stack whose contacts followed each small lean would buckle
// once it is high enough, since contacts are springs: at 4 substeps 16 cubes are too many, in
// double too (a column of stiffness k per contact and spacing 1 buckles under its own weight at the
// height (7.84 k / 4 w)^(1/3): A. G. Greenhill, 1881).

//
// The pose at which a body is held is one of a grid, so that a snapshot needs few bits for it.

namespace detent::detail {

/// A place that may be rounded to beyond the end of the world.
template <class Place>
using WidePlace = Fixed<Place::bits + 1, Place::frac>;

/// The number nearest to an orientation's component on the grid of held orientations.
template <Scalar S>
[[nodiscard]] constexpr typename Formats<S>::Anchor anchored(
    const typename Formats<S>::Ratio& component) noexcept {
  return nearest_to<typename Formats<S>::Anchor>(component);
}

/// The orientation at which a body is held.
template <Scalar S, int N, class Shape>
[[nodiscard]] constexpr auto held_orientation(const BodyRecord<S, N, Shape>& body) noexcept {
  return from_array(unit_vector<typename Formats<S>::Ratio>(to_array(body.anchor))
                        .value_or(to_array(body.state.orientation)));
}

/// How far a body has turned since it had the orientation `from`: twice the vector part of the
/// quaternion of the turn; in 2D the sine of its angle.
///
/// Components of orientations are at most 1, so sums of four products fit 62 bits.
template <Scalar S, int N, class Shape>
[[nodiscard]] constexpr Axial<typename Formats<S>::Spin, N> turn_since(
    const BodyRecord<S, N, Shape>& body,
    const Vec<typename Formats<S>::Ratio, BodyState<S, N>::orientation_size>& from) noexcept {
  using Spin = typename Formats<S>::Spin;
  const auto& q = body.state.orientation;
  if constexpr (N == 2) {
    return {nearest_to<Spin>(narrow<62>(cross(from, q)))};
  } else {
    const auto part = [&](int i, int j, int k) {
      const auto turn =
          narrow<62>((from.w * q[i] - q.w * from[i]) - (q[j] * from[k] - q[k] * from[j]));
      return nearest_to<Spin>(turn + turn);
    };
    return {part(0, 1, 2), part(1, 2, 0), part(2, 0, 1)};
  }
}

/// How far a body has turned since it was held.
template <Scalar S, int N, class Shape>
[[nodiscard]] constexpr Axial<typename Formats<S>::Spin, N> lean_of(
    const BodyRecord<S, N, Shape>& body) noexcept {
  if (!body.is_held()) return {};
  return turn_since(body, held_orientation(body));
}

/// Sets a support to the pose at which its body is held; returns how far it has turned since.
template <Scalar S, int N, class Shape>
constexpr Axial<typename Formats<S>::Spin, N> hold_back(
    Support<S, N>& support, const BodyRecord<S, N, Shape>& body) noexcept {
  for (int i = 0; i < N; ++i) {
    support.place[i] = saturate_to<typename Formats<S>::Place>(body.state.place[i] - body.drift[i]);
  }
  const auto at = held_orientation(body);
  support.axes = axes_of<S, N>(at);
  return turn_since(body, at);
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
  if (body.is_held()) {
    hold_back(support, body);
  } else {
    let_go(support, body);
  }
  return support;
}

/// A bound, rounded to nearest, on how far any point of a body is from where it is held, for a body
/// that has turned by `lean` since then.
template <Scalar S, int N, class Shape>
[[nodiscard]] constexpr typename Formats<S>::Lever slack_of(
    const BodyRecord<S, N, Shape>& body, const Axial<typename Formats<S>::Spin, N>& lean) noexcept {
  using Lever = typename Formats<S>::Lever;
  if (!body.is_held()) return {};
  const auto reach =
      saturate_to<Lever>(abs(body.reach.radius) + sum_of_magnitudes(body.reach.half_extents));
  const auto way = sum_of_magnitudes(body.drift);
  if constexpr (N == 2) {
    return saturate_to<Lever>(way + reach * abs(lean[0]));
  } else {
    return saturate_to<Lever>(way + reach * sum_of_magnitudes(from_array(lean)));
  }
}

/// Whether a held body has moved and turned so little that it stays held.
template <Scalar S, int N, class Shape>
[[nodiscard]] constexpr bool is_within_hold(const BodyRecord<S, N, Shape>& body,
                                            const Pace<S, N>& pace) noexcept {
  using Anchor = typename Formats<S>::Anchor;
  constexpr Anchor most = fraction<Anchor>(1, N == 2 ? 128 : 256);
  for (int i = 0; i < N; ++i) {
    if (abs(body.drift[i]) > pace.hold) return false;
  }
  for (int i = 0; i < BodyState<S, N>::orientation_size; ++i) {
    if (abs(anchored<S>(body.state.orientation[i]) - body.anchor[i]) > most) return false;
  }
  return pace.hold > 0;
}

/// Holds a body at the pose of the grid next to its own.
template <Scalar S, int N, class Shape>
constexpr void hold(BodyRecord<S, N, Shape>& body, const Pace<S, N>& pace) noexcept {
  for (int i = 0; i < BodyState<S, N>::orientation_size; ++i) {
    body.anchor[i] = anchored<S>(body.state.orientation[i]);
  }
  body.drift = {};
  if constexpr (is_fixed<S>) {
    using F = Formats<S>;
    for (int i = 0; i < N; ++i) {
      const auto& x = body.state.place[i];
      const auto steps = steps_nearest(x, pace.hold_grid);
      body.drift[i] = saturate_to<typename F::Speed>(
          x - of_steps<WidePlace<typename F::Place>>(steps, pace.hold_grid));
    }
  }
}

/// Notes how far a body that touches others has moved since it was held; if it is too far, or the
/// body was not held, holds it at its current pose.
template <Scalar S, int N, class Shape>
constexpr void note_hold(BodyRecord<S, N, Shape>& body, const Moving<S, N>& moving,
                         const Pace<S, N>& pace) noexcept {
  if (body.is_held()) {
    body.drift = moving.shift;
    if (is_within_hold(body, pace)) return;
  }
  hold(body, pace);
}

}  // namespace detent::detail
