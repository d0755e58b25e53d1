// SPDX-License-Identifier: MIT
#pragma once

#include "detent/dynamics/body.hpp"
#include "detent/dynamics/long_dot.hpp"

namespace detent::detail {

/// The inertia of a body.
template <Scalar S, int N>
struct Inertia {
  using F = Formats<S>;

  Spread<typename F::Gyration, N> inverse{};  // of the squared gyration, in the body's frame
  Spread<typename F::Ratio, N> share{};  // the squared gyration over its greatest diagonal entry
  Spread<typename F::Stretch, N> inverse_share{};
  bool is_round = true;  // the same about every axis: no gyroscopic torque

  /// Whether the frame's axes are the principal ones, so that all other entries are 0.
  [[nodiscard]] constexpr bool is_diagonal() const noexcept {
    if constexpr (N == 2) return true;
    return share[3] == 0 && share[4] == 0 && share[5] == 0 && inverse_share[3] == 0 &&
           inverse_share[4] == 0 && inverse_share[5] == 0;
  }
};

/// Transforms the matrix `m` from a body's frame to the world: R m R^T, rounded after each product.
template <Scalar S, int N, Number T>
[[nodiscard]] constexpr Spread<T, N> in_world(const Spread<T, N>& m,
                                              const Axes<S, N>& axes) noexcept {
  if constexpr (N == 2) {
    return m;
  } else {
    std::array<Vec<T, 3>, 3> half_way;  // row r: (R m)_r
    for (int r = 0; r < 3; ++r) {
      half_way[static_cast<std::size_t>(r)] = make_vec<3>([&](int c) {
        const auto row = make_vec<3>([&](int i) { return axes[static_cast<std::size_t>(i)][r]; });
        return nearest_dot<T>(row, make_vec<3>([&](int i) { return m[entry<3>(i, c)]; }));
      });
    }
    const auto product = [&](int r, int c) {
      const auto row = make_vec<3>([&](int i) { return axes[static_cast<std::size_t>(i)][c]; });
      return nearest_dot<T>(row, half_way[static_cast<std::size_t>(r)]);
    };
    return {product(0, 0), product(1, 1), product(2, 2),
            product(1, 2), product(2, 0), product(0, 1)};
  }
}

/// The spin that keeps a body's angular momentum while its axes turn from `from` to `to`.
///
/// Every product is rounded to steps of 2^-44, and the result once more.
template <Scalar S>
[[nodiscard]] constexpr Axial<typename Formats<S>::Spin, 3> carried(
    const Axial<typename Formats<S>::Spin, 3>& spin, const Axes<S, 3>& from, const Axes<S, 3>& to,
    const Inertia<S, 3>& inertia) noexcept {
  using FineSpin = typename Formats<S>::FineSpin;
  using Spin = typename Formats<S>::Spin;
  const auto along = [](const Axes<S, 3>& axes, int k) {
    return Vec{axes[0][k], axes[1][k], axes[2][k]};
  };
  const auto line_of = [](const auto& matrix, int i) {
    return make_vec<3>([&](int j) { return matrix[entry<3>(i, j)]; });
  };
  const bool is_diagonal = inertia.is_diagonal();
  const auto w = from_array(spin);
  const auto turning = make_vec<3>([&](int i) {
    return nearest_to<FineSpin>(narrow_dot<62>(from[static_cast<std::size_t>(i)], w));
  });
  const auto momentum = make_vec<3>([&](int i) {
    const auto k = static_cast<std::size_t>(i);
    if (is_diagonal) return nearest_to<FineSpin>(inertia.share[k] * turning[i]);
    return nearest_dot<FineSpin>(line_of(inertia.share, i), turning);
  });
  const auto in_space =
      make_vec<3>([&](int k) { return nearest_dot<FineSpin>(along(from, k), momentum); });
  const auto after = make_vec<3>(
      [&](int i) { return nearest_dot<FineSpin>(to[static_cast<std::size_t>(i)], in_space); });
  const auto turning_after = make_vec<3>([&](int i) {
    const auto k = static_cast<std::size_t>(i);
    if (is_diagonal) return nearest_to<FineSpin>(inertia.inverse_share[k] * after[i]);
    return nearest_to<FineSpin>(dot(line_of(inertia.inverse_share, i), after));
  });
  Axial<Spin, 3> result;
  for (int k = 0; k < 3; ++k) {
    result[static_cast<std::size_t>(k)] = nearest_dot<Spin>(along(to, k), turning_after);
  }
  return result;
}

}  // namespace detent::detail
