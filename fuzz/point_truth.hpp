// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>

#include "detent/query/on.hpp"
#include "oracle/describe.hpp"
#include "property.hpp"

namespace detent::fuzz {

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
  require(contains(shape, point) == oracle::is_within(truth, 0), because("contains"));
  require(on(shape, point, tolerance) == oracle::is_within(truth, oracle::raw(tolerance)),
          because("on"));
  require(oracle::is_distance(oracle::raw(distance(shape, point)), truth, oracle::raw(S::max())),
          because("distance"));
  if constexpr (requires { squared_distance(shape, point); }) {
    const bool is_far = !(squared_distance(shape, point) <= square(S::max()));
    const bool is_near = oracle::is_within(truth, oracle::raw(S::max()));
    require(is_far != is_near, because("squared_distance"));
  }
  require(oracle::is_closest<N>(oracle::raw(closest_point(shape, point)), oracle::raw(point), truth,
                                oracle::raw(S::lowest()), oracle::raw(S::max())),
          because("closest_point"));
}

}  // namespace detent::fuzz
