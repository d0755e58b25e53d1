// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "detent/query/distance/pair.hpp"
#include "query/raycast/helpers.hpp"

namespace detent::test {

/// Shapes that extend from x - 1 to x + 1 on the x axis, with their nearest points there.
template <Scalar S, int N, class Visit>
void visit_kinds(double x, const Visit& visit) {
  const auto one = num<S>(1);
  const auto left = at<S, N>(x - 1), right = at<S, N>(x + 1);
  visit(Sphere<S, N>{at<S, N>(x), one});
  visit(Aabb<S, N>{at<S, N>(x - 1, -1, -1), at<S, N>(x + 1, 1, 1)});
  visit(Obb<S, N>{at<S, N>(x), filled<S, N>(one), {}});
  visit(Triangle<S, N>{left, right, at<S, N>(x, 1)});
  visit(Capsule<S, N>{at<S, N>(x), at<S, N>(x), one});
  visit(Segment<S, N>{left, right});
  const std::array corners{left, at<S, N>(x, 1), right, at<S, N>(x, -1), at<S, N>(x, 0, 1)};
  visit(ConvexHull<S, N>{corners});
}

/// The distances of every two kinds of shapes.
template <Scalar S, int N>
void check_distances() {
  // The position of the other shape, and its distance there.
  constexpr std::array<std::array<double, 2>, 3> others{{{4, 5}, {-1, 0}, {-3, 0}}};
  const auto check = [](S got, S expected) { CHECK(got == expected); };
  visit_kinds<S, N>(-3, [&](const auto& a) {
    for (const auto& [x, expected] : others) {
      visit_kinds<S, N>(x, [&, d = num<S>(expected)](const auto& b) {
        check(distance(a, b), d);
        check(distance(b, a), d);
      });
    }
    const Plane<S, N> plane{toward<S, N>(1), num<S>(4)};
    CHECK(distance(a, plane) == num<S>(6));
    CHECK(distance(plane, a) == num<S>(6));
    CHECK(distance(Plane<S, N>{toward<S, N>(1), num<S>(-3)}, a) == S(0));
  });
}

}  // namespace detent::test
