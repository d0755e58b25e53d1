// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>

#include "detent/math/quat.hpp"
#include "detent/math/transform.hpp"

namespace detent {

/// The motion of a body's frame from one pose to another, over the time from 0 to 1.
///
/// At time t the frame's origin is at (1 - t) start + t end, and its rotation is that of the
/// quaternion (1 - t) p + t q, where p and q are `Quat::from_rotation` of the two rotations and q
/// has the sign of the shorter way (its own if both ways are equally long). So the frame turns
/// about a fixed axis by at most half a turn, fastest in the middle: at most 4 / pi times the mean.
/// In 2D the axis is the z axis.
template <Scalar S, int N>
struct Sweep {
  Vec<S, N> start, end;
  Rotation<S, N> start_rotation{}, end_rotation{};

  [[nodiscard]] friend constexpr bool operator==(const Sweep&, const Sweep&) noexcept = default;
};

/// Appends to a digest: the fields in order.
template <class D, Scalar S, int N>
constexpr void append(D& digest, const Sweep<S, N>& sweep) noexcept {
  digest.add(sweep.start, sweep.end, sweep.start_rotation, sweep.end_rotation);
}

template <Scalar S, int N>
Sweep(Vec<S, N>, Vec<S, N>) -> Sweep<S, N>;
template <Scalar S, int N>
Sweep(Vec<S, N>, Vec<S, N>, Rotation<S, N>, Rotation<S, N>) -> Sweep<S, N>;

namespace detail {

template <Scalar S>
[[nodiscard]] constexpr const Rotation<S, 3>& in_space(const Rotation<S, 3>& rotation) noexcept {
  return rotation;
}
/// Converts a rotation of the plane to one about the z axis, and back.
template <Scalar S>
[[nodiscard]] constexpr Rotation<S, 3> in_space(const Rotation<S, 2>& rotation) noexcept {
  using Axis = Direction<S, 3>;
  const auto lifted = [&](int i) {
    const auto& axis = rotation.axis(i);
    return Axis::assume_unit({axis[0], axis[1], direction_component<S>(0)});
  };
  return Rotation<S, 3>::from_axes({lifted(0), lifted(1), Axis::along(2)});
}
template <int N, Scalar S>
[[nodiscard]] constexpr Rotation<S, N> from_space(const Rotation<S, 3>& rotation) noexcept {
  if constexpr (N == 3) {
    return rotation;
  } else {
    using Axis = Direction<S, 2>;
    const auto flat = [&](int i) {
      return Axis::assume_unit({rotation.axis(i)[0], rotation.axis(i)[1]});
    };
    return Rotation<S, 2>::from_axes({flat(0), flat(1)});
  }
}

/// The rotation of a sweep's frame: by the quaternion (1 - t) start + t end.
template <Scalar S, int N>
class Turn {
 public:
  using Time = direction_component<S>;

  explicit constexpr Turn(const Sweep<S, N>& sweep) noexcept
      : start_(Quat<S>::from_rotation(in_space(sweep.start_rotation))),
        end_(Quat<S>::from_rotation(in_space(sweep.end_rotation))) {
    if (dot(start_, end_) < 0) end_ = -end_;
  }

  /// Whether the rotation is the same at all times; whether it is then the identity.
  [[nodiscard]] constexpr bool is_still() const noexcept { return start_ == end_; }
  [[nodiscard]] constexpr bool is_none() const noexcept {
    return is_still() && start_ == Quat<S>();
  }

  /// The rotation at time t; a point at distance r from the origin is off by less than 2^-28 r
  /// (2^-12 r for 16-bit scalars).
  ///
  /// In units of 2^-30: rounding the quaternion's components moves it by at most 1, so points move
  /// by at most 2 r; rounding the matrix moves them by at most 3 / 2 r.
  [[nodiscard]] constexpr Rotation<S, N> at(const Time& t) const noexcept {
    // Every component is between two that do not exceed 1.
    constexpr int bits = cosine_bits<S>;
    const auto q = make_vec<4>([&](int i) {
      const auto& from = start_.vec()[i];
      return narrow_sum<bits>(from, narrow_product<bits>(end_.vec()[i] - from, t));
    });
    return from_space<N>(to_rotation(Quat<S>::along(q).value_or(start_)));
  }

  /// An upper bound, at most 2, on the curvature of paths in the frame: over a time d, a point at
  /// distance r from the origin deviates by at most r bend() d^2 from uniform motion between its
  /// start and its end.
  ///
  /// The quaternion q moves by v = end - start in a line at distance h from 0, so the frame turns
  /// at the rate w = 2 |v| h / |q|^2. A point at distance r from the axis is accelerated by r
  /// sqrt(w^4 + w'^2) = 4 r |v|^2 h / |q|^3 <= 4 r |v|^2 / |q|^2, and deviates by at most d^2 / 8
  /// of that. With m the lesser of |start|^2 and |end|^2, and c >= 0 their dot product,
  /// |q|^2 >= m - 2 t (1 - t) (m - c) >= min(m, (m + c) / 2).
  [[nodiscard]] constexpr auto bend() const noexcept {
    using Bound = decltype(Time() + Time() + Time());
    const auto v = end_.vec() - start_.vec();
    const auto m = (std::min)(squared_length(start_), squared_length(end_));
    const auto c = dot(start_, end_);
    const auto below = -squared_length(v);  // negative, to round up
    return -quotient_floor<Bound>(below, c < m ? m + c : m + m);
  }

 private:
  Quat<S> start_, end_;
};

}  // namespace detail

/// The pose of a moving frame at time `t`, with scale 1.
///
/// domain: t is clamped to [0, 1]
/// exact:  each coordinate of the translation rounded to nearest, ties to even; the rotation is that
///         of the correctly rounded quaternion, each component rounded to nearest
///         (tests/math/sweep.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr Transform<S, N> transform_at(const Sweep<S, N>& sweep,
                                                     const direction_component<S>& t) noexcept {
  using Time = direction_component<S>;
  const Time time = t < 0 ? Time(0) : t > 1 ? Time(1) : t;
  return {nearest_to<S>(sweep.start + (sweep.end - sweep.start) * time),
          detail::Turn<S, N>(sweep).at(time)};
}

}  // namespace detent
