// SPDX-License-Identifier: MIT
#pragma once

#include "detent/dynamics/contact.hpp"

namespace detent::detail {

/// Warm-starts a substep with the impulses of the last one.
template <Scalar S, int N>
constexpr void warm_start(const ReadyContact<S, N>& ready, const ContactRows<S, N>& rows,
                          const BodyContact<S, N>& contact, Moving<S, N>& a,
                          Moving<S, N>& b) noexcept {
  for (std::size_t i = 0; i < ready.count; ++i) {
    apply(rows.normal, rows.pressure[i], contact.pressure[i], a, b, ready.pushed);
  }
  for (std::size_t t = 0; t < rows.friction.size(); ++t) {
    apply(rows.tangent[t], rows.friction[t], contact.friction[t], a, b, ready.pushed);
  }
  if constexpr (N == 3) turn_both(rows.twist, contact.friction[2], a, b, ready.pushed);
}

/// Adds `change` to the impulse `total`, which stays in [0, its range].
template <Scalar S, class Impulse = typename Formats<S>::Impulse>
[[nodiscard]] constexpr Impulse push_more(Impulse& total, const Impulse& change) noexcept {
  const auto before = total;
  total = saturate_to<Impulse>(total + change);
  if (total < 0) total = Impulse{};
  return narrow<31>(total - before);  // both are in [0, 2^31)
}

enum class Pass : std::uint8_t { biased, relaxed };

/// The index of the k-th point that a pass solves in the contacts of a substep.
///
/// The order rotates from pass to pass. The points of a contact disturb each other, so in a fixed
/// order the same corners of boxes would always carry more and tip stacks: the top of 20 boxes
/// would drift by 0.02 instead of 0.0001.                       (tests/dynamics/hold.test.cpp)
template <Pass P, std::size_t Capacity>
[[nodiscard]] constexpr std::size_t nth_point(std::size_t k, std::size_t substep) noexcept {
  return (k + substep + (P == Pass::relaxed ? Capacity / 2 : 0)) % Capacity;
}

/// Pushes the bodies apart at each point of a contact, one after another. Bodies move between a
/// biased pass and the following relaxed one, so relaxed passes compute gaps, and each biased pass
/// uses those of the previous pass, at first those at the start of the tick.
///
/// m t <= 2^60 and loss * total <= 2^57 steps: their difference fits 62 bits.
template <Pass P, Scalar S, int N>
constexpr void solve_pressure(ReadyContact<S, N>& ready, const ContactRows<S, N>& rows,
                              BodyContact<S, N>& contact, Moving<S, N>& a, Moving<S, N>& b,
                              const typename Formats<S>::Speed& fastest,
                              std::size_t substep) noexcept {
  using F = Formats<S>;
  using Speed = typename F::Speed;
  using Impulse = typename F::Impulse;
  constexpr auto capacity = ReadyContact<S, N>::capacity;
  const auto& soft = ready.is_wall ? wall_softness<S> : contact_softness<S>;
  for (std::size_t k = 0; k < capacity; ++k) {
    const auto i = nth_point<P, capacity>(k, substep);
    if (i >= ready.count) continue;
    const auto& row = rows.pressure[i];
    auto& total = contact.pressure[i];
    const auto rate =
        rate_along<S, N>(rows.normal.along, row, a.velocity, a.spin, b.velocity, b.spin);
    if constexpr (P == Pass::relaxed) {
      ready.gap_now[i] =
          rate_along<S, N>(rows.normal.along, row, a.shift, a.turn, b.shift, b.turn, ready.gap[i]);
    }
    const auto gap = ready.gap_now[i];
    Impulse change;
    if (gap > 0) {
      change = nearest_to<Impulse>(narrow_negative(narrow<62>(row.mass * (rate + gap))));
    } else if constexpr (P == Pass::biased) {
      auto pull = soft.pull * gap;
      const auto limit = decltype(pull)(narrow_negative(fastest));
      if (pull < limit) pull = limit;
      const auto wanted = nearest_to<Speed>(narrow<62>(soft.rigid * rate + pull));
      change = nearest_to<Impulse>(narrow_negative(
          narrow<62>(narrow<62>(row.mass * wanted) + narrow<62>(soft.loss * total))));
    } else {
      change = nearest_to<Impulse>(narrow_negative(narrow<62>(row.mass * rate)));
    }
    apply(rows.normal, row, push_more<S>(total, change), a, b, ready.pushed);
    ready.was_pushed[i] = ready.was_pushed[i] || total > 0;
  }
}

/// The gap of each point, with the motion of the bodies since they were held.
template <Scalar S, int N>
constexpr void measure_gaps(ReadyContact<S, N>& ready, const ContactRows<S, N>& rows,
                            const Moving<S, N>& a, const Moving<S, N>& b) noexcept {
  for (std::size_t i = 0; i < ready.count; ++i) {
    ready.gap_now[i] = rate_along<S, N>(rows.normal.along, rows.pressure[i], a.shift, a.turn,
                                        b.shift, b.turn, ready.gap[i]);
  }
}

/// The impulses of friction along one or two tangents, clamped to the disc of radius `limit`.
///
/// In 3D a vector outside is scaled by limit / length, both exact until the quotient is rounded to
/// nearest; the length is rounded up to the grid.
template <Scalar S, int N, class Impulse = typename Formats<S>::Impulse>
constexpr void clamp_to_disc(std::array<Impulse, std::size_t{N - 1}>& impulse,
                             const Impulse& limit) noexcept {
  if constexpr (N == 2) {
    impulse[0] = (std::clamp)(impulse[0], narrow_negative(limit), limit);
  } else {
    const auto squared = square(impulse[0]) + square(impulse[1]);
    if (squared <= square(limit)) return;
    const auto length = sqrt_ceil<typename Formats<S>::Length>(squared);
    for (auto& x : impulse) x = quotient_nearest<Impulse>(x * limit, length);
  }
}

/// Friction at the middle of a contact, in 3D also against twisting about its normal.
template <Scalar S, int N>
constexpr void solve_friction(const ReadyContact<S, N>& ready, const ContactRows<S, N>& rows,
                              BodyContact<S, N>& contact, Moving<S, N>& a,
                              Moving<S, N>& b) noexcept {
  using F = Formats<S>;
  using Impulse = typename F::Impulse;
  constexpr std::size_t tangents = N - 1;
  const auto wanted = [&](const Vec<typename F::Ratio, N>& along, const Row<S, N>& row,
                          const Impulse& total) {
    const auto rate = rate_along<S, N>(along, row, a.velocity, a.spin, b.velocity, b.spin);
    return saturate_to<Impulse>(total - nearest_to<Impulse>(narrow<62>(row.mass * rate)));
  };
  const auto change = [](const Impulse& to, const Impulse& from) {
    return saturate_to<Impulse>(to - from);
  };
  const auto limit_of = [&](const auto& pressure) {
    return nearest_to<Impulse>(narrow<62>(ready.grip * saturate_to<Impulse>(pressure)));
  };
  auto pressure = narrow<34>(Impulse() + Impulse());
  for (std::size_t i = 0; i < ready.count; ++i) {
    pressure = narrow<34>(pressure + contact.pressure[i]);
  }

  if constexpr (N == 3) {
    auto at_lever = narrow<34>(Impulse() + Impulse());
    for (std::size_t i = 0; i < ready.count; ++i) {
      at_lever = narrow<34>(at_lever +
                            nearest_to<Impulse>(narrow<62>(rows.reach[i] * contact.pressure[i])));
    }
    const auto limit = limit_of(at_lever);
    const auto spinning = turning_along<S, N>(rows.twist, a.spin, b.spin);
    auto twist = saturate_to<Impulse>(contact.friction[2] -
                                      nearest_to<Impulse>(narrow<62>(rows.twist.mass * spinning)));
    twist = (std::clamp)(twist, narrow_negative(limit), limit);
    turn_both(rows.twist, change(twist, contact.friction[2]), a, b, ready.pushed);
    contact.friction[2] = twist;
  }

  std::array<Impulse, tangents> impulse{};
  for (std::size_t t = 0; t < tangents; ++t) {
    impulse[t] = wanted(rows.tangent[t].along, rows.friction[t], contact.friction[t]);
  }
  clamp_to_disc<S, N>(impulse, limit_of(pressure));
  for (std::size_t t = 0; t < tangents; ++t) {
    apply(rows.tangent[t], rows.friction[t], change(impulse[t], contact.friction[t]), a, b,
          ready.pushed);
    contact.friction[t] = impulse[t];
  }
}

/// Bounces bodies that met faster than `threshold`.
template <Scalar S, int N>
constexpr void bounce(const ReadyContact<S, N>& ready, const ContactRows<S, N>& rows,
                      BodyContact<S, N>& contact, Moving<S, N>& a, Moving<S, N>& b,
                      const typename Formats<S>::Speed& threshold) noexcept {
  using F = Formats<S>;
  using Speed = typename F::Speed;
  using Impulse = typename F::Impulse;
  if (ready.bounce == 0) return;
  for (std::size_t i = 0; i < ready.count; ++i) {
    if (!ready.was_pushed[i] || rows.closing[i] >= narrow_negative(threshold)) continue;
    const auto& row = rows.pressure[i];
    const auto rate =
        rate_along<S, N>(rows.normal.along, row, a.velocity, a.spin, b.velocity, b.spin);
    const auto wanted =
        saturate_to<Speed>(rate + nearest_to<Speed>(narrow<62>(ready.bounce * rows.closing[i])));
    const auto change = nearest_to<Impulse>(narrow_negative(narrow<62>(row.mass * wanted)));
    apply(rows.normal, row, push_more<S>(contact.pressure[i], change), a, b, ready.pushed);
  }
}

}  // namespace detent::detail
