// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>

#include "detent/math/rotation.hpp"
#include "detent/number/arc.hpp"

namespace detent {

/// A rotation in space as a unit quaternion w + x i + y j + z k: four numbers instead of a
/// `Rotation`'s nine, and the form to blend rotations. `q` and `-q` are the same rotation.
///
/// Components are those of a `Direction`: Q2.30 for 32-bit scalars (Q2.14 for 16-bit ones), and the
/// length is 1 within 2^-29 (2^-13). Every function uses the quaternion exactly as stored; its
/// rotation is that of the unit quaternion along it.
template <Scalar S>
class Quat {
 public:
  using Component = direction_component<S>;
  using Raw = typename raw_of<Component>::type;

  /// The identity.
  constexpr Quat() noexcept { xyzw_.w = Component(1); }

  /// The quaternion with the raw components x, y, z, w, or nothing if they do not form a unit
  /// quaternion.
  [[nodiscard]] static constexpr std::optional<Quat> from_raw(
      const std::array<Raw, 4>& raw) noexcept {
    const auto components = detail::from_raw<Component>(raw);
    if (!is_unit(components)) return std::nullopt;
    return Quat(from_array(components));
  }

  /// The quaternion with the components x, y, z, w. The caller must know that they form a unit
  /// quaternion.
  [[nodiscard]] static constexpr Quat assume_unit(const Vec<Component, 4>& xyzw) noexcept {
    DETENT_ASSERT(!is_fixed<Component> || is_unit(to_array(xyzw)));
    return Quat(xyzw);
  }

  /// The unit quaternion along x i + y j + z k + w, or nothing for 0.
  ///
  /// exact: each component rounded to nearest; ties do not occur       (tests/math/quat.test.cpp)
  [[nodiscard]] static constexpr std::optional<Quat> normalize(S x, S y, S z, S w) noexcept {
    return along(Vec<S, 4>{x, y, z, w});
  }
  /// The same for a vector of any number type.
  template <Number T>
  [[nodiscard]] static constexpr std::optional<Quat> along(const Vec<T, 4>& xyzw) noexcept {
    const auto unit = unit_vector<Component>(to_array(xyzw));
    if (!unit) return std::nullopt;
    return assume_unit(from_array(*unit));
  }

  /// The rotation by `angle` about `axis`, counter-clockwise if the axis points at the viewer.
  ///
  /// result: w is not negative
  /// exact:  components off by less than 0.5 + 2^-27 of their units    (tests/math/quat.test.cpp)
  [[nodiscard]] static constexpr Quat from_axis_angle(const Direction<S, 3>& axis,
                                                      Angle<S> angle) noexcept {
    const auto [sine, cosine] = half_sine_cosine(angle);
    const auto ratio = quotient_nearest<Ratio>(sine, sqrt_floor<Ratio>(squared_length(axis)));
    return assume_unit({nearest_to<Component>(ratio * axis[0]),
                        nearest_to<Component>(ratio * axis[1]),
                        nearest_to<Component>(ratio * axis[2]), nearest_to<Component>(cosine)});
  }

  /// The rotation by `x` about the world's x axis, then by `y` about its y axis, then by `z` about
  /// its z axis, like `Rotation::from_euler`.
  ///
  /// exact: components off by less than 0.5 + 2^-27 of their units    (tests/math/quat.test.cpp)
  [[nodiscard]] static constexpr Quat from_euler(Angle<S> x, Angle<S> y, Angle<S> z) noexcept {
    const auto [sx, cx] = half_sine_cosine(x);
    const auto [sy, cy] = half_sine_cosine(y);
    const auto [sz, cz] = half_sine_cosine(z);
    // Products of three are rounded once in between, to 2^-62.
    const auto ss = nearest_to<Sine>(sx * sy), sc = nearest_to<Sine>(sx * cy);
    const auto cs = nearest_to<Sine>(cx * sy), cc = nearest_to<Sine>(cx * cy);
    return assume_unit(
        {nearest_to<Component>(sc * cz - cs * sz), nearest_to<Component>(cs * cz + sc * sz),
         nearest_to<Component>(cc * sz - ss * cz), nearest_to<Component>(cc * cz + ss * sz)});
  }

  /// The quaternion of a rotation, with the sign that makes the first non-zero component in the
  /// order w, x, y, z positive.
  ///
  /// domain: every frame; a shearing or mirroring one gives some rotation too
  /// exact:  the longest row of 4 q q^T, computed from the axes, normalised with correct rounding;
  ///         if the axes are those of a rotation, correctly rounded, components are off by less
  ///         than 1.5 of their units                                     (tests/math/quat.test.cpp)
  /// source: Shepperd, Quaternion from Rotation Matrix (1978)
  [[nodiscard]] static constexpr Quat from_rotation(const Rotation<S, 3>& rotation) noexcept {
    const auto m = [&](int row, int column) { return rotation.axis(column)[row]; };
    using Entry = decltype((Component(1) + m(0, 0)) + (m(1, 1) + m(2, 2)));
    const Entry yz = m(2, 1) - m(1, 2), zx = m(0, 2) - m(2, 0), xy = m(1, 0) - m(0, 1);
    const Entry y_z = m(2, 1) + m(1, 2), z_x = m(0, 2) + m(2, 0), x_y = m(1, 0) + m(0, 1);
    const auto square = [&](int i, int j, int k) -> Entry {
      return (Component(1) + m(i, i)) - (m(j, j) + m(k, k));
    };
    const std::array<Vec<Entry, 4>, 4> rows = {
        Vec{square(0, 1, 2), x_y, z_x, yz}, Vec{x_y, square(1, 2, 0), y_z, zx},
        Vec{z_x, y_z, square(2, 0, 1), xy},
        Vec{yz, zx, xy, Entry((Component(1) + m(0, 0)) + (m(1, 1) + m(2, 2)))}};
    // The squares on the diagonal sum to 4, so the greatest is not 0. The row is 4 q_i long, at
    // least 2, and its components are off by 1.5 or 1 units: 0.94 of a unit after normalising.
    int longest = 3;
    for (int i = 0; i < 3; ++i) {
      const auto at = [&](int k) { return rows[static_cast<std::size_t>(k)][k]; };
      if (at(i) > at(longest)) longest = i;
    }
    const auto q = along(rows[static_cast<std::size_t>(longest)]).value_or(Quat());
    for (const int i : {3, 0, 1, 2}) {
      if (q.xyzw_[i] != 0) return q.xyzw_[i] < 0 ? -q : q;
    }
    return q;
  }

  /// The component of i; `y`, `z` and `w` belong to j, k and 1.
  [[nodiscard]] constexpr Component x() const noexcept { return xyzw_.x; }
  [[nodiscard]] constexpr Component y() const noexcept { return xyzw_.y; }
  [[nodiscard]] constexpr Component z() const noexcept { return xyzw_.z; }
  [[nodiscard]] constexpr Component w() const noexcept { return xyzw_.w; }

  /// The components x, y, z, w as a vector.
  [[nodiscard]] constexpr const Vec<Component, 4>& vec() const noexcept { return xyzw_; }

  /// The same rotation, with the other sign.
  [[nodiscard]] constexpr Quat operator-() const noexcept { return Quat(narrow_negative(xyzw_)); }

  [[nodiscard]] friend constexpr bool operator==(const Quat&, const Quat&) noexcept = default;

 private:
  using Sine = typename detail::Precise<S>::Sine;
  using Ratio = typename detail::Precise<S>::Ratio;

  explicit constexpr Quat(const Vec<Component, 4>& xyzw) noexcept : xyzw_(xyzw) {}

  Vec<Component, 4> xyzw_;
};

/// Appends to a digest: x, y, z, w.
template <class D, Scalar S>
constexpr void append(D& digest, const Quat<S>& q) noexcept {
  digest.add(q.vec());
}

/// The cosine of half the angle between two rotations, exactly. Its sign says whether the
/// quaternions are on the same side.
template <Scalar S>
[[nodiscard]] constexpr auto dot(const Quat<S>& p, const Quat<S>& q) noexcept {
  return narrow_dot<detail::cosine_bits<S>>(p.vec(), q.vec());
}

/// The squared length, exactly: 1 up to the rounding of the components.
template <Scalar S>
[[nodiscard]] constexpr auto squared_length(const Quat<S>& q) noexcept {
  return dot(q, q);
}

/// The inverse rotation, exactly.
template <Scalar S>
[[nodiscard]] constexpr Quat<S> conjugate(const Quat<S>& q) noexcept {
  const auto opposite = (-q).vec();
  return Quat<S>::assume_unit({opposite.x, opposite.y, opposite.z, q.w()});
}

/// The rotation by `inner`, then by `outer`: the product of the quaternions.
///
/// exact: each component of the unit quaternion along the exact product, rounded to nearest, so
///        lengths do not drift                                         (tests/math/quat.test.cpp)
template <Scalar S>
[[nodiscard]] constexpr Quat<S> compose(const Quat<S>& outer, const Quat<S>& inner) noexcept {
  const auto p = outer.vec(), n = (-outer).vec();
  const auto row = [&](const auto& x, const auto& y, const auto& z, const auto& w) {
    // |p| |q| < 2
    return narrow_dot<detail::cosine_bits<S>>(Vec{x, y, z, w}, inner.vec());
  };
  return Quat<S>::along(Vec{row(p.w, n.z, p.y, p.x), row(p.z, p.w, n.x, p.y),
                            row(n.y, p.x, p.w, p.z), row(n.x, n.y, n.z, p.w)})
      .value_or(outer);
}

/// The rotation as a frame.
///
/// exact: each component rounded to nearest, ties to even               (tests/math/quat.test.cpp)
template <Scalar S>
[[nodiscard]] constexpr Rotation<S, 3> to_rotation(const Quat<S>& q) noexcept {
  return Rotation<S, 3>::template from_unit_quaternion<detail::cosine_bits<S>>(q.vec());
}

/// Rotates the vector `v` from the local frame into the world.
///
/// exact: each component of the rotated vector rounded to nearest, ties to even, and clamped
///        (tests/math/quat.test.cpp)
template <Scalar S>
[[nodiscard]] constexpr Vec<S, 3> rotate(const Quat<S>& q, const Vec<S, 3>& v) noexcept {
  const auto columns = detail::quaternion_columns<detail::cosine_bits<S>>(q.vec());
  constexpr int bits = bits_of<S> + detail::cosine_bits<S> + 1;  // sqrt(3) 2^B |q|^2
  return make_vec<3>([&](int j) {
    const Vec row{columns[0][j], columns[1][j], columns[2][j]};
    return quotient_nearest<S>(narrow_dot<bits>(row, v), squared_length(q));
  });
}

/// Rotates the direction `d` from the local frame into the world.
///
/// exact: each component of the rotated direction, normalised, rounded to nearest
///        (tests/math/quat.test.cpp)
template <Scalar S>
[[nodiscard]] constexpr Direction<S, 3> rotate(const Quat<S>& q,
                                               const Direction<S, 3>& d) noexcept {
  const auto columns = detail::quaternion_columns<detail::cosine_bits<S>>(q.vec());
  constexpr int bits = detail::cosine_bits<S> + bits_of<direction_component<S>>;  // |q|^2 |d|
  return direction_of<S>(make_vec<3>([&](int j) {
           return narrow_dot<bits>(Vec{columns[0][j], columns[1][j], columns[2][j]}, d.vec());
         }))
      .value_or(d);
}

/// Rotates the vector or direction `v` from the world into the local frame, as exactly as `rotate`.
template <Scalar S>
[[nodiscard]] constexpr Vec<S, 3> inverse_rotate(const Quat<S>& q, const Vec<S, 3>& v) noexcept {
  return rotate(conjugate(q), v);
}
template <Scalar S>
[[nodiscard]] constexpr Direction<S, 3> inverse_rotate(const Quat<S>& q,
                                                       const Direction<S, 3>& v) noexcept {
  return rotate(conjugate(q), v);
}

/// The angle of the rotation about `axis_of(q)`, in [0, 1) turn.
///
/// exact: off by less than 0.5 + 2^-28 units of 2^-32 turn               (tests/math/quat.test.cpp)
template <Scalar S>
[[nodiscard]] constexpr Angle<S> angle_of(const Quat<S>& q) noexcept {
  const Vec imaginary{q.x(), q.y(), q.z()};
  const auto squared = narrow_dot<detail::cosine_bits<S>>(imaginary, imaginary);
  return angle_of_arc<S>(squared, q.w(), 2);
}

/// The axis of the rotation, or nothing if it does not rotate.
///
/// exact: each component rounded to nearest                              (tests/math/quat.test.cpp)
template <Scalar S>
[[nodiscard]] constexpr std::optional<Direction<S, 3>> axis_of(const Quat<S>& q) noexcept {
  return direction_of<S>(Vec{q.x(), q.y(), q.z()});
}

}  // namespace detent
