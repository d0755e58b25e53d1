// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "detent/math/direction.hpp"
#include "detent/number/angle.hpp"
#include "detent/number/filter/unit_length.hpp"

namespace detent {

namespace detail {

/// |q|^2 times the matrix of the quaternion q = (x, y, z, w), column by column: q p q* for the axes
/// p. The caller must prove that |q|^2 fits `Bits`; no component exceeds it.
template <int Bits, Number T>
[[nodiscard]] constexpr auto quaternion_columns(const Vec<T, 4>& q) noexcept {
  const auto product = [&](int i, int j) { return narrow_product<Bits>(q[i], q[j]); };
  const auto sum = [](const auto& a, const auto& b) { return narrow_sum<Bits>(a, b); };
  const auto difference = [](const auto& a, const auto& b) {
    return narrow_difference<Bits>(a, b);
  };
  std::array<Vec<decltype(product(0, 0)), 3>, 3> columns{};
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const auto ij = sum(product(i, j), product(3, k)),
               ik = difference(product(i, k), product(3, j));
    auto& column = columns[static_cast<std::size_t>(i)];
    column[i] = difference(sum(product(3, 3), product(i, i)), sum(product(j, j), product(k, k)));
    column[j] = sum(ij, ij);
    column[k] = sum(ik, ik);
  }
  return columns;
}

}  // namespace detail

/// A rotation from a local frame into the world, stored as the local axes in world coordinates.
///
/// Each component of each axis is rounded to nearest when it is computed, so the axes are
/// orthonormal only within 2^-29 (2^-13 for 16-bit scalars). Queries use them exactly as stored.
template <Scalar S, int N>
class Rotation {
 public:
  using Axis = Direction<S, N>;
  using Component = direction_component<S>;

  /// The identity.
  constexpr Rotation() noexcept {
    for (int i = 0; i < N; ++i) axes_[static_cast<std::size_t>(i)] = Axis::along(i);
  }

  /// The frame with these axes, unchanged. Axes that are not perpendicular, or are left-handed,
  /// make a frame that shears or mirrors; all functions of frames accept those too.
  [[nodiscard]] static constexpr Rotation from_axes(
      const std::array<Axis, std::size_t{N}>& axes) noexcept {
    Rotation rotation;
    rotation.axes_ = axes;
    return rotation;
  }

  /// The rotation by `angle`, counter-clockwise.
  ///
  /// exact: each component rounded to nearest                      (tests/math/rotation.test.cpp)
  [[nodiscard]] static constexpr Rotation from_angle(Angle<S> angle) noexcept requires(N == 2) {
    const auto c = cos<Component>(angle), s = sin<Component>(angle);
    return from_columns({Column{c, s}, Column{narrow_negative(s), c}});
  }

  /// The rotation of the quaternion w + x i + y j + z k of any length, or nothing for 0.
  ///
  /// domain: every quaternion; a quaternion and its multiples give the same rotation
  /// exact:  each component is the exact quotient rounded to nearest, ties to even
  ///         (tests/math/rotation.test.cpp)
  [[nodiscard]] static constexpr std::optional<Rotation> from_quaternion(S x, S y, S z,
                                                                         S w) noexcept
      requires(N == 3) {
    constexpr int bits = detail::result_bits(2 * bits_of<S> + 2);
    return from_quaternion<bits>(Vec<S, 4>{x, y, z, w});
  }

  /// `from_quaternion` for components of any number type whose squared length fits `Bits`.
  template <int Bits, Number T>
  [[nodiscard]] static constexpr std::optional<Rotation> from_quaternion(
      const Vec<T, 4>& q) noexcept requires(N == 3) {
    const auto norm = narrow_dot<Bits>(q, q);
    if (norm == 0) return std::nullopt;
    std::array<Column, 3> columns;
    const auto exact = detail::quaternion_columns<Bits>(q);
    for (std::size_t i = 0; i < 3; ++i) {
      columns[i] =
          make_vec<3>([&](int j) { return quotient_nearest<Component>(exact[i][j], norm); });
    }
    return from_columns(columns);
  }

  /// The same for a unit quaternion, whose squared length fits `Bits`.
  template <int Bits>
  [[nodiscard]] static constexpr Rotation from_unit_quaternion(const Vec<Component, 4>& q) noexcept
      requires(N == 3) {
    const auto exact = [&] { return from_quaternion<Bits>(q).value_or(Rotation()); };
    if constexpr (is_fixed<Component> && has_filters) {
      const auto norm = narrow_dot<Bits>(q, q);
      const auto columns = detail::quaternion_columns<Bits>(q);
      Decided<std::array<Column, 3>> rounded{{}, true};
      for (std::size_t i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
          const auto nearest = decide_unit_quotient<Component>(columns[i][j], norm);
          rounded.value[i][j] = nearest.value;
          rounded.is_sure &= nearest.is_sure;
        }
      }
      return rounded.is_sure ? from_columns(rounded.value) : exact();
    } else {
      return exact();
    }
  }

  /// The rotation by `angle` about `axis`, counter-clockwise if the axis points at the viewer.
  ///
  /// exact:  the rotation about the line through `axis` as stored; components off by less than
  ///         0.5 + 2^-27 of their units                            (tests/math/rotation.test.cpp)
  /// source: Rodrigues' formula
  [[nodiscard]] static constexpr Rotation from_axis_angle(const Axis& axis, Angle<S> angle) noexcept
      requires(N == 3) {
    // cos I + p a a^T + q [a], where p = (1 - cos) / |a|^2 and q = sin / |a| for |a| is nearly 1.
    const auto [sine, cosine] = sine_cosine(angle);
    const auto squared = squared_length(axis);
    const auto p = quotient_nearest<Ratio>(Ratio(1) - cosine, squared);
    const auto q = quotient_nearest<Ratio>(sine, sqrt_floor<Ratio>(squared));
    std::array<Column, 3> columns;
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      Column& column = columns[static_cast<std::size_t>(i)];
      column[i] = nearest_to<Component>(cosine + p * (axis[i] * axis[i]));
      column[j] = nearest_to<Component>(p * (axis[i] * axis[j]) + q * axis[k]);
      column[k] = nearest_to<Component>(p * (axis[i] * axis[k]) - q * axis[j]);
    }
    return from_columns(columns);
  }

  /// The rotation by `x` about the world's x axis, then by `y` about its y axis, then by `z` about
  /// its z axis.
  ///
  /// exact: components off by less than 0.5 + 2^-27 of their units (tests/math/rotation.test.cpp)
  [[nodiscard]] static constexpr Rotation from_euler(Angle<S> x, Angle<S> y, Angle<S> z) noexcept
      requires(N == 3) {
    const auto [sx, cx] = sine_cosine(x);
    const auto [sy, cy] = sine_cosine(y);
    const auto [sz, cz] = sine_cosine(z);
    // Products of three are rounded once in between, to 2^-62.
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
  using Ratio = typename detail::Precise<S>::Ratio;
  using Column = Vec<Component, N>;

  static constexpr Rotation from_columns(
      const std::array<Column, std::size_t{N}>& columns) noexcept {
    Rotation rotation;
    for (std::size_t i = 0; i < N; ++i) rotation.axes_[i] = Axis::assume_unit(columns[i]);
    return rotation;
  }

  template <class X, class Y, class Z>
  static constexpr Column rounded(const X& x, const Y& y, const Z& z) noexcept {
    return {nearest_to<Component>(x), nearest_to<Component>(y), nearest_to<Component>(z)};
  }

  std::array<Axis, std::size_t{N}> axes_;
};

/// Appends to a digest: the axes in order.
template <class D, Scalar S, int N>
constexpr void append(D& digest, const Rotation<S, N>& rotation) noexcept {
  for (int i = 0; i < N; ++i) digest.add(rotation.axis(i));
}

/// Rotates the vector `v` from the local frame into the world.
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

/// Rotates the vector `v` from the world into the local frame.
///
/// result: the inverse of `rotate` if the axes are orthonormal
/// exact:  dot(axis(i), v), rounded to nearest, ties to even, and clamped
///         (tests/math/rotation.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr Vec<S, N> inverse_rotate(const Rotation<S, N>& rotation,
                                                 const Vec<S, N>& v) noexcept {
  return make_vec<N>([&](int i) { return nearest_to<S>(dot(rotation.axis(i), v)); });
}

/// Rotates the direction `d` from the local frame into the world. If the axes are not those of a
/// rotation, the sum may be 0; the result is then `d` itself.
///
/// exact: the direction of the exact sum, each component rounded to nearest
///        (tests/math/transform.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr Direction<S, N> rotate(const Rotation<S, N>& rotation,
                                               const Direction<S, N>& d) noexcept {
  constexpr int bits = detail::cosine_bits<S> + 1;  // at most sqrt(3) (1 + 2^-13)^2
  return direction_of<S>(make_vec<N>([&](int j) {
           const auto row = make_vec<N>([&](int i) { return rotation.axis(i)[j]; });
           return narrow_dot<bits>(row, d.vec());
         }))
      .value_or(d);
}

/// Rotates the direction `d` from the world into the local frame, as exactly as `rotate`.
template <Scalar S, int N>
[[nodiscard]] constexpr Direction<S, N> inverse_rotate(const Rotation<S, N>& rotation,
                                                       const Direction<S, N>& d) noexcept {
  return direction_of<S>(make_vec<N>([&](int i) { return dot(rotation.axis(i), d); })).value_or(d);
}

/// The rotation by `inner`, then by `outer`.
///
/// exact: each axis is that of `inner`, rotated and rounded once    (tests/math/transform.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr Rotation<S, N> compose(const Rotation<S, N>& outer,
                                               const Rotation<S, N>& inner) noexcept {
  std::array<Direction<S, N>, static_cast<std::size_t>(N)> axes;
  for (int i = 0; i < N; ++i) axes[static_cast<std::size_t>(i)] = rotate(outer, inner.axis(i));
  return Rotation<S, N>::from_axes(axes);
}

/// The inverse rotation: the world's axes in the local frame, if the axes are orthonormal.
///
/// exact: each row of the matrix normalised, rounded to nearest     (tests/math/transform.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr Rotation<S, N> inverse(const Rotation<S, N>& rotation) noexcept {
  std::array<Direction<S, N>, static_cast<std::size_t>(N)> axes;
  for (int j = 0; j < N; ++j) {
    const auto row = make_vec<N>([&](int i) { return rotation.axis(i)[j]; });
    axes[static_cast<std::size_t>(j)] = direction_of<S>(row).value_or(Direction<S, N>::along(j));
  }
  return Rotation<S, N>::from_axes(axes);
}

/// The angle of a rotation in the plane, counter-clockwise: the inverse of `from_angle`.
///
/// result: in (-1/2, 1/2] turn
/// exact:  that of axis 0 as stored, rounded to nearest, which is within 2^-29 radians (2^-14 for
///         16-bit scalars) of the argument of `from_angle`         (tests/math/rotation.test.cpp)
template <Scalar S>
[[nodiscard]] constexpr Angle<S> angle_of(const Rotation<S, 2>& rotation) noexcept {
  return Angle<S>::from_raw(atan2(rotation.axis(0)[1], rotation.axis(0)[0]).raw());
}

}  // namespace detent
