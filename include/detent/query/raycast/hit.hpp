// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "detent/number/fraction.hpp"
#include "detent/shape/ray.hpp"

namespace detent {

/// Where a ray first touches a shape.
///
/// `distance` is the exact one rounded down, so `point` lies on the surface or before it, except
/// for the rounding of its coordinates. `normal` is that of the exact point and faces the ray. If
/// the ray starts inside a solid, it is the opposite of the direction.
template <Scalar S, int N>
struct RayHit {
  S distance{};
  Vec<S, N> point;
  Direction<S, N> normal;

  [[nodiscard]] friend constexpr bool operator==(const RayHit&, const RayHit&) noexcept = default;
};

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
template <class D, Scalar S, int N>
constexpr void append(D& digest, const RayHit<S, N>& hit) noexcept {
  digest.add(hit.distance, hit.point, hit.normal);
}

template <class D, Scalar S>
constexpr void append(D& digest, const Interval<S>& interval) noexcept {
  digest.add(interval.enter, interval.exit);
}

/// Which sides of a surface rays hit: both, or only the front, the side that its normal points to.
enum class Facing { both, front };

namespace detail {

/// The part of a line inside a shape, from `enter` to `exit`, as exact distances of either sign.
template <Number N, Number D>
struct Span {
  Fraction<N, D> enter;
  Fraction<N, D> exit;
};

/// The first distance of `span` in [0, limit], rounded down.
template <Scalar S, Number N, Number D>
[[nodiscard]] constexpr std::optional<S> first_distance(const Span<N, D>& span,
                                                        const S& limit) noexcept {
  if (limit < 0 || span.exit.numerator < 0) return std::nullopt;
  if (span.enter.numerator <= 0) return S(0);
  return floor_within(span.enter, limit);
}

/// The part of `span` in [0, limit], rounded down.
template <Scalar S, Number N, Number D>
[[nodiscard]] constexpr std::optional<Interval<S>> interval_of(const Span<N, D>& span,
                                                               const S& limit) noexcept {
  const auto enter = first_distance(span, limit);
  if (!enter) return std::nullopt;
  return Interval<S>{*enter, floor_within(span.exit, limit).value_or(limit)};
}

template <Scalar S, int N>
[[nodiscard]] constexpr RayHit<S, N> hit_at(const Ray<S, N>& ray, const S& distance,
                                            const Direction<S, N>& normal) noexcept {
  return {distance, point_at(ray, distance), normal};
}

}  // namespace detail

}  // namespace detent
