// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "detent/math/mat.hpp"
#include "detent/math/transform.hpp"
#include "detent/number/arc.hpp"

// Cameras. A camera's frame is right-handed: x to the right, y up, and it looks along -z. After
// projection x and y of what is seen are in [-1, 1], and z, its depth, is in [0, 1] from near to
// far.

namespace detent {

/// The frame of a camera at `eye` that sees `target` in the middle and `up` upward; nothing where
/// `target` is `eye` or `up` is parallel to the line of sight, exactly.
///
/// domain: every point; `up` of any length, perpendicular or not
/// exact:  each component of each axis rounded to nearest          (tests/math/projection.test.cpp)
template <Scalar S>
[[nodiscard]] constexpr std::optional<Transform<S, 3>> look_at(const Vec<S, 3>& eye,
                                                               const Vec<S, 3>& target,
                                                               const Vec<S, 3>& up) noexcept {
  const auto back = eye - target;
  const auto right = cross(up, back);
  const auto x = direction_of<S>(right), z = direction_of<S>(back);
  const auto y = direction_of<S>(cross(back, right));
  if (!x || !y || !z) return std::nullopt;
  return Transform<S, 3>{eye, Rotation<S, 3>::from_axes({*x, *y, *z}), S(1)};
}

/// The matrix from the world into the frame of a camera, whose scale it leaves aside: the axes as
/// rows, exactly. `nearest_to<S>` makes scalars of the components.
template <Scalar S, int N>
[[nodiscard]] constexpr auto view_matrix(const Transform<S, N>& camera) noexcept {
  using T = decltype(-dot(camera.rotation.axis(0), camera.translation));
  return make_mat<N + 1, N + 1>([&](int i, int j) {
    if (i == N) return T(j == N ? 1 : 0);
    const auto& axis = camera.rotation.axis(i);
    return j == N ? -dot(axis, camera.translation) : T(axis[j]);
  });
}

/// The matrix of a lens that sees `fov` from top to bottom and `aspect` times as much, measured on
/// a screen, from left to right; components are scalars, or of the type asked for:
/// `perspective<T>(...)`.
///
/// domain: nothing unless `fov` is in (0, 1/2) turn, aspect > 0 and 0 < near_distance <
///         far_distance
/// exact:  components rounded to nearest, ties to even, and clamped; those of x and y, which take a
///         cotangent, off by less than 0.5 + 2^-28 units           (tests/math/projection.test.cpp)
template <class To = void, Scalar S>
[[nodiscard]] constexpr auto perspective(Angle<S> fov, S aspect, S near_distance,
                                         S far_distance) noexcept
    -> std::optional<Mat<detail::to_or_own<To, S>, 4, 4>> {
  using T = detail::to_or_own<To, S>;
  const auto [sine, cosine] = half_tangent(fov);
  const bool sees = sine > 0 && cosine > 0 && aspect > 0;
  if (!sees || !(near_distance > 0 && near_distance < far_distance)) return std::nullopt;
  Mat<T, 4, 4> m;
  m(0, 0) = quotient_nearest<T>(cosine, sine * aspect);
  m(1, 1) = quotient_nearest<T>(cosine, sine);
  m(2, 2) = quotient_nearest<T>(far_distance, near_distance - far_distance);
  m(2, 3) = quotient_nearest<T>(near_distance * far_distance, near_distance - far_distance);
  m(3, 2) = T(-1);
  return m;
}

/// The matrix of a view without perspective: the box from (left, bottom, -near_distance) to
/// (right, top, -far_distance) is what is seen. Components as for `perspective`: in a window
/// thousands of units wide a finer type pays.
///
/// domain: nothing unless left < right, bottom < top and near_distance < far_distance
/// exact:  components rounded to nearest, ties to even, and clamped
///         (tests/math/projection.test.cpp)
template <class To = void, Scalar S>
[[nodiscard]] constexpr auto orthographic(S left, S right, S bottom, S top, S near_distance,
                                          S far_distance) noexcept
    -> std::optional<Mat<detail::to_or_own<To, S>, 4, 4>> {
  using T = detail::to_or_own<To, S>;
  if (!(left < right && bottom < top && near_distance < far_distance)) return std::nullopt;
  Mat<T, 4, 4> m;
  m(0, 0) = quotient_nearest<T>(S(1) + S(1), right - left);
  m(1, 1) = quotient_nearest<T>(S(1) + S(1), top - bottom);
  m(2, 2) = quotient_nearest<T>(S(1), near_distance - far_distance);
  m(0, 3) = quotient_nearest<T>(right + left, left - right);
  m(1, 3) = quotient_nearest<T>(top + bottom, bottom - top);
  m(2, 3) = quotient_nearest<T>(near_distance, near_distance - far_distance);
  m(3, 3) = T(1);
  return m;
}

/// The point that a matrix takes `p` to: m * (p, 1), divided by its last component, or nothing
/// where that is 0. It is negative for what a camera with perspective has behind it.
///
/// exact: each coordinate is the exact quotient rounded to nearest, ties to even, and clamped
///        (tests/math/projection.test.cpp)
template <Number T, Scalar S, int N>
[[nodiscard]] constexpr std::optional<Vec<S, N>> project_point(const Mat<T, N + 1, N + 1>& m,
                                                               const Vec<S, N>& p) noexcept {
  const auto h = m * make_vec<N + 1>([&](int i) { return i < N ? p[i] : S(1); });
  if (h[N] == 0) return std::nullopt;
  return make_vec<N>([&](int i) { return quotient_nearest<S>(h[i], h[N]); });
}

}  // namespace detent
