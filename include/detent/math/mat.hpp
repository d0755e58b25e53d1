// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include "detent/math/vec.hpp"

namespace detent {

/// A matrix of R rows and C columns, each 2 to 4, that multiplies column vectors: m * v.
///
/// Written row by row: `Mat<S, 2, 2>{{{{a, b}, {c, d}}}}`. As with vectors, sums and products have
/// the component type that holds them exactly; `nearest_to<S>(m)` rounds.
template <Number T, int R, int C>
struct Mat {
  static_assert(R >= 2 && R <= 4 && C >= 2 && C <= 4);

  using Rows = std::array<Vec<T, C>, static_cast<std::size_t>(R)>;

  Rows rows = zero_rows();

  [[nodiscard]] constexpr T& operator()(int row, int column) noexcept {
    return rows[static_cast<std::size_t>(row)][column];
  }
  [[nodiscard]] constexpr const T& operator()(int row, int column) const noexcept {
    return rows[static_cast<std::size_t>(row)][column];
  }

  /// Row `i`, from 0.
  [[nodiscard]] constexpr const Vec<T, C>& row(int i) const noexcept {
    return rows[static_cast<std::size_t>(i)];
  }
  /// Column `j`, from 0.
  [[nodiscard]] constexpr Vec<T, R> column(int j) const noexcept {
    return make_vec<R>([&](int i) { return (*this)(i, j); });
  }

  [[nodiscard]] friend constexpr bool operator==(const Mat&, const Mat&) noexcept = default;

 private:
  /// The value of `Rows{}`, whose components GCC 12 considers uninitialized in constants.
  static constexpr Rows zero_rows() noexcept {
    Rows zero{};
    for (auto& row : zero) row = Vec<T, C>{};
    return zero;
  }
};

/// Appends to a digest: the components row by row.
template <class D, Number T, int R, int C>
constexpr void append(D& digest, const Mat<T, R, C>& m) noexcept {
  for (int i = 0; i < R; ++i) digest.add(m.row(i));
}

/// The matrix whose component (i, j) is f(i, j).
template <int R, int C, class F>
[[nodiscard]] constexpr auto make_mat(const F& f) noexcept {
  Mat<decltype(f(0, 0)), R, C> m;
  for (int i = 0; i < R; ++i) {
    for (int j = 0; j < C; ++j) m(i, j) = f(i, j);
  }
  return m;
}

/// The identity matrix.
template <Number T, int N>
[[nodiscard]] constexpr Mat<T, N, N> identity() noexcept {
  return make_mat<N, N>([](int i, int j) { return T(i == j ? 1 : 0); });
}

template <Number A, Number B, int R, int C>
[[nodiscard]] constexpr auto operator+(const Mat<A, R, C>& a, const Mat<B, R, C>& b) noexcept {
  return make_mat<R, C>([&](int i, int j) { return a(i, j) + b(i, j); });
}
template <Number A, Number B, int R, int C>
[[nodiscard]] constexpr auto operator-(const Mat<A, R, C>& a, const Mat<B, R, C>& b) noexcept {
  return make_mat<R, C>([&](int i, int j) { return a(i, j) - b(i, j); });
}
template <Number T, int R, int C>
[[nodiscard]] constexpr auto operator-(const Mat<T, R, C>& m) noexcept {
  return make_mat<R, C>([&](int i, int j) { return -m(i, j); });
}
template <Number A, Number B, int R, int C>
[[nodiscard]] constexpr auto operator*(const Mat<A, R, C>& m, const B& factor) noexcept {
  return make_mat<R, C>([&](int i, int j) { return m(i, j) * factor; });
}
template <Number A, Number B, int R, int C>
[[nodiscard]] constexpr auto operator*(const A& factor, const Mat<B, R, C>& m) noexcept {
  return m * factor;
}

/// The matrix that applies `b` first, then `a`.
template <Number A, Number B, int R, int K, int C>
[[nodiscard]] constexpr auto operator*(const Mat<A, R, K>& a, const Mat<B, K, C>& b) noexcept {
  return make_mat<R, C>([&](int i, int j) { return dot(a.row(i), b.column(j)); });
}
template <Number A, Number B, int R, int C>
[[nodiscard]] constexpr auto operator*(const Mat<A, R, C>& m, const Vec<B, C>& v) noexcept {
  return make_vec<R>([&](int i) { return dot(m.row(i), v); });
}

/// The transposed matrix.
template <Number T, int R, int C>
[[nodiscard]] constexpr Mat<T, C, R> transpose(const Mat<T, R, C>& m) noexcept {
  return make_mat<C, R>([&](int i, int j) { return m(j, i); });
}

/// `m` with each component rounded to nearest, ties to even, and clamped.
template <Number S, Number T, int R, int C>
[[nodiscard]] constexpr Mat<S, R, C> nearest_to(const Mat<T, R, C>& m) noexcept {
  return make_mat<R, C>([&](int i, int j) { return nearest_to<S>(m(i, j)); });
}

/// The components row by row.
template <Number T, int R, int C>
[[nodiscard]] constexpr auto to_row_major(const Mat<T, R, C>& m) noexcept {
  std::array<T, static_cast<std::size_t>(R * C)> components;
  for (int i = 0; i < R * C; ++i) components[static_cast<std::size_t>(i)] = m(i / C, i % C);
  return components;
}

/// The components column by column, as graphics interfaces expect them.
template <Number T, int R, int C>
[[nodiscard]] constexpr auto to_column_major(const Mat<T, R, C>& m) noexcept {
  return to_row_major(transpose(m));
}

/// The matrix with these components, row by row.
template <int R, int C, Number T>
[[nodiscard]] constexpr Mat<T, R, C> from_row_major(
    const std::array<T, static_cast<std::size_t>(R* C)>& components) noexcept {
  return make_mat<R, C>(
      [&](int i, int j) { return components[static_cast<std::size_t>(i * C + j)]; });
}

/// The matrix with these components, column by column.
template <int R, int C, Number T>
[[nodiscard]] constexpr Mat<T, R, C> from_column_major(
    const std::array<T, static_cast<std::size_t>(R* C)>& components) noexcept {
  return transpose(from_row_major<C, R>(components));
}

}  // namespace detent
