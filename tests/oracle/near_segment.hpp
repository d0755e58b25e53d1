// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <optional>

#include "oracle/point.hpp"

/// Whether a shape is within a distance of a segment. Each shape has finitely many candidates that
/// include the closest point, and each candidate is tested by the definition of distance. No
/// regions, no reasoning about where the closest point is.
namespace detent::oracle {

template <int N>
struct Edge {
  Vector<N> start, along;
};
template <Scalar S, int N>
Edge<N> edge(const Vec<S, N>& from, const Vec<S, N>& to) {
  return {raw(from), difference(raw(to), raw(from))};
}

/// Whether a point of the shape is within `reach` of `point`.
template <class Shape, Scalar S, int N>
bool near_point(const Shape& shape, const Vec<S, N>& point, const Integer& reach) {
  const auto place = nearest(shape, point);
  return place && place->core.squared.over <= reach * reach * place->core.squared.under;
}

/// Whether p.start + s p.along and q.start + t q.along are within `reach` of each other, for
/// s = s_over / under and t = t_over / under.
template <int N>
bool near_there(const Edge<N>& p, const Edge<N>& q, const Integer& s_over, const Integer& t_over,
                const Integer& under, const Integer& reach) {
  Integer squared = 0;
  for (std::size_t i = 0; i < p.start.size(); ++i) {
    const Integer apart =
        (p.start[i] - q.start[i]) * under + s_over * p.along[i] - t_over * q.along[i];
    squared += apart * apart;
  }
  return squared <= reach * reach * under * under;
}

/// Every end against the other segment, and the one pair of points where the distance of the lines
/// is stationary, by Cramer's rule.
template <Scalar S, int N>
bool near_segment(const Segment<S, N>& a, const Segment<S, N>& b, const Integer& reach) {
  if (near_point(a, b.start, reach) || near_point(a, b.end, reach)) return true;
  if (near_point(b, a.start, reach) || near_point(b, a.end, reach)) return true;
  const auto p = edge(a.start, a.end), q = edge(b.start, b.end);
  const auto w = difference(q.start, p.start);
  // s pp - t pq = pw, s pq - t qq = qw
  const Integer pp = dot(p.along, p.along), pq = dot(p.along, q.along), qq = dot(q.along, q.along);
  const Integer pw = dot(p.along, w), qw = dot(q.along, w);
  Integer under = pq * pq - pp * qq;
  if (under.is_zero()) return false;
  Integer s = pq * qw - qq * pw, t = pp * qw - pq * pw;
  if (under < 0) {
    under = -under;
    s = -s;
    t = -t;
  }
  if (s < 0 || s > under || t < 0 || t > under) return false;
  return near_there<N>(p, q, s, t, under, reach);
}

inline Integer determinant(const Vector<3>& a, const Vector<3>& b, const Vector<3>& c) {
  return dot(a, cross(b, c));
}

/// Edges and ends, and in 3D the point where the line crosses the plane: start + t along = a + u (b
/// - a) + v (c - a), by Cramer's rule.
template <Scalar S, int N>
bool near_segment(const Triangle<S, N>& triangle, const Segment<S, N>& segment,
                  const Integer& reach) {
  const auto& [a, b, c] = triangle;
  for (const auto& side : {Segment{a, b}, Segment{b, c}, Segment{c, a}}) {
    if (near_segment(side, segment, reach)) return true;
  }
  if (near_point(triangle, segment.start, reach)) return true;
  if (near_point(triangle, segment.end, reach)) return true;
  if constexpr (N == 3) {
    const auto u_along = edge(a, b).along, v_along = edge(a, c).along;
    const auto t_along = edge(segment.end, segment.start).along;
    const auto w = difference(raw(segment.start), raw(a));
    const Integer whole = determinant(u_along, v_along, t_along);
    if (whole.is_zero()) return false;
    const auto weight = [&](const Integer& over) { return Moment::fraction(over, whole); };
    const auto u = weight(determinant(w, v_along, t_along));
    const auto v = weight(determinant(u_along, w, t_along));
    const auto t = weight(determinant(u_along, v_along, w));
    return u.over >= 0 && v.over >= 0 && u.over + v.over <= u.under && t.over >= 0 &&
           t.over <= t.under;
  } else {
    return false;
  }
}

/// The ends, and any point where the line meets the plane.
template <Scalar S, int N>
bool near_segment(const Plane<S, N>& plane, const Segment<S, N>& segment, const Integer& reach) {
  const Integer one = Integer(1) << static_cast<unsigned>(direction_component<S>::frac);
  const auto n = widen(raw(plane.normal));
  const auto line = edge(segment.start, segment.end);
  const auto t = Moment::fraction(raw(plane.offset) * one - dot(n, line.start), dot(n, line.along));
  if (!t.under.is_zero() && t.over >= 0 && t.over <= t.under) return true;
  return near_point(plane, segment.start, reach) || near_point(plane, segment.end, reach);
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
    // If every moving coordinate gets inside, that begins at a crossing.
    const auto axis = static_cast<std::size_t>(choice / 3) % slabs.low.size();
    const Integer& bound = choice % 3 == 1 ? slabs.low[axis] : slabs.high[axis];
    const auto t = Moment::fraction(bound - slabs.start[axis], slabs.along[axis]);
    if (!t.under.is_zero() && near_at(slabs, t.over, t.under, reach)) return true;
  }
  return false;
}

template <Scalar S, int N>
bool near_segment(const Aabb<S, N>& box, const Segment<S, N>& segment, const Integer& reach) {
  const auto line = edge(segment.start, segment.end);
  return near_slabs<N>({raw(box.min), raw(box.max), line.start, line.along, 1}, reach);
}

/// In the frame of the box.
template <Scalar S, int N>
bool near_segment(const Obb<S, N>& box, const Segment<S, N>& segment, const Integer& reach) {
  const auto line = edge(segment.start, segment.end);
  const auto from_center = difference(line.start, raw(box.center));
  Slabs<N> slabs;
  slabs.one = Integer(1) << static_cast<unsigned>(direction_component<S>::frac);
  for (std::size_t i = 0; i < from_center.size(); ++i) {
    const auto axis = widen(raw(box.rotation.axis(static_cast<int>(i))));
    slabs.high[i] = raw(box.half_extents[static_cast<int>(i)]) * slabs.one;
    slabs.low[i] = -slabs.high[i];
    slabs.start[i] = dot(axis, from_center);
    slabs.along[i] = dot(axis, line.along);
  }
  return near_slabs(slabs, reach);
}

}  // namespace detent::oracle
