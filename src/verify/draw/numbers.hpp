// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <iterator>

#include "detent/math/rotation.hpp"
#include "verify/draw/random.hpp"
#include "verify/draw/raw.hpp"

namespace detent::verify {

/// Draws numbers, directions and rotations from the whole domain of a scalar, using integers only.
template <Scalar S>
class Numbers {
 public:
  static constexpr int bits = S::bits;
  static constexpr std::int64_t limit = std::int64_t{1} << bits;
  static constexpr std::int64_t one = std::int64_t{1} << direction_component<S>::frac;

  explicit constexpr Numbers(Random& source) noexcept : random(source) {}

  Random& random;

  static constexpr S scalar(std::int64_t raw) noexcept {
    const auto clamped = raw < -limit ? -limit : raw >= limit ? limit - 1 : raw;
    return S::from_raw(static_cast<typename S::raw_type>(clamped));
  }
  template <int N>
  static constexpr Vec<S, N> vec(const Raw<N>& raw) noexcept {
    Vec<S, N> v;
    for (int i = 0; i < N; ++i) v[i] = scalar(raw[i]);
    return v;
  }
  template <int N>
  static constexpr Direction<S, N> direction(const Raw<N>& raw) noexcept {
    std::array<typename Direction<S, N>::Raw, N> components{};
    for (int i = 0; i < N; ++i) {
      components[static_cast<std::size_t>(i)] = static_cast<typename Direction<S, N>::Raw>(raw[i]);
    }
    return Direction<S, N>::from_raw(components).value_or(Direction<S, N>());
  }

  constexpr S any() noexcept { return scalar(random.edgy(bits)); }

  template <int N>
  constexpr Raw<N> any_point() noexcept {
    Raw<N> point;
    for (int i = 0; i < N; ++i) point[i] = random.edgy(bits);
    return point;
  }

  /// Every kind of direction: often along or close to the axes and diagonals, and some as far from
  /// unit length as a direction may be.
  template <int N>
  constexpr Raw<N> any_direction() noexcept {
    Raw<N> v;
    const auto kind = random.below(8);
    for (int i = 0; i < N; ++i) {
      v[i] = kind == 0   ? random.between(-1, 1)
             : kind == 1 ? random.wide(31)
                         : random.between(-one, one);
    }
    if (kind == 2) v[static_cast<int>(random.below(N))] = 0;
    const auto straight = unit(v, one);
    if (kind != 3) return straight;
    auto bent = straight;
    for (int i = 0; i < N; ++i) bent[i] += random.between(-1, 1);
    return is_direction(bent) ? bent : straight;
  }

  /// A quarter at or next to the multiples of 22.5 degrees, where sine and cosine are special.
  constexpr Angle<S> angle() noexcept {
    const auto turn = static_cast<std::uint32_t>(random.next() >> 32);
    switch (random.below(8)) {
      case 0:
        return Angle<S>::from_raw(turn & 0xf0000000u);
      case 1:
        return Angle<S>::from_raw((turn & 0xf0000000u) + static_cast<std::uint32_t>(turn & 3) - 1);
      default:
        return Angle<S>::from_raw(turn);
    }
  }

  /// A frame whose axes have exact directions, with coordinates and axes permuted and signs random.
  template <int N>
  constexpr Frame<N> frame() noexcept {
    const auto& table = [&]() -> const auto& {
      if constexpr (N == 2) {
        return frames_2d;
      } else {
        return frames_3d;
      }
    }
    ();
    const auto index = random.below(std::size(table));
    const Frame<N>& drawn = table[steps_per_unit(table[index].norm, one) == 0 ? 0 : index];
    const int turn = static_cast<int>(random.below(N));
    Frame<N> frame{{}, drawn.norm};
    for (int i = 0; i < N; ++i) {
      const auto sign = random.sign();
      for (int k = 0; k < N; ++k) frame.axes[k][(i + turn) % N] = drawn.axes[k][i] * sign;
    }
    for (int k = static_cast<int>(random.below(N)); k > 0; --k) {
      const auto first = frame.axes[0];
      for (int i = 0; i + 1 < N; ++i) frame.axes[i] = frame.axes[i + 1];
      frame.axes[N - 1] = first;
    }
    return frame;
  }

  template <int N>
  static constexpr Raw<N> along(const Frame<N>& frame, int axis) noexcept {
    return frame.axes[axis] * steps_per_unit(frame.norm, one);
  }

  /// The axes of a rotation: from a random quaternion (a complex number in 2D), rounded, or
  /// unrelated directions.
  template <int N>
  constexpr Frame<N> axes() noexcept {
    if (!random.one_in(4)) return turned_axes<N>();
    Frame<N> result{{}, 0};
    for (int k = 0; k < N; ++k) result.axes[k] = any_direction<N>();
    return result;
  }
  /// The axes of a rotation.
  template <int N>
  constexpr Frame<N> turned_axes() noexcept {
    Frame<N> result{{}, 0};
    const auto w = random.between(-1000, 1000), x = random.between(-1000, 1000);
    if constexpr (N == 2) {
      result.axes[0] = unit(Raw<2>{{w * w - x * x, 2 * w * x}}, one);
      result.axes[1] = Raw<2>{{-result.axes[0][1], result.axes[0][0]}};
    } else {
      const auto y = random.between(-1000, 1000), z = random.between(-1000, 1000);
      const auto xx = x * x, yy = y * y, zz = z * z, ww = w * w;
      result.axes[0] =
          unit(Raw<3>{{ww + xx - yy - zz, 2 * (x * y + w * z), 2 * (x * z - w * y)}}, one);
      result.axes[1] =
          unit(Raw<3>{{2 * (x * y - w * z), ww - xx + yy - zz, 2 * (y * z + w * x)}}, one);
      result.axes[2] =
          unit(Raw<3>{{2 * (x * z + w * y), 2 * (y * z - w * x), ww - xx - yy + zz}}, one);
    }
    return result;
  }

  template <int N>
  static constexpr Rotation<S, N> rotation(const Frame<N>& unit_axes) noexcept {
    std::array<Direction<S, N>, N> directions;
    for (int k = 0; k < N; ++k) {
      directions[static_cast<std::size_t>(k)] = direction(unit_axes.axes[k]);
    }
    return Rotation<S, N>::from_axes(directions);
  }
  /// The unit axes of an exact frame.
  template <int N>
  static constexpr Frame<N> stretched(const Frame<N>& frame) noexcept {
    Frame<N> result{{}, 0};
    for (int k = 0; k < N; ++k) result.axes[k] = along(frame, k);
    return result;
  }

  template <int N>
  constexpr Rotation<S, N> any_rotation() noexcept {
    return rotation(random.coin() ? stretched(frame<N>()) : axes<N>());
  }

 private:
  template <int N>
  static constexpr bool is_direction(const Raw<N>& v) noexcept {
    return longest(v) <= static_cast<std::uint64_t>(one) &&
           squared(v) >= static_cast<std::uint64_t>((one - 2) * (one - 2)) &&
           squared(v) <= static_cast<std::uint64_t>((one + 2) * (one + 2));
  }
};

}  // namespace detent::verify
