// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "detent/dynamics/contact.hpp"

// Rolling resistance: a torque between two bodies that opposes the rotation of one relative to the
// other, at most the resistance times the radius times the pressure of their contact. It stops
// balls and capsules, which friction lets roll and spin for ever.

namespace detent::detail {

/// The radius of a ball or capsule, on which it rolls.
template <Scalar S, int N, class Shape>
[[nodiscard]] constexpr std::optional<S> rolling_radius(const Shape& shape) noexcept {
  if constexpr (Round<Shape>) {
    return shape.radius;
  } else {
    return std::nullopt;
  }
}

/// How a contact resists rolling; it does not unless both are positive.
template <Scalar S>
struct RollingLimit {
  S resistance{}, radius{};

  [[nodiscard]] constexpr bool is_any() const noexcept { return resistance > 0 && radius > 0; }
};

/// The greater resistance of two bodies or parts, and the radius of the round one, or the lesser
/// radius of two.
template <Scalar S, int N, class Shape, class Contact>
[[nodiscard]] constexpr RollingLimit<S> rolling_limit(const BodyRecord<S, N, Shape>& a,
                                                      const BodyRecord<S, N, Shape>& b,
                                                      const Contact& contact) noexcept {
  const auto* parts_of_a = compound_of<S, N>(a.shape);
  const auto* parts_of_b = compound_of<S, N>(b.shape);
  RollingLimit<S> limit;
  std::optional<S> radius;
  const auto take = [&](const auto& shape, const S& resistance) {
    limit.resistance = (max)(limit.resistance, resistance);
    shape.visit([&](const auto& solid) {
      const auto own = rolling_radius<S, N>(solid);
      if (own && (!radius || *own < *radius)) radius = own;
    });
  };
  const auto take_body = [&](const auto& body, const auto* parts, std::uint32_t number) {
    if (parts == nullptr) {
      take(body.shape, body.rolling_resistance);
    } else {
      const auto& part = parts->parts()[number];
      take(part.shape(), part.options().rolling_resistance);
    }
  };
  take_body(a, parts_of_a, contact.member);
  take_body(b, parts_of_b, parts_of_a == nullptr ? contact.member : contact.part);
  limit.radius = radius.value_or(S(0));
  return limit;
}

/// Whether a body, or one of its parts, resists rolling.
template <Scalar S, int N, class Shape>
[[nodiscard]] constexpr bool resists_rolling(const BodyRecord<S, N, Shape>& body) noexcept {
  const auto* compound = compound_of<S, N>(body.shape);
  return compound == nullptr ? body.rolling_resistance > 0 : compound->resists_rolling();
}

/// Whether a contact resists rolling, so that its rolling impulses are state.
template <Scalar S, int N, class Shape, class Contact>
[[nodiscard]] constexpr bool resists_rolling(const BodyRecord<S, N, Shape>& a,
                                             const BodyRecord<S, N, Shape>& b,
                                             const Contact& contact) noexcept {
  return (resists_rolling(a) || resists_rolling(b)) && rolling_limit<S, N>(a, b, contact).is_any();
}

/// A contact that resists rolling, ready to be solved: a row for each axis of the world, all with
/// the same lever and mass.
template <Scalar S, int N>
struct Rolling {
  using F = Formats<S>;

  typename F::Arm radius{};
  Spread<typename F::Response, N> on_a{}, on_b{};  // change of spin by an impulse of 1 at the lever
  typename F::Ratio mass{};                        // effective, in (0, 1]
  typename F::Ratio resistance{};
};

/// The rows of a contact whose bodies have these inverse squared gyrations, times their shares.
///
/// The greatest sum of magnitudes of a row of a symmetric matrix is at least its greatest
/// eigenvalue, and equal to it for balls: so one mass for all axes never removes more spin than
/// there is.
template <Scalar S, int N>
[[nodiscard]] constexpr Rolling<S, N> prepare_rolling(
    const RollingLimit<S>& limit, const Spread<typename Formats<S>::Gyration, N>& spread_a,
    const Spread<typename Formats<S>::Gyration, N>& spread_b) noexcept {
  using F = Formats<S>;
  using Ratio = typename F::Ratio;
  constexpr int turns = N == 2 ? 1 : 3;
  Rolling<S, N> rolling;
  rolling.radius = saturate_to<typename F::Arm>(limit.radius);
  rolling.resistance = saturate_to<Ratio>(limit.resistance);
  const auto give_of = [&](const auto& spread, auto& on) {
    for (std::size_t i = 0; i < on.size(); ++i) {
      on[i] = saturate_to<typename F::Response>(spread[i] * rolling.radius);
    }
    auto greatest = narrow<34>(typename F::Response() + typename F::Response());
    for (int i = 0; i < turns; ++i) {
      auto sum = narrow<34>(abs(on[entry<N>(i, 0)]) + typename F::Response());
      for (int j = 1; j < turns; ++j) sum = narrow<34>(sum + abs(on[entry<N>(i, j)]));
      greatest = (max)(greatest, sum);
    }
    return saturate_to<typename F::Give>(greatest * rolling.radius);
  };
  const auto give_a = give_of(spread_a, rolling.on_a), give_b = give_of(spread_b, rolling.on_b);
  rolling.mass = quotient_nearest<Ratio>(Ratio(1), Ratio(1) + (give_a + give_b));
  return rolling;
}

/// Turns b about axis k of the world by `impulse` at the lever, and a in the opposite direction.
template <Scalar S, int N>
constexpr void roll(const Rolling<S, N>& rolling, int k,
                    const typename Formats<S>::Impulse& impulse, Moving<S, N>& a, Moving<S, N>& b,
                    const Pushed& pushed) noexcept {
  using F = Formats<S>;
  constexpr int turns = N == 2 ? 1 : 3;
  if (impulse == 0) return;
  const auto column = [&](const auto& on) {
    Axial<typename F::Response, N> result{};
    for (int i = 0; i < turns; ++i) result[static_cast<std::size_t>(i)] = on[entry<N>(i, k)];
    return result;
  };
  if (pushed.a) {
    push_each<-1, turns, typename F::Spin>(column(rolling.on_a), impulse, a.spin);
  }
  if (pushed.b) push_each<1, turns, typename F::Spin>(column(rolling.on_b), impulse, b.spin);
}

/// Warm-starts a substep with the impulses of the last one.
template <Scalar S, int N>
constexpr void warm_start_rolling(const ReadyContact<S, N>& ready, const ContactRows<S, N>& rows,
                                  const RollingContact<S, N>& contact, Moving<S, N>& a,
                                  Moving<S, N>& b) noexcept {
  if (rows.rolling == nullptr) return;
  for (std::size_t k = 0; k < contact.rolling.size(); ++k) {
    roll(*rows.rolling, static_cast<int>(k), contact.rolling[k], a, b, ready.pushed);
  }
}

/// Slows the relative rotation of both bodies about all axes, within the limit of their contact.
template <Scalar S, int N>
constexpr void solve_rolling(const ReadyContact<S, N>& ready, const ContactRows<S, N>& rows,
                             RollingContact<S, N>& contact, Moving<S, N>& a,
                             Moving<S, N>& b) noexcept {
  using F = Formats<S>;
  using Impulse = typename F::Impulse;
  if (rows.rolling == nullptr) return;
  const auto& rolling = *rows.rolling;
  auto pressure = narrow<34>(Impulse() + Impulse());
  for (std::size_t i = 0; i < ready.count; ++i) {
    pressure = narrow<34>(pressure + contact.pressure[i]);
  }
  const auto limit =
      nearest_to<Impulse>(narrow<62>(rolling.resistance * saturate_to<Impulse>(pressure)));
  Axial<Impulse, N> impulse{};
  for (std::size_t k = 0; k < impulse.size(); ++k) {
    const auto rate = saturate_to<typename F::Speed>(rolling.radius * (b.spin[k] - a.spin[k]));
    impulse[k] = saturate_to<Impulse>(contact.rolling[k] -
                                      nearest_to<Impulse>(narrow<62>(rolling.mass * rate)));
  }
  if constexpr (N == 2) {
    impulse[0] = (std::clamp)(impulse[0], narrow_negative(limit), limit);
  } else {
    const auto squared = square(impulse[0]) + square(impulse[1]) + square(impulse[2]);
    if (squared > square(limit)) {
      const auto length = sqrt_ceil<typename F::Length>(squared);
      for (auto& x : impulse) x = quotient_nearest<Impulse>(x * limit, length);
    }
  }
  for (std::size_t k = 0; k < impulse.size(); ++k) {
    roll(rolling, static_cast<int>(k), saturate_to<Impulse>(impulse[k] - contact.rolling[k]), a, b,
         ready.pushed);
  }
  contact.rolling = impulse;
}

}  // namespace detent::detail
