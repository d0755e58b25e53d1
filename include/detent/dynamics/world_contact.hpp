// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "detent/dynamics/contact.hpp"
#include "detent/dynamics/hold.hpp"
#include "detent/dynamics/settings.hpp"

namespace detent {

/// A point at which two bodies touch.
template <Scalar S, int N>
struct WorldContactPoint {
  Vec<S, N> point;            // in the world, midway between the surfaces
  S separation{};             // negative where they overlap
  S impulse{};                // along the normal
  std::uint32_t feature = 0;  // identifies the corners, edges or faces that meet

  [[nodiscard]] friend constexpr bool operator==(const WorldContactPoint&,
                                                 const WorldContactPoint&) noexcept = default;
};

/// The contact of two bodies; for compounds that of two parts, for meshes and height fields that of
/// one triangle. The first `count` of `points` are set. Impulses act on b; a gets the opposite. They
/// are those of the last substep, in units of mass times units per second.
template <Scalar S, int N>
struct WorldContact {
  BodyId a, b;                           // in order of their indices
  std::uint32_t part_a = 0, part_b = 0;  // the number of the part; 0 for other bodies
  std::uint32_t triangle = 0;            // of a mesh or height field
  Direction<S, N> normal;                // from a to b
  S impulse{};                           // along the normal, of all points
  Vec<S, N> friction;                    // the impulse of friction, across the normal
  std::array<WorldContactPoint<S, N>, N == 2 ? 2 : 4> points{};
  std::size_t count = 0;

  [[nodiscard]] friend constexpr bool operator==(const WorldContact&,
                                                 const WorldContact&) noexcept = default;
};

namespace detail {

/// An impulse of the solver in units of mass times units per second: times the substeps per second
/// and over the sum of the inverse masses, rounded to nearest once and clamped.
template <Scalar S, class Body, Number T>
[[nodiscard]] constexpr S momentum_of(const Body& a, const Body& b, const T& impulse,
                                      int rate) noexcept {
  const auto change = impulse * as_operand<S>(rate);
  if (!b.can_move()) return saturate_to<S>(change * a.mass);
  if (!a.can_move()) return saturate_to<S>(change * b.mass);
  return quotient_nearest<S>(change * (a.mass * b.mass), a.mass + b.mass);
}

/// Writes normal, points and impulses. `at_a` is the pose at which a is held, `from_a_to_b` the
/// position of b relative to a when both are there.
template <Scalar S, int N, class Body>
constexpr void describe(WorldContact<S, N>& out, const Body& a, const Body& b,
                        const BodyContact<S, N>& contact, const Support<S, N>& at_a,
                        const Manifold<S, N>& manifold,
                        const Vec<typename Formats<S>::Lever, N>& from_a_to_b, int rate) noexcept {
  using F = Formats<S>;
  const auto to_world = [&](const auto& v, int k) {
    const auto row = make_vec<N>([&](int i) { return at_a.axes[static_cast<std::size_t>(i)][k]; });
    return narrow_dot<62>(row, v);
  };
  out.normal = direction_of<S>(make_vec<N>([&](int k) {
                 return to_world(manifold.normal, k);
               })).value_or(Direction<S, N>());
  const auto n = out_of_axes<S, N>(at_a.axes, manifold.normal);
  const auto along_turn = [&](const auto& arm, const Axial<typename F::Spin, N>& turn) {
    if constexpr (N == 2) {
      return cross(arm, n) * turn[0];
    } else {
      return dot(cross(arm, n), from_array(turn));
    }
  };
  out.count = static_cast<std::size_t>(manifold.count);
  const auto lean_a = lean_of(a), lean_b = lean_of(b);
  for (std::size_t i = 0; i < out.count; ++i) {
    const auto& from = manifold.points[i];
    const auto arm = out_of_axes<S, N>(at_a.axes, from.point);
    auto& point = out.points[i];
    point.point = make_vec<N>(
        [&](int k) { return saturate_to<S>(a.state.place[k] + to_world(from.point, k)); });
    point.separation =
        saturate_to<S>(from.separation + dot(n, b.drift - a.drift) +
                       (along_turn(arm - from_a_to_b, lean_b) - along_turn(arm, lean_a)));
    point.impulse = momentum_of<S>(a, b, contact.pressure[i], rate);
    point.feature = from.feature;
  }
  auto pressure = narrow<34>(typename F::Impulse() + typename F::Impulse());
  for (std::size_t i = 0; i < contact.count; ++i)
    pressure = narrow<34>(pressure + contact.pressure[i]);
  out.impulse = momentum_of<S>(a, b, pressure, rate);
  const auto across = tangents<S, N>(n);
  out.friction = make_vec<N>([&](int k) {
    if constexpr (N == 2) {
      return momentum_of<S>(a, b, across[0][k] * contact.friction[0], rate);
    } else {
      return momentum_of<S>(
          a, b, across[0][k] * contact.friction[0] + across[1][k] * contact.friction[1], rate);
    }
  });
}

}  // namespace detail

}  // namespace detent
