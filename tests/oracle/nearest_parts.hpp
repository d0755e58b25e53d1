// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "oracle/corners.hpp"
#include "oracle/nearest.hpp"

// Closest points by candidates: one of them is the closest, so no regions are needed.
namespace detent::oracle {

template <int N>
Place<N> place_at(const Vector<N>& p, const Vector<N>& corner) {
  const auto apart = difference(p, corner);
  return {corner, 1, {dot(apart, apart), 1}};
}

/// The candidate with the least squared distance.
template <int N>
const Place<N>& least(const std::vector<Place<N>>& candidates) {
  const Place<N>* best = &candidates.front();
  for (const auto& candidate : candidates) {
    if (candidate.squared < best->squared) best = &candidate;
  }
  return *best;
}

/// Adds the foot of the perpendicular from p to the line through `start` along `e`, if it is at
/// start + t e with 0 <= t <= limit. Its squared distance is a quotient of Gram determinants.
template <int N>
void add_foot(std::vector<Place<N>>& candidates, const Vector<N>& p, const Vector<N>& start,
              const Vector<N>& e, const Moment& limit) {
  const auto w = difference(p, start);
  const Integer ee = dot(e, e), we = dot(w, e), ww = dot(w, w);
  if (ee.is_zero() || we < 0 || limit < Moment{we, ee}) return;
  Place<N> foot{{}, ee, {ww * ee - we * we, ee}};
  for (std::size_t i = 0; i < e.size(); ++i) foot.over[i] = start[i] * ee + e[i] * we;
  candidates.push_back(foot);
}

template <int N>
void add_edge(std::vector<Place<N>>& candidates, const Vector<N>& p, const Vector<N>& a,
              const Vector<N>& b) {
  candidates.push_back(place_at<N>(p, a));
  candidates.push_back(place_at<N>(p, b));
  add_foot<N>(candidates, p, a, difference(b, a), {1, 1});
}

/// Adds the foot of the perpendicular to a triangle's plane if it is in the triangle: its weights
/// solve the normal equations by Cramer's rule, in 2D and in 3D.
template <int N>
void add_face(std::vector<Place<N>>& candidates, const Vector<N>& p, const Vector<N>& a,
              const Vector<N>& b, const Vector<N>& c) {
  const auto u = difference(b, a), v = difference(c, a), w = difference(p, a);
  const Integer uu = dot(u, u), uv = dot(u, v), vv = dot(v, v);
  const Integer uw = dot(u, w), vw = dot(v, w), ww = dot(w, w);
  const Integer total = uu * vv - uv * uv;
  const Integer of_b = vv * uw - uv * vw, of_c = uu * vw - uv * uw;
  if (total.is_zero() || of_b < 0 || of_c < 0 || of_b + of_c > total) return;
  const Integer volume = ww * total - uw * of_b - vw * of_c;
  Place<N> foot{{}, total, {volume, total}};
  for (std::size_t i = 0; i < u.size(); ++i) {
    foot.over[i] = a[i] * total + u[i] * of_b + v[i] * of_c;
  }
  candidates.push_back(foot);
}

/// The point of the hull of `points` closest to p, which is outside: on a line or a triangle of
/// these points.
template <int N>
Place<N> nearest_outside(const std::vector<Vector<N>>& points, const Vector<N>& p) {
  std::vector<Place<N>> candidates;
  for (std::size_t i = 0; i < points.size(); ++i) {
    candidates.push_back(place_at<N>(p, points[i]));
    for (std::size_t j = 0; j < i; ++j) {
      add_foot<N>(candidates, p, points[i], difference(points[j], points[i]), {1, 1});
      for (std::size_t k = 0; N == 3 && k < j; ++k) {
        add_face<N>(candidates, p, points[i], points[j], points[k]);
      }
    }
  }
  return least<N>(candidates);
}

/// The squared distance between the lines a + s u and b + t v, if they are closest within both
/// segments, ends included: s and t solve the normal equations by Cramer's rule.
template <int N>
std::optional<Moment> between_inner_points(const Edge<N>& p, const Edge<N>& q) {
  const auto u = difference(p.end, p.start), v = difference(q.end, q.start);
  const auto w = difference(q.start, p.start);
  const Integer uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), uw = dot(u, w), vw = dot(v, w);
  const Integer whole = uu * vv - uv * uv;
  const Integer s = vv * uw - uv * vw, t = uv * uw - uu * vw;
  if (whole.is_zero() || s < 0 || s > whole || t < 0 || t > whole) return {};
  Vector<N> apart;
  for (std::size_t i = 0; i < apart.size(); ++i) apart[i] = w[i] * whole + v[i] * t - u[i] * s;
  return Moment{dot(apart, w), whole};  // w less multiples of u and v, which it is perpendicular to
}

/// The squared distance of a wall and a hull.
template <int N>
Moment squared_apart(const Wall<N>& wall, const Hull<N>& hull) {
  if (wall_meets(wall, hull)) return {};
  std::optional<Moment> least;
  for (const auto& point : hull.over) {
    const Integer height = dot(wall.normal, point) - wall.offset * wall.one * hull.under;
    const Moment squared{height * height, dot(wall.normal, wall.normal) * hull.under * hull.under};
    if (!least || squared < *least) least = squared;
  }
  return *least;
}

}  // namespace detent::oracle
