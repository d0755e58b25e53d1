// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "oracle/cast_judge.hpp"
#include "oracle/impact_truth.hpp"
#include "verify/judge/exact.hpp"

// Moving shapes.

namespace detent::verify::judge {

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
