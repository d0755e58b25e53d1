// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>

#include "detent/math/inverse.hpp"
#include "detent/math/project.hpp"
#include "detent/math/transform.hpp"

// Conversions between transforms and matrices; orthonormalization of frames.

namespace detent {

/// The matrix of a rotation: its axes are the columns.
template <Scalar S, int N>
[[nodiscard]] constexpr auto to_mat(const Rotation<S, N>& rotation) noexcept {
  return make_mat<N, N>([&](int i, int j) { return rotation.axis(j)[i]; });
}

/// The matrix of a transform, which maps (p, 1) to (transform_point(p), 1): exactly, with
/// components wide enough for scale times axis. `nearest_to<S>` rounds them to scalars.
template <Scalar S, int N>
[[nodiscard]] constexpr auto to_mat(const Transform<S, N>& transform) noexcept {
  using T = decltype(transform.scale * direction_component<S>());
  return make_mat<N + 1, N + 1>([&](int i, int j) {
    if (i == N) return T(j == N ? 1 : 0);
    if (j == N) return T(transform.translation[i]);
    return transform.scale * transform.rotation.axis(j)[i];
  });
}

namespace detail {

/// The directions of the Gram-Schmidt vectors of the columns, each rounded once, or nothing if the
/// columns are dependent. The last one is the normal of the others, on the side of its column.
template <Scalar S, Number T>
[[nodiscard]] constexpr std::optional<Rotation<S, 2>> orthogonal_frame(
    const std::array<Vec<T, 2>, 2>& columns) noexcept {
  const auto side = cross(columns[0], columns[1]);
  if (side == 0) return std::nullopt;
  const auto first = *direction_of<S>(columns[0]);
  const auto second = perpendicular(first);
  return Rotation<S, 2>::from_axes({first, side < 0 ? -second : second});
}
template <Scalar S, Number T>
[[nodiscard]] constexpr std::optional<Rotation<S, 3>> orthogonal_frame(
    const std::array<Vec<T, 3>, 3>& columns) noexcept {
  const auto normal = cross(columns[0], columns[1]);
  const auto side = dot(normal, columns[2]);
  if (side == 0) return std::nullopt;
  const auto first = direction_of<S>(columns[0]);
  const auto second = direction_of<S>(cross(normal, columns[0]));
  const auto third = direction_of<S>(normal);
  if (!first || !second || !third) return std::nullopt;  // scalars that round may underflow
  return Rotation<S, 3>::from_axes({*first, *second, side < 0 ? -*third : *third});
}

/// Whether two components of a transform's matrix are at most 4 units apart; for scalars that
/// round, which have no unit, 4 * 2^-24 of the scale.
template <Scalar S, Number T>
[[nodiscard]] constexpr bool is_near(const S& a, const T& b, const S& scale) noexcept {
  const S slack = [&] {
    if constexpr (is_fixed<S>) {
      return S::from_raw(4);
    } else {
      return abs(scale) / (1 << 22);
    }
  }();
  return a - b <= slack && b - a <= slack;
}

}  // namespace detail

/// Orthonormalizes a frame, for instance after many products. Axis 0 keeps its direction, axis 1
/// turns by the least angle that makes it perpendicular to axis 0, and axis 2 becomes perpendicular
/// to both, on its own side. Nothing if the axes are linearly dependent.
///
/// exact:  each axis is the direction of the exact vector, rounded to nearest, so that their angles
///         are right within 2^-29 (2^-13)                         (tests/math/decompose.test.cpp)
/// source: the Gram-Schmidt process
template <Scalar S, int N>
[[nodiscard]] constexpr std::optional<Rotation<S, N>> orthogonalize(
    const Rotation<S, N>& rotation) noexcept {
  std::array<Vec<direction_component<S>, N>, static_cast<std::size_t>(N)> columns{};
  for (int i = 0; i < N; ++i) columns[static_cast<std::size_t>(i)] = rotation.axis(i).vec();
  return detail::orthogonal_frame<S>(columns);
}

/// The transform with this matrix, or nothing if there is none: a last row other than 0 0 0 1,
/// columns that are not perpendicular or not of one length, or a mirror in 2D.
///
/// result: a matrix of scalars has been rounded, so each component may differ by up to 4 units from
///         that of the result, but no more; a mirror in 3D has a negative scale
/// exact:  the axes are the Gram-Schmidt frame of the columns, the scale is the best fit for these
///         axes, each rounded once                                (tests/math/decompose.test.cpp)
template <Scalar S, int Size>
requires(Size == 3 || Size == 4)
    [[nodiscard]] constexpr std::optional<Transform<S, Size - 1>> decompose(
        const Mat<S, Size, Size>& m) noexcept {
  constexpr int dimension = Size - 1;
  for (int j = 0; j < Size; ++j) {
    if (m(dimension, j) != (j == dimension ? 1 : 0)) return std::nullopt;
  }
  const auto volume = minor_of(m, dimension, dimension);
  if (dimension == 2 && volume < 0) return std::nullopt;
  using T = decltype(-S());
  std::array<Vec<T, dimension>, static_cast<std::size_t>(dimension)> columns{};
  for (int i = 0; i < dimension; ++i) {
    columns[static_cast<std::size_t>(i)] =
        make_vec<dimension>([&](int j) { return volume < 0 ? -m(j, i) : T(m(j, i)); });
  }
  const auto frame = detail::orthogonal_frame<S>(columns);
  if (!frame) return std::nullopt;

  // The best fit for the scale: <columns, axes> / <axes, axes>.
  const auto fit = [&](int i) { return dot(frame->axis(i), columns[static_cast<std::size_t>(i)]); };
  const auto size = [&](int i) { return squared_length(frame->axis(i)); };
  const T length = [&] {
    if constexpr (dimension == 2) {
      return quotient_nearest<T>(fit(0) + fit(1), size(0) + size(1));
    } else {
      return quotient_nearest<T>(fit(0) + fit(1) + fit(2), size(0) + size(1) + size(2));
    }
  }();
  const auto origin = make_vec<dimension>([&](int i) { return m(i, dimension); });
  const S scale = volume < 0 ? nearest_to<S>(-length) : nearest_to<S>(length);
  const Transform<S, dimension> found{origin, *frame, scale};
  const auto exact = to_mat(found);
  for (int i = 0; i < dimension; ++i) {
    for (int j = 0; j < dimension; ++j) {
      if (!detail::is_near(m(i, j), exact(i, j), scale)) return std::nullopt;
    }
  }
  return found;
}

}  // namespace detent
