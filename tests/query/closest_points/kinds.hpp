// SPDX-License-Identifier: MIT
#pragma once

#include <utility>

#include "detent/query/closest_points/pair.hpp"
#include "query/shapes_at.hpp"

namespace detent::test {

/// The points between every two kinds of shapes: two ends on the x axis.
template <Scalar S, int N>
void check_closest_points() {
  using Points = std::pair<Vec<S, N>, Vec<S, N>>;
  const auto check = [](const Points& got, double first, double second) {
    CHECK(got == Points{at<S, N>(first), at<S, N>(second)});
  };
  const auto check_all = [&](const auto& a) {
    visit_shapes<S, N>(4, [&](const auto& b) {
      check(closest_points(a, b), -2, 3);
      check(closest_points(b, a), 3, -2);
    });
    const Plane<S, N> plane{toward<S, N>(1), num<S>(3)};
    check(closest_points(a, plane), -2, 3);
    check(closest_points(plane, a), 3, -2);
  };
  visit_round<S, N>(-3, check_all);
  visit_hulls<S, N>(-3, check_all);
}

}  // namespace detent::test
