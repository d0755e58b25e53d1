// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "detent/dynamics/manifold.hpp"
#include "detent/dynamics/record.hpp"
#include "detent/dynamics/row.hpp"

namespace detent::detail {

/// The state of a contact between ticks: the impulses that warm-start the next solve.
template <Scalar S, int N>
struct BodyContact {
  using Impulse = typename Formats<S>::Impulse;
  static constexpr std::size_t capacity = std::size_t{Manifold<S, N>::capacity};

  std::uint32_t a = 0, b = 0;  // indices of the bodies, a < b
  std::uint32_t part = 0;      // the triangle of terrain, or b's part if both are compounds; or 0
  std::uint8_t count = 0;
  bool touches = false;      // some point overlapped or was pushed in the last tick
  std::uint16_t member = 0;  // the part of the compound (of a, if both are compounds), or 0
  std::array<std::uint32_t, capacity> feature{};
  std::array<Impulse, capacity> pressure{};
  Axial<Impulse, N> friction{};  // along the tangents; in 3D the last is the twist

  [[nodiscard]] friend constexpr bool operator==(const BodyContact&,
                                                 const BodyContact&) noexcept = default;
};

/// The state of a contact in worlds with balls or capsules.
template <Scalar S, int N>
struct RollingContact : BodyContact<S, N> {
  Axial<typename Formats<S>::Impulse, N> rolling{};  // about the world's axes

  [[nodiscard]] friend constexpr bool operator==(const RollingContact&,
                                                 const RollingContact&) noexcept = default;
};

/// A soft constraint in units of the substep: the share of the velocity removed, the share of the
/// overlap added to it, and the share of the accumulated impulse given back.
template <Scalar S>
struct Softness {
  typename Formats<S>::Ratio rigid{}, pull{}, loss{};
};

template <Scalar S>
[[nodiscard]] constexpr Softness<S> softness(int rigid, int pull) noexcept {
  return {dyadic<S>(rigid), dyadic<S>(pull), dyadic<S>((1 << 30) - rigid)};
}

/// A spring of w h = 0.9 and damping ratio 10: rigid = w h (20 + w h) / (1 + w h (20 + w h)),
/// pull = rigid w h / (20 + w h), rounded to 2^-30.
template <Scalar S>
inline constexpr Softness<S> contact_softness = softness<S>(1019539814, 43903628);
/// The spring of `contact_softness` with w h = 1.8, for contacts with a body that cannot be pushed.
template <Scalar S>
inline constexpr Softness<S> wall_softness = softness<S>(1047058379, 86454362);

/// The solver's data about a body besides its motion.
template <Scalar S, int N>
struct Support {
  using F = Formats<S>;

  Axes<S, N> axes{};
  Vec<typename F::Place, N> place{};
  Spread<typename F::Gyration, N> spread{};  // inverse squared gyration in the world
  bool is_fixed = true;                      // never moves or turns
  std::uint8_t locked = 0;                   // of a body that can move
};

template <Scalar S, int N>
struct Rolling;

/// A contact, ready to be solved. Impulses are in its `BodyContact`, rows in its `ContactRows` or
/// its group.
template <Scalar S, int N>
struct ReadyContact {
  using F = Formats<S>;
  static constexpr std::size_t capacity = BodyContact<S, N>::capacity;

  std::uint32_t contact = 0;  // index in the list of contacts
  std::uint32_t a = 0, b = 0;
  std::uint8_t count = 0;
  bool is_wall = false;  // one of the bodies cannot be pushed
  Pushed pushed{};
  std::array<bool, capacity> was_pushed{};
  typename F::Ratio grip{}, bounce{};
  std::array<typename F::Speed, capacity> gap{};      // at the start of the tick
  std::array<typename F::Speed, capacity> gap_now{};  // after the last move
};

/// The rows of a contact that is solved alone.
template <Scalar S, int N>
struct ContactRows {
  using F = Formats<S>;
  static constexpr std::size_t capacity = ReadyContact<S, N>::capacity;

  const Rolling<S, N>* rolling = nullptr;  // if it resists rolling
  Thrust<S, N> normal{};
  std::array<Thrust<S, N>, std::size_t{N - 1}> tangent{};
  std::array<Row<S, N>, capacity> pressure{};
  std::array<Row<S, N>, std::size_t{N - 1}> friction{};
  Row<S, N> twist{};
  std::array<typename F::Ratio, capacity> reach{};    // distance from the middle over the greatest
  std::array<typename F::Speed, capacity> closing{};  // rate at the start of the tick
};

/// The impulses of a and b along `n`: shares of the whole, rounded once.
template <Scalar S, int N>
[[nodiscard]] constexpr Thrust<S, N> push_along(
    const Vec<typename Formats<S>::Ratio, N>& n, const typename Formats<S>::Ratio& share_a,
    const typename Formats<S>::Ratio& share_b) noexcept {
  using Ratio = typename Formats<S>::Ratio;
  return {n, make_vec<N>([&](int i) { return nearest_to<Ratio>(share_a * n[i]); }),
          make_vec<N>([&](int i) { return nearest_to<Ratio>(share_b * n[i]); })};
}

/// Removes the locked axes from a push. Returns the part of the motion along it that is lost,
/// rounded once per body.
template <Scalar S, int N>
[[nodiscard]] constexpr typename Formats<S>::Give lock(Thrust<S, N>& push, std::uint8_t locked_a,
                                                       std::uint8_t locked_b) noexcept {
  using Give = typename Formats<S>::Give;
  const auto part = [&](Vec<typename Formats<S>::Ratio, N>& on, std::uint8_t locked) {
    auto lost = Vec<typename Formats<S>::Ratio, N>();
    for (int i = 0; i < N; ++i) {
      if (is_locked(locked, i)) std::swap(lost[i], on[i]);
    }
    return nearest_to<Give>(narrow_dot<62>(lost, push.along));
  };
  if (locked_a == 0 && locked_b == 0) return {};
  return nearest_to<Give>(part(push.on_a, locked_a) + part(push.on_b, locked_b));
}

/// Unit vectors across `n`: in 2D (n.y, -n.x); in 3D n x e for the axis e with the least |n . e|,
/// the first of equals, of unit length, and n x that; components rounded to nearest.
template <Scalar S, int N, class Ratio = typename Formats<S>::Ratio>
[[nodiscard]] constexpr auto tangents(const Vec<Ratio, N>& n) noexcept {
  if constexpr (N == 2) {
    return std::array<Vec<Ratio, 2>, 1>{Vec<Ratio, 2>{n.y, narrow_negative(n.x)}};
  } else {
    int least = 0;
    for (int i = 1; i < 3; ++i) {
      if (narrow_abs(n[i]) < narrow_abs(n[least])) least = i;
    }
    const int j = (least + 1) % 3, k = (least + 2) % 3;
    const std::array<Ratio, 2> across{n[k], narrow_negative(n[j])};  // n x e, without its zero
    const auto unit = unit_vector<Ratio>(across).value_or(across);
    Vec<Ratio, 3> first;
    first[j] = unit[0];
    first[k] = unit[1];
    return std::array<Vec<Ratio, 3>, 2>{first, nearest_to<Ratio>(narrow_cross<62>(n, first))};
  }
}

/// The inverse squared gyration of a body times its share of the inverse masses.
template <Scalar S, int N, class Gyration = typename Formats<S>::Gyration>
[[nodiscard]] constexpr Spread<Gyration, N> share_of(
    Spread<Gyration, N> spread, const typename Formats<S>::Ratio& share) noexcept {
  for (auto& x : spread) x = nearest_to<Gyration>(x * share);
  return spread;
}

/// `v` of a body's frame along the world's axes, each component rounded to nearest.
template <Scalar S, int N, Number T>
[[nodiscard]] constexpr Vec<T, N> out_of_axes(const Axes<S, N>& axes, const Vec<T, N>& v) noexcept {
  return make_vec<N>([&](int k) {
    const auto row = make_vec<N>([&](int i) { return axes[static_cast<std::size_t>(i)][k]; });
    return nearest_to<T>(narrow_dot<62>(row, v));  // |row| |v| < 2^30 2^31 sqrt(3)
  });
}

/// The contact of two bodies, from their manifold in the frame of a.
///
/// `offset` is the position of b relative to a, as in the relative pose.
template <Scalar S, int N>
constexpr void prepare(ReadyContact<S, N>& ready, ContactRows<S, N>& rows,
                       const Manifold<S, N>& manifold, const Support<S, N>& a,
                       const Support<S, N>& b, const Vec<typename Formats<S>::Lever, N>& offset,
                       const typename Formats<S>::Ratio& share_a,
                       const typename Formats<S>::Ratio& share_b) noexcept {
  using F = Formats<S>;
  using Arm = typename F::Arm;
  using Lever = typename F::Lever;
  using Ratio = typename F::Ratio;
  const auto spread_a = share_of<S, N>(a.spread, share_a);
  const auto spread_b = share_of<S, N>(b.spread, share_b);
  ready.count = static_cast<std::uint8_t>(manifold.count);
  ready.is_wall = share_a == 0 || share_b == 0;
  ready.pushed = {share_a != 0, share_b != 0};
  const auto n = out_of_axes<S, N>(a.axes, manifold.normal);
  rows.rolling = nullptr;
  rows.normal = push_along<S, N>(n, share_a, share_b);
  const auto stuck = lock<S, N>(rows.normal, a.locked, b.locked);

  const auto row_at = [&](const Vec<Arm, N>& from_a, const Vec<Arm, N>& from_b,
                          const Vec<Ratio, N>& along, const typename F::Give& lost) {
    Row<S, N> row;
    if (!a.is_fixed) row.moment_a = moment<S, N>(from_a, along);
    if (!b.is_fixed) row.moment_b = moment<S, N>(from_b, along);
    complete<S, N>(row, spread_a, spread_b, lost);
    return row;
  };
  const auto count = static_cast<std::size_t>(manifold.count);
  std::array<Vec<Lever, N>, ReadyContact<S, N>::capacity> at{};  // from the center of a
  for (std::size_t i = 0; i < count; ++i) {
    const auto& point = manifold.points[i];
    at[i] = out_of_axes<S, N>(a.axes, point.point);
    rows.pressure[i] = row_at(nearest_to<Arm>(at[i]), nearest_to<Arm>(at[i] - offset), n, stuck);
    ready.gap[i] = ready.gap_now[i] = saturate_to<typename F::Speed>(point.separation);
  }

  // Friction acts at the mean of the points.
  const auto middle = make_vec<N>([&](int k) {
    auto sum = narrow<34>(at[0][k] + Lever());
    for (std::size_t i = 1; i < count; ++i) sum = narrow<34>(sum + at[i][k]);
    return quotient_nearest<Lever>(sum, as_operand<Lever>(manifold.count));
  });
  const auto across = tangents<S, N>(n);
  for (std::size_t t = 0; t < across.size(); ++t) {
    rows.tangent[t] = push_along<S, N>(across[t], share_a, share_b);
    const auto slip = lock<S, N>(rows.tangent[t], a.locked, b.locked);
    rows.friction[t] =
        row_at(nearest_to<Arm>(middle), nearest_to<Arm>(middle - offset), across[t], slip);
  }
  if constexpr (N == 3) {
    rows.twist = {};
    std::array<Arm, ReadyContact<S, N>::capacity> distance{};
    Arm farthest{};
    for (std::size_t i = 0; i < count; ++i) {
      distance[i] = sqrt_floor<Arm>(squared_length(at[i] - middle));
      farthest = (std::max)(farthest, distance[i]);
    }
    for (std::size_t i = 0; i < count; ++i) {
      rows.reach[i] = farthest == 0 ? Ratio{} : quotient_nearest<Ratio>(distance[i], farthest);
    }
    for (int i = 0; i < 3; ++i) {
      const auto lever = nearest_to<typename F::Moment>(farthest * n[i]);
      if (!a.is_fixed) rows.twist.moment_a[static_cast<std::size_t>(i)] = lever;
      if (!b.is_fixed) rows.twist.moment_b[static_cast<std::size_t>(i)] = lever;
    }
    complete<S, N>(rows.twist, spread_a, spread_b);
  }
}

}  // namespace detent::detail
