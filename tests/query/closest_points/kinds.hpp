// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <utility>

#include "detent/query/closest_points/pair.hpp"
#include "query/raycast/helpers.hpp"

namespace detent::test {

template <Scalar S, int N>
using Points = std::pair<Vec<S, N>, Vec<S, N>>;

/// Shapes that extend from x - 1 to x + 1 on the x axis and touch these limits only there.
template <Scalar S, int N, class Visit>
void visit_pointed_ends(double x, const Visit& visit) {
  const auto one = num<S>(1);
  const auto left = at<S, N>(x - 1), right = at<S, N>(x + 1);
  visit(Sphere<S, N>{at<S, N>(x), one});
  visit(Capsule<S, N>{at<S, N>(x), at<S, N>(x), one});
  visit(Segment<S, N>{left, right});
  visit(Triangle<S, N>{left, right, at<S, N>(x, 1)});
  const std::array corners{left, at<S, N>(x, 1), right, at<S, N>(x, -1), at<S, N>(x, 0, 1)};
  visit(ConvexHull<S, N>{corners});
}
/// Shapes with a face at both limits.
template <Scalar S, int N, class Visit>
void visit_ends(double x, const Visit& visit) {
  visit_pointed_ends<S, N>(x, visit);
  visit(Aabb<S, N>{at<S, N>(x - 1, -1, -1), at<S, N>(x + 1, 1, 1)});
  visit(Obb<S, N>{at<S, N>(x), filled<S, N>(num<S>(1)), {}});
}

/// The closest points of every two kinds of shapes: two ends on the x axis.
template <Scalar S, int N>
void check_closest_points() {
  const auto check = [](const Points<S, N>& got, double first, double second) {
    CHECK(got == Points<S, N>{at<S, N>(first), at<S, N>(second)});
  };
  visit_pointed_ends<S, N>(-3, [&](const auto& a) {
    visit_ends<S, N>(4, [&](const auto& b) {
      check(closest_points(a, b), -2, 3);
      check(closest_points(b, a), 3, -2);
    });
    const Plane<S, N> plane{toward<S, N>(1), num<S>(3)};
    check(closest_points(a, plane), -2, 3);
    check(closest_points(plane, a), 3, -2);
  });
}

}  // namespace detent::test
