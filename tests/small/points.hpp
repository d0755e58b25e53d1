// SPDX-License-Identifier: MIT
#pragma once

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
      verdict.count(truth && oracle::is_within(*truth, 0));
      verdict.judge(oracle::point_mistakes(shape, point, truth, tolerances),
                    [&] { return oracle::describe(shape) + "; point " + oracle::describe(point); });
    }
  }
}

/// Every point against at most `most` shapes of every kind.
template <Scalar S, int N>
void ask_every_point(std::size_t most, long expected) {
  Verdict verdict;
  const auto all = points<S, N>();
  const auto ways = directions<S, N>(2);
  const auto corners = some(N == 2 ? 16 : 9, all);
  ask_points(verdict, some(most, spheres<S, N>()), all);
  ask_points(verdict, some(most, boxes(all)), all);
  ask_points(verdict, some(most, turned_boxes(all, all, rotations<S, N>())), all);
  ask_points(verdict, some(most, planes(ways)), all);
  ask_points(verdict, some(most, triangles(all, all)), all);
  ask_points(verdict, some(most, capsules(all)), all);
  ask_points(verdict, some(most, segments(all)), all);
  ask_points(verdict, some(most, rays(all, ways, numbers<S>())), all);
  const Hulls<S, N> hulls(corners, N == 2 ? 4 : 5);
  ask_points(verdict, some(most, hulls.all()), all);
  verdict.finish(expected);
}

}  // namespace detent::small
