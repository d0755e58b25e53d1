// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string_view>

#include "detent/math/angle_between.hpp"
#include "detent/math/inverse.hpp"
#include "detent/math/project.hpp"
#include "detent/math/projection.hpp"
#include "detent/math/slerp.hpp"
#include "detent/math/transform.hpp"
#include "verify/draw/numbers.hpp"
#include "verify/questions/cases.hpp"

// Matrices, quaternions, motions and cameras.

namespace detent::verify {

/// A 63-bit number on the grid of a scalar.
template <Number S>
struct long_of {
  using type = S;
};
template <int Bits, int Frac>
struct long_of<Fixed<Bits, Frac>> {
  using type = Fixed<63, Frac>;
};

/// A matrix; a quarter have small entries, and some are singular.
template <Scalar S, int Size>
[[nodiscard]] constexpr Mat<S, Size, Size> any_matrix(Numbers<S>& numbers) noexcept {
  Mat<S, Size, Size> m;
  const bool small = numbers.random.one_in(4);
  for (int i = 0; i < Size; ++i) {
    for (int j = 0; j < Size; ++j) {
      m(i, j) = small ? numbers.scalar(numbers.random.between(-2, 2)) : numbers.any();
    }
  }
  if (numbers.random.one_in(8)) m.rows[Size - 1] = m.rows[0];
  return m;
}

template <Scalar S, int N>
struct MatrixCase {
  Mat<S, N, N> matrix;

  static constexpr std::array<std::string_view, 1> field_names{"matrix"};
  constexpr auto fields(const auto& f) const noexcept { return f(matrix); }
};

struct Matrices : InDimensions<2, 3> {
  static constexpr std::array<std::string_view, 2> names{"determinant", "inverse"};
  template <Scalar S, int N>
  static constexpr auto draw(Random& random) noexcept {
    Numbers<S> numbers(random);
    return MatrixCase<S, N>{any_matrix<S, N>(numbers)};
  }
  /// A determinant is too wide for a digest, so it is rounded to the grid of the scalar.
  template <int Row, Scalar S, int N>
  [[nodiscard]] static constexpr auto answer(const MatrixCase<S, N>& c) noexcept {
    if constexpr (Row == 0) {
      return nearest_to<typename long_of<S>::type>(determinant(c.matrix));
    } else {
      return inverse(c.matrix);
    }
  }
};

/// A unit quaternion from plain integers: a complex number, and one more in each of its two planes.
template <Scalar S>
[[nodiscard]] constexpr Quat<S> any_quat(Numbers<S>& numbers) noexcept {
  const auto outer = numbers.template any_direction<2>();
  const auto first = numbers.template any_direction<2>();
  const auto second = numbers.template any_direction<2>();
  constexpr auto one = Numbers<S>::one;
  const auto product = [](std::int64_t a, std::int64_t b) {
    const auto size = (magnitude(a) * magnitude(b) + one / 2) / one;
    const auto whole = static_cast<std::int64_t>(size);
    return static_cast<typename Quat<S>::Raw>((a < 0) != (b < 0) ? -whole : whole);
  };
  return Quat<S>::from_raw({product(outer[0], first[0]), product(outer[0], first[1]),
                            product(outer[1], second[0]), product(outer[1], second[1])})
      .value_or(Quat<S>());
}

template <Scalar S, int N>
struct BlendCase {
  Quat<S> p, q;
  S t;
  Vec<S, N> vector;

  static constexpr std::array<std::string_view, 4> field_names{"p", "q", "t", "vector"};
  constexpr auto fields(const auto& f) const noexcept { return f(p, q, t, vector); }
};

/// Quaternions, some of them equal or opposite.
struct Blends : InDimensions<3> {
  static constexpr std::array<std::string_view, 3> names{"quat/compose", "quat/slerp",
                                                         "quat/rotate"};
  template <Scalar S, int N>
  static constexpr auto draw(Random& random) noexcept {
    Numbers<S> numbers(random);
    const auto p = any_quat(numbers);
    auto q = any_quat(numbers);
    if (random.one_in(8)) q = random.coin() ? p : -p;
    const S t = numbers.scalar(random.between(-1, (std::int64_t{1} << S::frac) + 1));
    return BlendCase<S, N>{p, q, t, numbers.vec(numbers.template any_point<N>())};
  }
  template <int Row, Scalar S, int N>
  [[nodiscard]] static constexpr auto answer(const BlendCase<S, N>& c) noexcept {
    if constexpr (Row == 0) {
      return compose(c.p, c.q).vec();
    } else if constexpr (Row == 1) {
      return slerp(c.p, c.q, c.t).vec();
    } else {
      return rotate(c.p, c.vector);
    }
  }
};

template <Scalar S, int N>
struct MotionCase {
  Transform<S, N> transform;
  Vec<S, N> point;

  static constexpr std::array<std::string_view, 2> field_names{"transform", "point"};
  constexpr auto fields(const auto& f) const noexcept { return f(transform, point); }
};

struct Motions : InDimensions<2, 3> {
  static constexpr std::array<std::string_view, 2> names{"transform_point",
                                                         "inverse_transform_point"};
  template <Scalar S, int N>
  static constexpr auto draw(Random& random) noexcept {
    Numbers<S> numbers(random);
    const auto translation = numbers.vec(numbers.template any_point<N>());
    const auto rotation = numbers.template any_rotation<N>();
    const S scale = random.coin() ? S(1) : numbers.any();
    return MotionCase<S, N>{{translation, rotation, scale},
                            numbers.vec(numbers.template any_point<N>())};
  }
  template <int Row, Scalar S, int N>
  [[nodiscard]] static constexpr auto answer(const MotionCase<S, N>& c) noexcept {
    if constexpr (Row == 0) {
      return transform_point(c.transform, c.point);
    } else {
      return inverse_transform_point(c.transform, c.point);
    }
  }
};

template <Scalar S, int N>
struct CameraCase {
  Vec<S, N> eye, target, up;
  Mat<S, N + 1, N + 1> matrix;

  static constexpr std::array<std::string_view, 4> field_names{"eye", "target", "up", "matrix"};
  constexpr auto fields(const auto& f) const noexcept { return f(eye, target, up, matrix); }
};

/// Cameras; for some the target is the eye or the view is along the up vector.
struct Cameras : InDimensions<3> {
  static constexpr std::array<std::string_view, 2> names{"look_at", "project_point"};
  template <Scalar S, int N>
  static constexpr auto draw(Random& random) noexcept {
    Numbers<S> numbers(random);
    auto eye = numbers.template any_point<N>();
    const auto target = numbers.template any_point<N>();
    auto up = numbers.template any_point<N>();
    if (random.one_in(8)) {
      eye = target;
      eye[static_cast<int>(random.below(N))] += random.between(-1, 1);
    }
    if (random.coin()) up = Raw<N>{{0, std::int64_t{1} << S::frac, 0}};
    return CameraCase<S, N>{numbers.vec(eye), numbers.vec(target), numbers.vec(up),
                            any_matrix<S, N + 1>(numbers)};
  }
  template <int Row, Scalar S, int N>
  [[nodiscard]] static constexpr auto answer(const CameraCase<S, N>& c) noexcept {
    if constexpr (Row == 0) {
      return look_at(c.eye, c.target, c.up);
    } else {
      return project_point(c.matrix, c.eye);
    }
  }
};

template <Scalar S, int N>
struct LensCase {
  Angle<S> fov;
  S aspect, near_distance, far_distance;

  static constexpr std::array<std::string_view, 4> field_names{"fov", "aspect", "near_distance",
                                                               "far_distance"};
  constexpr auto fields(const auto& f) const noexcept {
    return f(fov, aspect, near_distance, far_distance);
  }
};

/// Lenses; most of them are valid.
struct Lenses : InDimensions<1> {
  static constexpr std::array<std::string_view, 1> names{"perspective"};
  template <Scalar S, int N>
  static constexpr auto draw(Random& random) noexcept {
    Numbers<S> numbers(random);
    const auto fov = numbers.angle();
    const bool any = random.one_in(8);
    const auto positive = [&] {
      return any ? numbers.any() : numbers.scalar(random.between(1, Numbers<S>::limit - 1));
    };
    const S aspect = positive();
    const S first = positive();
    const S second = positive();
    const bool swaps = !any && second < first;
    return LensCase<S, N>{any ? fov : Angle<S>::from_raw(fov.raw() & 0x7fffffffu), aspect,
                          swaps ? second : first, swaps ? first : second};
  }
  template <int Row, Scalar S, int N>
  [[nodiscard]] static constexpr auto answer(const LensCase<S, N>& c) noexcept {
    return perspective(c.fov, c.aspect, c.near_distance, c.far_distance);
  }
};

template <Scalar S, int N>
struct VectorsCase {
  Vec<S, N> u, v;
  Direction<S, N> normal;
  S t;

  static constexpr std::array<std::string_view, 4> field_names{"u", "v", "normal", "t"};
  constexpr auto fields(const auto& f) const noexcept { return f(u, v, normal, t); }
};

/// Two vectors; some are parallel and some zero.
struct VectorPairs : InDimensions<2, 3> {
  static constexpr std::array<std::string_view, 4> names{"angle_between", "project", "reflect",
                                                         "lerp"};
  template <Scalar S, int N>
  static constexpr auto draw(Random& random) noexcept {
    Numbers<S> numbers(random);
    auto u = numbers.template any_point<N>();
    auto v = numbers.template any_point<N>();
    switch (random.below(8)) {
      case 0:
        for (int i = 0; i < N; ++i) u[i] = random.between(-2, 2);
        break;
      case 1:
        for (int i = 0; i < N; ++i) v[i] = random.between(-2, 2);
        break;
      case 2:
        v = u * random.between(-1, 1);
        break;
      default:
        break;
    }
    const auto normal = numbers.direction(numbers.template any_direction<N>());
    const S t = random.coin() ? numbers.any()
                              : numbers.scalar(random.between(0, std::int64_t{1} << S::frac));
    return VectorsCase<S, N>{numbers.vec(u), numbers.vec(v), normal, t};
  }
  template <int Row, Scalar S, int N>
  [[nodiscard]] static constexpr auto answer(const VectorsCase<S, N>& c) noexcept {
    if constexpr (Row == 0) {
      return angle_between(c.u, c.v).raw();
    } else if constexpr (Row == 1) {
      return project(c.u, c.v);
    } else if constexpr (Row == 2) {
      return reflect(c.u, c.normal);
    } else {
      return lerp(c.u, c.v, c.t);
    }
  }
};

}  // namespace detent::verify
