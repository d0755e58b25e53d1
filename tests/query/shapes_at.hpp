// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "query/raycast/helpers.hpp"

// One shape of every kind that reaches from x - 1 to x + 1 on the x axis.

namespace detent::test {

/// Round shapes, with the ends of the reach there.
template <Scalar S, int N, class Visit>
void visit_round(double x, const Visit& visit) {
  visit(Sphere<S, N>{at<S, N>(x), num<S>(1)});
  visit(Capsule<S, N>{at<S, N>(x + 0.5), at<S, N>(x - 0.5), num<S>(0.5)});
}

/// Boxes, with a face at both ends.
template <Scalar S, int N, class Visit>
void visit_boxes(double x, const Visit& visit) {
  visit(Aabb<S, N>{at<S, N>(x - 1, -1, -1), at<S, N>(x + 1, 1, 1)});
  visit(Obb<S, N>{at<S, N>(x), filled<S, N>(num<S>(1)), {}});
}

/// Others that end in a corner.
template <Scalar S, int N, class Visit>
void visit_hulls(double x, const Visit& visit) {
  const auto left = at<S, N>(x - 1), right = at<S, N>(x + 1);
  visit(Triangle<S, N>{left, right, at<S, N>(x, 1)});
  visit(Segment<S, N>{left, right});
  const std::array corners{left, at<S, N>(x, 1), right, at<S, N>(x, -1), at<S, N>(x, 0, 1)};
  visit(ConvexHull<S, N>{corners});
}

template <Scalar S, int N, class Visit>
void visit_shapes(double x, const Visit& visit) {
  visit_round<S, N>(x, visit);
  visit_boxes<S, N>(x, visit);
  visit_hulls<S, N>(x, visit);
}

/// Solid shapes that extend farther on the other axes, except for the sphere. They end at x - 1 and
/// x + 1 in a point, an edge or a face perpendicular to the axis.
template <Scalar S, int N, class Visit>
void visit_wide_shapes(double x, const Visit& visit) {
  visit(Sphere<S, N>{at<S, N>(x), num<S>(1)});
  visit(Aabb<S, N>{at<S, N>(x - 1, -4, -4), at<S, N>(x + 1, 4, 4)});
  visit(Obb<S, N>{at<S, N>(x), at<S, N>(1, 4, 4), {}});
  visit(Capsule<S, N>{at<S, N>(x, -8), at<S, N>(x, 8), num<S>(1)});
  const std::array corners{at<S, N>(x - 1, -4, -4), at<S, N>(x - 1, 4, -4), at<S, N>(x - 1, 0, 4),
                           at<S, N>(x + 1, -4, -4), at<S, N>(x + 1, 4, -4), at<S, N>(x + 1, 0, 4)};
  visit(ConvexHull<S, N>{corners});
}

}  // namespace detent::test
