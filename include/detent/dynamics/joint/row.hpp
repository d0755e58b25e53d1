// SPDX-License-Identifier: MIT
#pragma once

#include "detent/dynamics/joint/law.hpp"

namespace detent::detail {

/// A direction in which a joint pushes two points.
template <Scalar S, int N>
struct PushRow {
  using F = Formats<S>;

  Terms<S, typename F::Speed, typename F::Impulse> terms{};
  Thrust<S, N> thrust{};
  Row<S, N> row{};
  typename F::Speed gap{};
};

/// An axis about which a joint turns two bodies. A turn of 1 changes the spin of b relative to a by
/// 1 about the axis.
template <Scalar S, int N>
struct TurnRow {
  using F = Formats<S>;

  Terms<S, typename F::Spin, typename F::Turn> terms{};
  Axial<typename F::Ratio, N> axis{};
  Axial<typename F::TurnShare, N> on_a{}, on_b{};
  typename F::Spin gap{};
};

/// The rate at which b turns about `axis` relative to a.
///
/// |axis| |wb - wa| <= 2^30 (1 + 2^-28) 2^31 sqrt(3) fits 62 bits.
template <Scalar S, int N, class F = Formats<S>>
[[nodiscard]] constexpr typename F::Spin turning_rate(
    const Axial<typename F::Ratio, N>& axis, const Axial<typename F::Spin, N>& wa,
    const Axial<typename F::Spin, N>& wb) noexcept {
  if constexpr (N == 2) {
    return nearest_to<typename F::Spin>(narrow<62>(axis[0] * (wb[0] - wa[0])));
  } else {
    return nearest_to<typename F::Spin>(
        narrow_dot<62>(from_array(axis), from_array(wb) - from_array(wa)));
  }
}

/// Turns b by `turn` and a in the opposite direction. A product is rounded, a spin clamped.
template <Scalar S, int N, class F = Formats<S>>
constexpr void apply(const TurnRow<S, N>& row, const typename F::Turn& turn, Moving<S, N>& a,
                     Moving<S, N>& b) noexcept {
  using Spin = typename F::Spin;
  constexpr int turns = N == 2 ? 1 : 3;
  if constexpr (is_fixed<S>) {
    if (turn == 0) return;
  }
  push_each<-1, turns, Spin>(row.on_a, turn, a.spin);
  push_each<1, turns, Spin>(row.on_b, turn, b.spin);
}

/// Computes a row's shares and returns s: with y = G axis for each body, s is the sum of both axis
/// . y, and the shares are y / s, or 0 if s is not positive.
template <Scalar S, int N, class F = Formats<S>>
constexpr auto share_out(TurnRow<S, N>& row, const Spread<typename F::Gyration, N>& spread_a,
                         const Spread<typename F::Gyration, N>& spread_b) noexcept {
  using Gyration = typename F::Gyration;
  using TurnShare = typename F::TurnShare;
  const auto times_axis = [&](const Spread<Gyration, N>& spread) {
    Axial<Gyration, N> y;
    for (std::size_t i = 0; i < y.size(); ++i) {
      if constexpr (N == 2) {
        y[i] = nearest_to<Gyration>(spread[0] * row.axis[0]);
      } else {
        const auto line =
            make_vec<3>([&](int j) { return spread[entry<3>(static_cast<int>(i), j)]; });
        y[i] = nearest_dot<Gyration>(from_array(row.axis), line);
      }
    }
    return y;
  };
  const auto along_axis = [&](const Axial<Gyration, N>& y) {
    if constexpr (N == 2) {
      return nearest_to<Gyration>(row.axis[0] * y[0]);
    } else {
      return nearest_dot<Gyration>(from_array(row.axis), from_array(y));
    }
  };
  const auto y_a = times_axis(spread_a), y_b = times_axis(spread_b);
  const auto whole = along_axis(y_a) + along_axis(y_b);
  for (std::size_t i = 0; i < y_a.size(); ++i) {
    row.on_a[i] = whole > 0 ? quotient_of_long<TurnShare>(y_a[i], whole) : TurnShare{};
    row.on_b[i] = whole > 0 ? quotient_of_long<TurnShare>(y_b[i], whole) : TurnShare{};
  }
  return whole;
}

/// One more solve of a row, whose impulse so far is `total`.
template <Pass P, Scalar S, int N>
constexpr void solve(const PushRow<S, N>& push, typename Formats<S>::Impulse& total,
                     Moving<S, N>& a, Moving<S, N>& b) noexcept {
  using Impulse = typename Formats<S>::Impulse;
  const auto rate =
      rate_along<S, N>(push.thrust.along, push.row, a.velocity, a.spin, b.velocity, b.spin);
  const auto before = total;
  total = next_total<P>(push.terms, push.row.mass, rate, push.gap, total);
  apply(push.thrust, push.row, saturate_to<Impulse>(total - before), a, b);
}
/// The same for a push along axis I of the world.
template <Pass P, int I, Scalar S>
constexpr void solve_along_axis(const PushRow<S, 3>& push, typename Formats<S>::Impulse& total,
                                Moving<S, 3>& a, Moving<S, 3>& b) noexcept {
  using Impulse = typename Formats<S>::Impulse;
  const auto rate = rate_along_axis<I, S>(push.row, a, b);
  const auto before = total;
  total = next_total<P>(push.terms, push.row.mass, rate, push.gap, total);
  apply_along_axis<I, S>(push.thrust, push.row, saturate_to<Impulse>(total - before), a, b);
}
template <Pass P, Scalar S, int N>
constexpr void solve(const TurnRow<S, N>& turn, typename Formats<S>::Turn& total, Moving<S, N>& a,
                     Moving<S, N>& b) noexcept {
  const auto rate = turning_rate<S, N>(turn.axis, a.spin, b.spin);
  const auto before = total;
  total = next_total<P>(turn.terms, typename Formats<S>::Ratio(1), rate, turn.gap, total);
  apply(turn, saturate_to<typename Formats<S>::Turn>(total - before), a, b);
}

}  // namespace detent::detail
