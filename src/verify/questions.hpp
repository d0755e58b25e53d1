// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "detent/detent.hpp"
#include "verify/draw.hpp"

namespace detent::verify {

// A group draws cases of one kind and puts several questions to each; a question is a row of the
// report. A group says
//   names              what the rows are called
//   asks<N>            in which dimensions it asks; a number has one
//   draw<S, N>(random) a case: the arguments of a question
//   answer<Row>(case)  what the library says, as anything that a digest takes
// and for every case type there is `append`, since the questions have a digest too.

template <class D, Scalar S, int N, class Shape>
constexpr void append(D& digest, const RayCase<S, N, Shape>& c) noexcept {
  digest.add(c.ray, c.shape, c.facing == Facing::front);
}
/// Of a rotation, which has no bytes of its own, the axes.
template <class D, Scalar S, int N>
constexpr void append(D& digest, const RayCase<S, N, Obb<S, N>>& c) noexcept {
  digest.add(c.ray, c.shape.center, c.shape.half_extents);
  for (int i = 0; i < N; ++i) digest.add(c.shape.rotation.axis(i));
}

template <Scalar S, int N>
[[nodiscard]] constexpr std::array<Direction<S, N>, N> axes_of(
    const Rotation<S, N>& rotation) noexcept {
  std::array<Direction<S, N>, N> axes;
  for (int i = 0; i < N; ++i) axes[static_cast<std::size_t>(i)] = rotation.axis(i);
  return axes;
}

/// raycast, raycast_hit and raycast_interval against one kind of shape.
template <int Row, class Case>
[[nodiscard]] constexpr auto cast(const Case& c) noexcept {
  constexpr bool has_sides = requires { raycast(c.ray, c.shape, c.facing); };
  if constexpr (Row == 0) {
    if constexpr (has_sides)
      return raycast(c.ray, c.shape, c.facing);
    else
      return raycast(c.ray, c.shape);
  } else if constexpr (Row == 1) {
    if constexpr (has_sides)
      return raycast_hit(c.ray, c.shape, c.facing);
    else
      return raycast_hit(c.ray, c.shape);
  } else {
    if constexpr (has_sides)
      return raycast_interval(c.ray, c.shape, c.facing);
    else
      return raycast_interval(c.ray, c.shape);
  }
}

struct RayGroup {
  template <int N>
  static constexpr bool asks = N >= 2;
  template <int Row, class Case>
  [[nodiscard]] static constexpr auto answer(const Case& c) noexcept {
    return cast<Row>(c);
  }
};

struct Spheres : RayGroup {
  static constexpr std::array<std::string_view, 3> names{"raycast/sphere", "raycast_hit/sphere",
                                                         "raycast_interval/sphere"};
  template <Scalar S, int N>
  static constexpr auto draw(Scene<S, N>& scene) noexcept {
    return scene.sphere();
  }
};
struct Aabbs : RayGroup {
  static constexpr std::array<std::string_view, 3> names{"raycast/aabb", "raycast_hit/aabb",
                                                         "raycast_interval/aabb"};
  template <Scalar S, int N>
  static constexpr auto draw(Scene<S, N>& scene) noexcept {
    return scene.aabb();
  }
};
struct Obbs : RayGroup {
  static constexpr std::array<std::string_view, 3> names{"raycast/obb", "raycast_hit/obb",
                                                         "raycast_interval/obb"};
  template <Scalar S, int N>
  static constexpr auto draw(Scene<S, N>& scene) noexcept {
    return scene.obb();
  }
};
struct Planes : RayGroup {
  static constexpr std::array<std::string_view, 3> names{"raycast/plane", "raycast_hit/plane",
                                                         "raycast_interval/plane"};
  template <Scalar S, int N>
  static constexpr auto draw(Scene<S, N>& scene) noexcept {
    return scene.plane();
  }
};
struct Triangles : RayGroup {
  static constexpr std::array<std::string_view, 3> names{"raycast/triangle", "raycast_hit/triangle",
                                                         "raycast_interval/triangle"};
  template <Scalar S, int N>
  static constexpr auto draw(Scene<S, N>& scene) noexcept {
    return scene.triangle();
  }
};

template <Scalar S, int N>
struct VectorCase {
  Vec<S, N> vector;
};
template <class D, Scalar S, int N>
constexpr void append(D& digest, const VectorCase<S, N>& c) noexcept {
  digest.add(c.vector);
}

/// Vectors of every length, the zero vector and multiples of integer unit vectors among them.
struct Normals {
  static constexpr std::array<std::string_view, 2> names{"normalize", "length"};
  template <int N>
  static constexpr bool asks = N >= 2;
  template <Scalar S, int N>
  static constexpr auto draw(Scene<S, N>& scene) noexcept {
    Raw<N> v = scene.template any_point<N>();
    switch (scene.random.below(8)) {
      case 0:
        for (int i = 0; i < N; ++i) v[i] = scene.random.between(-2, 2);
        break;
      case 1: {
        const auto frame = scene.template frame<N>();
        v = frame.axes[0] * (scene.random.wide(S::bits) / frame.norm);
        break;
      }
      case 2: {
        const int bits = static_cast<int>(scene.random.between(2, S::bits));
        for (int i = 0; i < N; ++i) v[i] = scene.random.wide(bits);
        break;
      }
      default:
        break;
    }
    return VectorCase<S, N>{scene.vec(v)};
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
};
template <class D, Scalar S, int N>
constexpr void append(D& digest, const AngleCase<S, N>& c) noexcept {
  digest.add(c.angle.raw(), c.number);
}

/// Angles, and numbers of degrees or radians.
struct Angles {
  static constexpr std::array<std::string_view, 6> names{
      "sin", "cos", "angle/degrees", "angle/radians", "angle/from_degrees", "angle/from_radians"};
  template <int N>
  static constexpr bool asks = N == 1;
  template <Scalar S, int N>
  static constexpr auto draw(Scene<S, N>& scene) noexcept {
    return AngleCase<S, N>{scene.angle(), scene.any()};
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
struct PointCase {
  S y, x;
};
template <class D, Scalar S, int N>
constexpr void append(D& digest, const PointCase<S, N>& c) noexcept {
  digest.add(c.y, c.x);
}

struct Bearings {
  static constexpr std::array<std::string_view, 1> names{"atan2"};
  template <int N>
  static constexpr bool asks = N == 1;
  template <Scalar S, int N>
  static constexpr auto draw(Scene<S, N>& scene) noexcept {
    const S y = scene.any();
    // On and beside the diagonals, where an octant ends.
    const auto beside = static_cast<std::int64_t>(y.raw()) + scene.random.between(-1, 1);
    const S x = scene.random.one_in(8) ? scene.scalar(beside * scene.random.sign()) : scene.any();
    return PointCase<S, N>{y, x};
  }
  template <int Row, Scalar S, int N>
  [[nodiscard]] static constexpr auto answer(const PointCase<S, N>& c) noexcept {
    return atan2(c.y, c.x).raw();
  }
};

/// The turn by an angle in the plane.
struct FlatTurns {
  static constexpr std::array<std::string_view, 1> names{"rotation/angle"};
  template <int N>
  static constexpr bool asks = N == 2;
  template <Scalar S, int N>
  static constexpr auto draw(Scene<S, N>& scene) noexcept {
    return AngleCase<S, N>{scene.angle(), S()};
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
};
template <class D, Scalar S, int N>
constexpr void append(D& digest, const TurnCase<S, N>& c) noexcept {
  digest.add(c.axis, c.angle.raw());
}

struct AxisTurns {
  static constexpr std::array<std::string_view, 1> names{"rotation/axis_angle"};
  template <int N>
  static constexpr bool asks = N == 3;
  template <Scalar S, int N>
  static constexpr auto draw(Scene<S, N>& scene) noexcept {
    return TurnCase<S, N>{scene.direction(scene.template any_direction<N>()), scene.angle()};
  }
  template <int Row, Scalar S, int N>
  [[nodiscard]] static constexpr auto answer(const TurnCase<S, N>& c) noexcept {
    return axes_of(Rotation<S, N>::from_axis_angle(c.axis, c.angle));
  }
};

template <Scalar S, int N>
struct QuaternionCase {
  S x, y, z, w;
};
template <class D, Scalar S, int N>
constexpr void append(D& digest, const QuaternionCase<S, N>& c) noexcept {
  digest.add(c.x, c.y, c.z, c.w);
}

struct Quaternions {
  static constexpr std::array<std::string_view, 1> names{"rotation/quaternion"};
  template <int N>
  static constexpr bool asks = N == 3;
  template <Scalar S, int N>
  static constexpr auto draw(Scene<S, N>& scene) noexcept {
    // Small integers give quotients that are ties.
    const bool small = scene.random.one_in(4);
    const auto part = [&] {
      return small ? scene.scalar(scene.random.between(-2, 2)) : scene.any();
    };
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
};
template <class D, Scalar S, int N>
constexpr void append(D& digest, const EulerCase<S, N>& c) noexcept {
  digest.add(c.x.raw(), c.y.raw(), c.z.raw());
}

struct Eulers {
  static constexpr std::array<std::string_view, 1> names{"rotation/euler"};
  template <int N>
  static constexpr bool asks = N == 3;
  template <Scalar S, int N>
  static constexpr auto draw(Scene<S, N>& scene) noexcept {
    return EulerCase<S, N>{scene.angle(), scene.angle(), scene.angle()};
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
};
template <class D, Scalar S, int N>
constexpr void append(D& digest, const RotateCase<S, N>& c) noexcept {
  for (int i = 0; i < N; ++i) digest.add(c.rotation.axis(i));
  digest.add(c.vector);
}

struct Rotations {
  static constexpr std::array<std::string_view, 2> names{"rotate", "inverse_rotate"};
  template <int N>
  static constexpr bool asks = N >= 2;
  template <Scalar S, int N>
  static constexpr auto draw(Scene<S, N>& scene) noexcept {
    return RotateCase<S, N>{scene.template any_rotation<N>(),
                            scene.vec(scene.template any_point<N>())};
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

/// A few units on the grid of a product of two numbers, or of four.
template <Number S, int Factors>
struct crumb_of {
  using type = S;
};
template <int Bits, int Frac, int Factors>
struct crumb_of<Fixed<Bits, Frac>, Factors> {
  using type = Fixed<4, Frac * Factors>;
};

template <Scalar S, int N>
struct RootCase {
  S a, b;
  typename crumb_of<S, 2>::type beside_square;
  typename crumb_of<S, 4>::type beside_fourth_power;
};
template <class D, Scalar S, int N>
constexpr void append(D& digest, const RootCase<S, N>& c) noexcept {
  digest.add(c.a, c.b, c.beside_square, c.beside_fourth_power);
}

/// Roots of 64 and of 128 bits, on and just beside squares as often as anywhere.
struct Roots {
  static constexpr std::array<std::string_view, 2> names{"sqrt_floor", "sqrt_floor/wide"};
  template <int N>
  static constexpr bool asks = N == 1;
  template <Scalar S, int N>
  static constexpr auto draw(Scene<S, N>& scene) noexcept {
    using Square = typename crumb_of<S, 2>::type;
    using Fourth = typename crumb_of<S, 4>::type;
    const S a = scene.any();
    const S b = scene.random.coin() ? a : scene.any();
    const auto near = static_cast<typename Square::raw_type>(scene.random.between(-2, 2));
    return RootCase<S, N>{a, b, Square::from_raw(near), Fourth::from_raw(near)};
  }
  template <int Row, Scalar S, int N>
  [[nodiscard]] static constexpr auto answer(const RootCase<S, N>& c) noexcept {
    if constexpr (Row == 0) {
      return sqrt_floor<S>(c.a * c.b + c.beside_square);
    } else {
      const auto product = c.a * c.b;
      return sqrt_floor<decltype(c.a * c.b)>(product * product + c.beside_fourth_power);
    }
  }
};

template <Scalar S, int N>
struct QuotientCase {
  S a, b, c, d;
};
template <class D, Scalar S, int N>
constexpr void append(D& digest, const QuotientCase<S, N>& c) noexcept {
  digest.add(c.a, c.b, c.c, c.d);
}

/// Quotients of numbers and of products of three by products of two, division by 0 included.
struct Quotients {
  static constexpr std::array<std::string_view, 4> names{
      "quotient_floor", "quotient_floor/wide", "quotient_nearest", "quotient_nearest/wide"};
  template <int N>
  static constexpr bool asks = N == 1;
  template <Scalar S, int N>
  static constexpr auto draw(Scene<S, N>& scene) noexcept {
    return QuotientCase<S, N>{scene.any(), scene.any(), scene.any(), scene.any()};
  }
  template <int Row, Scalar S, int N>
  [[nodiscard]] static constexpr auto answer(const QuotientCase<S, N>& c) noexcept {
    if constexpr (Row == 0) {
      return quotient_floor<S>(c.a, c.b);
    } else if constexpr (Row == 1) {
      return quotient_floor<S>(c.a * c.b * c.c, c.d * c.c);
    } else if constexpr (Row == 2) {
      return quotient_nearest<S>(c.a, c.b);
    } else {
      return quotient_nearest<S>(c.a * c.b * c.c, c.d * c.a);
    }
  }
};

struct Text {
  static constexpr int capacity = 40;
  std::array<char, capacity> characters{};
  int length = 0;

  constexpr void add(char c) noexcept {
    if (length < capacity) characters[static_cast<std::size_t>(length++)] = c;
  }
  [[nodiscard]] constexpr std::string_view view() const noexcept {
    return {characters.data(), static_cast<std::size_t>(length)};
  }
};
/// Characters as ASCII bytes, after their number: `char` is signed on one machine and not on
/// another, and the same byte on both.
template <class D>
constexpr void append(D& digest, const Text& text) noexcept {
  digest.add(static_cast<std::uint8_t>(text.length));
  for (const char c : text.view()) digest.add(static_cast<std::uint8_t>(c));
}

template <Scalar S, int N>
struct TextCase {
  Text text;
  S number;
};
template <class D, Scalar S, int N>
constexpr void append(D& digest, const TextCase<S, N>& c) noexcept {
  digest.add(c.text, c.number);
}

/// Decimals in every spelling, malformed and out of range ones too; and numbers to be spelt.
struct Texts {
  static constexpr std::array<std::string_view, 2> names{"parse", "to_chars"};
  template <int N>
  static constexpr bool asks = N == 1;
  template <Scalar S, int N>
  static constexpr auto draw(Scene<S, N>& scene) noexcept {
    auto& random = scene.random;
    Text text;
    const auto digits = [&](std::int64_t most) {
      const auto count = random.between(0, most);
      const auto kind = random.below(8);
      for (std::int64_t i = 0; i < count; ++i) {
        text.add(static_cast<char>('0' + (kind == 0   ? 9
                                          : kind == 1 ? 0
                                                      : static_cast<int>(random.below(10)))));
      }
    };
    const auto sign = random.below(8);
    if (sign < 4) text.add(sign == 0 ? '+' : '-');
    digits((S::bits - S::frac) * 3 / 10 + 1);
    if (!random.one_in(8)) {
      text.add('.');
      digits(S::frac + 2);
    }
    if (random.one_in(8)) {
      text.add(random.coin() ? 'e' : 'E');
      if (random.coin()) text.add(random.coin() ? '-' : '+');
      text.add(static_cast<char>('0' + static_cast<int>(random.below(10))));
    }
    if (random.one_in(16)) text.add("+-.e x0"[random.below(7)]);
    return TextCase<S, N>{text, scene.any()};
  }
  template <int Row, Scalar S, int N>
  [[nodiscard]] static constexpr auto answer(const TextCase<S, N>& c) noexcept {
    if constexpr (Row == 0) {
      return S::parse(c.text.view());
    } else {
      Text text;
      char* const first = text.characters.data();
      text.length = static_cast<int>(to_chars(first, first + Text::capacity, c.number) - first);
      return text;
    }
  }
};

}  // namespace detent::verify
