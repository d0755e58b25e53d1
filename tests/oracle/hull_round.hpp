// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>

#include "oracle/hull.hpp"

/// Whether a hull overlaps a sphere, a plane or a capsule: to be included before headers that
/// handle shapes of any kind.
namespace detent::oracle {

template <Scalar S, int N>
bool meet(const Sphere<S, N>& sphere, const ConvexHull<S, N>& hull) {
  if (sphere.radius < 0 || hull.points.empty()) return false;
  const Integer square = raw(sphere.radius) * raw(sphere.radius);
  return !(Moment{square, 1} < nearest(hull, sphere.center)->core.squared);
}

/// Whether some convex combination of the points' heights over the plane is 0.
template <Scalar S, int N>
bool meet(const Plane<S, N>& plane, const ConvexHull<S, N>& hull) {
  const Integer one = Integer(1) << static_cast<unsigned>(direction_component<S>::frac);
  const auto normal = widen(raw(plane.normal));
  Simplex weights(2, hull.points.size());
  for (std::size_t i = 0; i < hull.points.size(); ++i) {
    weights.at(0, i) = dot(normal, raw(hull.points[i])) - raw(plane.offset) * one;
    weights.at(1, i) = 1;
  }
  weights.right(1) = 1;
  return weights.is_feasible();
}

/// The squared distance between the lines a + s u and b + t v, if they are closest within both
/// segments, ends included: s and t solve the normal equations by Cramer's rule.
template <int N>
std::optional<Moment> between_inner_points(const Vector<N>& a, const Vector<N>& u,
                                           const Vector<N>& b, const Vector<N>& v) {
  const auto w = difference(b, a);
  const Integer uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), uw = dot(u, w), vw = dot(v, w);
  const Integer whole = uu * vv - uv * uv;
  const Integer s = vv * uw - uv * vw, t = uv * uw - uu * vw;
  if (whole.is_zero() || s < 0 || s > whole || t < 0 || t > whole) return {};
  Vector<N> apart;
  for (std::size_t i = 0; i < apart.size(); ++i) apart[i] = w[i] * whole + v[i] * t - u[i] * s;
  return Moment{dot(apart, w), whole};  // w less multiples of u and v, which it is perpendicular to
}

/// The distance of disjoint sets is that of an end of the axis from the hull, of the axis from a
/// point, or of the axis from a segment of two points.
template <Scalar S, int N>
bool meet(const Capsule<S, N>& capsule, const ConvexHull<S, N>& hull) {
  if (capsule.radius < 0 || hull.points.empty()) return false;
  if (meet(hull_of(Segment<S, N>{capsule.a, capsule.b}), hull_of(hull))) return true;
  const auto points = hull_of(hull).over;
  const auto a = raw(capsule.a), u = difference(raw(capsule.b), a);
  auto least =
      std::min(nearest(hull, capsule.a)->core.squared, nearest(hull, capsule.b)->core.squared);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto to_point = nearest(Segment<S, N>{capsule.a, capsule.b}, hull.points[i]);
    least = std::min(least, to_point->core.squared);
    for (std::size_t j = 0; j < i; ++j) {
      const auto across =
          between_inner_points<N>(a, u, points[i], difference(points[j], points[i]));
      if (across) least = std::min(least, *across);
    }
  }
  return !(Moment{raw(capsule.radius) * raw(capsule.radius), 1} < least);
}

}  // namespace detent::oracle
