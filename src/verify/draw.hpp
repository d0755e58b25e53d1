// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <iterator>

#include "detent/math/rotation.hpp"
#include "detent/query/raycast/hit.hpp"
#include "detent/shape/aabb.hpp"
#include "detent/shape/obb.hpp"
#include "detent/shape/plane.hpp"
#include "detent/shape/ray.hpp"
#include "detent/shape/sphere.hpp"
#include "detent/shape/triangle.hpp"
#include "verify/random.hpp"
#include "verify/raw.hpp"

namespace detent::verify {

/// Numbers, directions and rotations from the whole domain of a scalar, made with integers alone.
template <Scalar S>
class Numbers {
 public:
  static constexpr int bits = S::bits;
  static constexpr std::int64_t limit = std::int64_t{1} << bits;
  static constexpr std::int64_t one = std::int64_t{1} << direction_component<S>::frac;

  explicit constexpr Numbers(std::uint64_t seed) noexcept : random(seed) {}

  Random random;

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

  /// Every direction, along the axes and diagonals and close to them often enough, some of them as
  /// far from unit length as a direction may be.
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

  /// A quarter of them where sine and cosine are special: at the multiples of 22.5 degrees.
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

  /// A frame whose axes have exact directions, its coordinates and axes in any order and of any
  /// sign.
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

  /// The axes of a rotation: of a random quaternion (a complex number in 2D), rounded, or
  /// directions that have nothing to do with one another.
  template <int N>
  constexpr Frame<N> axes() noexcept {
    Frame<N> result{{}, 0};
    if (random.one_in(4)) {
      for (int k = 0; k < N; ++k) result.axes[k] = any_direction<N>();
      return result;
    }
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

/// A ray and a shape in one of its ways.
template <Scalar S, int N, class ShapeType>
struct RayCase {
  using Shape = ShapeType;
  Ray<S, N> ray;
  Shape shape;
  Facing facing = Facing::both;
};

/// Rays aimed at shapes.
///
/// One case takes place at a scale from a few raw units to the whole range, anywhere in the world;
/// one in eight is made of extreme numbers instead. A shape chooses a point to aim at, on its
/// surface, inside or outside, and the ray goes through that point: exactly, along an axis of an
/// exact frame, or nearly, from anywhere.
template <Scalar S, int N>
class Scene : public Numbers<S> {
  using Base = Numbers<S>;

 public:
  using Base::limit;
  using Base::one;
  using Base::random;
  using Point = Raw<N>;
  template <class Shape>
  using Case = RayCase<S, N, Shape>;

  using Base::Base;

  constexpr Case<Sphere<S, N>> sphere() noexcept {
    begin();
    auto radius = extent();
    auto target = center_;
    for (int i = 0; i < N; ++i) target[i] += part(radius, 20);
    if (random.one_in(8)) {  // a pole, where the ray may end
      target = center_;
      target[static_cast<int>(random.below(N))] += random.coin() ? radius : -radius;
    }
    auto ray = ray_through(target);
    if (!extreme_ && random.one_in(4)) {
      // A tangent, or one beside it: the radius stands at a right angle on the ray.
      const auto frame = Base::template frame<N>();
      const auto steps = random.between(0, reach_ / frame.norm);
      radius = steps * frame.norm + random.between(-1, 1);
      ray = ray_along(frame, 0, center_ + frame.axes[1] * steps);
    }
    return {ray, {Base::vec(center_), Base::scalar(radius)}};
  }

  constexpr Case<Aabb<S, N>> aabb() noexcept {
    begin();
    Point half, target = center_;
    for (int i = 0; i < N; ++i) {
      half[i] = extent();
      target[i] += face_or_part(half[i]);
    }
    const auto ray = ray_through(target);
    return {ray, {Base::vec(center_ - half), Base::vec(center_ + half)}};
  }

  constexpr Case<Obb<S, N>> obb() noexcept {
    begin();
    Point half, target = center_;
    if (!extreme_ && random.coin()) {
      const auto frame = Base::template frame<N>();
      for (int k = 0; k < N; ++k) {
        const auto steps = random.between(-reach_, reach_) / frame.norm;
        target += frame.axes[k] * steps;
        half[k] = static_cast<std::int64_t>(magnitude(steps)) * frame.norm;
        if (random.coin()) half[k] += random.coin() ? extent() : random.between(-1, 1);
      }
      const auto ray = random.coin() ? ray_along(frame, static_cast<int>(random.below(N)), target)
                                     : ray_through(target);
      return {ray, {Base::vec(center_), Base::vec(half), Base::rotation(Base::stretched(frame))}};
    }
    const auto axes = Base::template axes<N>();
    for (int k = 0; k < N; ++k) {
      half[k] = extent();
      const auto steps = face_or_part(half[k]);
      for (int i = 0; i < N; ++i) target[i] += axes.axes[k][i] * steps / one;
    }
    const auto ray = ray_through(target);
    return {ray, {Base::vec(center_), Base::vec(half), Base::rotation(axes)}};
  }

  constexpr Case<Plane<S, N>> plane() noexcept {
    begin();
    const auto facing = random.one_in(4) ? Facing::front : Facing::both;
    if (random.one_in(4)) {
      // Parallel, and in the plane unless an offset of one unit says otherwise: a plane through the
      // origin has points on it whatever its normal is, another one where its normal is an axis.
      const auto frame = Base::template frame<N>();
      const auto steps = random.between(-reach_, reach_) / frame.norm;
      const auto height = frame.norm == 1 ? random.edgy(Base::bits) : 0;
      const auto origin = frame.axes[1] * steps + frame.axes[0] * height;
      const auto offset = height + (random.coin() ? 0 : random.between(-2, 2));
      return {ray_along(frame, N - 1, origin),
              {Base::direction(Base::along(frame, 0)), Base::scalar(offset)},
              facing};
    }
    const auto normal = random.coin() ? Base::along(Base::template frame<N>(), 0)
                                      : Base::template any_direction<N>();
    std::int64_t height = one / 2;  // at most |normal| |center| < 2^62
    for (int i = 0; i < N; ++i) height += normal[i] * center_[i];
    const auto offset = extreme_ ? random.edgy(Base::bits) : height >> direction_component<S>::frac;
    const auto ray = ray_through(center_);
    return {ray, {Base::direction(normal), Base::scalar(offset)}, facing};
  }

  constexpr Case<Triangle<S, N>> triangle() noexcept {
    begin();
    const auto facing = N == 3 && random.one_in(6) ? Facing::front : Facing::both;
    // Corners on a coarse grid about the first make sixteenths of the edges exact points.
    const std::int64_t grid = random.coin() ? 1 : reach_ >= 16 ? 16 : 1;
    const auto frame = Base::template frame<N>();
    const bool flat = !extreme_ && random.one_in(4);  // in one plane with a ray along the frame
    const auto edge = [&] {
      if (!flat) return corner(reach_ / grid) * grid;
      const auto far = reach_ / frame.norm / 2;
      const auto along = random.between(-far, far), across = random.between(-far, far);
      return frame.axes[0] * along + frame.axes[1] * across;
    };
    const auto to_b = edge();
    auto to_c = edge();
    if (random.one_in(16)) to_c = to_b * random.between(-1, 2);
    const auto a = extreme_ ? Base::template any_point<N>() : center_;
    auto b = a + to_b, c = a + to_c;
    if (extreme_ && random.coin()) b = Base::template any_point<N>();
    if (extreme_ && random.coin()) c = Base::template any_point<N>();
    const auto target = a + point_of(b - a, c - a);
    const auto ray = flat && random.coin() ? ray_along(frame, 0, target) : ray_through(target);
    return {ray, {Base::vec(a), Base::vec(b), Base::vec(c)}, facing};
  }

 private:
  constexpr void begin() noexcept {
    extreme_ = random.one_in(8);
    const int size = static_cast<int>(random.between(2, Base::bits - 1));
    reach_ = std::int64_t{1} << size;
    const auto room = limit - 4 * reach_;
    for (int i = 0; i < N; ++i) {
      const auto place = random.wide(Base::bits);
      center_[i] = extreme_        ? random.edgy(Base::bits)
                   : room <= 0     ? 0
                   : place > room  ? room
                   : place < -room ? -room
                                   : place;
    }
  }

  constexpr Point corner(std::int64_t far) noexcept {
    Point point;
    for (int i = 0; i < N; ++i) point[i] = random.between(-far, far);
    return point;
  }

  /// A radius or half extent, sometimes nothing and sometimes negative.
  constexpr std::int64_t extent() noexcept {
    if (random.one_in(32)) return random.between(-2, 0);
    return extreme_ ? static_cast<std::int64_t>(magnitude(random.edgy(Base::bits)))
                    : random.between(0, reach_);
  }
  /// Up to `sixteenths` of `length` either way.
  constexpr std::int64_t part(std::int64_t length, std::int64_t sixteenths) noexcept {
    const auto far = length * sixteenths / 16;
    return random.between(-far, far);
  }
  /// Inside, outside or exactly at the end of an extent, or one unit beside it.
  constexpr std::int64_t face_or_part(std::int64_t half) noexcept {
    switch (random.below(8)) {
      case 0:
      case 1:
        return half * random.sign();
      case 2: {
        const auto beside = random.between(-1, 1);
        return half * random.sign() + beside;
      }
      default:
        return part(half, 20);
    }
  }
  /// A point of the plane of two edges: a corner, on an edge, inside or outside.
  constexpr Point point_of(const Point& b, const Point& c) noexcept {
    auto s = random.one_in(4) ? 16 * random.between(0, 1) : random.between(-1, 17);
    auto t = random.one_in(4) ? (16 - s) * random.between(0, 1) : random.between(-1, 17 - s);
    Point point;
    for (int i = 0; i < N; ++i) point[i] = (b[i] * s + c[i] * t) / 16;
    return point;
  }

  /// The ray along an axis of a frame that goes through `target` exactly, or away from it.
  constexpr Ray<S, N> ray_along(const Frame<N>& frame, int axis, const Point& target) noexcept {
    const auto far = 2 * reach_ / frame.norm;
    const auto steps = random.between(-far / 8, far);
    const auto sign = random.sign();
    return {Base::vec(target - frame.axes[axis] * (sign * steps)),
            Base::direction(Base::along(frame, axis) * sign), end(steps * frame.norm)};
  }

  constexpr Ray<S, N> ray_through(const Point& target) noexcept {
    switch (random.below(8)) {
      case 0:
      case 1:
        return ray_along(Base::template frame<N>(), 0, target);
      case 2:
        return {Base::vec(target), Base::direction(Base::template any_direction<N>()), end(0)};
      case 3: {
        const auto origin = somewhere();
        return {Base::vec(origin), Base::direction(Base::template any_direction<N>()),
                end(4 * reach_)};
      }
      default: {
        const auto origin = somewhere();
        const auto path = target - origin;
        return {Base::vec(origin), Base::direction(unit(path, one)), end(length(path))};
      }
    }
  }
  constexpr Point somewhere() noexcept {
    return extreme_ ? Base::template any_point<N>() : center_ + corner(3 * reach_);
  }

  /// Where a ray ends that should meet something after `expected`: beyond, about there, or before.
  constexpr S end(std::int64_t expected) noexcept {
    switch (random.below(16)) {
      case 0:
      case 1:
      case 2:
        return Base::scalar(expected + random.between(-1, 1));
      case 3:
        return Base::scalar(random.between(0, 4 * reach_));
      case 4:
        return Base::scalar(random.coin() ? random.between(-1, 1) : random.edgy(Base::bits));
      default:
        return largest<S>;
    }
  }

  bool extreme_ = false;
  std::int64_t reach_ = 1;
  Point center_{};
};

}  // namespace detent::verify
