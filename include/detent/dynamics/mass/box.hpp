// SPDX-License-Identifier: MIT
#pragma once

#include "detent/dynamics/mass/properties.hpp"
#include "detent/shape/measure.hpp"

namespace detent::detail {

/// A box along the axes: N! times its volume, and gyrations (s_j^2 + s_k^2) / 12 for sides s.
template <Scalar S, int N>
[[nodiscard]] constexpr MassProperties<S, N> solid_properties(const Aabb<S, N>& box,
                                                              const S& density) noexcept {
  using Formats = MassFormats<S>;
  using Gyration = typename Formats::Gyration;
  if (is_empty(box)) return {};
  const auto side = box.max - box.min;
  const auto about = [&](int j, int k) {
    return quotient_nearest<Gyration>(square(side[j]) + square(side[k]), as_operand<S>(12));
  };
  const auto center = nearest_to<typename Formats::Center>(half(box.min + box.max));
  const auto content = size(box) * as_operand<S>(N == 2 ? 2 : 6);
  if constexpr (N == 2) {
    return properties_of<S, 2>(density, content, center, about(0, 1));
  } else {
    return properties_of<S, 3>(density, content, center,
                               Symmetric<Gyration>{{about(1, 2), about(2, 0), about(0, 1)}, {}});
  }
}

/// An oriented box, whose axes a are taken as orthonormal: the gyration is the sum of
/// (h_j^2 + h_k^2) / 3 a_i a_i^T for half extents h.
template <Scalar S, int N>
[[nodiscard]] constexpr MassProperties<S, N> solid_properties(const Obb<S, N>& box,
                                                              const S& density) noexcept {
  using Formats = MassFormats<S>;
  using Gyration = typename Formats::Gyration;
  if (is_empty(box)) return {};
  const auto& h = box.half_extents;
  const auto center = make_vec<N>([&](int i) { return typename Formats::Center(box.center[i]); });
  const auto content = size(box) * as_operand<S>(N == 2 ? 2 : 6);
  const auto thrice = as_operand<S>(3);
  if constexpr (N == 2) {
    const auto gyration = quotient_nearest<Gyration>(square(h[0]) + square(h[1]), thrice);
    return properties_of<S, 2>(density, content, center, gyration);
  } else {
    const auto entry = [&](int r, int c) {
      const auto term = [&](int i) {
        const auto about = square(h[(i + 1) % 3]) + square(h[(i + 2) % 3]);
        return about * (box.rotation.axis(i)[r] * box.rotation.axis(i)[c]);
      };
      return quotient_nearest<Gyration>(term(0) + term(1) + term(2), thrice);
    };
    return properties_of<S, 3>(density, content, center,
                               Symmetric<Gyration>{{entry(0, 0), entry(1, 1), entry(2, 2)},
                                                   {entry(1, 2), entry(0, 2), entry(0, 1)}});
  }
}

}  // namespace detent::detail
