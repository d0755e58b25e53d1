// SPDX-License-Identifier: MIT
#pragma once

#include <utility>

#include "detent/dynamics/contact.hpp"
#include "detent/dynamics/record.hpp"
#include "detent/dynamics/row.hpp"

namespace detent::detail {

/// The data of a body in its current pose that rows need. `axes` are those of its orientation.
template <Scalar S, int N, class Shape>
[[nodiscard]] constexpr Support<S, N> support_of(const BodyRecord<S, N, Shape>& body,
                                                 const Axes<S, N>& axes) noexcept {
  Support<S, N> support;
  support.axes = axes;
  support.place = body.state.place;
  support.locked = body.can_move() ? body.locked : std::uint8_t{0};
  support.spread =
      without_locked<S, N>(in_world<S, N>(body.inertia.inverse, support.axes), support.locked);
  support.is_fixed = body.motion == BodyMotion::fixed;
  return support;
}

template <Scalar S, int N, class Shape>
[[nodiscard]] constexpr Support<S, N> support_of(const BodyRecord<S, N, Shape>& body) noexcept {
  return support_of<S, N>(body, axes_of<S, N>(body.state.orientation));
}

/// Shares of the inverse masses: each is the other mass over the sum of both.
template <Scalar S, class Body>
[[nodiscard]] constexpr auto mass_shares(const Body& a, const Body& b) noexcept {
  using Ratio = typename Formats<S>::Ratio;
  std::pair<Ratio, Ratio> share{};
  if (a.can_move() && b.can_move()) {
    share.first = quotient_nearest<Ratio>(b.mass, a.mass + b.mass);
    if constexpr (is_fixed<S>) {
      share.second = narrow<Ratio::bits>(Ratio(1) - share.first);  // 1 is even, so ties agree
    } else {
      share.second = quotient_nearest<Ratio>(a.mass, a.mass + b.mass);
    }
  } else {
    (a.can_move() ? share.first : share.second) = Ratio(1);
  }
  return share;
}

/// The first half of a substep: gravity, forces, damping and locked axes.
template <Scalar S, int N, class Shape>
constexpr void accelerate(const BodyRecord<S, N, Shape>& body, Moving<S, N>& moving,
                          const Pace<S, N>& pace) noexcept {
  using F = Formats<S>;
  using Ratio = typename F::Ratio;
  for (int i = 0; i < N; ++i) {
    auto& v = moving.velocity[i];
    const auto gravity = body.gravity_scale == S(1)
                             ? pace.gravity[i]
                             : saturate_to<typename F::Speed>(body.gravity_scale * pace.gravity[i]);
    v = saturate_to<typename F::Speed>(v + gravity);
    v = saturate_to<typename F::Speed>(v + body.push[i]);
    if (body.kept_velocity != Ratio(1)) {
      v = nearest_to<typename F::Speed>(v * body.kept_velocity);
    }
  }
  for (std::size_t i = 0; i < moving.spin.size(); ++i) {
    moving.spin[i] = saturate_to<typename F::Spin>(moving.spin[i] + body.twist[i]);
  }
  if (body.kept_spin != Ratio(1)) {
    for (auto& w : moving.spin) w = nearest_to<typename F::Spin>(w * body.kept_spin);
  }
  lock<S, N>(body.locked, moving.velocity, moving.spin);
}

/// Whether a body's spin changes by itself, to keep its angular momentum.
template <Scalar S, int N, class Shape>
[[nodiscard]] constexpr bool tumbles(const BodyRecord<S, N, Shape>& body) noexcept {
  return N == 3 && !body.inertia.is_round && body.can_move();
}
/// Sets the spin that keeps the angular momentum of a body that tumbles from the axes `from` to
/// those of the orientation q, and writes the latter to `to`.
template <Scalar S, class Shape>
constexpr void carry(const BodyRecord<S, 3, Shape>& body, Moving<S, 3>& moving,
                     const Vec<typename Formats<S>::Ratio, 4>& q, const Axes<S, 3>& from,
                     Axes<S, 3>& to) noexcept {
  to = axes_of<S, 3>(q);
  moving.spin = carried<S>(moving.spin, from, to, body.inertia);
  lock<S, 3>(body.locked, moving.velocity, moving.spin);
}

/// The second half of a substep except for the turn: moves by the velocity. Positions are exact,
/// but clamped at the ends of the world.
template <Scalar S, int N, class Shape>
constexpr void move(BodyRecord<S, N, Shape>& body, Moving<S, N>& moving) noexcept {
  using F = Formats<S>;
  if (body.can_move()) lock<S, N>(body.locked, moving.velocity, moving.spin);
  for (int i = 0; i < N; ++i) {
    auto& x = body.state.place[i];
    const auto to = saturate_to<typename F::Place>(x + moving.velocity[i]);
    moving.shift[i] = saturate_to<typename F::Speed>(moving.shift[i] + (to - x));
    x = to;
  }
  for (std::size_t i = 0; i < moving.spin.size(); ++i) {
    moving.turn[i] = saturate_to<typename F::Spin>(moving.turn[i] + moving.spin[i]);
  }
}

}  // namespace detent::detail
