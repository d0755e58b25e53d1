// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "detent/math/mat.hpp"
#include "detent/math/transform.hpp"
#include "detent/number/arc.hpp"

// Cameras. A camera's frame is right-handed: x to the right, y up, looking along -z. After
// projection visible points have x and y in [-1, 1] and depth z in [0, 1], from near to far.

namespace detent {

/// The frame of a camera at `eye` that looks at `target`, with `up` pointing up in the image;
/// nothing if `target` is `eye` or `up` is parallel to the line of sight, exactly.
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

/// The matrix from the world into a camera's frame, ignoring the camera's scale: the axes as rows,
/// exactly. `nearest_to<S>` rounds the components to scalars.
template <Scalar S, int N>
[[nodiscard]] constexpr auto view_matrix(const Transform<S, N>& camera) noexcept {
  using T = decltype(-dot(camera.rotation.axis(0), camera.translation));
  return make_mat<N + 1, N + 1>([&](int i, int j) {
    if (i == N) return T(j == N ? 1 : 0);
    const auto& axis = camera.rotation.axis(i);
    return j == N ? -dot(axis, camera.translation) : T(axis[j]);
  });
}

/// The matrix of a perspective camera. `fov` is the field of view from top to bottom, `aspect` the
/// width of the screen over its height. Components are scalars, or of a given type:
/// `perspective<T>(...)`.
///
/// domain: nothing unless `fov` is in (0, 1/2) turn, aspect > 0 and
///         0 < near_distance < far_distance
/// exact:  components rounded to nearest, ties to even, and clamped; those of x and y, which need a
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

/// The matrix of an orthographic camera, which sees the box from (left, bottom, -near_distance) to
/// (right, top, -far_distance). Component types as for `perspective`; for a window thousands of
/// units wide, use a finer type.
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

/// The point to which a matrix maps `p`: m * (p, 1) divided by its last component, or nothing if
/// that is 0. The last component is negative for points behind a perspective camera.
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
