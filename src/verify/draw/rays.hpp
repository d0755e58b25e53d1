// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/raycast/hit.hpp"
#include "detent/shape/aabb.hpp"
#include "detent/shape/obb.hpp"
#include "detent/shape/plane.hpp"
#include "detent/shape/ray.hpp"
#include "detent/shape/sphere.hpp"
#include "detent/shape/triangle.hpp"
#include "verify/draw/stage.hpp"

namespace detent::verify {

/// A ray and a shape, and which sides of the shape count.
template <Scalar S, int N, class ShapeType>
struct RayCase {
  using Shape = ShapeType;
  Ray<S, N> ray;
  Shape shape;
  Facing facing = Facing::both;
};

/// Draws rays aimed at shapes.
///
/// A shape picks a target on its surface, inside or outside. The ray goes through the target:
/// exactly, along an axis of an exact frame, or nearly, from anywhere.
template <Scalar S, int N>
class RayScene : public Stage<S, N> {
  using Base = Stage<S, N>;
  using Base::begin;
  using Base::center_;
  using Base::corner;
  using Base::extent;
  using Base::extreme_;
  using Base::face_or_part;
  using Base::part;
  using Base::reach_;

 public:
  using Base::limit;
  using Base::one;
  using Base::random;
  using typename Base::Point;
  template <class Shape>
  using Case = RayCase<S, N, Shape>;

  using Base::Base;

  constexpr Case<Sphere<S, N>> draw(Type<Sphere<S, N>>) noexcept {
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
      // A tangent, or off by one unit: the radius is perpendicular to the ray.
      const auto frame = Base::template frame<N>();
      const auto steps = random.between(0, reach_ / frame.norm);
      radius = steps * frame.norm + random.between(-1, 1);
      ray = ray_along(frame, 0, center_ + frame.axes[1] * steps);
    }
    return {ray, {Base::vec(center_), Base::scalar(radius)}};
  }

  constexpr Case<Aabb<S, N>> draw(Type<Aabb<S, N>>) noexcept {
    begin();
    Point half, target = center_;
    for (int i = 0; i < N; ++i) {
      half[i] = extent();
      target[i] += face_or_part(half[i]);
    }
    const auto ray = ray_through(target);
    return {ray, {Base::vec(center_ - half), Base::vec(center_ + half)}};
  }

  constexpr Case<Obb<S, N>> draw(Type<Obb<S, N>>) noexcept {
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

  constexpr Case<Plane<S, N>> draw(Type<Plane<S, N>>) noexcept {
    begin();
    const auto facing = random.one_in(4) ? Facing::front : Facing::both;
    if (random.one_in(4)) {
      // Parallel, and in the plane unless the offset differs by a unit. A plane through the origin
      // contains grid points for every normal; one elsewhere does when its normal is an axis.
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

  constexpr Case<Triangle<S, N>> draw(Type<Triangle<S, N>>) noexcept {
    begin();
    const auto facing = N == 3 && random.one_in(6) ? Facing::front : Facing::both;
    // Corners on a coarse grid relative to the first, so that sixteenths of the edges are exact
    // points.
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
  /// A point in the plane of two edges: a corner, on an edge, inside or outside.
  constexpr Point point_of(const Point& b, const Point& c) noexcept {
    auto s = random.one_in(4) ? 16 * random.between(0, 1) : random.between(-1, 17);
    auto t = random.one_in(4) ? (16 - s) * random.between(0, 1) : random.between(-1, 17 - s);
    Point point;
    for (int i = 0; i < N; ++i) point[i] = (b[i] * s + c[i] * t) / 16;
    return point;
  }

  /// A ray along an axis of a frame, exactly through `target` or away from it.
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

  /// The end of a ray expected to hit after `expected`: beyond it, about there, or before.
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
};

}  // namespace detent::verify
