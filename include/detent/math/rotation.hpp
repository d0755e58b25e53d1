// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "detent/math/direction.hpp"
#include "detent/number/angle.hpp"

namespace detent {

/// A rotation from a local frame into the world, stored as the local axes seen from the world.
///
/// Every way to make one rounds each component of each axis to nearest, so the axes are orthonormal
/// only within 2^-29 (2^-13 beside 16-bit scalars). Queries take them exactly as stored.
template <Scalar S, int N>
class Rotation {
 public:
  using Axis = Direction<S, N>;
  using Component = direction_component<S>;

  /// The identity.
  constexpr Rotation() noexcept {
    for (int i = 0; i < N; ++i) axes_[static_cast<std::size_t>(i)] = Axis::along(i);
  }

  /// The frame with these axes, taken as they are. Axes that are not perpendicular, or left-handed,
  /// make a frame that shears or mirrors; every function of a frame is defined for those too.
  [[nodiscard]] static constexpr Rotation from_axes(const std::array<Axis, N>& axes) noexcept {
    Rotation rotation;
    rotation.axes_ = axes;
    return rotation;
  }

  /// The turn by `angle`, counter-clockwise.
  ///
  /// exact: each component rounded to nearest                      (tests/math/rotation.test.cpp)
  [[nodiscard]] static constexpr Rotation from_angle(Angle<S> angle) noexcept requires(N == 2) {
    const auto c = cos<Component>(angle), s = sin<Component>(angle);
    return from_columns({Column{c, s}, Column{narrow<bits_of<Component>>(-s), c}});
  }

  /// The rotation of the quaternion w + x i + y j + z k of any length, or nothing for 0.
  ///
  /// domain: every quaternion; a quaternion and its multiples give the same rotation
  /// exact:  each component is the exact quotient rounded to nearest, ties to even
  ///         (tests/math/rotation.test.cpp)
  [[nodiscard]] static constexpr std::optional<Rotation> from_quaternion(S x, S y, S z,
                                                                         S w) noexcept
      requires(N == 3) {
    if (x == 0 && y == 0 && z == 0 && w == 0) return std::nullopt;
    return from_parts(Vec<S, 3>{x, y, z}, w);
  }

  /// The turn by `angle` about `axis`, counter-clockwise when the axis points at the viewer.
  ///
  /// exact: the rotation about the line through `axis` as stored; components off by less than
  ///        0.5001 of their units                                 (tests/math/rotation.test.cpp)
  [[nodiscard]] static constexpr Rotation from_axis_angle(const Axis& axis, Angle<S> angle) noexcept
      requires(N == 3) {
    // axis * sin(angle / 2) + |axis| * cos(angle / 2), the four parts off by half of 2^-45 each.
    // That moves the unit quaternion by 2^-45 and what it turns by twice as much: 2^-14 units of
    // 2^-30.
    using Part = typename detail::Precise<S>::QuaternionPart;
    const auto [sine, cosine] = half_sine_cosine(angle);
    const auto length = sqrt_floor<typename detail::Precise<S>::Length>(squared_length(axis));
    return from_parts(nearest_to<Part>(axis.vec() * sine), nearest_to<Part>(length * cosine));
  }

  /// The turn by `x` about the world's x axis, then by `y` about its y axis, then by `z` about its
  /// z axis.
  ///
  /// exact: components off by less than 0.5001 of their units      (tests/math/rotation.test.cpp)
  [[nodiscard]] static constexpr Rotation from_euler(Angle<S> x, Angle<S> y, Angle<S> z) noexcept
      requires(N == 3) {
    const auto [sx, cx] = sine_cosine(x);
    const auto [sy, cy] = sine_cosine(y);
    const auto [sz, cz] = sine_cosine(z);
    // Products of three are rounded once on the way, to 2^-62.
    const auto sy_sx = nearest_to<Sine>(sy * sx), sy_cx = nearest_to<Sine>(sy * cx);
    return from_columns({rounded(cz * cy, sz * cy, -sy),
                         rounded(cz * sy_sx - sz * cx, sz * sy_sx + cz * cx, cy * sx),
                         rounded(cz * sy_cx + sz * sx, sz * sy_cx - cz * sx, cy * cx)});
  }

  /// The local axis `i` in the world: column i of the rotation's matrix.
  [[nodiscard]] constexpr const Axis& axis(int i) const noexcept {
    return axes_[static_cast<std::size_t>(i)];
  }

  [[nodiscard]] friend constexpr bool operator==(const Rotation&,
                                                 const Rotation&) noexcept = default;

 private:
  using Sine = typename detail::Precise<S>::Sine;
  using Column = Vec<Component, N>;

  static constexpr Rotation from_columns(const std::array<Column, N>& columns) noexcept {
    Rotation rotation;
    for (std::size_t i = 0; i < N; ++i) rotation.axes_[i] = Axis::assume_unit(columns[i]);
    return rotation;
  }

  template <class X, class Y, class Z>
  static constexpr Column rounded(const X& x, const Y& y, const Z& z) noexcept {
    return {nearest_to<Component>(x), nearest_to<Component>(y), nearest_to<Component>(z)};
  }

  /// q p q* / |q|^2 for the unit vectors p. No numerator exceeds the denominator, |q|^2.
  template <Number T>
  static constexpr Rotation from_parts(const Vec<T, 3>& v, const T& w) noexcept {
    const auto norm = (v.x * v.x + v.y * v.y) + (v.z * v.z + w * w);
    std::array<Column, 3> columns;
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      const auto ij = v[i] * v[j] + w * v[k];
      const auto ik = v[i] * v[k] - w * v[j];
      const auto ii = (w * w + v[i] * v[i]) - (v[j] * v[j] + v[k] * v[k]);
      Column& column = columns[static_cast<std::size_t>(i)];
      column[i] = quotient_nearest<Component>(ii, norm);
      column[j] = quotient_nearest<Component>(ij + ij, norm);
      column[k] = quotient_nearest<Component>(ik + ik, norm);
    }
    return from_columns(columns);
  }

  std::array<Axis, N> axes_;
};

/// The canonical bytes of a digest: the axes in order.
template <class D, Scalar S, int N>
constexpr void append(D& digest, const Rotation<S, N>& rotation) noexcept {
  for (int i = 0; i < N; ++i) digest.add(rotation.axis(i));
}

/// The vector `v` of the local frame in the world.
///
/// exact: the sum of v[i] * axis(i), each component rounded to nearest, ties to even, and clamped
///        (tests/math/rotation.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr Vec<S, N> rotate(const Rotation<S, N>& rotation,
                                         const Vec<S, N>& v) noexcept {
  // At most 3 * 2^(b - 1) times a component of v, b the bits of a direction's component.
  constexpr int bits = bits_of<S> + bits_of<direction_component<S>> + 1;
  return make_vec<N>([&](int j) {
    const auto row = make_vec<N>([&](int i) { return rotation.axis(i)[j]; });
    return nearest_to<S>(narrow_dot<bits>(row, v));
  });
}

/// The vector `v` of the world in the local frame.
///
/// exact: dot(axis(i), v), rounded to nearest, ties to even, and clamped; the inverse of `rotate`
/// as
///        far as the axes are orthonormal                         (tests/math/rotation.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr Vec<S, N> inverse_rotate(const Rotation<S, N>& rotation,
                                                 const Vec<S, N>& v) noexcept {
  return make_vec<N>([&](int i) { return nearest_to<S>(dot(rotation.axis(i), v)); });
}

}  // namespace detent
