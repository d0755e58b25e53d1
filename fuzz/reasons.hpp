// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "oracle/describe.hpp"

namespace detent::fuzz {

/// For `require(is_right, reasons(query))`: the query and its arguments, which must stay where they
/// are.
template <class Shape, Scalar S, int N>
auto reasons(const Shape& shape, const Ray<S, N>& ray, const Vec<S, N>& point) {
  return [&](const char* query) {
    return [&, query] {
      return std::string(query) + ": " + oracle::describe(shape) + "; " + oracle::describe(ray) +
             "; point " + oracle::describe(point);
    };
  };
}

}  // namespace detent::fuzz
