// SPDX-License-Identifier: MIT
#pragma once

#include "detent/dynamics/formats.hpp"
#include "detent/math/vec.hpp"

namespace detent {

/// A symmetric 3x3 matrix: the entries (i, i), and for each pair (j, k) one entry, at the index i
/// of the third axis.
template <Number T>
struct Symmetric {
  Vec<T, 3> diagonal;
  Vec<T, 3> mixed;

  /// The entry of row `i` and column `j`.
  [[nodiscard]] constexpr const T& at(int i, int j) const noexcept {
    return i == j ? diagonal[i] : mixed[3 - i - j];
  }
  [[nodiscard]] friend constexpr bool operator==(const Symmetric&,
                                                 const Symmetric&) noexcept = default;
};

/// Appends to a digest: the diagonal, then the entries (1, 2), (0, 2) and (0, 1).
template <class D, Number T>
constexpr void append(D& digest, const Symmetric<T>& matrix) noexcept {
  digest.add(matrix.diagonal, matrix.mixed);
}

namespace detail {

/// The formats of mass properties.
template <Scalar S>
struct MassFormats {
  using Mass = S;
  using Center = S;
  using Gyration = S;
  using InverseGyration = S;
  using Length = S;
};
template <int Bits, int Frac>
struct MassFormats<Fixed<Bits, Frac>> {
  using Mass = Fixed<63, 2 * Frac>;
  using Center = finer<Fixed<Bits, Frac>, 6>;
  using Gyration = Fixed<2 * Bits + 34, 2 * Frac + 30>;
  using InverseGyration = typename Formats<Fixed<Bits, Frac>>::Gyration;
  using Length = Fixed<Bits + 27, Frac + 24>;  // of a capsule's axis
};

template <Number T, int N>
struct tensor_of {
  using type = T;
};
template <Number T>
struct tensor_of<T, 3> {
  using type = Symmetric<T>;
};

/// An inertia about the center: a number in 2D, a symmetric matrix in 3D.
template <Number T, int N>
using Tensor = typename tensor_of<T, N>::type;

}  // namespace detail

/// The mass, center and inertia of a solid body.
///
/// units: mass in units of density times length^N; for `Fixed<Bits, Frac>` a multiple of
///        2^-(2 Frac). A mass of 0 cannot be dynamic; then all fields are 0
///        center of mass, in the frame of the shape; a multiple of 2^-(Frac + 6)
///        gyration: the inertia about the center divided by the mass, in square lengths; a multiple
///        of 2^-(2 Frac + 30)
///        inverse_gyration: the inverse of `gyration`; a multiple of 2^-(66 - 2 Frac)
/// exact: each field is rounded once to nearest, ties to even, and saturates at the ends of its
///        format                                               (tests/dynamics/mass.test.cpp)
template <Scalar S, int N>
struct MassProperties {
  using Formats = detail::MassFormats<S>;

  typename Formats::Mass mass{};
  Vec<typename Formats::Center, N> center{};
  detail::Tensor<typename Formats::Gyration, N> gyration{};
  detail::Tensor<typename Formats::InverseGyration, N> inverse_gyration{};

  [[nodiscard]] friend constexpr bool operator==(const MassProperties&,
                                                 const MassProperties&) noexcept = default;
};

/// Appends to a digest: the fields in order.
template <class D, Scalar S, int N>
constexpr void append(D& digest, const MassProperties<S, N>& properties) noexcept {
  digest.add(properties.mass, properties.center, properties.gyration, properties.inverse_gyration);
}

namespace detail {

/// The inverse of a positive number, or 0.
template <Number T, Number K>
[[nodiscard]] constexpr T inverse_tensor(const K& gyration) noexcept {
  if (gyration <= 0) return T(0);
  return quotient_nearest<T>(K(1), gyration);
}

/// The inverse of a positive definite matrix by its cofactors, or 0 if the determinant is not
/// positive.
template <Number T, Number K>
[[nodiscard]] constexpr Symmetric<T> inverse_tensor(const Symmetric<K>& gyration) noexcept {
  const auto& diagonal = gyration.diagonal;
  const auto& mixed = gyration.mixed;
  const auto major = make_vec<3>([&](int i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    return diagonal[j] * diagonal[k] - mixed[i] * mixed[i];
  });
  const auto minor = make_vec<3>([&](int i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    return mixed[j] * mixed[k] - diagonal[i] * mixed[i];
  });
  const auto determinant = diagonal[0] * major[0] + mixed[2] * minor[2] + mixed[1] * minor[1];
  if (determinant <= 0) return {};
  return {quotient_nearest<T>(major, determinant), quotient_nearest<T>(minor, determinant)};
}

/// The properties of a solid. `content` is N! times its volume, of any number type.
template <Scalar S, int N, Number C>
[[nodiscard]] constexpr MassProperties<S, N> properties_of(
    const S& density, const C& content, const Vec<typename MassFormats<S>::Center, N>& center,
    const Tensor<typename MassFormats<S>::Gyration, N>& gyration) noexcept {
  using Formats = MassFormats<S>;
  if (density <= 0) return {};
  const auto weight = density * content;
  const auto mass = quotient_nearest<typename Formats::Mass>(
      weight, as_operand<std::remove_cvref_t<decltype(weight)>>(N == 2 ? 2 : 6));
  if (mass <= 0) return {};
  return {mass, center, gyration, inverse_tensor<typename Formats::InverseGyration>(gyration)};
}

}  // namespace detail

}  // namespace detent
