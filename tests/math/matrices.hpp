// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <utility>

#include "detent/math/mat.hpp"
#include "number/big_integer.hpp"

namespace detent::test {

/// The oracle for matrices: exact fractions, and elimination instead of cofactors.
template <int N>
using Rationals =
    std::array<std::array<BigRational, static_cast<std::size_t>(N)>, static_cast<std::size_t>(N)>;

template <class T, int N>
Rationals<N> rationals(const Mat<T, N, N>& m) {
  Rationals<N> result;
  for (std::size_t i = 0; i < N; ++i) {
    for (std::size_t j = 0; j < N; ++j) {
      result[i][j] = rational(m(static_cast<int>(i), static_cast<int>(j)));
    }
  }
  return result;
}

template <std::size_t N>
struct Elimination {
  BigRational determinant = 1;
  std::array<std::array<BigRational, N>, N> inverse;  // if the determinant is not 0
};

/// Gauss-Jordan elimination.
template <std::size_t N>
Elimination<N> eliminate(std::array<std::array<BigRational, N>, N> m) {
  Elimination<N> result;
  for (std::size_t i = 0; i < N; ++i) result.inverse[i][i] = 1;
  for (std::size_t i = 0; i < N; ++i) {
    std::size_t pivot = i;
    while (pivot < N && m[pivot][i] == 0) ++pivot;
    if (pivot == N) {
      result.determinant = 0;
      return result;
    }
    if (pivot != i) {
      std::swap(m[pivot], m[i]);
      std::swap(result.inverse[pivot], result.inverse[i]);
      result.determinant = -result.determinant;
    }
    const BigRational scale = m[i][i];
    result.determinant *= scale;
    for (std::size_t k = 0; k < N; ++k) {
      m[i][k] /= scale;
      result.inverse[i][k] /= scale;
    }
    for (std::size_t j = 0; j < N; ++j) {
      const BigRational factor = m[j][i];
      if (j == i || factor == 0) continue;
      for (std::size_t k = 0; k < N; ++k) {
        m[j][k] -= factor * m[i][k];
        result.inverse[j][k] -= factor * result.inverse[i][k];
      }
    }
  }
  return result;
}

/// Components of similar magnitude, often ends of the domain; one matrix in four is singular.
template <Scalar S, int R, int C>
Mat<S, R, C> random_mat(Random& random, int most_bits = S::bits) {
  const int bits = static_cast<int>(random.below(static_cast<std::uint64_t>(most_bits) + 1));
  auto m = make_mat<R, C>(
      [&](int, int) { return S::from_raw(static_cast<typename S::raw_type>(random.edgy(bits))); });
  if (random.one_in(4)) m.rows[0] = m.rows[1];
  return m;
}

}  // namespace detent::test
