// SPDX-License-Identifier: MIT
#pragma once

#include "detent/dynamics/body.hpp"

namespace detent::detail {

/// How a body resists turning.
template <Scalar S, int N>
struct Inertia {
  using F = Formats<S>;

  Spread<typename F::Gyration, N> inverse{};  // of the squared gyration, in the body's frame
  Spread<typename F::Ratio, N> share{};  // the squared gyration over its greatest diagonal entry
  Spread<typename F::Stretch, N> inverse_share{};
  bool is_round = true;  // it turns alike about every axis: no torque, no change of spin
};

/// The matrix `m` of a body's frame in the world: R m R^T, rounded after either product.
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
        return nearest_to<T>(dot(row, make_vec<3>([&](int i) { return m[entry<3>(i, c)]; })));
      });
    }
    const auto product = [&](int r, int c) {
      return nearest_to<T>(dot(half_way[static_cast<std::size_t>(r)], make_vec<3>([&](int i) {
                                 return axes[static_cast<std::size_t>(i)][c];
                               })));
    };
    return {product(0, 0), product(1, 1), product(2, 2),
            product(1, 2), product(2, 0), product(0, 1)};
  }
}

/// The spin with which the body keeps its angular momentum while its axes turn from `from` to `to`.
///
/// Every product is rounded to a step of 2^-44, the result once more.
template <Scalar S>
[[nodiscard]] constexpr Axial<typename Formats<S>::Spin, 3> carried(
    const Axial<typename Formats<S>::Spin, 3>& spin, const Axes<S, 3>& from, const Axes<S, 3>& to,
    const Inertia<S, 3>& inertia) noexcept {
  using FineSpin = typename Formats<S>::FineSpin;
  const auto into = [](const Axes<S, 3>& axes, const auto& v) {
    return make_vec<3>(
        [&](int i) { return nearest_to<FineSpin>(dot(axes[static_cast<std::size_t>(i)], v)); });
  };
  const auto out_of = [](const Axes<S, 3>& axes, const auto& v, int k) {
    return dot(Vec{axes[0][k], axes[1][k], axes[2][k]}, v);
  };
  const auto times = [](const auto& matrix, const auto& v) {
    return make_vec<3>([&](int i) {
      return nearest_to<FineSpin>(
          dot(make_vec<3>([&](int j) { return matrix[entry<3>(i, j)]; }), v));
    });
  };
  const auto momentum = times(inertia.share, into(from, from_array(spin)));
  const auto in_space =
      make_vec<3>([&](int k) { return nearest_to<FineSpin>(out_of(from, momentum, k)); });
  const auto turning = times(inertia.inverse_share, into(to, in_space));
  Axial<typename Formats<S>::Spin, 3> result;
  for (int k = 0; k < 3; ++k) {
    result[static_cast<std::size_t>(k)] =
        saturate_to<typename Formats<S>::Spin>(out_of(to, turning, k));
  }
  return result;
}

}  // namespace detent::detail
