// SPDX-License-Identifier: MIT
#pragma once

#include "detent/dynamics/manifold.hpp"
#include "detent/number/min_max.hpp"
#include "detent/number/rounding.hpp"
#include "detent/number/unit.hpp"

namespace detent::detail {

/// The number types inside a manifold's computation; docs/contacts_of_bodies.md says where each is
/// rounded.
template <Scalar S>
struct ContactFormats {
  using Ratio = S;
  using Lever = S;
  using Gap = S;
  using Foot = S;
  using Length = S;
  using Corner = S;
  using Span = S;
  static constexpr S tolerance = S(1) / 2048;
};
template <int Bits, int Frac>
struct ContactFormats<Fixed<Bits, Frac>> {
  using Ratio = typename Formats<Fixed<Bits, Frac>>::Ratio;
  using Lever = typename Formats<Fixed<Bits, Frac>>::Lever;
  using Gap = typename Formats<Fixed<Bits, Frac>>::Gap;
  /// A point inside a segment: a lever on a grid 2^8 times finer.
  using Foot = Fixed<39, Frac + 14>;
  /// A distance of two such points.
  using Length = Fixed<41, Frac + 6>;
  /// A corner of one box in the frame of the other: at most (1 + sqrt(3)) 2^31 steps of a lever.
  using Corner = Fixed<33, Frac + 6>;
  /// An exact sum of products of levers and ratios. It fits 64 bits: see `FaceAxes`.
  using Span = Fixed<63, Frac + 36>;
  /// How much better an axis of a later class must be: 2^-11 units of q16_16.
  static constexpr Gap tolerance = Gap::assume_raw(1 << 11);
};

/// A manifold of one point; none if the separation exceeds the margin.
template <Scalar S, int N>
[[nodiscard]] constexpr Manifold<S, N> one_point(const Vec<typename Formats<S>::Ratio, N>& normal,
                                                 const Vec<typename Formats<S>::Lever, N>& p,
                                                 const typename Formats<S>::Gap& separation,
                                                 std::uint32_t feature,
                                                 const typename Formats<S>::Gap& margin) noexcept {
  Manifold<S, N> result;
  if (separation > margin) return result;
  result.normal = normal;
  result.points[0] = {p, separation, feature};
  result.count = 1;
  return result;
}

/// Any positive number, exactly.
template <Number T>
[[nodiscard]] constexpr T positive() noexcept {
  if constexpr (is_fixed<T>) {
    return T::assume_raw(1);
  } else {
    return T(1);
  }
}

/// 1 / n for a power of 2.
template <Number Ratio>
[[nodiscard]] constexpr Ratio one_over(int n) noexcept {
  return quotient_nearest<Ratio>(Ratio(1), as_operand<Ratio>(n));
}

/// sqrt(x) rounded to nearest on the grid of T: the root of 4 x, which is never halfway.
template <class T, Number X>
[[nodiscard]] constexpr T sqrt_nearest(const X& x) noexcept {
  if constexpr (!is_fixed<X>) {
    return sqrt_floor<T>(x);
  } else {
    using Half = Fixed<T::bits + 2, T::frac + 1>;
    return ceil_to<T>(narrow<T::bits + 2>(sqrt_floor<Half>(x)));
  }
}

/// Axis `i` of the frame.
template <Number T, int N>
[[nodiscard]] constexpr Vec<T, N> unit_axis(int i, bool negative = false) noexcept {
  Vec<T, N> result{};
  result[i] = negative ? T(-1) : T(1);
  return result;
}

/// The direction of `v`, each component rounded to nearest; the x axis if `v` is 0.
template <class Ratio, Number T, int N>
[[nodiscard]] constexpr Vec<Ratio, N> unit_or_x(const Vec<T, N>& v) noexcept {
  const auto unit = unit_vector<Ratio>(to_array(v));
  return unit ? from_array(*unit) : unit_axis<Ratio, N>(0);
}

}  // namespace detent::detail
