// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>

#include "detent/query/on.hpp"
#include "oracle/describe.hpp"
#include "oracle/point.hpp"
#include "oracle/rounding.hpp"
#include "property.hpp"

namespace detent::fuzz {

using oracle::Integer;
using oracle::Nearest;

template <int N>
bool is_within(const std::optional<Nearest<N>>& truth, const Integer& tolerance) {
  if (!truth) return false;
  const Integer reach = truth->radius + tolerance;
  return truth->core.squared.over <= reach * reach * truth->core.squared.under;
}

/// Whether `given` is the distance rounded down, or the largest number if that is less.
template <Scalar S, int N>
bool is_distance(S given, const std::optional<Nearest<N>>& truth) {
  const bool is_largest = given == S::max();
  if (!truth) return is_largest;
  const Integer raw = oracle::raw(given), reach = truth->radius + raw;
  const auto& [over, under] = truth->core.squared;
  if (raw > 0 && over < reach * reach * under) return false;
  return raw >= 0 && (is_largest || over < (reach + 1) * (reach + 1) * under);
}

template <Scalar S, int N>
bool is_closest(const Vec<S, N>& given, const Vec<S, N>& point,
                const std::optional<Nearest<N>>& truth) {
  if (!truth || (truth->keeps_inside && is_within<N>(truth, 0))) return given == point;
  const auto closest = oracle::raw(given), p = oracle::raw(point);
  const auto& core = truth->core;
  oracle::Vector<N> onward;
  for (std::size_t i = 0; i < onward.size(); ++i) onward[i] = p[i] * core.under - core.over[i];
  for (std::size_t i = 0; i < onward.size(); ++i) {
    if (!truth->radius.is_zero()) {
      if (!oracle::is_rounded<N>(closest[i], core, i, truth->radius, onward)) return false;
    } else {
      const Integer nearest = oracle::nearest_quotient(core.over[i], core.under);
      const Integer low = oracle::raw(S::lowest()), high = oracle::raw(S::max());
      if (closest[i] != std::clamp(nearest, low, high)) return false;
    }
  }
  return true;
}

/// Throws unless contains, on, distance and closest_point give the oracle's result, rounded as
/// their docstrings say.
template <class Shape, Scalar S, int N>
void check_point(const Shape& shape, const Vec<S, N>& point, S tolerance) {
  const auto truth = oracle::nearest(shape, point);
  const auto because = [&](const char* query) {
    return [&, query] {
      return std::string(query) + ": " + oracle::describe(shape) + "; point " +
             oracle::describe(point) + "; tolerance " + oracle::raw(tolerance).str();
    };
  };
  require(contains(shape, point) == is_within<N>(truth, 0), because("contains"));
  require(on(shape, point, tolerance) ==
              (tolerance >= 0 && is_within<N>(truth, oracle::raw(tolerance))),
          because("on"));
  require(is_distance<S, N>(distance(shape, point), truth), because("distance"));
  if constexpr (requires { squared_distance(shape, point); }) {
    const bool is_far = !(squared_distance(shape, point) <= square(S::max()));
    const bool is_near = is_within<N>(truth, oracle::raw(S::max()));
    require(is_far != is_near, because("squared_distance"));
  }
  require(is_closest<S, N>(closest_point(shape, point), point, truth), because("closest_point"));
}

}  // namespace detent::fuzz
