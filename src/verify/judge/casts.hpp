// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "oracle/cast_judge.hpp"
#include "oracle/impact_truth.hpp"
#include "verify/judge/exact.hpp"

// Moving shapes.

namespace detent::verify::judge {

/// The distance that a shape moves before it touches the target, rounded down; nothing if it does
/// not within `limit`.
template <Scalar S, int N>
std::optional<S> distance_along(const oracle::Travel<N>& travel, const S& limit) {
  const auto is_apart = [&](const Integer& time, const Integer& under) {
    return *oracle::clearance(travel, 0, time, under) > 0;
  };
  if (limit < 0 || !oracle::clearance(travel, 0, 0, 1)) return std::nullopt;
  if (is_apart(oracle::raw(limit), 1)) return std::nullopt;
  if (!is_apart(0, 1)) return S(0);
  // The last number of units after which they are still apart.
  Integer low = 0, high = oracle::raw(limit);
  while (high - low > 1) {
    const Integer middle = (low + high) / 2;
    (is_apart(middle, 1) ? low : high) = middle;
  }
  // They touch before or at the next one.
  const Integer parts = Integer(1) << 60u;
  return clamped<S>(is_apart(high * parts - 1, parts) ? high : low);
}
template <class Shape, class Target>
std::optional<typename Cast<Shape>::S> distance_along(const Cast<Shape>& moving,
                                                      const Target& target) {
  return distance_along(oracle::travel_of(moving.shape, moving.direction, target),
                        moving.max_distance);
}

/// Hit or miss, distance and point are exact; the normal is judged within its bound.
template <int Row, Scalar S, int N, class First, class Second>
std::optional<Wrong> judge(const CastCase<S, N, First, Second>& c,
                           const std::optional<CastHit<S, N>>& got) {
  const auto& shape = as_shape(c.shape);
  const auto& target = as_shape(c.target);
  const auto travel = oracle::travel_of(shape, c.direction, target);
  const auto fault = oracle::fault_of(travel, shape, c.direction, target, got, c.max_distance);
  if (fault.empty()) return std::nullopt;
  return Wrong{"another hit: " + fault, words(got)};
}

/// Apart before the time, and as close as stated at it, at sampled times.
template <int Row, Scalar S, int N, class First, class Second>
std::optional<Wrong> judge(const ImpactCase<S, N, First, Second>& c,
                           const std::optional<Impact<S>>& got) {
  const auto& a = as_shape(c.a);
  const auto& b = as_shape(c.b);
  if (!detent::detail::has_points(a) || !detent::detail::has_points(b)) {
    return compare(std::optional<Impact<S>>(), got);
  }
  const auto fault =
      oracle::fault_of(got, oracle::moving(a, c.sweep_a), oracle::moving(b, c.sweep_b),
                       detent::detail::touching_distance<S>(), 12);
  if (!fault) return std::nullopt;
  return Wrong{"another time: " + *fault, words(got)};
}

}  // namespace detent::verify::judge
