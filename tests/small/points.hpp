// SPDX-License-Identifier: MIT
#pragma once

#include "oracle/describe.hpp"
#include "oracle/hull.hpp"
#include "oracle/point_answer.hpp"
#include "small/world.hpp"

/// Every point of a small world against every shape, or every shape of an exhaustive set: contains,
/// on, distance, squared_distance and closest_point.
namespace detent::small {

/// Every shape against every point; `on` with every tolerance.
template <class Shape, Scalar S, int N>
void ask_points(Verdict& verdict, const std::vector<Shape>& shapes,
                const std::vector<Vec<S, N>>& points) {
  const auto tolerances = numbers<S>();
  for (const auto& shape : shapes) {
    for (const auto& point : points) {
      const auto truth = oracle::nearest(shape, point);
      verdict.count(oracle::is_within(truth, 0));
      verdict.judge(oracle::point_mistakes(shape, point, truth, tolerances),
                    [&] { return oracle::describe(shape) + "; point " + oracle::describe(point); });
    }
  }
}

/// Every point against at most `most` shapes of every kind.
template <Scalar S, int N>
void ask_every_point(std::size_t most, long expected) {
  Verdict verdict;
  const auto parts = all_parts<S, N>();
  with_some(most, parts,
            [&](const auto&... shapes) { (ask_points(verdict, shapes, parts.points), ...); });
  ask_points(verdict, some<Ray<S, N>>(most, parts), parts.points);
  verdict.finish(expected);
}

}  // namespace detent::small
