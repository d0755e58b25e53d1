// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

#include "verify/draw/numbers.hpp"
#include "verify/questions/cases.hpp"

namespace detent::verify {

template <Scalar S, int N>
[[nodiscard]] constexpr std::array<Direction<S, N>, N> axes_of(
    const Rotation<S, N>& rotation) noexcept {
  std::array<Direction<S, N>, N> axes;
  for (int i = 0; i < N; ++i) axes[static_cast<std::size_t>(i)] = rotation.axis(i);
  return axes;
}

template <Scalar S, int N>
struct VectorCase {
  Vec<S, N> vector;

  static constexpr std::array<std::string_view, 1> field_names{"vector"};
  constexpr auto fields(const auto& f) const noexcept { return f(vector); }
};

/// Vectors of every length, including zero and multiples of integer unit vectors.
struct Normals : InDimensions<2, 3> {
  static constexpr std::array<std::string_view, 2> names{"normalize", "length"};
  template <Scalar S, int N>
  static constexpr auto draw(Random& random) noexcept {
    Numbers<S> numbers(random);
    Raw<N> v = numbers.template any_point<N>();
    switch (random.below(8)) {
      case 0:
        for (int i = 0; i < N; ++i) v[i] = random.between(-2, 2);
        break;
      case 1: {
        const auto frame = numbers.template frame<N>();
        v = frame.axes[0] * (random.wide(S::bits) / frame.norm);
        break;
      }
      case 2: {
        const int bits = static_cast<int>(random.between(2, S::bits));
        for (int i = 0; i < N; ++i) v[i] = random.wide(bits);
        break;
      }
      default:
        break;
    }
    return VectorCase<S, N>{numbers.vec(v)};
  }
  template <int Row, Scalar S, int N>
  [[nodiscard]] static constexpr auto answer(const VectorCase<S, N>& c) noexcept {
    if constexpr (Row == 0) {
      return normalize(c.vector);
    } else {
      return length(c.vector);
    }
  }
};

template <Scalar S, int N>
struct AngleCase {
  Angle<S> angle;
  S number;

  static constexpr std::array<std::string_view, 2> field_names{"angle", "number"};
  constexpr auto fields(const auto& f) const noexcept { return f(angle, number); }
};

/// Angles, and numbers of degrees or radians.
struct Angles : InDimensions<1> {
  static constexpr std::array<std::string_view, 6> names{
      "sin", "cos", "angle/degrees", "angle/radians", "angle/from_degrees", "angle/from_radians"};
  template <Scalar S, int N>
  static constexpr auto draw(Random& random) noexcept {
    Numbers<S> numbers(random);
    return AngleCase<S, N>{numbers.angle(), numbers.any()};
  }
  template <int Row, Scalar S, int N>
  [[nodiscard]] static constexpr auto answer(const AngleCase<S, N>& c) noexcept {
    if constexpr (Row == 0) {
      return sin(c.angle);
    } else if constexpr (Row == 1) {
      return cos(c.angle);
    } else if constexpr (Row == 2) {
      return c.angle.degrees();
    } else if constexpr (Row == 3) {
      return c.angle.radians();
    } else if constexpr (Row == 4) {
      return Angle<S>::from_degrees(c.number).raw();
    } else {
      return Angle<S>::from_radians(c.number).raw();
    }
  }
};

template <Scalar S, int N>
struct BearingCase {
  S y, x;

  static constexpr std::array<std::string_view, 2> field_names{"y", "x"};
  constexpr auto fields(const auto& f) const noexcept { return f(y, x); }
};

struct Bearings : InDimensions<1> {
  static constexpr std::array<std::string_view, 1> names{"atan2"};
  template <Scalar S, int N>
  static constexpr auto draw(Random& random) noexcept {
    Numbers<S> numbers(random);
    const S y = numbers.any();
    // On and next to the diagonals, where an octant ends.
    const auto beside = static_cast<std::int64_t>(y.raw()) + random.between(-1, 1);
    const S x = random.one_in(8) ? numbers.scalar(beside * random.sign()) : numbers.any();
    return BearingCase<S, N>{y, x};
  }
  template <int Row, Scalar S, int N>
  [[nodiscard]] static constexpr auto answer(const BearingCase<S, N>& c) noexcept {
    return atan2(c.y, c.x).raw();
  }
};

/// The rotation by an angle in the plane.
struct FlatTurns : InDimensions<2> {
  static constexpr std::array<std::string_view, 1> names{"rotation/angle"};
  template <Scalar S, int N>
  static constexpr auto draw(Random& random) noexcept {
    Numbers<S> numbers(random);
    return AngleCase<S, N>{numbers.angle(), S()};
  }
  template <int Row, Scalar S, int N>
  [[nodiscard]] static constexpr auto answer(const AngleCase<S, N>& c) noexcept {
    return axes_of(Rotation<S, N>::from_angle(c.angle));
  }
};

template <Scalar S, int N>
struct TurnCase {
  Direction<S, N> axis;
  Angle<S> angle;

  static constexpr std::array<std::string_view, 2> field_names{"axis", "angle"};
  constexpr auto fields(const auto& f) const noexcept { return f(axis, angle); }
};

struct AxisTurns : InDimensions<3> {
  static constexpr std::array<std::string_view, 1> names{"rotation/axis_angle"};
  template <Scalar S, int N>
  static constexpr auto draw(Random& random) noexcept {
    Numbers<S> numbers(random);
    return TurnCase<S, N>{numbers.direction(numbers.template any_direction<N>()), numbers.angle()};
  }
  template <int Row, Scalar S, int N>
  [[nodiscard]] static constexpr auto answer(const TurnCase<S, N>& c) noexcept {
    return axes_of(Rotation<S, N>::from_axis_angle(c.axis, c.angle));
  }
};

template <Scalar S, int N>
struct QuaternionCase {
  S x, y, z, w;

  static constexpr std::array<std::string_view, 4> field_names{"x", "y", "z", "w"};
  constexpr auto fields(const auto& f) const noexcept { return f(x, y, z, w); }
};

struct Quaternions : InDimensions<3> {
  static constexpr std::array<std::string_view, 1> names{"rotation/quaternion"};
  template <Scalar S, int N>
  static constexpr auto draw(Random& random) noexcept {
    Numbers<S> numbers(random);
    // Small integers give quotients that are ties.
    const bool small = random.one_in(4);
    const auto part = [&] { return small ? numbers.scalar(random.between(-2, 2)) : numbers.any(); };
    return QuaternionCase<S, N>{part(), part(), part(), part()};
  }
  template <int Row, Scalar S, int N>
  [[nodiscard]] static constexpr auto answer(const QuaternionCase<S, N>& c) noexcept {
    using Axes = std::optional<std::array<Direction<S, N>, N>>;
    const auto rotation = Rotation<S, N>::from_quaternion(c.x, c.y, c.z, c.w);
    return rotation ? Axes(axes_of(*rotation)) : Axes();
  }
};

template <Scalar S, int N>
struct EulerCase {
  Angle<S> x, y, z;

  static constexpr std::array<std::string_view, 3> field_names{"x", "y", "z"};
  constexpr auto fields(const auto& f) const noexcept { return f(x, y, z); }
};

struct Eulers : InDimensions<3> {
  static constexpr std::array<std::string_view, 1> names{"rotation/euler"};
  template <Scalar S, int N>
  static constexpr auto draw(Random& random) noexcept {
    Numbers<S> numbers(random);
    return EulerCase<S, N>{numbers.angle(), numbers.angle(), numbers.angle()};
  }
  template <int Row, Scalar S, int N>
  [[nodiscard]] static constexpr auto answer(const EulerCase<S, N>& c) noexcept {
    return axes_of(Rotation<S, N>::from_euler(c.x, c.y, c.z));
  }
};

template <Scalar S, int N>
struct RotateCase {
  Rotation<S, N> rotation;
  Vec<S, N> vector;

  static constexpr std::array<std::string_view, 2> field_names{"", "vector"};
  constexpr auto fields(const auto& f) const noexcept { return f(rotation, vector); }
};

struct Rotations : InDimensions<2, 3> {
  static constexpr std::array<std::string_view, 2> names{"rotate", "inverse_rotate"};
  template <Scalar S, int N>
  static constexpr auto draw(Random& random) noexcept {
    Numbers<S> numbers(random);
    return RotateCase<S, N>{numbers.template any_rotation<N>(),
                            numbers.vec(numbers.template any_point<N>())};
  }
  template <int Row, Scalar S, int N>
  [[nodiscard]] static constexpr auto answer(const RotateCase<S, N>& c) noexcept {
    if constexpr (Row == 0) {
      return rotate(c.rotation, c.vector);
    } else {
      return inverse_rotate(c.rotation, c.vector);
    }
  }
};

}  // namespace detent::verify
