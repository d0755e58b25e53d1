// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "detent/math/direction.hpp"
#include "detent/shape/fields.hpp"

namespace detent {

/// The points origin + t * direction with 0 <= t <= max_distance, with the direction exactly as
/// stored; none if `max_distance` is negative.
template <Scalar S, int N>
struct Ray {
  Vec<S, N> origin;
  Direction<S, N> direction;
  S max_distance = largest<S>;

  [[nodiscard]] friend constexpr bool operator==(const Ray&, const Ray&) noexcept = default;
};

template <Scalar S, int N>
struct detail::ShapeFields<Ray<S, N>> {
  static constexpr std::string_view name = "ray", names[] = {"origin", "direction", "max_distance"};

  template <class Self, class F>
  static constexpr auto of(Self& ray, const F& f) {
    return f(ray.origin, ray.direction, ray.max_distance);
  }
};

template <Scalar S, int N>
Ray(Vec<S, N>, Direction<S, N>, S) -> Ray<S, N>;
template <Scalar S, int N>
Ray(Vec<S, N>, Direction<S, N>) -> Ray<S, N>;
// So that a vector in the place of the direction gets the error of Direction.
template <Scalar S, int N, class... Rest>
Ray(Vec<S, N>, Vec<S, N>, Rest...) -> Ray<S, N>;

/// The point `distance` along `ray`: each coordinate rounded to nearest, ties to even, and clamped
/// to the range of the scalar.
template <Scalar S, int N>
[[nodiscard]] constexpr Vec<S, N> point_at(const Ray<S, N>& ray, const S& distance) noexcept {
  return nearest_to<S>(ray.origin + distance * ray.direction.vec());
}

/// The part of a ray inside a shape, as distances from the origin, each rounded down.
///
/// `enter` is 0 when the ray starts inside, and `exit` is max_distance when it ends inside.
template <Scalar S>
struct Interval {
  S enter{};
  S exit{};

  [[nodiscard]] friend constexpr bool operator==(const Interval&,
                                                 const Interval&) noexcept = default;
};

/// Appends to a digest: the fields in order.
template <class D, Scalar S>
constexpr void append(D& digest, const Interval<S>& interval) noexcept {
  digest.add(interval.enter, interval.exit);
}

}  // namespace detent
