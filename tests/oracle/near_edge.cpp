// SPDX-License-Identifier: MIT
#include "oracle/near_edge.hpp"

#include <algorithm>
#include <array>

#include "oracle/meet.hpp"
#include "oracle/nearest.hpp"
#include "oracle/nearest_parts.hpp"

namespace detent::oracle {
namespace {

/// Whether a point of the shape is within `reach` of `point`.
template <int N>
bool near_point(const Solid<N>& shape, const Vector<N>& point, const Integer& reach) {
  return is_within(nearest(shape, point), reach);
}

Integer determinant(const Vector<3>& a, const Vector<3>& b, const Vector<3>& c) {
  return dot(a, cross(b, c));
}

/// Whether the segment crosses the triangle: start + t along = a + u (b - a) + v (c - a), by
/// Cramer's rule.
bool cuts(const Edge<3>& edge, const Face<3>& face) {
  const auto& [a, b, c] = face.corners;
  const auto u_along = difference(b, a), v_along = difference(c, a);
  const auto t_along = difference(edge.start, edge.end);
  const auto w = difference(edge.start, a);
  const Integer whole = determinant(u_along, v_along, t_along);
  if (whole.is_zero()) return false;
  const auto weight = [&](const Integer& over) { return Moment::fraction(over, whole); };
  const auto u = weight(determinant(w, v_along, t_along));
  const auto v = weight(determinant(u_along, w, t_along));
  const auto t = weight(determinant(u_along, v_along, w));
  return u.over >= 0 && v.over >= 0 && u.over + v.over <= u.under && t.over >= 0 &&
         t.over <= t.under;
}

/// Slabs from `low` to `high`, the position relative to them at time 0, and the movement until time
/// 1. Lengths are in steps of 1 / `one` raw unit.
template <int N>
struct Slabs {
  Vector<N> low, high, start, along;
  Integer one;
};

/// Whether the position at time over / under is within `reach` of the slabs; false for times
/// outside [0, 1].
template <int N>
bool near_at(const Slabs<N>& slabs, const Integer& over, const Integer& under,
             const Integer& reach) {
  if (over < 0 || over > under) return false;
  Integer squared = 0;
  for (std::size_t i = 0; i < slabs.low.size(); ++i) {
    const Integer place = slabs.start[i] * under + slabs.along[i] * over;
    const Integer beyond = std::max(std::max<Integer>(slabs.low[i] * under - place, 0),
                                    std::max<Integer>(place - slabs.high[i] * under, 0));
    squared += beyond * beyond;
  }
  const Integer most = reach * slabs.one * under;
  return squared <= most * most;
}

/// For every choice of a side or the inside on each axis, the squared distance to the chosen planes
/// is quadratic in time. The minimum of one of these is the minimum distance.
template <int N>
bool near_slabs(const Slabs<N>& slabs, const Integer& reach) {
  for (std::size_t i = 0; i < slabs.low.size(); ++i) {
    if (slabs.low[i] > slabs.high[i]) return false;
  }
  if (near_at(slabs, 0, 1, reach) || near_at(slabs, 1, 1, reach)) return true;
  for (int choice = 0, all = N == 2 ? 9 : 27; choice < all; ++choice) {
    Integer over = 0, under = 0;
    for (std::size_t i = 0, rest = static_cast<std::size_t>(choice); i < slabs.low.size();
         ++i, rest /= 3) {
      if (rest % 3 == 0) continue;
      const Integer& side = rest % 3 == 1 ? slabs.low[i] : slabs.high[i];
      over += slabs.along[i] * (side - slabs.start[i]);
      under += slabs.along[i] * slabs.along[i];
    }
    if (!under.is_zero() && near_at(slabs, over, under, reach)) return true;
    // If every moving coordinate gets inside, the common interval begins at a crossing.
    const auto axis = static_cast<std::size_t>(choice / 3) % slabs.low.size();
    const Integer& bound = choice % 3 == 1 ? slabs.low[axis] : slabs.high[axis];
    const auto t = Moment::fraction(bound - slabs.start[axis], slabs.along[axis]);
    if (!t.under.is_zero() && near_at(slabs, t.over, t.under, reach)) return true;
  }
  return false;
}

}  // namespace

/// Every end against the other segment, and the points where the distance of the lines is
/// stationary.
template <int N>
bool near_edge(const Edge<N>& a, const Edge<N>& b, const Integer& reach) {
  if (near_point<N>(a, b.start, reach) || near_point<N>(a, b.end, reach)) return true;
  if (near_point<N>(b, a.start, reach) || near_point<N>(b, a.end, reach)) return true;
  const auto squared = between_inner_points(a, b);
  return squared && !(Moment{reach * reach, 1} < *squared);
}

/// Edges and ends, and in 3D the point where the line crosses the plane.
template <int N>
bool near_edge(const Face<N>& face, const Edge<N>& edge, const Integer& reach) {
  const auto& [a, b, c] = face.corners;
  for (const auto& side : {Edge<N>{a, b}, Edge<N>{b, c}, Edge<N>{c, a}}) {
    if (near_edge(side, edge, reach)) return true;
  }
  if (near_point<N>(face, edge.start, reach)) return true;
  if (near_point<N>(face, edge.end, reach)) return true;
  if constexpr (N == 3) {
    return cuts(edge, face);
  } else {
    return false;
  }
}

/// The ends, and any point where the line meets the plane.
template <int N>
bool near_edge(const Wall<N>& wall, const Edge<N>& edge, const Integer& reach) {
  const auto along = difference(edge.end, edge.start);
  const auto t = Moment::fraction(wall.offset * wall.one - dot(wall.normal, edge.start),
                                  dot(wall.normal, along));
  if (!t.under.is_zero() && t.over >= 0 && t.over <= t.under) return true;
  return near_point<N>(wall, edge.start, reach) || near_point<N>(wall, edge.end, reach);
}

template <int N>
bool near_edge(const Box<N>& box, const Edge<N>& edge, const Integer& reach) {
  return near_slabs<N>({box.low, box.high, edge.start, difference(edge.end, edge.start), 1}, reach);
}

/// In the frame of the box.
template <int N>
bool near_edge(const TurnedBox<N>& box, const Edge<N>& edge, const Integer& reach) {
  const auto from_center = difference(edge.start, box.center);
  const auto along = difference(edge.end, edge.start);
  Slabs<N> slabs;
  slabs.one = box.one;
  for (std::size_t i = 0; i < from_center.size(); ++i) {
    slabs.high[i] = box.half[i] * box.one;
    slabs.low[i] = -slabs.high[i];
    slabs.start[i] = dot(box.axes[i], from_center);
    slabs.along[i] = dot(box.axes[i], along);
  }
  return near_slabs(slabs, reach);
}

/// The distance of disjoint sets is that of an end of the segment from the hull, of the segment
/// from a point, or of the segment from a segment between two points.
template <int N>
bool near_edge(const Cloud<N>& cloud, const Edge<N>& edge, const Integer& reach) {
  if (cloud.points.empty()) return false;
  if (meet(edge, cloud)) return true;
  if (near_point<N>(cloud, edge.start, reach)) return true;
  if (near_point<N>(cloud, edge.end, reach)) return true;
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      if (near_edge(Edge<N>{cloud.points[i], cloud.points[j]}, edge, reach)) return true;
    }
  }
  return false;
}

template bool near_edge(const Edge<2>&, const Edge<2>&, const Integer&);
template bool near_edge(const Edge<3>&, const Edge<3>&, const Integer&);
template bool near_edge(const Face<2>&, const Edge<2>&, const Integer&);
template bool near_edge(const Face<3>&, const Edge<3>&, const Integer&);
template bool near_edge(const Wall<2>&, const Edge<2>&, const Integer&);
template bool near_edge(const Wall<3>&, const Edge<3>&, const Integer&);
template bool near_edge(const Box<2>&, const Edge<2>&, const Integer&);
template bool near_edge(const Box<3>&, const Edge<3>&, const Integer&);
template bool near_edge(const TurnedBox<2>&, const Edge<2>&, const Integer&);
template bool near_edge(const TurnedBox<3>&, const Edge<3>&, const Integer&);
template bool near_edge(const Cloud<2>&, const Edge<2>&, const Integer&);
template bool near_edge(const Cloud<3>&, const Edge<3>&, const Integer&);

}  // namespace detent::oracle
