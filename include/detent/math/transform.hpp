// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "detent/math/rotation.hpp"

namespace detent {

/// A transform from a local frame into the world, p -> translation + scale * rotation * p: a
/// translation, a rotation and a uniform scale.
///
/// scale:  1 is a rigid motion; a negative scale mirrors through the origin of the frame
template <Scalar S, int N>
struct Transform {
  Vec<S, N> translation{};
  Rotation<S, N> rotation{};
  S scale = S(1);

  [[nodiscard]] friend constexpr bool operator==(const Transform&,
                                                 const Transform&) noexcept = default;
};

template <Scalar S, int N>
Transform(Vec<S, N>, Rotation<S, N>) -> Transform<S, N>;
template <Scalar S, int N>
Transform(Vec<S, N>, Rotation<S, N>, S) -> Transform<S, N>;

/// Appends to a digest: translation, rotation, scale.
template <class D, Scalar S, int N>
constexpr void append(D& digest, const Transform<S, N>& transform) noexcept {
  digest.add(transform.translation, transform.rotation, transform.scale);
}

namespace detail {

/// Component j of scale * rotation * v, exactly.
template <Scalar S, int N>
[[nodiscard]] constexpr auto moved(const Transform<S, N>& transform, const Vec<S, N>& v,
                                   int j) noexcept {
  // At most 3 * 2^(b - 1) times a component of v, b the bits of a direction's component.
  constexpr int bits = bits_of<S> + bits_of<direction_component<S>> + 1;
  const auto row = make_vec<N>([&](int i) { return transform.rotation.axis(i)[j]; });
  return narrow_dot<bits>(row, v) * transform.scale;
}

}  // namespace detail

/// Transforms the point `p` from the local frame into the world.
///
/// exact: translation + the sum of scale * p[i] * axis(i), each coordinate rounded to nearest, ties
///        to even, and clamped                                   (tests/math/transform.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr Vec<S, N> transform_point(const Transform<S, N>& transform,
                                                  const Vec<S, N>& p) noexcept {
  return make_vec<N>([&](int j) {
    return nearest_to<S>(transform.translation[j] + detail::moved(transform, p, j));
  });
}

/// Transforms the vector `v`, a difference of points, from the local frame into the world: scaled
/// and rotated.
///
/// exact: the sum of scale * v[i] * axis(i), each component rounded to nearest, ties to even, and
///        clamped                                                (tests/math/transform.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr Vec<S, N> transform_vector(const Transform<S, N>& transform,
                                                   const Vec<S, N>& v) noexcept {
  return make_vec<N>([&](int j) { return nearest_to<S>(detail::moved(transform, v, j)); });
}

/// Transforms the direction `d` from the local frame into the world: rotated, and reversed by a
/// negative scale. As exact as `rotate`.
template <Scalar S, int N>
[[nodiscard]] constexpr Direction<S, N> transform_direction(const Transform<S, N>& transform,
                                                            const Direction<S, N>& d) noexcept {
  return rotate(transform.rotation, transform.scale < 0 ? -d : d);
}

namespace detail {

template <Scalar S, int N, Number T>
[[nodiscard]] constexpr Vec<S, N> moved_back(const Transform<S, N>& transform,
                                             const Vec<T, N>& v) noexcept {
  return make_vec<N>([&](int i) {
    return quotient_nearest<S>(dot(transform.rotation.axis(i), v), transform.scale);
  });
}

}  // namespace detail

/// Transforms the point `p` from the world into the local frame.
///
/// domain: every transform; with scale 0 a coordinate is a quotient by 0: 0 or an end of the range
/// result: the inverse of `transform_point` if the axes are orthonormal; a round trip moves a point
///         by less than 8 units if the scale is 1 and nothing is clamped
/// exact:  dot(axis(i), p - translation) / scale, rounded to nearest, ties to even, and clamped
///         (tests/math/transform.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr Vec<S, N> inverse_transform_point(const Transform<S, N>& transform,
                                                          const Vec<S, N>& p) noexcept {
  return detail::moved_back(transform, p - transform.translation);
}

/// Transforms the vector `v` from the world into the local frame: dot(axis(i), v) / scale, as for
/// points.
template <Scalar S, int N>
[[nodiscard]] constexpr Vec<S, N> inverse_transform_vector(const Transform<S, N>& transform,
                                                           const Vec<S, N>& v) noexcept {
  return detail::moved_back(transform, v);
}

/// Transforms the direction `d` from the world into the local frame.
template <Scalar S, int N>
[[nodiscard]] constexpr Direction<S, N> inverse_transform_direction(
    const Transform<S, N>& transform, const Direction<S, N>& d) noexcept {
  return inverse_rotate(transform.rotation, transform.scale < 0 ? -d : d);
}

/// The transform `inner` followed by `outer`, such as a child's transform followed by its parent's.
///
/// exact: the translation is `transform_point` of the inner one; axes and scale are rounded once,
///        and the scale is clamped                                (tests/math/transform.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr Transform<S, N> compose(const Transform<S, N>& outer,
                                                const Transform<S, N>& inner) noexcept {
  return {transform_point(outer, inner.translation), compose(outer.rotation, inner.rotation),
          nearest_to<S>(outer.scale * inner.scale)};
}

/// The inverse transform, or nothing if the scale is 0.
///
/// exact: rotation and scale rounded once; the translation is `inverse_transform_point` of the
///        origin                                                 (tests/math/transform.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr std::optional<Transform<S, N>> inverse(
    const Transform<S, N>& transform) noexcept {
  if (transform.scale == 0) return std::nullopt;
  return Transform<S, N>{inverse_transform_point(transform, Vec<S, N>{}),
                         inverse(transform.rotation), quotient_nearest<S>(S(1), transform.scale)};
}

}  // namespace detent
