// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <type_traits>

#include "detent/math/mat.hpp"
#include "detent/math/width.hpp"

// Determinants, minors, cofactors, the adjugate, the inverse. All are exact, except that an inverse
// is rounded once.

namespace detent {

namespace detail {

/// The bits of a determinant of N rows of B-bit components: at most N^(N/2) 2^(N B).
///
/// source: Hadamard's inequality
constexpr int determinant_bits(int n, int bits) noexcept {
  constexpr std::array<int, 5> excess = {0, 0, 1, 3, 4};
  return result_bits(n * bits + excess[static_cast<std::size_t>(n)]);
}

/// The determinant of the listed rows and columns of `m`.
///
/// A sum of the first terms of the expansion is the determinant with zeros for the other components
/// of the row, so Hadamard's bound holds for it too.
template <int Size, Number T, int N>
[[nodiscard]] constexpr auto determinant_of(const Mat<T, N, N>& m, const std::array<int, 4>& rows,
                                            const std::array<int, 4>& columns) noexcept {
  if constexpr (Size == 1) {
    return m(rows[0], columns[0]);
  } else {
    constexpr int bits = determinant_bits(Size, bits_of<T>);
    const auto term = [&](std::size_t j) {
      std::array<int, 4> others{}, below{};
      for (std::size_t k = 0; k + 1 < Size; ++k) {
        others[k] = columns[k < j ? k : k + 1];
        below[k] = rows[k + 1];
      }
      return narrow_product<bits>(m(rows[0], columns[j]),
                                  determinant_of<Size - 1>(m, below, others));
    };
    auto sum = narrow_difference<bits>(term(0), term(1));
    if constexpr (Size > 2) sum = narrow_sum<bits>(sum, term(2));
    if constexpr (Size > 3) sum = narrow_difference<bits>(sum, term(3));
    return sum;
  }
}

inline constexpr std::array<int, 4> all_indices = {0, 1, 2, 3};

constexpr std::array<int, 4> indices_without(int index) noexcept {
  std::array<int, 4> indices{};
  for (int k = 0; k < 3; ++k) indices[static_cast<std::size_t>(k)] = k < index ? k : k + 1;
  return indices;
}

}  // namespace detail

/// The determinant: the volume of the parallelepiped spanned by the columns, negative if they are
/// left-handed.
///
/// exact: always                                                 (tests/math/inverse.test.cpp)
template <Number T, int N>
[[nodiscard]] constexpr auto determinant(const Mat<T, N, N>& m) noexcept {
  return detail::determinant_of<N>(m, detail::all_indices, detail::all_indices);
}

/// The determinant of `m` without row `i` and column `j`, exactly: the minor of (i, j).
template <Number T, int N>
[[nodiscard]] constexpr auto minor_of(const Mat<T, N, N>& m, int i, int j) noexcept {
  return detail::determinant_of<N - 1>(m, detail::indices_without(i), detail::indices_without(j));
}

/// The minor of (i, j), negated if i + j is odd.
template <Number T, int N>
[[nodiscard]] constexpr auto cofactor_of(const Mat<T, N, N>& m, int i, int j) noexcept {
  const auto minor_value = minor_of(m, i, j);
  using Cofactor = decltype(-minor_value);
  return (i + j) % 2 == 0 ? Cofactor(minor_value) : -minor_value;
}

/// The matrix of the minors.
template <Number T, int N>
[[nodiscard]] constexpr auto minors(const Mat<T, N, N>& m) noexcept {
  return make_mat<N, N>([&](int i, int j) { return minor_of(m, i, j); });
}

/// The matrix of the cofactors.
template <Number T, int N>
[[nodiscard]] constexpr auto cofactors(const Mat<T, N, N>& m) noexcept {
  return make_mat<N, N>([&](int i, int j) { return cofactor_of(m, i, j); });
}

/// The transposed matrix of the cofactors: m * adjugate(m) is determinant(m) on the diagonal.
template <Number T, int N>
[[nodiscard]] constexpr auto adjugate(const Mat<T, N, N>& m) noexcept {
  return make_mat<N, N>([&](int i, int j) { return cofactor_of(m, j, i); });
}

namespace detail {

template <Scalar S, Number T, int N>
[[nodiscard]] constexpr std::optional<Mat<S, N, N>> inverse_of(const Mat<T, N, N>& m) noexcept {
  const auto volume = determinant(m);
  if (volume == 0) return std::nullopt;
  const auto numerators = adjugate(m);
  return make_mat<N, N>(
      [&](int i, int j) { return quotient_nearest<S>(numerators(i, j), volume); });
}

}  // namespace detail

/// The inverse of `m`, or nothing if the determinant is 0.
///
/// domain: every matrix of scalars
/// exact:  whether it is singular; each component is that of the exact inverse rounded to nearest,
///         ties to even, and clamped                              (tests/math/inverse.test.cpp)
/// source: Cramer's rule, adjugate / determinant
template <Scalar S, int N>
[[nodiscard]] constexpr std::optional<Mat<S, N, N>> inverse(const Mat<S, N, N>& m) noexcept {
  if constexpr (N < 4) {
    return detail::inverse_of<S>(m);
  } else {
    // The determinant of 30-bit components needs 124 bits; of 31-bit ones, 128.
    return by_width<30>(
        [](const auto& a, const auto& b, const auto& c, const auto& d) {
          using T = std::remove_cvref_t<decltype(a.x)>;
          return detail::inverse_of<S>(Mat<T, 4, 4>{{a, b, c, d}});
        },
        m.row(0), m.row(1), m.row(2), m.row(3));
  }
}

}  // namespace detent
