// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include "detent/dynamics/axial.hpp"
#include "detent/dynamics/manifold.hpp"
#include "detent/math/rotation.hpp"

namespace detent::detail {

/// The pose and motion of a body: the state of a match.
template <Scalar S, int N>
struct BodyState {
  using F = Formats<S>;
  static constexpr int orientation_size = N == 2 ? 2 : 4;

  Vec<typename F::Place, N> place{};                       // of the center of mass
  Vec<typename F::Ratio, orientation_size> orientation{};  // cosine, sine; quaternion x y z w
  Vec<typename F::Speed, N> velocity{};                    // per substep
  Axial<typename F::Spin, N> spin{};                       // per substep, about the world's axes

  [[nodiscard]] friend constexpr bool operator==(const BodyState&,
                                                 const BodyState&) noexcept = default;
};

/// The axes of a body's frame in the world, components rounded to nearest once.
template <Scalar S, int N>
using Axes = std::array<Vec<typename Formats<S>::Ratio, N>, std::size_t{N}>;

/// n / d, rounded to nearest, for |n| <= 1 and a d near 1, both in steps of 2^-60.
///
/// With d = 1 + e and |e| < 2^-28 the quotient is n - n e + n e^2 - ... The third term is less than
/// 2^-56, and rounding n down to 2^-30 changes n e by less than 2^-58. The error of the first two
/// terms is therefore below 2^-55; a division is needed only if that may change the rounding.
template <class Ratio, class T>
[[nodiscard]] constexpr Ratio quotient_of_near_one(const T& n, const T& d) noexcept {
  if constexpr (is_fixed<Ratio>) {
    static_assert(T::bits == 62 && T::frac == 60 && Ratio::frac == 30);
    using Raw = typename T::raw_type;
    constexpr Raw one = Raw(1) << 60, half = Raw(1) << 29, doubt = Raw(1) << 5;
    const Raw e = d.raw() - one;
    if (-(Raw(1) << 32) < e && e < Raw(1) << 32) {
      const Raw x = n.raw() - ((n.raw() >> 30) * e >> 30);
      const Raw raised = x + half, left = raised & (2 * half - 1);
      if (doubt <= left && left <= 2 * half - doubt) {
        return Ratio::assume_raw(static_cast<typename Ratio::raw_type>(raised >> 30));
      }
    }
  }
  return quotient_nearest<Ratio>(n, d);
}

/// The axes of an orientation. Those of a quaternion are its quadratic forms divided by its squared
/// length.
template <Scalar S, int N>
[[nodiscard]] constexpr Axes<S, N> axes_of(
    const Vec<typename Formats<S>::Ratio, BodyState<S, N>::orientation_size>& q) noexcept {
  if constexpr (N == 2) {
    return {q, Vec<typename Formats<S>::Ratio, 2>{narrow_negative(q.y), q.x}};
  } else {
    constexpr int bits = 62;  // components are at most 1
    const auto exact = quaternion_columns<bits>(q);
    const auto norm = narrow_dot<bits>(q, q);
    Axes<S, N> axes;
    for (std::size_t i = 0; i < 3; ++i) {
      axes[i] = make_vec<3>([&](int k) {
        return quotient_of_near_one<typename Formats<S>::Ratio>(exact[i][k], norm);
      });
    }
    return axes;
  }
}

/// The orientation after a turn by `angle` (in radians; in 3D a rotation vector in the world) times
/// 2^-halvings: q + angle q, of unit length again, each component rounded to nearest once.
///
/// The length before normalising is at least 1, so there is a direction. (1 + 7) 2^59 fits 62 bits.
template <Scalar S, int N, int Halvings = 0>
[[nodiscard]] constexpr auto turned(
    const Vec<typename Formats<S>::Ratio, BodyState<S, N>::orientation_size>& q,
    const Axial<typename Formats<S>::Spin, N>& angle) noexcept {
  using Ratio = typename Formats<S>::Ratio;
  const auto halved = [](const auto& x) {
    if constexpr (N == 2) {
      return x;
    } else if constexpr (Halvings == 0) {
      return half(x);  // a quaternion turns by twice its angle
    } else {
      return half(half(x));
    }
  };
  if constexpr (N == 2) {
    const auto a = halved(angle[0]);
    return from_array(
        unit_vector<Ratio>(to_array(Vec{narrow<62>(q.x - a * q.y), narrow<62>(q.y + a * q.x)}))
            .value_or(to_array(q)));
  } else {
    const auto x = halved(angle[0]), y = halved(angle[1]), z = halved(angle[2]);
    return from_array(
        unit_vector<Ratio>(to_array(Vec{narrow<62>(q.x + (x * q.w + y * q.z - z * q.y)),
                                        narrow<62>(q.y + (y * q.w + z * q.x - x * q.z)),
                                        narrow<62>(q.z + (z * q.w + x * q.y - y * q.x)),
                                        narrow<62>(q.w - (x * q.x + y * q.y + z * q.z))}))
            .value_or(to_array(q)));
  }
}

}  // namespace detent::detail
