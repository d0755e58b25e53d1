// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "accuracy/question.hpp"
#include "exact.hpp"
#include "oracle/exact.hpp"

// The exact results, by the oracle.

namespace detent::accuracy {

using cli::distance_frac;
using cli::Exact;
using Steps = oracle::Integer;

/// The exact distance in steps of 2^-48, rounded down; nothing for a miss.
using Distance = std::optional<Steps>;

inline cli::ExactShape exact(const Points<Carrier, 3>& hull) {
  cli::ExactShape shape{cli::ExactShape::Form::cloud};
  for (const auto& point : hull.points) shape.add(point);
  return shape;
}

/// Where a ray first hits a shape in the carrier, whose lengths are in steps of 2^-frac.
template <class Shape>
Distance first_hit(const Ray<Carrier, 3>& ray, const Shape& shape, int frac) {
  using cli::exact;
  auto exact_ray = exact(ray), exact_shape = exact(shape);
  for (auto* const lengths : {&exact_ray.lengths, &exact_shape.lengths}) {
    for (auto& length : *lengths) length.exponent = -frac;
  }
  return cli::first_hit(exact_ray, exact_shape);
}

/// Whether two shapes in the carrier overlap.
template <class A, class B>
bool meet(const A& a, const B& b) {
  return oracle::meet(as_shape(a), as_shape(b));
}

}  // namespace detent::accuracy
