// SPDX-License-Identifier: MIT
#pragma once

#include "oracle/answer.hpp"
#include "oracle/ask.hpp"
#include "oracle/describe.hpp"
#include "property.hpp"

namespace detent::fuzz {

/// Requires that all three raycasts of `shape` give the oracle's results for `same`, the equivalent
/// shape.
template <class Ray, class Shape, class Same>
void check_ray(const Ray& ray, const Shape& shape, const Same& same) {
  const auto found = mistakes(oracle::expected_raycast(ray, same), oracle::ask(ray, shape));
  require(found.empty(),
          [&] { return oracle::describe(ray) + "; " + oracle::describe(same) + "\n" + found; });
}

}  // namespace detent::fuzz
